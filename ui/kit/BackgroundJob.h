#pragma once
/// Long work on a worker thread, with progress and cancel: one at a time.

#include <QFutureWatcher>
#include <QObject>
#include <QStringList>

#include <atomic>
#include <functional>
#include <memory>

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/record/Id.h"

namespace lubberline::ui {

struct JobOutcome {
    QString message;
    QStringList warnings;
    SwingId swing; ///< what to show then, if valid
    bool fleetChanged = false;
};

/// Runs on the worker; calls its argument now and then and gives up when that returns false.
using Work = std::function<Result<JobOutcome>(const Progress&)>;

class BackgroundJob : public QObject {
    Q_OBJECT

public:
    explicit BackgroundJob(QObject* parent = nullptr);
    /// Cancels and waits.
    ~BackgroundJob() override;

    void start(const Work& work); ///< broken contract while running()
    void cancel() { m_cancelled = true; }
    [[nodiscard]] bool running() const { return m_running; }

signals:
    void progressed(int percent);
    void finished(const lubberline::Result<lubberline::ui::JobOutcome>& outcome);

private:
    bool report(double fraction);

    QFutureWatcher<std::shared_ptr<Result<JobOutcome>>> m_watcher;
    bool m_running = false;
    std::atomic<bool> m_cancelled{false};
    std::atomic<int> m_percent{-1};
};

} // namespace lubberline::ui
