#pragma once
/// What figures of our JSON files may be, where several kinds of record have the like.

#include "core/format/json/JsonObject.h"

namespace lubberline {

inline constexpr NumberRange kHeadingRange{0, 360};        ///< 360 is 0
inline constexpr NumberRange kSignedAngleRange{-180, 180}; ///< variation, longitude
inline constexpr NumberRange kFigureRange{-360, 360};      ///< a figure as an instrument shows it, or a turn

} // namespace lubberline
