#pragma once
/// The sun as a datum: a shadow pin or an astrocompass on the aircraft, anywhere.

#include <optional>
#include <span>

#include "core/procedure/DatumHeading.h"
#include "core/procedure/JobState.h"
#include "core/record/SharedErrors.h"
#include "core/reference/Sun.h"

namespace lubberline {

/// Whether the figures of this kind of instrument are bearings of the sun's shadow from the nose, and so need place and time.
[[nodiscard]] bool needsSun(DatumKind kind);

/// heading = azimuth of the sun − its bearing from the nose (clockwise); that of a shadow less 180°.
[[nodiscard]] TrueHeading headingBySun(const SunPosition& sun, double bearing_deg, bool ofShadow);

/// Whether the sun is behind its figures: a shadow pin, or an astrocompass, which is set for place and time and shows true headings.
[[nodiscard]] bool takesSun(DatumKind kind);

/// Of the figures of a shadow pin or an astrocompass at one place and time: the magnetic heading, uncertain by the sun's own error, too
/// (core/reference/Sun.h). The instrument's zero is added to the heading, not to the bearing.
/// Errors: those of datumHeading(); InvalidInput: no variation; the sun is below the horizon.
struct SunHeading {
    DatumHeading heading;
    std::vector<Message> warnings; ///< the sun stands so high that it tells little, or so low that its shadow is faint
};
Result<SunHeading> sunHeading(const DatumInstrument& instrument, const RawFigures& raw, const Place& place, UtcTime time,
    std::optional<Variation> variation, const SunSighting& sighting = {});

/// A heading of a swing of which some, or all, were taken by the sun.
struct TakenHeading {
    TrueHeading heading;
    CompassHeading compass;
    std::optional<UtcTime> bySun; ///< when; none: by another instrument
    bool fromTrue = true;         ///< made magnetic with the variation
    double runway_deg = 0;        ///< standard error of the direction of the runway that it was lined up with
    double setting_deg = 0;       ///< of the transfer gyro on its base
    double drift_deg = 0;         ///< by how much that has drifted until then
};
/// What the headings by the sun share: clock, position and variation, which are in A, and a pin or level that leans with the aircraft
/// (`plumb`), which is in B and C; and what a runway's direction and a transfer gyro share. What is read anew on each heading (pointing,
/// lining up) their scatter shows.
[[nodiscard]] SharedErrors sharedBySun(
    const Place& place, std::span<const TakenHeading> headings, const SunSighting& sighting, double variationError_deg);
/// The same of a guided swing at its base, with what such a datum commonly has (the defaults of SunSighting, RunwayAlignment and
/// TransferGyro in core/reference/Alignment.h); headings that are true are uncertain by the variation, too, where that is the model's.
/// A runway read in whole tens of degrees is its designator (3°). A transfer gyro was set TransferGyro::minutes before the first reading
/// that was taken by it; a datum that is changed, to the same one again, too, begins anew. @param place none: not known; of the sun and
/// the model nothing is said then.
[[nodiscard]] SharedErrors sharedErrorsOf(const SwingJob& job, const Swing& swing, const std::optional<Place>& place);

/// What a clock that is an hour fast adds to A (magnetic − compass) of a swing read at these times [deg]; slow: about the opposite.
[[nodiscard]] double hourInA_deg(const Place& place, std::span<const UtcTime> times, int hours = 1);
/// Says so where an A looks like daylight saving, like bearings of the sun for those of its shadow, or like a longitude of the other sign;
/// else empty.
[[nodiscard]] Message sunDoubt(const Place& place, std::span<const UtcTime> times, double A_deg);
/// The same of a guided swing by the sun as soon as four of its readings or more, all around, tell an A; empty before, and by another datum.
[[nodiscard]] Message sunDoubt(const SwingJob& job, const JobState& state, const Place& place);

} // namespace lubberline
