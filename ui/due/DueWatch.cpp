#include "ui/due/DueWatch.h"

#include "ui/kit/Words.h"

namespace lubberline::ui {

namespace {

constexpr int kDayLook_ms = 60'000;

}

DueWatch::DueWatch(db::Stores& stores, std::function<Date()> today, QObject* parent)
    : QObject(parent)
    , m_stores(stores)
    , m_today(std::move(today))
    , m_worker([this](Result<DueNews> news) { take(std::move(news)); })
{
    connect(&m_dayTimer, &QTimer::timeout, this, &DueWatch::lookAtDay);
    m_dayTimer.start(kDayLook_ms);
}

void DueWatch::start()
{
    m_day = m_today();
    m_worker.start([&stores = m_stores, today = m_day](const Progress& progress) -> Result<DueNews> {
        auto own = stores.openForWorker();
        if (!own)
            return own.error();
        return dueNews(**own, today, progress);
    });
}

void DueWatch::lookAtDay()
{
    if (!m_day.empty() && m_day != m_today())
        start();
}

void DueWatch::take(Result<DueNews> news)
{
    if (news) {
        m_news = std::make_shared<const DueNews>(std::move(news.value()));
        emit ready();
    } else {
        emit failed(messageOf(news.error()));
    }
}

} // namespace lubberline::ui
