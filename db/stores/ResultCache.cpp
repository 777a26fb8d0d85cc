#include "db/stores/ResultCache.h"

#include <algorithm>

#include "core/record/Ranges.h"
#include "core/swing/Analysis.h"
#include "core/swing/Observations.h"
#include "db/engine/Statement.h"
#include "db/stores/SiteStore.h"

namespace lubberline::db {

namespace {

Result<std::vector<SwingId>> swingIds(Statement& statement)
{
    return rowsOf<SwingId>(statement, [](Statement& row) { return row.id<SwingId>(0); });
}

Result<void> refreshAll(Database& database, const Result<std::vector<SwingId>>& ids)
{
    if (!ids)
        return ids.error();
    for (const SwingId id : *ids)
        if (const auto done = refreshSwing(database, id); !done)
            return done;
    return {};
}

Result<void> write(Database& database, SwingId swing, const CachedResult& result)
{
    Statement statement(database,
        "UPDATE swing SET reading_count = ?, max_abs_deviation_deg = ?, a_deg = ?, b_deg = ?, c_deg = ?, d_deg = ?, e_deg = ?, status = ?,"
        " results_behind = 0 WHERE id = ?");
    statement << result.readings << result.maxAbsDeviation_deg;
    for (const auto& coefficient_deg : result.coefficient_deg)
        statement << coefficient_deg;
    statement << static_cast<int>(result.status) << swing;
    return statement.run();
}

/// @param complete how many readings have both headings. @param used those that are not left out.
CachedResult resultOf(int complete, const std::vector<Observation>& used, const std::optional<LimitsProfile>& limits)
{
    CachedResult result;
    result.readings = complete;
    const auto outline = outlineOf(used);
    if (!outline)
        return result;
    result.maxAbsDeviation_deg = toDegrees(outline->summary.maxAbsDeviation_rad);
    for (std::size_t i = 0; i < result.coefficient_deg.size(); ++i)
        if (outline->approximate_rad[i])
            result.coefficient_deg[i] = toDegrees(*outline->approximate_rad[i]);
    result.status = statusOf(judge(outline->summary, limits).verdict);
    return result;
}

/// What results need of a stored swing: a log has many readings, and a keystroke in it does not wait for their other columns.
struct StoredHeadings {
    CompassId compass;
    std::optional<double> indexRemoved_deg;
    int complete = 0;
    std::vector<Observation> used = {};
};

Result<StoredHeadings> headingsOf(Database& database, SwingId id)
{
    Statement swing(database, "SELECT compass_id, index_removed_deg FROM swing WHERE id = ?");
    swing << id;
    auto headings = oneOf<StoredHeadings>(swing, database, MARKED("db", "swing"), [](Statement& row) {
        return StoredHeadings{row.id<CompassId>(0), row.optionalReal(1, kSignedAngleRange)};
    });
    if (!headings)
        return headings;
    Statement readings(database,
        "SELECT magnetic_heading_deg, compass_heading_deg, COALESCE(exclusion_reason, '') <> '' FROM reading WHERE swing_id = ?"
        " AND magnetic_heading_deg IS NOT NULL AND compass_heading_deg IS NOT NULL ORDER BY position, id");
    readings << id;
    if (const auto done = readings.run(); !done)
        return done.error();
    for (; readings.next(); ++headings->complete)
        if (!readings.flag(2))
            headings->used.push_back(
                observationOf(headings->indexRemoved_deg, MagneticHeading::fromDegrees(readings.real(0, kHeadingRange)),
                    CompassHeading::fromDegrees(readings.real(1, kHeadingRange))));
    if (const auto whole = readings.finished(); !whole)
        return whole.error();
    return headings;
}

} // namespace

Status statusOf(Verdict verdict)
{
    switch (verdict) {
    case Verdict::InLimits: return Status::InLimits;
    case Verdict::OutOfLimits: return Status::OutOfLimits;
    case Verdict::NotKnown: break;
    }
    return Status::NotKnown;
}

Result<void> keep(Database& database, SwingId swing, CompassId compass, const CachedResult& result)
{
    if (const auto written = write(database, swing, result); !written)
        return written;
    return refreshCompass(database, compass);
}

Result<void> markBehind(Database& database, SwingId swing, CompassId compass)
{
    Statement statement(database,
        "UPDATE swing SET results_behind = results_behind + 1, max_abs_deviation_deg = NULL, a_deg = NULL, b_deg = NULL, c_deg = NULL,"
        " d_deg = NULL, e_deg = NULL, status = ? WHERE id = ?");
    statement << static_cast<int>(Status::NotKnown) << swing;
    const auto done = statement.run();
    return done ? refreshCompass(database, compass) : done;
}

Result<void> refreshBehind(Database& database)
{
    Statement statement(database, "SELECT id FROM swing WHERE results_behind > 0");
    return refreshAll(database, swingIds(statement));
}

CachedResult resultOf(const Swing& swing, const std::optional<LimitsProfile>& limits)
{
    const auto& readings = swing.readings;
    const auto complete = std::count_if(readings.begin(), readings.end(), [](const Reading& one) { return one.complete(); });
    return resultOf(static_cast<int>(complete), observationsOf(swing), limits);
}

Result<void> refreshSwing(Database& database, SwingId id)
{
    const auto headings = headingsOf(database, id);
    if (!headings)
        return headings.error();
    const auto limits = SiteStore(database).limitsOf(headings->compass);
    if (!limits)
        return limits.error();
    return keep(database, id, headings->compass, resultOf(headings->complete, headings->used, *limits));
}

Result<void> storeResult(Database& database, const Swing& swing)
{
    const auto limits = SiteStore(database).limitsOf(swing.compass);
    if (!limits)
        return limits.error();
    return keep(database, swing.id, swing.compass, resultOf(swing, *limits));
}

QString statusOfLatest(const QString& compass)
{
    return "COALESCE((SELECT s.status FROM swing s WHERE s.compass_id = " + compass
        + ".id AND (s.max_abs_deviation_deg IS NOT NULL OR s.results_behind > 0)"
          " ORDER BY s.date DESC, s.stage DESC, s.id DESC LIMIT 1), 0)";
}

Result<void> refreshCompass(Database& database, CompassId compass)
{
    Statement statement(database, "UPDATE compass SET status = " + statusOfLatest("compass") + " WHERE id = ?");
    statement << compass;
    return statement.run();
}

Result<void> refreshSwingsUnder(Database& database, LimitsProfileId profile)
{
    Statement statement(database, "SELECT s.id FROM swing s JOIN compass c ON c.id = s.compass_id WHERE c.limits_id = ?");
    statement << profile;
    return refreshAll(database, swingIds(statement));
}

Result<void> refreshSwingsOf(Database& database, CompassId compass)
{
    Statement statement(database, "SELECT id FROM swing WHERE compass_id = ?");
    statement << compass;
    return refreshAll(database, swingIds(statement));
}

} // namespace lubberline::db
