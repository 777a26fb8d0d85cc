// When a swing has a field stamp, and what changes say about it.

#include <gmock/gmock.h>

#include "core/earth/FieldModel.h"
#include "core/swing/SwingField.h"

namespace lubberline::test {

namespace {

Site siteAt(double latitude_deg, double longitude_deg, std::optional<double> elevation_m = 117.0)
{
    Site site;
    site.latitude_deg = latitude_deg;
    site.longitude_deg = longitude_deg;
    site.elevation_m = elevation_m;
    return site;
}

Swing swingOn(Date date)
{
    Swing swing;
    swing.date = date;
    return swing;
}

/// At Deblin on a day of 2026, with the stamp of then.
Swing stamped()
{
    Swing swing = swingOn("2026-03-10");
    swing.field = stampFor(swing, siteAt(51.55, 21.89));
    return swing;
}

} // namespace

TEST(SwingField, isThatOfTheSiteOnTheDay)
{
    const auto stamp = stampFor(swingOn("2026-03-10"), siteAt(51.55, 21.89));
    ASSERT_TRUE(stamp);
    const auto answer = defaultFieldModel(*decimalYear("2026-03-10"))->evaluate({51.55, 21.89, 117}, *decimalYear("2026-03-10"));
    ASSERT_TRUE(answer);
    EXPECT_EQ(stamp->field, answer->field);
    EXPECT_EQ(stamp->model, "WMM2025");
    EXPECT_EQ(stamp->date, Date("2026-03-10"));
    EXPECT_EQ(stamp->place, (Place{51.55, 21.89, 117}));
    EXPECT_EQ(stampFor(swingOn("2005-06-01"), siteAt(51.55, 21.89))->model, "IGRF-14");
    EXPECT_EQ(stampFor(swingOn("2026-03-10"), siteAt(51.55, 21.89, {}))->place.height_m, 0);
}

TEST(SwingField, isNoneWhereNothingCanBeSaid)
{
    EXPECT_FALSE(stampFor(swingOn("2026-03-10"), std::nullopt));
    EXPECT_FALSE(stampFor(swingOn(""), siteAt(51.55, 21.89)));
    EXPECT_FALSE(stampFor(swingOn("1850-01-01"), siteAt(51.55, 21.89)));
    EXPECT_FALSE(stampFor(swingOn("2026-03-10"), siteAt(86, 142))); // H < 2000 nT
    EXPECT_FALSE(stampFor(swingOn("2026-03-10"), siteAt(91, 0)));
    Site half = siteAt(51.55, 21.89);
    half.longitude_deg.reset();
    EXPECT_FALSE(stampFor(swingOn("2026-03-10"), half));
}

TEST(SwingField, isHeldAgainstWhatWouldBeComputedNow)
{
    const Site site = siteAt(51.55, 21.89);
    EXPECT_EQ(stateOf(swingOn("2026-03-10"), site), StampState::None);
    Swing swing = stamped();
    EXPECT_EQ(stateOf(swing, site), StampState::Current);
    EXPECT_EQ(stateOf(swing, std::nullopt), StampState::Current); // nothing to hold it against
    swing.field->field.north_nT += 0.04;
    EXPECT_EQ(stateOf(swing, site), StampState::Current);
    swing.field->field.north_nT += 0.04;
    EXPECT_EQ(stateOf(swing, site), StampState::ModelChanged);
}

TEST(SwingField, anotherPlaceOrDayIsToldFromAnotherModel)
{
    EXPECT_EQ(stateOf(stamped(), siteAt(52.55, 21.89)), StampState::PlaceChanged);
    EXPECT_EQ(stateOf(stamped(), siteAt(51.55, 22.89)), StampState::PlaceChanged);
    EXPECT_EQ(stateOf(stamped(), siteAt(51.55, 21.89, 1117)), StampState::PlaceChanged);
    EXPECT_EQ(stateOf(stamped(), siteAt(51.550001, 21.89)), StampState::Current); // some centimetres: the same field
    Swing later = stamped();
    later.date = "2026-09-10";
    EXPECT_EQ(stateOf(later, siteAt(51.55, 21.89)), StampState::PlaceChanged);
}

TEST(SwingField, aVariationIsHeldAgainstTheDeclination)
{
    Swing swing = stamped();
    EXPECT_FALSE(variationBeyondStamp_deg(swing));
    swing.variation_deg = swing.field->field.variation().degrees() + 1.5;
    EXPECT_NEAR(*variationBeyondStamp_deg(swing), 1.5, 1e-12);
    swing.field->field = {-1000, 1, 50000}; // declination near 180
    swing.variation_deg = -179;
    EXPECT_NEAR(*variationBeyondStamp_deg(swing), 1.06, 0.01);
    swing.field.reset();
    EXPECT_FALSE(variationBeyondStamp_deg(swing));
}

TEST(SwingField, baseSurveyModelAndSwingAreHeldAgainstEachOther)
{
    const auto model = stamped().field;
    const double there_deg = model->field.variation().degrees();
    const auto base = [&](std::optional<double> stated, std::vector<double> surveyed) {
        auto site = siteAt(51.55, 21.89);
        site.variation_deg = stated;
        for (const double declination_deg : surveyed) {
            SurveyPoint point;
            point.declination_deg = declination_deg;
            site.survey.push_back(point);
        }
        return site;
    };
    EXPECT_TRUE(variationDisagreement(base({}, {}), model).empty());
    EXPECT_TRUE(variationDisagreement(base(there_deg + 0.9, {there_deg, there_deg + 0.2}), model, there_deg + 0.5).empty());
    EXPECT_FALSE(variationDisagreement(base(there_deg + 1.0, {}), model).empty());
    EXPECT_FALSE(variationDisagreement(base({}, {there_deg - 1.1, there_deg - 1.1}), model).empty());
    EXPECT_FALSE(variationDisagreement(base(4.0, {5.4}), {}).empty()); // without any model
    EXPECT_FALSE(variationDisagreement({}, model, there_deg - 2).empty());
    const std::string words = variationDisagreement(base(4.0, {5.4, 5.6}), {}, -1.0).english();
    EXPECT_EQ(words, "VARIATION in doubt, by 6.5°: the base states +4.00°; its survey found +5.50°; the swing states −1.00°");
    // Around the date line of angles they are near.
    EXPECT_TRUE(variationDisagreement(base(179.9, {-179.8}), {}).empty());
}

/// What made magnetic headings of true ones turns A by its own error; where the headings are magnetic it does nothing.
TEST(SwingField, aVariationThatIsContradictedMakesAUnsure)
{
    Site base;
    base.variation_deg = 4.0;
    Swing swing;
    swing.variation_deg = 6.5;
    Reading reading;
    reading.magnetic = MagneticHeading::fromDegrees(90);
    reading.compass = CompassHeading::fromDegrees(91);
    swing.readings = {reading};
    EXPECT_EQ(variationDoubt_deg(swing, base), 0.0);
    swing.readings[0].trueHeading = TrueHeading::fromDegrees(96.5);
    EXPECT_DOUBLE_EQ(variationDoubt_deg(swing, base), 2.5);
    EXPECT_EQ(variationDoubt_deg(swing, {}), 0.0);
    base.variation_deg = 6.0;
    EXPECT_EQ(variationDoubt_deg(swing, base), 0.0);
}

} // namespace lubberline::test
