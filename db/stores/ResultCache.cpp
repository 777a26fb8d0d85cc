#include "db/stores/ResultCache.h"

#include "core/swing/Observations.h"

#include "core/swing/Analysis.h"
#include "db/engine/Statement.h"
#include "db/stores/SiteStore.h"
#include "db/stores/SwingStore.h"

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
        "UPDATE swing SET reading_count = ?, max_abs_deviation_deg = ?, a_deg = ?, b_deg = ?, c_deg = ?, d_deg = ?, e_deg = ?, status = ?"
        " WHERE id = ?");
    statement << result.readings << result.maxAbsDeviation_deg;
    for (const auto& coefficient_deg : result.coefficient_deg)
        statement << coefficient_deg;
    statement << static_cast<int>(result.status) << swing;
    return statement.run();
}

Status statusOf(Verdict verdict)
{
    switch (verdict) {
    case Verdict::InLimits: return Status::InLimits;
    case Verdict::OutOfLimits: return Status::OutOfLimits;
    case Verdict::NotKnown: break;
    }
    return Status::NotKnown;
}

} // namespace

CachedResult resultOf(const Swing& swing, const std::optional<LimitsProfile>& limits)
{
    CachedResult result;
    for (const auto& reading : swing.readings)
        result.readings += reading.complete() ? 1 : 0;
    const auto outline = outlineOf(observationsOf(swing));
    if (!outline)
        return result;
    result.maxAbsDeviation_deg = toDegrees(outline->summary.maxAbsDeviation_rad);
    for (std::size_t i = 0; i < result.coefficient_deg.size(); ++i)
        if (outline->approximate_rad[i])
            result.coefficient_deg[i] = toDegrees(*outline->approximate_rad[i]);
    result.status = statusOf(judge(outline->summary, limits).verdict);
    return result;
}

Result<void> refreshSwing(Database& database, SwingId id)
{
    const auto swing = SwingStore(database).swing(id, ReadingParts::Headings);
    if (!swing)
        return swing.error();
    return storeResult(database, *swing);
}

Result<void> storeResult(Database& database, const Swing& swing)
{
    const auto limits = SiteStore(database).limitsOf(swing.compass);
    if (!limits)
        return limits.error();
    if (const auto written = write(database, swing.id, resultOf(swing, *limits)); !written)
        return written;
    return refreshCompass(database, swing.compass);
}

QString statusOfLatest(const QString& compass)
{
    return "COALESCE((SELECT s.status FROM swing s WHERE s.compass_id = " + compass
        + ".id AND s.max_abs_deviation_deg IS NOT NULL"
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
