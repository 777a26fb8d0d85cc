#pragma once
/// What a heading is worth that was carried to the aircraft [K 9.2, 9.4]: parts of one standard deviation each.

#include "core/reference/Sun.h"

namespace lubberline {

/// A directional gyro set on a base and carried to the aircraft (the book: 0.1° in all).
struct TransferGyro {
    double setting_deg = 0.05, reading_deg = 0.05;
    double drift_deg_h = 0.5; ///< free drift of a good one 0.25–0.5°/h
    double minutes = 10;      ///< since it was set; a free gyro is good for about ten
};
[[nodiscard]] ErrorBudget budgetOf(const TransferGyro& gyro);

/// Lined up on a runway whose direction is published (the book: better than 0.5°).
struct RunwayAlignment {
    double published_deg = 0.1; ///< its direction; a designator of whole tens has 3°
    double offCentre_m = 0.05;  ///< by how much nose and tail may miss the line, each
    double wheelbase_m = 10;    ///< between the two points that are lined up
};
[[nodiscard]] ErrorBudget budgetOf(const RunwayAlignment& runway);

/// A bearing of the sun with an astrocompass or a shadow pin.
[[nodiscard]] ErrorBudget budgetOf(const Place& place, UtcTime time, const SunSighting& sighting);

/// A heading that comes by synchro: sensor and receiver have a one-cycle and a two-cycle error of about 0.2° each.
struct SynchroTransmission {
    double oneCycle_deg = 0.2, twoCycle_deg = 0.2; ///< amplitudes
};
[[nodiscard]] ErrorBudget budgetOf(const SynchroTransmission& synchro);

/// With what making a magnetic heading of a true one adds.
[[nodiscard]] ErrorBudget withVariation(ErrorBudget budget, double variation_deg);

} // namespace lubberline
