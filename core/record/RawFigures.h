#pragma once

#include <vector>

namespace lubberline {

/// Figures as they were read, up to three of each: they are kept as they are, and the mean counts.
struct RawFigures {
    std::vector<double> datum_deg;   ///< as the instrument shows; what it means is for core/record/DatumInstrument.h
    std::vector<double> astern_deg;  ///< the same from astern, where it was sighted both ways
    std::vector<double> compass_deg; ///< as the compass shows
    [[nodiscard]] bool empty() const { return datum_deg.empty() && astern_deg.empty() && compass_deg.empty(); }
    friend bool operator==(const RawFigures&, const RawFigures&) = default;
};

} // namespace lubberline
