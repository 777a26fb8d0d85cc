#pragma once
/// Headings as types: true, magnetic and compass headings cannot be mixed by accident.
///   deviation = magnetic − compass, east positive                                          [P 4, M 2]
///   magnetic = compass + deviation;  true = magnetic + variation (east positive)
/// All are held in degrees, because that is what was read: 359 stays 359 through every file and database.
/// A value can only be read by naming its unit.

#include <compare>

#include "core/angle/Angle.h"

namespace lubberline {

/// A direction clockwise from the north of its frame, [0°, 360°).
template <class Frame>
class Heading {
public:
    Heading() = default;
    /// @param heading_deg any finite angle [deg]; wrapped to [0, 360).
    [[nodiscard]] static Heading fromDegrees(double heading_deg) { return Heading(wrap360(heading_deg)); }
    [[nodiscard]] static Heading fromRadians(double heading_rad) { return Heading(wrap360(toDegrees(heading_rad))); }
    [[nodiscard]] double degrees() const { return m_heading_deg; }
    [[nodiscard]] double radians() const { return toRadians(m_heading_deg); }
    friend bool operator==(const Heading&, const Heading&) = default;

private:
    explicit Heading(double heading_deg) : m_heading_deg(heading_deg) {}
    double m_heading_deg = 0.0;
};

using TrueHeading = Heading<struct TrueFrame>;         ///< from true (geographic) north
using MagneticHeading = Heading<struct MagneticFrame>; ///< ψ, from magnetic north: the reference of a swing
using CompassHeading = Heading<struct CompassFrame>;   ///< ψ', what the compass reads

/// A signed angle between two norths, (−180°, 180°], east positive.
template <class Meaning>
class EastPositive {
public:
    EastPositive() = default;
    [[nodiscard]] static EastPositive fromDegrees(double angle_deg) { return EastPositive(wrap180(angle_deg)); }
    [[nodiscard]] static EastPositive fromRadians(double angle_rad) { return EastPositive(wrap180(toDegrees(angle_rad))); }
    [[nodiscard]] double degrees() const { return m_angle_deg; }
    [[nodiscard]] double radians() const { return toRadians(m_angle_deg); }
    friend bool operator==(const EastPositive&, const EastPositive&) = default;

private:
    explicit EastPositive(double angle_deg) : m_angle_deg(angle_deg) {}
    double m_angle_deg = 0.0;
};

using Deviation = EastPositive<struct DeviationMeaning>; ///< δ = magnetic − compass
using Variation = EastPositive<struct VariationMeaning>; ///< D = true − magnetic (declination)

/// δ = ψ − ψ' [P 4].
inline Deviation deviationOf(MagneticHeading magnetic, CompassHeading compass)
{
    return Deviation::fromDegrees(magnetic.degrees() - compass.degrees());
}
/// ψ = ψ' + δ.
inline MagneticHeading toMagnetic(CompassHeading compass, Deviation deviation)
{
    return MagneticHeading::fromDegrees(compass.degrees() + deviation.degrees());
}
/// ψ' = ψ − δ.
inline CompassHeading toCompass(MagneticHeading magnetic, Deviation deviation)
{
    return CompassHeading::fromDegrees(magnetic.degrees() - deviation.degrees());
}
/// magnetic = true − variation.
inline MagneticHeading toMagnetic(TrueHeading heading, Variation variation)
{
    return MagneticHeading::fromDegrees(heading.degrees() - variation.degrees());
}
/// true = magnetic + variation.
inline TrueHeading toTrue(MagneticHeading heading, Variation variation)
{
    return TrueHeading::fromDegrees(heading.degrees() + variation.degrees());
}

} // namespace lubberline
