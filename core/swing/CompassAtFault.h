#pragma once
/// What is wrong with the compass or the list as a whole is said before any coefficient: coefficients of it mean nothing.

#include <optional>
#include <span>
#include <vector>

#include "core/deviation/SmithFit.h"
#include "core/deviation/SwingSlips.h"

namespace lubberline {

/// An error that names it when the compass reads the same on headings all round (stuck, or one figure copied down), keeps within 45° all
/// the while, or falls as the aircraft turns right (a mirrored card, figures of the other scale). Fewer than three readings, or readings within 45°, tell neither.
[[nodiscard]] std::optional<Error> faultOf(std::span<const Observation> readings);

/// Likewise by what the fits make of it: coefficients that no compass has, or a scatter that no reading explains, unless the exact ones leave
/// next to nothing (a compass that folds is none of these).
[[nodiscard]] std::optional<Error> faultOf(const ApproximateFit& approximate, const ExactFit& exact);

/// A stretch on which the compass falls while the aircraft turns right.
struct Fold {
    MagneticHeading from, to;
    CompassHeading reads, readsThen; ///< there
};
/// The widest stretch of a list (no log) on which two neighbours or more fall one after the other, by 3° or more in all: one reading that
/// was misread falls once. None else, and none of headings further than 60° apart.
[[nodiscard]] std::optional<Fold> foldOf(std::span<const Observation> readings);
[[nodiscard]] Message foldWords(const Fold& fold);

/// The readings without which the others are those of a compass: reciprocals, figures of another row. None: the whole list is at fault.
[[nodiscard]] std::vector<std::size_t> astrayReadings(
    std::span<const Observation> readings, double resolution_deg, const std::optional<ExpectedCurve>& history);

/// The words for an index that is no deviation any more (largeIndex_deg of SmithFit.h), none for 0.
[[nodiscard]] std::optional<Message> indexWords(double index_deg);
/// What the coefficients mean beside such an index; none for 0.
[[nodiscard]] std::optional<Message> indexMeaning(double index_deg);
/// The words for an A that is one step of evenly listed headings, as readings that stand one row off make it: what A, B and C would be. Else
/// for an A of 15° and more that is no such index yet: what B and C will be when the mount has been set right. None below.
[[nodiscard]] std::optional<Message> mountWords(std::span<const Observation> readings, const ApproximateFit& fit);

} // namespace lubberline
