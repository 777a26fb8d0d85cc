#pragma once
/// The magnetism of one compass of the demonstration fleet through the years, and the readings that a crew takes of it.

#include <array>
#include <vector>

#include "core/demo/DemoRandom.h"
#include "core/demo/DemoTypes.h"
#include "core/record/Swing.h"

namespace lubberline {

class DemoMagnetism {
public:
    DemoMagnetism(const DemoCompassKind& kind, DemoRandom& random);

    void ageOneYear();            ///< hard iron drifts
    void strike(double size_deg); ///< something magnetised the aircraft: B and C jump
    void compensate();            ///< what a correction swing leaves of A, B, C
    /// What remains when the radio is switched off, or comes with it: the field of its supply line.
    void addSupplyField(double B_deg) { m_coefficient_deg[1] += B_deg; }

    /// A swing over `points` equally spaced headings; the actual headings are up to `spread_deg` from them.
    [[nodiscard]] std::vector<Reading> read(int points, double spread_deg);

private:
    const DemoCompassKind& m_kind;
    DemoRandom& m_random;
    std::array<double, 5> m_coefficient_deg;
    std::array<double, 2> m_drift_deg; ///< of B and C in a year
};

/// The largest |deviation| of complete readings [deg].
[[nodiscard]] double largestDeviation_deg(const std::vector<Reading>& readings);

} // namespace lubberline
