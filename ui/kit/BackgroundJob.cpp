#include "ui/kit/BackgroundJob.h"

#include <QtConcurrent/QtConcurrentRun>

#include "core/base/Contract.h"

namespace lubberline::ui {

BackgroundJob::BackgroundJob(QObject* parent) : QObject(parent)
{
    connect(&m_watcher, &QFutureWatcherBase::finished, this, [this] {
        m_running = false;
        emit finished(*m_watcher.result());
    });
}

BackgroundJob::~BackgroundJob()
{
    m_watcher.disconnect(this);
    cancel();
    m_watcher.waitForFinished();
}

void BackgroundJob::start(const Work& work)
{
    LUBBERLINE_EXPECT(!m_running, "one background job at a time");
    m_running = true;
    m_cancelled = false;
    m_percent = -1;
    m_watcher.setFuture(QtConcurrent::run(
        [this, work] { return std::make_shared<Result<JobOutcome>>(work([this](double fraction) { return report(fraction); })); }));
}

bool BackgroundJob::report(double fraction)
{
    const int percent = static_cast<int>(fraction * 100.0);
    if (m_percent.exchange(percent) != percent)
        emit progressed(percent); // queued: receivers live on the window's thread
    return !m_cancelled.load();
}

} // namespace lubberline::ui
