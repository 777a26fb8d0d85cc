#include "db/stores/ResultStore.h"

#include <algorithm>
#include <utility>

#include "core/deviation/SmithFit.h"
#include "core/fleet/SoftIron.h"
#include "db/saving/Saving.h"
#include "db/stores/CoilStore.h"
#include "db/stores/JobStore.h"
#include "db/stores/PopulationStore.h"
#include "db/stores/ResultCache.h"
#include "db/stores/SwingStore.h"

namespace lubberline::db {

namespace {

/// D and E of its type out of the years; none: too few aircraft tell them.
/// @param siblings without this aircraft itself, and out of as many swings as a page that opens has time for
Result<std::optional<SoftIronStandard>> standardOfType(Database& database, const SwingRecord& record, bool siblings)
{
    constexpr int kManySwings = 500;
    if (record.type.name.empty() || (siblings && !record.swing.id.valid()))
        return std::optional<SoftIronStandard>();
    FleetSelection selection;
    selection.type = record.type.name;
    selection.compass = record.compass.name;
    auto fleet = PopulationStore(database).columns(selection, {}, siblings ? kManySwings : 0);
    if (!fleet)
        return fleet.error();
    if (siblings)
        std::erase_if(fleet->swings, [&](const FleetSwing& swing) {
            return fleet->compasses[static_cast<std::size_t>(swing.compass)].aircraft == record.aircraft.registration;
        });
    const auto curves = curvesOf(*fleet);
    if (!curves)
        return curves.error();
    const auto standards = softIronOf(*fleet, *curves);
    return standards.empty() ? std::nullopt : std::optional(standards.front());
}

/// What the years of its type say of D and E in the place of what its headings do not tell.
Result<std::optional<TypeSoftIron>> softIronOfType(Database& database, const SwingRecord& record)
{
    const auto standardFound = standardOfType(database, record, false);
    if (!standardFound)
        return standardFound.error();
    if (!*standardFound)
        return std::optional<TypeSoftIron>();
    TypeSoftIron type;
    const SoftIronStandard& standard = **standardFound;
    const auto estimate = [](const SoftIronCoefficient& one) {
        return Estimate{std::sin(toRadians(one.mean_deg)), toRadians(one.next_deg)}; // 𝔇 = sin D [P 5]
    };
    if (standard.D) {
        type.D = estimate(*standard.D);
        type.words = inWords(*standard.D, 'D');
    }
    if (standard.E) {
        type.E = estimate(*standard.E);
        type.words = standard.D ? Message{MARKED("db", "%1; %2"), type.words, inWords(*standard.E, 'E')} : inWords(*standard.E, 'E');
    }
    return std::optional(std::move(type));
}

/// None where the swing before told less than five coefficients.
std::optional<ExpectedCurve> historyOf(const SwingRow& before, const Swing& swing)
{
    const auto last = smithOfKept(before.coefficient_deg);
    return last ? std::optional(expectedAfter(*last, before.kind, before.stage, swing)) : std::nullopt;
}

CachedResult cachedOf(const SwingRecord& record, const Analysis& analysis)
{
    CachedResult result;
    const auto& readings = record.swing.readings;
    result.readings = static_cast<int>(std::count_if(readings.begin(), readings.end(), [](const Reading& one) { return one.complete(); }));
    result.maxAbsDeviation_deg = toDegrees(analysis.summary.maxAbsDeviation_rad);
    for (std::size_t i = 0; i < result.coefficient_deg.size(); ++i)
        if (const auto& value_rad = analysis.approximate.value[i])
            result.coefficient_deg[i] = toDegrees(*value_rad);
    result.status = statusOf(judge(analysis.summary, record.limits).verdict);
    return result;
}

} // namespace

Result<std::optional<ExpectedCurve>> ResultStore::siblingsOf(const SwingRecord& record)
{
    const auto before = SwingStore(m_database).previousRow(record.swing.id);
    if (!before)
        return before.error();
    if (*before && historyOf(**before, record.swing))
        return std::optional<ExpectedCurve>();
    const auto standard = standardOfType(m_database, record, true);
    if (!standard)
        return standard.error();
    return *standard ? std::optional(expectedOf(**standard)) : std::nullopt;
}

Result<SwingQuestion> ResultStore::questionOf(const SwingRecord& record)
{
    const auto siblings = siblingsOf(record);
    return siblings ? questionOf(record, *siblings) : Result<SwingQuestion>(siblings.error());
}

Result<SwingQuestion> ResultStore::questionOf(const SwingRecord& record, const std::optional<ExpectedCurve>& siblings)
{
    const auto job = JobStore(m_database).jobOf(record.swing.id);
    if (!job)
        return job.error();
    const auto before = SwingStore(m_database).previousRow(record.swing.id);
    if (!before)
        return before.error();
    const auto own = *before ? historyOf(**before, record.swing) : std::nullopt;
    const auto kept = CoilStore(m_database).before(record.compass.id, record.swing.date, record.compass.serialNumber);
    if (!kept)
        return kept.error();
    std::optional<SensorBench> bench;
    if (*kept) {
        const auto told = sensorBenchOf(**kept);
        if (!told)
            return told.error();
        bench = *told;
    }
    return lubberline::questionOf(record, *job ? &(*job)->job : nullptr, {.history = own ? own : siblings}, bench);
}

Result<SwingQuestion> ResultStore::questionOf(SwingId swing)
{
    const auto record = SwingStore(m_database).record(swing, ReadingParts::Headings);
    return record ? questionOf(*record) : Result<SwingQuestion>(record.error());
}

Result<Analysis> ResultStore::resultOf(const SwingRecord& record)
{
    const auto question = questionOf(record);
    return question ? answerTo(*question) : Result<Analysis>(question.error());
}

Result<Analysis> ResultStore::resultOf(SwingId swing)
{
    const auto question = questionOf(swing);
    return question ? answerTo(*question) : Result<Analysis>(question.error());
}

Result<int> ResultStore::behind(SwingId swing)
{
    Statement statement(m_database, "SELECT results_behind FROM swing WHERE id = ?");
    statement << swing;
    return oneOf<int>(statement, m_database, MARKED("db", "swing"), [](Statement& row) { return static_cast<int>(row.integer(0)); });
}

Result<void> ResultStore::keep(const SwingRecord& record, const Analysis& analysis, int behind, ReadingId changed)
{
    const SwingId swing = record.swing.id;
    return noting(
        m_database,
        [&]() -> Result<void> {
            const auto now = this->behind(swing);
            if (!now)
                return now.error();
            return *now == behind ? lubberline::db::keep(m_database, swing, record.swing.compass, cachedOf(record, analysis))
                                  : Result<void>();
        },
        [&] {
            m_database.changes().note(change::OfSwing{swing, changed});
        });
}

Result<void> ResultStore::catchUp(SwingId swing)
{
    const auto now = behind(swing);
    if (!now)
        return now.error();
    return *now == 0
        ? Result<void>()
        : noting(
            m_database, [&] { return refreshSwing(m_database, swing); }, [&] { m_database.changes().note(change::OfSwing{swing}); });
}

Result<SwingAtPlace> ResultStore::placeOf(const SwingRecord& record)
{
    const auto found = JobStore(m_database).jobOf(record.swing.id);
    if (!found)
        return found.error();
    const SwingJob* job = *found ? &(*found)->job : nullptr;
    auto place = swingAtPlace(record, job);
    if (place)
        return place;
    const auto result = lubberline::resultOf(record, job, {.maxOrder = 0, .findSlips = false});
    if (!result || result->exact.parameters != static_cast<int>(kCoefficientCount) - 1)
        return place;
    const auto type = softIronOfType(m_database, record);
    return type && *type ? swingAtPlace(record, job, *type) : std::move(place);
}

} // namespace lubberline::db
