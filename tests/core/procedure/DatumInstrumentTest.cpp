// What the figures of datum instruments mean: sides, zero, true north, means across north, and figures that cannot be of one
// heading.

#include <gtest/gtest.h>

#include <cmath>

#include "core/procedure/DatumHeading.h"

namespace lubberline {
namespace {

DatumInstrument sightingCompass(SightingDirection ahead)
{
    DatumInstrument instrument;
    instrument.name = "landing compass";
    instrument.ahead = ahead;
    return instrument;
}

TEST(DatumInstrument, readDirectlyFromTheNose)
{
    const auto heading = datumHeading(sightingCompass(SightingDirection::Direct), {{178}, {}, {}}, {});
    ASSERT_TRUE(heading);
    EXPECT_DOUBLE_EQ(heading->magnetic.degrees(), 178.0);
    EXPECT_FALSE(heading->collimation_deg);
}

TEST(DatumInstrument, reciprocalIsASettingOfTheInstrument)
{
    EXPECT_DOUBLE_EQ(datumHeading(sightingCompass(SightingDirection::Reciprocal), {{178}, {}, {}}, {})->magnetic.degrees(), 358.0);
}

TEST(DatumInstrument, aheadAndAsternAreAveragedAndCompared)
{
    // From ahead it reads direct, 90.4; from astern turned by 180°, 269.8.
    const auto heading = datumHeading(sightingCompass(SightingDirection::Direct), {{90.4}, {269.8}, {}}, {});
    ASSERT_TRUE(heading);
    EXPECT_NEAR(heading->magnetic.degrees(), 90.1, 1e-9);
    EXPECT_NEAR(*heading->collimation_deg, 0.3, 1e-9);
    const auto wrong = datumHeading(sightingCompass(SightingDirection::Direct), {{90.4}, {90.0}, {}}, {});
    ASSERT_FALSE(wrong);
    EXPECT_NE(wrong.error().message.english().find("other way round"), std::string::npos);
}

TEST(DatumInstrument, threeReadingsAcrossNorth)
{
    const auto heading = datumHeading(sightingCompass(SightingDirection::Direct), {{359.5, 0.5, 0.0}, {}, {}}, {});
    ASSERT_TRUE(heading);
    EXPECT_NEAR(wrap180(heading->magnetic.degrees()), 0.0, 1e-9);
    EXPECT_NEAR(heading->spread_deg, 1.0, 1e-9);
    // scatter of the mean 0.5/√3, and half a division of 0.5° evenly likely
    EXPECT_NEAR(heading->uncertainty_deg, std::hypot(0.5 / std::sqrt(3.0), 0.5 / std::sqrt(12.0)), 1e-9);
    EXPECT_FALSE(datumHeading(sightingCompass(SightingDirection::Direct), {{359, 20, 0}, {}, {}}, {}));
}

TEST(DatumInstrument, trueInstrumentsNeedTheVariation)
{
    DatumInstrument inertial{{}, "INS", DatumKind::Inertial, {}, {}, {}, SightingDirection::Direct, true, 0, 0.1, {}};
    EXPECT_FALSE(datumHeading(inertial, {{100}, {}, {}}, {}));
    EXPECT_DOUBLE_EQ(datumHeading(inertial, {{100}, {}, {}}, Variation::fromDegrees(6.5))->magnetic.degrees(), 93.5);
    EXPECT_DOUBLE_EQ(datumHeading(inertial, {{100}, {}, {}}, Variation::fromDegrees(-6.5))->magnetic.degrees(), 106.5);
}

TEST(DatumInstrument, theZeroOfACircleIsAdded)
{
    DatumInstrument theodolite = sightingCompass(SightingDirection::Direct);
    theodolite.zero_deg = -12.25;
    EXPECT_DOUBLE_EQ(datumHeading(theodolite, {{10}, {}, {}}, {})->magnetic.degrees(), 357.75);
}

TEST(DatumInstrument, theDayItselfIsStillInCalibration)
{
    DatumInstrument instrument;
    EXPECT_FALSE(calibrationOver(instrument, "2026-11-23"));
    instrument.calibrationDue = "2026-11-23";
    EXPECT_FALSE(calibrationOver(instrument, "2026-11-23"));
    EXPECT_TRUE(calibrationOver(instrument, "2026-11-24"));
}

TEST(CompassFigure, meanAndErrors)
{
    EXPECT_NEAR(compassFigure({{}, {}, {358, 0, 2}}, 1.0)->compass.degrees(), 0.0, 1e-9);
    EXPECT_FALSE(compassFigure({}, 1.0));
    EXPECT_FALSE(compassFigure({{}, {}, {10, 40}}, 1.0));
}

} // namespace
} // namespace lubberline
