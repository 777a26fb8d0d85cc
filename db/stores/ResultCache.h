#pragma once
/// The results that storage keeps beside the readings, so that trees and histories need no recomputation. Never the truth:
/// written in the same transaction as the readings, recomputed and compared by verify().

#include <array>
#include <optional>

#include "core/record/FleetRows.h"
#include "core/record/Site.h"
#include "core/record/Swing.h"
#include "core/swing/Analysis.h"
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

/// A swing of more readings than this is a log: a change of one reading marks its results as behind, and whoever analyses it keeps them.
inline constexpr std::size_t kRefreshedAtOnce = 2000;
/// Of a log: nothing is known of it until its results are kept or computed again. Inside the caller's transaction.
Result<void> markBehind(Database& database, SwingId swing, CompassId compass);
/// Computes the results of all swings that are behind (a program was killed between).
Result<void> refreshBehind(Database& database);
/// Keeps what was computed elsewhere of the readings as they are stored, and the status of the compass; inside the caller's transaction.
Result<void> keep(Database& database, SwingId swing, CompassId compass, const CachedResult& result);
[[nodiscard]] Status statusOf(Verdict verdict);
/// Recomputes the cache of a stored swing and the status of its compass; inside the caller's transaction.
Result<void> refreshSwing(Database& database, SwingId swing);
/// The same for a swing that is at hand as it is stored (with its id, compass and readings).
Result<void> storeResult(Database& database, const Swing& swing);
/// The status of the latest swing with a result, or one to come, of the row `compass`, as an SQL expression.
[[nodiscard]] QString statusOfLatest(const QString& compass = "c");
/// Recomputes the status of a compass from the cached status of its swings.
Result<void> refreshCompass(Database& database, CompassId compass);
/// Recomputes all swings of the compasses that a profile applies to, or of one compass.
Result<void> refreshSwingsUnder(Database& database, LimitsProfileId profile);
Result<void> refreshSwingsOf(Database& database, CompassId compass);

} // namespace lubberline::db
