#pragma once
/// What figures and texts of records may be, wherever they come from: a file, the database, a hand. Wide: they keep out what is no
/// figure of an aircraft or a compass at all; what else is sensible is for the user to know.

#include <cstddef>

#include "core/base/NumberRange.h"

namespace lubberline {

inline constexpr NumberRange kHeadingRange{0, 360};        ///< 360 is 0
inline constexpr NumberRange kSignedAngleRange{-180, 180}; ///< variation, longitude
inline constexpr NumberRange kFigureRange{-360, 360};      ///< a figure as an instrument shows it, or a turn
inline constexpr NumberRange kLatitudeRange{-90, 90};
inline constexpr NumberRange kPitchRange{-90, 90};
inline constexpr NumberRange kRollRange{-180, 180};
inline constexpr NumberRange kElevationRange{-1e5, 1e5}; ///< [m]
inline constexpr NumberRange kHeightRange{-1e5, 1e6};    ///< [m] of a field
inline constexpr NumberRange kFieldRange{-1e6, 1e6};     ///< [nT] ten times the field anywhere on Earth
inline constexpr NumberRange kSharedErrorRange{0, 180};  ///< a standard error [deg]
inline constexpr NumberRange kYearRange{1, 9999};
inline constexpr NumberRange kPositiveRange{std::numeric_limits<double>::min(), 1e9};
inline constexpr NumberRange kInstrumentResolutionRange{1e-6, 90}; ///< [deg]
inline constexpr NumberRange kMonthsRange{1, 1200};
inline constexpr NumberRange kDaysRange{0, 36500};
inline constexpr NumberRange kRevisionRange{1, 10000};

/// Of one text that people write (a name, a configuration, a note) [bytes]: three pages.
inline constexpr std::size_t kLongestText = 10'000;

} // namespace lubberline
