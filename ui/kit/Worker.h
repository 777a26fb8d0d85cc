#pragma once
/// Long work on a thread of its own, with progress and cancel: the only place of the window where a thread begins. (Core reads reports of
/// wind with two hands of its own: core/format/csv/WindHands.h, core/inflight/Alongside.h.)

#include <QObject>
#include <QThreadPool>

#include <atomic>
#include <functional>
#include <memory>
#include <utility>

#include "core/base/Progress.h"
#include "core/base/Result.h"

namespace lubberline::ui {

/// The part of a Worker that does not depend on its result.
class WorkerThread {
public:
    WorkerThread(const WorkerThread&) = delete;
    WorkerThread& operator=(const WorkerThread&) = delete;

    /// The work is told to give up; what it then returns (Cancelled, or a result that was ready before it looked) is delivered.
    void cancel();
    /// Waits for the work that runs, and delivers its result before it returns.
    void finish();
    [[nodiscard]] bool running() const { return m_run != nullptr; } ///< until its result was delivered

protected:
    using Delivery = std::function<void()>;
    explicit WorkerThread(std::function<void(int percent)> progressed);
    ~WorkerThread();
    /// @param job  runs on the thread; what it returns is called on the thread of this object, unless another job began since.
    void begin(std::function<Delivery(const Progress&)> job);

private:
    struct Run {
        std::atomic<bool> cancelled{false};
        std::atomic<int> percent{-1};
    };
    void wait();
    bool report(const std::shared_ptr<Run>& run, double fraction);

    std::function<void(int)> m_progressed;
    QObject m_home;             ///< lives on the window's thread; what was on its way there is dropped when it dies
    QThreadPool m_pool;         ///< one thread: what was replaced has ended, and let go of its connection, before the next begins
    std::shared_ptr<Run> m_run; ///< of the newest job; null: none
};

/// Runs one piece of work at a time and delivers its result on the thread that made this object. The newest wins: what was started before
/// is cancelled, and neither its progress nor its result is heard of any more. The end of this object cancels and waits; nothing is
/// delivered after it, so that work and delivery may use what outlives this object.
template <class T>
class Worker : public WorkerThread {
public:
    /// Called on the worker's thread; to call its argument now and then, and to return Cancelled when that says false.
    using Work = std::function<Result<T>(const Progress&)>;

    /// @param deliver  may start the next work, or delete this object.
    /// @param progressed  0…100, each at most once.
    explicit Worker(std::function<void(Result<T>)> deliver, std::function<void(int percent)> progressed = {})
        : WorkerThread(std::move(progressed))
        , m_deliver(std::move(deliver))
    {
    }

    void start(Work work)
    {
        begin([work = std::move(work), deliver = m_deliver](const Progress& progress) -> Delivery {
            auto result = std::make_shared<Result<T>>(work(progress));
            return [result, deliver] { deliver(std::move(*result)); };
        });
    }

private:
    std::function<void(Result<T>)> m_deliver;
};

} // namespace lubberline::ui
