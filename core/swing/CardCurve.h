#pragma once
/// The compass as a curve, once around: what it reads on each magnetic heading, as it stands after the swing.

#include <functional>
#include <vector>

#include "core/angle/Heading.h"
#include "core/base/Result.h"

namespace lubberline {

class CardCurve {
public:
    using DeviationAt = std::function<Deviation(MagneticHeading)>;

    /// Errors: Numeric when what the compass reads does not rise all the way around, looked at every quarter of a degree: it names
    /// the headings between which it goes back.
    static Result<CardCurve> of(DeviationAt deviation);

    [[nodiscard]] Deviation deviationAt(MagneticHeading magnetic) const { return m_deviation(magnetic); }
    [[nodiscard]] CompassHeading compassAt(MagneticHeading magnetic) const { return toCompass(magnetic, m_deviation(magnetic)); }
    /// The only heading on which the compass reads this.
    [[nodiscard]] MagneticHeading magneticAt(CompassHeading compass) const;

private:
    explicit CardCurve(DeviationAt deviation);
    [[nodiscard]] Result<void> checkOneWay() const;

    DeviationAt m_deviation;
    std::vector<double> m_compass_deg; ///< at every step from magnetic 0 to 360, each within half a turn of the one before
};

} // namespace lubberline
