#include "ui/due/DueWatch.h"

#include "ui/kit/Words.h"

namespace lubberline::ui {

namespace {

constexpr int kDayLook_ms = 60'000;
constexpr int kQuiet_ms = 2'000; ///< without a change, before all swings are read: neither the start nor typing is slowed by them

} // namespace

DueWatch::DueWatch(db::Stores& stores, std::function<Date()> today, QObject* parent)
    : QObject(parent)
    , m_stores(stores)
    , m_today(std::move(today))
    , m_worker([this](Result<DueNews> news) { take(std::move(news)); })
{
    connect(&m_dayTimer, &QTimer::timeout, this, &DueWatch::lookAtDay);
    m_dayTimer.start(kDayLook_ms);
    m_quietTimer.setSingleShot(true);
    connect(&m_quietTimer, &QTimer::timeout, this, &DueWatch::forecast);
}

void DueWatch::start()
{
    m_day = m_today();
    m_quietTimer.stop();
    m_worker.start([&stores = m_stores, today = m_day, known = m_news](const Progress& progress) -> Result<DueNews> {
        auto own = stores.openForWorker();
        if (!own)
            return own.error();
        return dueNews(**own, today, progress, known ? known->forecasts : std::vector<CompassForecast>());
    });
}

void DueWatch::forecast()
{
    m_worker.start([&stores = m_stores, today = m_day](const Progress& progress) -> Result<DueNews> {
        auto own = stores.openForWorker();
        if (!own)
            return own.error();
        auto forecasts = dueForecasts(**own, today, progress);
        if (!forecasts)
            return forecasts.error();
        auto news = dueNews(**own, today, progress, std::move(forecasts.value()));
        if (news)
            news->forecastsAreNew = true;
        return news;
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
        if (!news->forecastsAreNew)
            m_quietTimer.start(kQuiet_ms);
        m_news = std::make_shared<const DueNews>(std::move(news.value()));
        emit ready();
    } else {
        emit failed(messageOf(news.error()));
    }
}

} // namespace lubberline::ui
