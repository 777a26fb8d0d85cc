#pragma once
/// What an electrical swing (core/record/ElectricalSwing.h) tells, and whether it passes. Errors are indicated − selected, as
/// in its sources.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/base/Result.h"
#include "core/record/ElectricalSwing.h"
#include "core/record/Swing.h"

namespace lubberline {

/// 0, 15 … 345 with nothing indicated.
[[nodiscard]] std::vector<SelectedHeading> everyFifteenDegrees();

struct FourPointErrors {
    std::array<double, 4> error_deg{}; ///< indicated − selected at 0, 90, 180, 270
    double northSouth_deg = 0;         ///< (e0 − e180)/2: taken out at 0
    double eastWest_deg = 0;           ///< (e90 − e270)/2: taken out at 90
    double index_deg = 0;              ///< mean of the four
    double pair0_180_deg = 0;          ///< |e0 − e180|
    double pair90_270_deg = 0;
    bool pairsAgree = false; ///< both within 0.2° (TM 11-4920-292-15, p. 190)
};
inline constexpr double kPairLimit_deg = 0.2;

/// Errors: InvalidInput (a point is missing; further than 30° from what was selected: a slip).
Result<FourPointErrors> errorsOf(const FourPointTable& table);

struct SelfCheck {
    double largest_deg = 0; ///< largest |electrical − turntable| after the mean of each is taken out
    double mean_deg = 0;    ///< mean of |…|
    int beyondSixMinutes = 0;
    bool passed = false; ///< ≤ 8′ everywhere; one beyond 6′ only if the mean is ≤ 4′ (TM 11-4920-292-15, p. 157)
};
/// Errors: InvalidInput (fewer than 24 of either, or different headings).
Result<SelfCheck> selfCheckOf(const ElectricalSwing& swing);

/// What the 24 headings tell by themselves. No source has a limit for them.
struct ElectricalErrors {
    int read = 0;             ///< headings that something is indicated for
    double largest_deg = 0;   ///< the error of the largest size
    double largestAt_deg = 0; ///< selected there
    double mean_deg = 0;      ///< of the errors: the index
    int slips = 0;            ///< further than 30° from what was selected
    double againstF1_deg = 0; ///< largest difference to table F1 after the adjustment, where both have the heading
    double againstF1At_deg = 0;
};
/// None where nothing is indicated.
[[nodiscard]] std::optional<ElectricalErrors> electricalErrorsOf(const ElectricalSwing& swing);

/// What is still missing or wrong before the record may be signed; empty: nothing.
[[nodiscard]] std::vector<Message> openPoints(const ElectricalSwing& swing);

/// The calibration swing, as left, that the headings of an electrical swing are: selected as magnetic, indicated as compass; those
/// that nobody indicated are left out. What stands in its particulars is English, whatever the window speaks: it is stored.
[[nodiscard]] Swing swingFrom(const ElectricalSwing& electrical);

} // namespace lubberline
