#include "core/earth/GeographicModel.h"

#include <algorithm>
#include <cmath>

#include <GeographicLib/Geocentric.hpp>

namespace lubberline {

namespace {

using GeographicLib::Geocentric;
using GeographicLib::SphericalEngine;

constexpr double kReferenceRadius_m = 6371200.0; // of all WMM and IGRF models (WMM2025 report, section 1.2)

/// The constructors of GeographicLib's sums make a table of roots, common to all, as long as they need it. Made once for every
/// degree there is: a model that is loaded later must not lengthen it under a thread that is adding up.
void makeRoots()
{
    static const bool made = (SphericalEngine::RootTable(kMostDegree), true);
    static_cast<void>(made);
}

/// The gradient of the sums [1/m of nT], in geocentric axes; the field is −a times it.
struct Gradient {
    double x = 0, y = 0, z = 0;
};

/// From geocentric axes (X to 0° N 0° E, Z to the North Pole) to north, east, down of the ellipsoid.
EarthField turned(const Gradient& gradient, double sinLatitude, double cosLatitude, double sinLongitude, double cosLongitude)
{
    const double X = -kReferenceRadius_m * gradient.x, Y = -kReferenceRadius_m * gradient.y, Z = -kReferenceRadius_m * gradient.z;
    const double outward = cosLongitude * X + sinLongitude * Y; // from the axis
    return {cosLatitude * Z - sinLatitude * outward, cosLongitude * Y - sinLongitude * X, -(cosLatitude * outward + sinLatitude * Z)};
}

/// A place in geocentric coordinates [m], and the vertical of the ellipsoid there.
struct GeocentricPlace {
    double X = 0, Y = 0, Z = 0, sinLatitude = 0, cosLatitude = 1;
};

GeocentricPlace geocentric(double latitude_deg, double longitude_deg, double height_m)
{
    GeocentricPlace place;
    Geocentric::WGS84().Forward(latitude_deg, longitude_deg, height_m, place.X, place.Y, place.Z);
    GeographicLib::Math::sincosd(GeographicLib::Math::LatFix(latitude_deg), place.sinLatitude, place.cosLatitude);
    return place;
}

GaussSet changeBetween(const GaussSet& from, const GaussSet& to, double years)
{
    GaussSet change(from.size());
    for (std::size_t i = 0; i < from.size(); ++i)
        change[i] = {(to[i].g - from[i].g) / years, (to[i].h - from[i].h) / years};
    return change;
}

} // namespace

GeographicModel::Epoch::Epoch(Columns mainColumns, Columns changeColumns, int degree)
    : main(std::move(mainColumns))
    , change(std::move(changeColumns))
    , field(main.g, main.h, degree, change.g, change.h, degree, kReferenceRadius_m, GeographicLib::SphericalHarmonic1::SCHMIDT)
    , rate(change.g, change.h, degree, kReferenceRadius_m, GeographicLib::SphericalHarmonic::SCHMIDT)
{
}

GeographicModel::Columns GeographicModel::columnsOf(const GaussSet& set, int degree)
{
    Columns columns;
    for (int m = 0; m <= degree; ++m)
        for (int n = m; n <= degree; ++n) {
            const Gauss gauss = n == 0 ? Gauss{} : set[gaussIndex(n, m)];
            columns.g.push_back(gauss.g);
            if (m > 0)
                columns.h.push_back(gauss.h);
        }
    return columns;
}

GeographicModel::GeographicModel(const FieldTable& table) : m_firstEpoch(table.firstEpoch), m_epochStep(table.epochStep)
{
    makeRoots();
    for (std::size_t i = 0; i < table.main.size(); ++i) {
        const bool isLast = i + 1 == table.main.size();
        const GaussSet change = isLast ? table.change : changeBetween(table.main[i], table.main[i + 1], table.epochStep);
        m_epochs.emplace_back(columnsOf(table.main[i], table.degree), columnsOf(change, table.degree), table.degree);
    }
}

std::size_t GeographicModel::epochAt(double year) const
{
    const double last = static_cast<double>(m_epochs.size() - 1);
    return static_cast<std::size_t>(std::clamp(std::floor((year - m_firstEpoch) / m_epochStep), 0.0, last));
}

double GeographicModel::yearsSince(std::size_t epoch, double year) const
{
    return year - m_firstEpoch - static_cast<double>(epoch) * m_epochStep;
}

FieldAndRate GeographicModel::at(double year, const Place& place) const
{
    const std::size_t epoch = epochAt(year);
    const GeocentricPlace there = geocentric(place.latitude_deg, place.longitude_deg, place.height_m);
    double sinLongitude = 0, cosLongitude = 1;
    GeographicLib::Math::sincosd(place.longitude_deg, sinLongitude, cosLongitude);
    Gradient field, rate;
    m_epochs[epoch].field(yearsSince(epoch, year), there.X, there.Y, there.Z, field.x, field.y, field.z);
    m_epochs[epoch].rate(there.X, there.Y, there.Z, rate.x, rate.y, rate.z);
    return {turned(field, there.sinLatitude, there.cosLatitude, sinLongitude, cosLongitude),
        turned(rate, there.sinLatitude, there.cosLatitude, sinLongitude, cosLongitude)};
}

FieldCircle GeographicModel::circle(double year, double latitude_deg, double height_m) const
{
    const std::size_t epoch = epochAt(year);
    const GeocentricPlace there = geocentric(latitude_deg, 0.0, height_m); // at longitude 0, X is the distance from the axis
    FieldCircle circle;
    circle.m_sinLatitude = there.sinLatitude;
    circle.m_cosLatitude = there.cosLatitude;
    circle.m_sums = m_epochs[epoch].field.Circle(yearsSince(epoch, year), there.X, there.Z, true);
    return circle;
}

EarthField FieldCircle::at(double longitude_deg) const
{
    double sinLongitude = 0, cosLongitude = 1;
    GeographicLib::Math::sincosd(longitude_deg, sinLongitude, cosLongitude);
    Gradient gradient;
    m_sums(sinLongitude, cosLongitude, gradient.x, gradient.y, gradient.z);
    return turned(gradient, m_sinLatitude, m_cosLatitude, sinLongitude, cosLongitude);
}

} // namespace lubberline
