#include "db/transfer/ResultCheck.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "db/engine/Statement.h"
#include "db/stores/ResultCache.h"
#include "db/stores/SiteStore.h"
#include "db/stores/SwingRows.h"
#include "db/stores/SwingStore.h"

namespace lubberline::db {

namespace {

/// Cached figures are degrees of the same computation on the same readings; only another build of the mathematics may differ.
constexpr double kSameResult_deg = 1e-9;

bool same(std::optional<double> a, std::optional<double> b)
{
    return a.has_value() == b.has_value() && (!a || std::abs(*a - *b) <= kSameResult_deg);
}

bool same(const CachedResult& computed, const SwingRow& stored)
{
    if (computed.readings != stored.readings || computed.status != stored.status
        || !same(computed.maxAbsDeviation_deg, stored.maxAbsDeviation_deg))
        return false;
    for (std::size_t i = 0; i < stored.coefficient_deg.size(); ++i)
        if (!same(computed.coefficient_deg[i], stored.coefficient_deg[i]))
            return false;
    return true;
}

Result<std::map<SwingId, SwingRow>> storedRows(Database& database)
{
    Statement statement(database, "SELECT " + swingRowColumns() + " FROM swing");
    const auto listed = shownRowsOf<SwingRow>(statement, swingRowFrom);
    if (!listed)
        return listed.error();
    std::map<SwingId, SwingRow> rows;
    for (const auto& row : *listed)
        rows[row.id] = row;
    return rows;
}

/// Logs whose readings were changed while nobody has computed their results since.
Result<std::set<SwingId>> behindRows(Database& database)
{
    Statement statement(database, "SELECT id FROM swing WHERE results_behind > 0");
    const auto ids = rowsOf<SwingId>(statement, [](Statement& row) { return row.id<SwingId>(0); });
    return ids ? Result<std::set<SwingId>>(std::set<SwingId>(ids->begin(), ids->end())) : Result<std::set<SwingId>>(ids.error());
}

bool showsNothing(const SwingRow& row)
{
    return !row.maxAbsDeviation_deg && row.status == Status::NotKnown
        && std::none_of(row.coefficient_deg.begin(), row.coefficient_deg.end(), [](const auto& one) { return one.has_value(); });
}

Result<std::map<CompassId, std::optional<LimitsProfile>>> limitsByCompass(Database& database)
{
    const auto profiles = SiteStore(database).limitsProfiles();
    if (!profiles)
        return profiles.error();
    Statement statement(database, "SELECT id, limits_id FROM compass");
    const auto pairs = rowsOf<std::pair<CompassId, LimitsProfileId>>(
        statement, [](Statement& row) { return std::pair(row.id<CompassId>(0), row.optionalId<LimitsProfileId>(1)); });
    if (!pairs)
        return pairs.error();
    std::map<CompassId, std::optional<LimitsProfile>> limits;
    for (const auto& [compass, id] : *pairs) {
        auto& slot = limits[compass];
        for (const auto& profile : *profiles)
            if (profile.id == id)
                slot = profile;
    }
    return limits;
}

} // namespace

Result<void> checkResults(Database& database, VerifyReport& report, const Progress& progress)
{
    const auto stored = storedRows(database);
    if (!stored)
        return stored.error();
    const auto limits = limitsByCompass(database);
    if (!limits)
        return limits.error();
    const auto behind = behindRows(database);
    if (!behind)
        return behind.error();
    bool cancelled = false;
    const auto done = SwingStore(database).forEach([&](const Swing& swing) {
        ++report.swings;
        report.readings += static_cast<std::int64_t>(swing.readings.size());
        const auto row = stored->find(swing.id);
        const auto profile = limits->find(swing.compass);
        if (row != stored->end() && behind->contains(swing.id) && showsNothing(row->second)) {
            report.notes.push_back(
                {MARKED("db",
                     "the swing of %1 (record %2): its readings were changed last and its results are not computed since; "
                     "the next program that opens this file to write does it"),
                    swing.date, swing.record});
        } else if (row == stored->end() || profile == limits->end() || !same(resultOf(swing, profile->second), row->second)) {
            report.findings.push_back({MARKED("db", "results: those kept for the swing of %1 (record %2) are not what its readings give"),
                swing.date, swing.record});
        }
        cancelled
            = progress && report.swings % 64 == 0 && !progress(static_cast<double>(report.swings) / static_cast<double>(stored->size()));
        return !cancelled;
    });
    if (!done)
        return done;
    if (cancelled)
        return Error{ErrorCode::Cancelled, MARKED("db", "cancelled"), database.path().toStdString()};
    if (progress)
        progress(1.0);
    return {};
}

} // namespace lubberline::db
