#pragma once
/// The Earth's field that goes with a swing: computed once, kept with it, and held against what would be computed now.
/// A site's elevation is taken as height above the ellipsoid: the 100 m between the two change no figure of a compass.

#include <optional>

#include "core/base/Message.h"
#include "core/record/Site.h"
#include "core/record/Swing.h"

namespace lubberline {

/// At the site on the day of the swing, by the default model of that day. None where latitude, longitude or date are not
/// stated, in the blackout zone (H < 2000 nT), and outside the years of every model.
[[nodiscard]] std::optional<FieldStamp> stampFor(const Swing& swing, const std::optional<Site>& site);

/// What a new swing without a stamp is given; what was signed without one stays so.
void stampUnlessSigned(Swing& swing, const std::optional<Site>& site);

enum class StampState {
    None,         ///< the swing keeps no stamp
    Current,      ///< what would be computed now; or nothing can be computed to hold it against
    ModelChanged, ///< the same place and day have another field by the model of today
    PlaceChanged, ///< site or date of the swing are others than those of the stamp
};

/// Half of the last digit that the models' own tables print: what differs by less is the same field.
inline constexpr double kSameField_nT = 0.05;
[[nodiscard]] StampState stateOf(const Swing& swing, const std::optional<Site>& site);

/// What the swing states less the stamp's declination [deg, east positive], wrapped to (−180, 180]; none where either is
/// missing.
[[nodiscard]] std::optional<double> variationBeyondStamp_deg(const Swing& swing);
/// More than models and charts differ by: one of the two is wrong.
inline constexpr double kDoubtfulVariation_deg = 1.0;

/// What the base states, what its survey found (the mean of its points), what the model has there and then, and what the swing states, in
/// words, where two of them are a degree or more apart; empty: they agree, or only one is known.
/// @param model none: not known; swing_deg [deg, east positive].
[[nodiscard]] Message variationDisagreement(
    const std::optional<Site>& site, const std::optional<FieldStamp>& model, std::optional<double> swing_deg = {});

/// The same as a standard error of A [deg]: how far what was applied is from the others, where magnetic headings were made of true ones
/// and that is a degree or more; else 0.
[[nodiscard]] double variationDoubt_deg(const Swing& swing, const std::optional<Site>& site);

} // namespace lubberline
