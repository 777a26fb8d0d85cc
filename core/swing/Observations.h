#pragma once
/// What the fits take of a swing.

#include <optional>
#include <vector>

#include "core/deviation/Smith.h"
#include "core/record/Swing.h"

namespace lubberline {

/// A complete reading as the compass stands since: where the compass was turned in its mount after the swing by the index A
/// that is kept in Swing::indexRemoved_deg, it reads A more, so that the deviation is the one that was read − A.
[[nodiscard]] Observation observationOf(const Swing& swing, const Reading& reading);
/// The same of the headings alone, as storage has them. @param indexRemoved_deg Swing::indexRemoved_deg.
[[nodiscard]] Observation observationOf(std::optional<double> indexRemoved_deg, MagneticHeading magnetic, CompassHeading compass);
/// What the fits take: the complete readings that are not excluded, as the compass stands since.
[[nodiscard]] std::vector<Observation> observationsOf(const Swing& swing);

} // namespace lubberline
