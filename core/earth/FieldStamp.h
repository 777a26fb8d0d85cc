#pragma once
/// The Earth's field that a swing was computed with: kept with it, so that a later model cannot change what was said.

#include <string>

#include "core/base/Date.h"
#include "core/earth/EarthField.h"

namespace lubberline {

struct FieldStamp {
    std::string model; ///< "WMM2025", "IGRF-14", or the name that a loaded file gives itself
    Place place;       ///< for which it was computed
    Date date;         ///< for which it was computed
    EarthField field;
    friend bool operator==(const FieldStamp&, const FieldStamp&) = default;
};

} // namespace lubberline
