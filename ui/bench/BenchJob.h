#pragma once

#include <QFutureWatcher>
#include <QObject>
#include <QThreadPool>

#include <atomic>
#include <memory>

#include "core/iron/BenchModel.h"

namespace lubberline::ui {

/// The iron bench computed on a worker thread: the newest bench wins, an older one is given up.
class BenchJob : public QObject {
    Q_OBJECT

public:
    explicit BenchJob(QObject* parent = nullptr);
    ~BenchJob() override;

    void start(const IronBench& bench, const BenchStates& states);
    void cancel();
    [[nodiscard]] bool running() const { return m_watcher.isRunning(); }

signals:
    void progressed(int percent);
    void ready(const lubberline::BenchModel& model);
    void failed(const QString& message);
    void cancelled();

private:
    using Answer = std::shared_ptr<const Result<BenchModel>>;
    struct Shared {
        std::atomic<bool> cancelled{false};
        std::atomic<int> percent{0};
    };
    void finish();

    QThreadPool m_pool; ///< one thread; its end waits for the work, which tells its progress to this object
    QFutureWatcher<Answer> m_watcher;
    std::shared_ptr<Shared> m_shared; ///< with the newest work
};

} // namespace lubberline::ui
