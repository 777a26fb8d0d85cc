#include "ui/due/DueJob.h"

#include <QtConcurrent/QtConcurrentRun>

#include "ui/kit/Words.h"

namespace lubberline::ui {

namespace {

constexpr int kDayLook_ms = 60'000;

}

DueJob::DueJob(db::Stores& stores, std::function<std::string()> today, QObject* parent)
    : QObject(parent)
    , m_stores(stores)
    , m_today(std::move(today))
    , m_cancelled(std::make_shared<std::atomic<bool>>(false))
{
    connect(&m_watcher, &QFutureWatcherBase::finished, this, &DueJob::finish);
    connect(&m_dayTimer, &QTimer::timeout, this, &DueJob::lookAtDay);
    m_dayTimer.start(kDayLook_ms);
}

DueJob::~DueJob()
{
    m_watcher.disconnect(this);
    m_cancelled->store(true);
    m_watcher.waitForFinished();
}

void DueJob::start()
{
    if (m_watcher.isRunning()) {
        m_again = true;
        m_cancelled->store(true);
        return;
    }
    m_again = false;
    m_cancelled = std::make_shared<std::atomic<bool>>(false);
    m_day = m_today();
    m_watcher.setFuture(QtConcurrent::run([&stores = m_stores, today = m_day, cancelled = m_cancelled]() -> Answer {
        auto worker = stores.openForWorker();
        if (!worker)
            return std::make_shared<Result<DueNews>>(worker.error());
        return std::make_shared<Result<DueNews>>(dueNews(**worker, today, [&cancelled](double) { return !cancelled->load(); }));
    }));
}

void DueJob::lookAtDay()
{
    if (!m_day.empty() && m_day != m_today())
        start();
}

void DueJob::finish()
{
    const Answer answer = m_watcher.result();
    if (m_again) {
        start();
        return;
    }
    if (*answer) {
        m_news = std::shared_ptr<const DueNews>(answer, &answer->value());
        emit ready();
    } else if (answer->error().code != ErrorCode::Cancelled) {
        emit failed(messageOf(answer->error()));
    }
}

} // namespace lubberline::ui
