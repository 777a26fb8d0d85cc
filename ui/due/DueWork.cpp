#include "ui/due/DueWork.h"

#include <algorithm>

#include "core/fleet/FleetReport.h"
#include "core/swing/MoveRule.h"
#include "db/stores/PopulationStore.h"
#include "db/stores/SwingMarks.h"

namespace lubberline::ui {

namespace {

/// The last swing of the compass, where it was made elsewhere than at the base.
Result<std::optional<SwingRecord>> lastSwingElsewhere(db::Stores& stores, const DueCompass& compass)
{
    const auto rows = stores.swings.swingsOf(compass.compass);
    if (!rows)
        return rows.error();
    for (const auto& row : *rows) {
        if (row.superseded || db::signedMark(stores.database(), row.id, row.state) != db::SignedMark::Stands)
            continue;
        auto record = stores.swings.record(row.id);
        if (!record)
            return record.error();
        if (!record->swing.site.valid() || record->swing.site == compass.base)
            return std::optional<SwingRecord>();
        return std::optional(std::move(record.value()));
    }
    return std::optional<SwingRecord>();
}

} // namespace

int DueNews::due() const
{
    return static_cast<int>(
        std::count_if(lines.begin(), lines.end(), [](const DueLine& line) { return line.answer.state >= DueState::Due; }));
}

Result<std::vector<CompassForecast>> dueForecasts(db::Stores& stores, Date today, const Progress& progress)
{
    const auto half = [&progress](double begin) -> Progress {
        if (!progress)
            return {};
        return [&progress, begin](double fraction) { return progress(begin + fraction / 2); };
    };
    const auto fleet = db::PopulationStore(stores.database()).columns({}, half(0.0));
    if (!fleet)
        return fleet.error();
    const auto ranking = swingNext(*fleet, dayOfDate(today.text()).value_or(0), half(0.5));
    if (!ranking)
        return ranking.error();
    std::vector<CompassForecast> forecasts;
    for (const auto& ranked : ranking->compasses) {
        const auto day = [](int of) { return Date::read(dateOfDay(of)).value_or(Date()); };
        const Date since = ranked.reached50_day ? day(*ranked.reached50_day) : Date();
        forecasts.push_back({fleet->compasses[static_cast<std::size_t>(ranked.compass)].id,
            {ranked.probability, day(ranked.by_day), since, day(ranked.lastSwing_day), inWords(ranked)}});
    }
    std::ranges::sort(forecasts, {}, &CompassForecast::compass);
    return forecasts;
}

Result<DueNews> dueNews(db::Stores& stores, Date today, const Progress& progress, std::vector<CompassForecast> forecasts)
{
    auto compasses = stores.due.compasses();
    auto rules = stores.due.rules();
    auto sites = stores.sites.sites();
    if (!compasses || !rules || !sites)
        return !compasses ? compasses.error() : !rules ? rules.error() : sites.error();
    DueNews news;
    std::vector<MovePrediction> moves;
    for (std::size_t i = 0; i < compasses->size(); ++i) {
        const DueCompass& compass = (*compasses)[i];
        if (progress && !progress(static_cast<double>(i) / static_cast<double>(compasses->size())))
            return Error{ErrorCode::Cancelled, MARKED("ui", "cancelled")};
        const auto base = std::find_if(sites->begin(), sites->end(), [&](const Site& site) { return site.id == compass.base; });
        if (!compass.base.valid() || base == sites->end())
            continue;
        const auto last = lastSwingElsewhere(stores, compass);
        if (!last)
            return last.error();
        if (!*last)
            continue;
        const auto job = stores.jobs.jobOf((*last)->swing.id);
        if (!job)
            return job.error();
        const auto why = whySwingAfterMove(**last, *base, today, *job ? &(*job)->job : nullptr);
        if (!why)
            news.warnings.push_back({MARKED("ui", "%1, %2: %3"), compass.registration, compass.compassName, why.error().message});
        else
            moves.push_back({compass.compass, *why});
    }
    news.rules = std::move(rules.value());
    news.forecasts = std::move(forecasts);
    news.lines = dueList(*compasses, news.rules, moves, today, news.forecasts);
    return news;
}

} // namespace lubberline::ui
