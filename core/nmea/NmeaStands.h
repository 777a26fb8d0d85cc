#pragma once
/// An aircraft that stands says one heading over and over. Its readings, hundreds of them before a turn begins, would weigh as much as the
/// turn, and what is wrong with one of them is wrong with all: they make no coefficient surer. A stand counts for its last moments only.

#include <span>
#include <vector>

#include "core/nmea/HeadingLine.h"
#include "core/nmea/NmeaSwing.h"

namespace lubberline {

/// Of each stand so much is used, the last of it: the card has settled by then.
inline constexpr double kStand_s = 20.0;

/// Marks as not used what repeats the reading before it much sooner than the next was due (a logger that writes its buffer again), and of
/// stands all but their last kStand_s.
/// A swing on steady headings stands on three of them or more: there the stands are the readings, and one is cut to the usual length.
/// @param rates [deg/s] of the used pairs, in order. @param spacing_s from one reading to the next, as usual. @return how many were left out.
int leaveOutStands(std::vector<NmeaPair>& pairs, std::span<const double> rates, double spacing_s);

/// How fast a line turns while it turns [deg, to a step]: the mean over degrees that were turned, so that a stand before it counts nothing.
[[nodiscard]] double turnOfStep_deg(const HeadingLine& steps);

} // namespace lubberline
