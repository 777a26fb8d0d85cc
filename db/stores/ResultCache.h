#pragma once
/// The results that storage keeps beside the readings, so that trees and histories need no recomputation. Never the truth:
/// written in the same transaction as the readings, recomputed and compared by verify().

#include <array>
#include <optional>

#include "core/record/FleetRows.h"
#include "core/record/Site.h"
#include "core/record/Swing.h"
#include "db/engine/Database.h"

namespace lubberline::db {

struct CachedResult {
    int readings = 0;
    std::optional<double> maxAbsDeviation_deg;
    std::array<std::optional<double>, 5> coefficient_deg = {};
    Status status = Status::NotKnown;
};

/// What core computes from the readings that count, held against the limits of the compass.
[[nodiscard]] CachedResult resultOf(const Swing& swing, const std::optional<LimitsProfile>& limits);

/// Recomputes the cache of a stored swing and the status of its compass; inside the caller's transaction.
Result<void> refreshSwing(Database& database, SwingId swing);
/// The same for a swing that is at hand as it is stored (with its id, compass and readings).
Result<void> storeResult(Database& database, const Swing& swing);
/// The status of the latest swing with a result of the row `compass`, as an SQL expression.
[[nodiscard]] QString statusOfLatest(const QString& compass = "c");
/// Recomputes the status of a compass from the cached status of its swings.
Result<void> refreshCompass(Database& database, CompassId compass);
/// Recomputes all swings of the compasses that a profile applies to, or of one compass.
Result<void> refreshSwingsUnder(Database& database, LimitsProfileId profile);
Result<void> refreshSwingsOf(Database& database, CompassId compass);

} // namespace lubberline::db
