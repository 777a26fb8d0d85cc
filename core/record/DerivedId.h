#pragma once
/// Identities for records that come without one, as those of a CSV do: derived from what they are, so that a second import, and
/// the import of another swing of the same aircraft, find the records that are there.

#include <string_view>

#include "core/record/Aircraft.h"
#include "core/record/Site.h"
#include "core/record/Swing.h"

namespace lubberline {

[[nodiscard]] RecordId recordIdOfType(std::string_view name);
[[nodiscard]] RecordId recordIdOfAircraft(std::string_view registration);
[[nodiscard]] RecordId recordIdOfCompass(std::string_view registration, std::string_view name);
[[nodiscard]] RecordId recordIdOfSensor(std::string_view registration, std::string_view compass, std::string_view name);
[[nodiscard]] RecordId recordIdOfSite(std::string_view name);
[[nodiscard]] RecordId recordIdOfLimits(std::string_view name);

/// From every particular (of a field stamp: its place) and every reading as values, not as they were written: 90 and 90.0 are
/// the same swing.
[[nodiscard]] RecordId recordIdOfSwing(const Swing& swing, std::string_view registration, std::string_view compass, std::string_view site);

} // namespace lubberline
