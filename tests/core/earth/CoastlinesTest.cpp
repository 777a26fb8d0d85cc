#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/earth/Coastlines.h"

namespace lubberline {
namespace {

double nearestCoast_deg(double latitude_deg, double longitude_deg)
{
    const double shrink = std::cos(latitude_deg * std::numbers::pi / 180.0); // of a degree of longitude
    double nearest = 360;
    for (const Coastline& line : coastlines())
        for (const CoastPoint& point : line)
            nearest = std::min(nearest, std::hypot(point.latitude_deg - latitude_deg, (point.longitude_deg - longitude_deg) * shrink));
    return nearest;
}

TEST(Coastlines, areLinesOnTheMap)
{
    ASSERT_GT(coastlines().size(), 50u);
    for (const Coastline& line : coastlines()) {
        ASSERT_GE(line.size(), 2u);
        for (const CoastPoint& point : line) {
            EXPECT_LE(std::abs(point.longitude_deg), 180.0);
            EXPECT_LE(std::abs(point.latitude_deg), 90.0);
        }
        for (std::size_t i = 1; i < line.size(); ++i)
            EXPECT_LT(std::abs(line[i].longitude_deg - line[i - 1].longitude_deg), 25.0);
    }
}

/// Capes by their places in the gazetteers: what would show latitude for longitude, a sign, or a shift.
TEST(Coastlines, capesAreWhereTheyAre)
{
    EXPECT_LT(nearestCoast_deg(-34.8, 20.0), 1.0);  // Cape Agulhas
    EXPECT_LT(nearestCoast_deg(71.2, 25.8), 1.0);   // North Cape
    EXPECT_LT(nearestCoast_deg(36.0, -5.6), 1.0);   // Tarifa
    EXPECT_LT(nearestCoast_deg(8.1, 77.5), 1.0);    // Cape Comorin
    EXPECT_LT(nearestCoast_deg(-55.0, -67.3), 1.5); // Tierra del Fuego
    EXPECT_GT(nearestCoast_deg(0.0, -30.0), 5.0);   // the open Atlantic
    EXPECT_GT(nearestCoast_deg(65.0, 100.0), 5.0);  // Siberia
}

} // namespace
} // namespace lubberline
