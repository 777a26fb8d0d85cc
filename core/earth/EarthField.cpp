#include "core/earth/EarthField.h"

#include <cmath>

namespace lubberline {

Result<Place> makePlace(double latitude_deg, double longitude_deg, double height_m)
{
    if (!std::isfinite(latitude_deg) || std::abs(latitude_deg) > 90.0)
        return Error{
            ErrorCode::InvalidInput, MARKED("core", "the latitude is beyond the poles; expected -90 to 90 degrees, north positive")};
    if (!std::isfinite(longitude_deg))
        return Error{ErrorCode::InvalidInput, MARKED("core", "the longitude is not a number; expected degrees, east positive")};
    if (!std::isfinite(height_m) || height_m < -10'000.0 || height_m > 600'000.0)
        return Error{
            ErrorCode::InvalidInput, MARKED("core", "the height is outside the models; expected -10 000 to 600 000 m above the ellipsoid")};
    const double wrapped = wrap180(longitude_deg);
    return Place{latitude_deg, wrapped == 180.0 ? -180.0 : wrapped, height_m};
}

double MeridianField::total_nT() const { return std::hypot(horizontal_nT, down_nT); }
double MeridianField::inclination_rad() const { return std::atan2(down_nT, horizontal_nT); }

MeridianField MeridianField::fromDip(double horizontal_nT, double inclination_rad)
{
    return {horizontal_nT, horizontal_nT * std::tan(inclination_rad)};
}

double EarthField::horizontal_nT() const { return std::hypot(north_nT, east_nT); }
double EarthField::total_nT() const { return std::hypot(horizontal_nT(), down_nT); }
Variation EarthField::variation() const { return Variation::fromRadians(std::atan2(east_nT, north_nT)); }
double EarthField::inclination_rad() const { return std::atan2(down_nT, horizontal_nT()); }

} // namespace lubberline
