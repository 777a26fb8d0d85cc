// Declination between nodes is that of the model, at any place and time that has one.

#include <gtest/gtest.h>

#include <cmath>

#include "core/earth/DeclinationNodes.h"

using namespace lubberline;

namespace {

TEST(DeclinationNodes, areTheModel)
{
    DeclinationNodes nodes;
    double worst_deg = 0;
    for (const double year : {2012.3, 2026.9})
        for (double latitude = -70; latitude <= 70; latitude += 7.3)
            for (double longitude = -180; longitude < 180; longitude += 17.7) {
                const auto model = defaultFieldModel(year);
                const auto place = makePlace(latitude, longitude, 8000);
                ASSERT_TRUE(model && place);
                const auto field = fieldForCompass(*model, *place, year);
                const auto found = nodes.at(latitude, longitude, year);
                ASSERT_EQ(found.has_value(), bool(field)) << latitude << " " << longitude;
                // Where a compass still points: near the magnetic poles it turns within a degree of the map.
                if (found && field->field.horizontal_nT() > 8000)
                    worst_deg = std::max(worst_deg, std::abs(wrap180(*found - field->field.variation().degrees())));
            }
    EXPECT_LT(worst_deg, 0.05);
    EXPECT_GT(worst_deg, 0.0);
}

TEST(DeclinationNodes, sayNothingWhereThereIsNoModel)
{
    DeclinationNodes nodes;
    EXPECT_FALSE(nodes.at(50, 10, 1850));
    EXPECT_FALSE(nodes.at(50, 10, 2100));
    EXPECT_FALSE(nodes.at(95, 10, 2026));
    EXPECT_FALSE(nodes.at(std::nan(""), 10, 2026));
    EXPECT_TRUE(nodes.at(80, 10, 2026));
    // Across 180 degrees of longitude it is one map.
    EXPECT_NEAR(*nodes.at(40, 179.999, 2026), *nodes.at(40, -179.999, 2026), 0.01);
}

} // namespace
