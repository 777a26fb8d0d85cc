#pragma once
/// The Earth's magnetic field at a place: nT, north, east, down; declination (variation) east positive, inclination (dip)
/// positive down.

#include "core/angle/Heading.h"
#include "core/base/Result.h"

namespace lubberline {

/// A place on or above the WGS84 ellipsoid.
struct Place {
    double latitude_deg = 0;  ///< geodetic, north positive, [−90, 90]
    double longitude_deg = 0; ///< east positive, [−180, 180)
    double height_m = 0;      ///< above the ellipsoid
    friend bool operator==(const Place&, const Place&) = default;
};

/// Longitude is wrapped (540 is −180). Errors: InvalidInput (not finite; latitude beyond ±90; height outside −10 km … 600 km).
Result<Place> makePlace(double latitude_deg, double longitude_deg, double height_m = 0.0);

/// The field as magnetic axes see it, (H, 0, Z): all that Poisson's model asks of a place.
struct MeridianField {
    double horizontal_nT = 0; ///< H ≥ 0, towards magnetic north
    double down_nT = 0;       ///< Z, positive down
    [[nodiscard]] double total_nT() const;
    [[nodiscard]] double inclination_rad() const; ///< atan2(Z, H): positive down, ±π/2 at the magnetic poles
    [[nodiscard]] static MeridianField fromDip(double horizontal_nT, double inclination_rad);
    friend bool operator==(const MeridianField&, const MeridianField&) = default;
};

/// The field in geographic axes.
struct EarthField {
    double north_nT = 0, east_nT = 0, down_nT = 0; ///< X, Y, Z
    [[nodiscard]] double horizontal_nT() const;    ///< H = √(X² + Y²)
    [[nodiscard]] double total_nT() const;         ///< F
    [[nodiscard]] Variation variation() const;     ///< D = atan2(Y, X); 0 where H is 0
    [[nodiscard]] double inclination_rad() const;  ///< I = atan2(Z, H)
    [[nodiscard]] MeridianField meridian() const { return {horizontal_nT(), down_nT}; }
    friend bool operator==(const EarthField&, const EarthField&) = default;
};

} // namespace lubberline
