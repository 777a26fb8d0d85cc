#include "ui/bench/BenchJob.h"

#include <QtConcurrent/QtConcurrentRun>

#include "ui/kit/Words.h"

namespace lubberline::ui {

BenchJob::BenchJob(QObject* parent) : QObject(parent)
{
    m_pool.setMaxThreadCount(1);
    connect(&m_watcher, &QFutureWatcherBase::finished, this, &BenchJob::finish);
}

BenchJob::~BenchJob()
{
    m_watcher.disconnect(this);
    cancel();
    m_pool.waitForDone();
}

void BenchJob::cancel()
{
    if (m_shared)
        m_shared->cancelled.store(true);
}

void BenchJob::start(const IronBench& bench, const BenchStates& states)
{
    cancel();
    auto shared = std::make_shared<Shared>();
    m_shared = shared;
    m_watcher.setFuture(QtConcurrent::run(&m_pool, [this, bench, states, shared]() -> Answer {
        const auto progress = [this, &shared](double fraction) {
            const int percent = static_cast<int>(100 * fraction);
            if (shared->percent.exchange(percent) != percent)
                QMetaObject::invokeMethod(
                    this,
                    [this, shared, percent] {
                        if (shared == m_shared) // of the newest work only
                            emit progressed(percent);
                    },
                    Qt::QueuedConnection);
            return !shared->cancelled.load();
        };
        return std::make_shared<const Result<BenchModel>>(benchModel(bench, states, progress));
    }));
}

void BenchJob::finish()
{
    const Answer answer = m_watcher.result();
    if (*answer)
        emit ready(answer->value());
    else if (answer->error().code == ErrorCode::Cancelled)
        emit cancelled();
    else
        emit failed(messageOf(answer->error()));
}

} // namespace lubberline::ui
