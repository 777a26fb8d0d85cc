#include <gmock/gmock.h>

#include <limits>

#include "core/angle/AngleText.h"
#include "core/angle/PrintedHeading.h"

namespace lubberline::test {

namespace {

double signedOf(const char* text)
{
    const auto angle = parseSignedAngle_deg(text);
    EXPECT_TRUE(angle.ok()) << text << ": " << (angle.ok() ? "" : angle.error().message.english());
    return angle.ok() ? *angle : std::numeric_limits<double>::quiet_NaN();
}

double headingOf(const char* text)
{
    const auto heading = parseHeading_deg(text);
    EXPECT_TRUE(heading.ok()) << text;
    return heading.ok() ? *heading : std::numeric_limits<double>::quiet_NaN();
}

} // namespace

TEST(SignedAngle, isTakenInEveryFormThatCrewsType)
{
    for (const char* text : {"3.25", "+3.25", "3.25E", "3.25 e", "3,25", "3\u00B015'E", "3\u00B015\u2032", "3 15", "3:15", "3 15 E",
             "3:15E", " 3.25 ", "3.25\u00B0", "3\u00B0 15' E"})
        EXPECT_DOUBLE_EQ(signedOf(text), 3.25) << text;
    for (const char* text : {"-3.25", "\u22123,25", "3.25W", "3.25 w", "3\u00B015'W", "3 15 W", "3:15W", "-3 15", "-3\u00B015'", "- 3.25"})
        EXPECT_DOUBLE_EQ(signedOf(text), -3.25) << text;
}

TEST(SignedAngle, keepsTheSignOfZeroDegreesAndSomeMinutes)
{
    EXPECT_DOUBLE_EQ(signedOf("-0 15"), -0.25);
    EXPECT_DOUBLE_EQ(signedOf("0\u00B015'W"), -0.25);
    EXPECT_FALSE(std::signbit(signedOf("0W"))); // no minus zero
}

TEST(SignedAngle, takesEveryMinusThatIsTyped)
{
    for (const char* text : {"-3.25", "\u22123.25", "\u20133.25", "\u20103.25", "\u20113\u00B015'"})
        EXPECT_EQ(signedOf(text), -3.25) << text;
}

TEST(SignedAngle, reachesHalfATurnAndNoFurther)
{
    EXPECT_EQ(signedOf("180"), 180.0);
    EXPECT_EQ(signedOf("180W"), -180.0);
    EXPECT_FALSE(parseSignedAngle_deg("180.1"));
    EXPECT_FALSE(parseSignedAngle_deg("180 1"));
}

TEST(SignedAngle, refusesWhatIsNotOneNamingTheText)
{
    for (const char* text : {"", " ", "abc", "W", "3.25N", "--3", "3 60", "3.5 15", "3 15 20", "3 15.2.1", "1e2", "0x3", "nan", "inf",
             "3..2", "3W5", "3 -15", "\u00B0", "'"}) {
        const auto angle = parseSignedAngle_deg(text);
        ASSERT_FALSE(angle) << text;
        EXPECT_EQ(angle.error().code, ErrorCode::InvalidInput);
        EXPECT_THAT(angle.error().message.english(),
            testing::AllOf(testing::HasSubstr(std::string("\"") + text + "\""), testing::HasSubstr("expected")));
    }
}

/// A slip of the thumb for 84, for 8.4 and for 8°04'.
TEST(AngleText, refusesMinutesOfOneDigitBehindASpaceAlone)
{
    for (const char* text : {"8 4", "8 4W", "W 8 4", "8 4.5"})
        EXPECT_FALSE(parseSignedAngle_deg(text)) << text;
    EXPECT_FALSE(parseHeading_deg("27 4"));
    EXPECT_FALSE(parseLatitude_deg("51 3 N"));
    EXPECT_NEAR(*parseSignedAngle_deg("8 04"), 8 + 4 / 60.0, 1e-12);
    EXPECT_NEAR(*parseSignedAngle_deg("8 04.5 W"), -8 - 4.5 / 60.0, 1e-12);
    EXPECT_NEAR(*parseSignedAngle_deg("8°4'"), 8 + 4 / 60.0, 1e-12);
    EXPECT_NEAR(*parseSignedAngle_deg("8:4"), 8 + 4 / 60.0, 1e-12);
}

TEST(SignedAngle, refusesASignTogetherWithALetter)
{
    for (const char* text : {"-3W", "+3E", "-3E", "\u22123\u00B015'W"})
        EXPECT_THAT(parseSignedAngle_deg(text).error().message.english(), testing::HasSubstr("not both")) << text;
}

TEST(HeadingText, isTakenInEveryForm)
{
    EXPECT_EQ(headingOf("7"), 7.0);
    EXPECT_EQ(headingOf("007.5"), 7.5);
    EXPECT_EQ(headingOf("7,5"), 7.5);
    EXPECT_EQ(headingOf("7\u00B030'"), 7.5);
    EXPECT_EQ(headingOf("7 30"), 7.5);
    EXPECT_EQ(headingOf("359.9"), 359.9);
}

TEST(HeadingText, threeHundredAndSixtyIsNorth)
{
    EXPECT_EQ(headingOf("360"), 0.0);
    EXPECT_EQ(headingOf("360.0\u00B0"), 0.0);
    EXPECT_EQ(headingOf("0"), 0.0);
    EXPECT_FALSE(std::signbit(headingOf("-0")));
}

TEST(HeadingText, refusesWhatIsNone)
{
    for (const char* text : {"", "-1", "361", "360.1", "360 1", "7E", "7W", "north", "nan", "7 60"}) {
        const auto heading = parseHeading_deg(text);
        ASSERT_FALSE(heading) << text;
        EXPECT_EQ(heading.error().code, ErrorCode::InvalidInput);
        EXPECT_THAT(heading.error().message.english(), testing::HasSubstr("expected"));
    }
}

TEST(SignedAngle, isTakenAsSpreadsheetsAndOldRecordsWriteIt)
{
    for (const char* text :
        {"3.5 W", "W 3.5", "W3\u00B030'", "3\u00B030\u2032 W", "3\u00A0\u00B0\u00A030\u202F\u2032 W", "3\u00B0 30\u00B4 W", "3.5 west",
            "West 3,5", "3\u00B030'00\"W", "3:30:00 W", "3\u02DA30'W", "-3.50E+00", "\u22123,5\u202F\u00B0", "3\u00B029'60.0'' W"}) {
        if (std::string(text).find("60.0") != std::string::npos)
            EXPECT_FALSE(parseSignedAngle_deg(text)) << text; // sixty seconds
        else
            EXPECT_DOUBLE_EQ(signedOf(text), -3.5) << text;
    }
    EXPECT_DOUBLE_EQ(signedOf("24\u00B010\u2032"), 24.0 + 10.0 / 60.0);
    EXPECT_DOUBLE_EQ(signedOf("1\u00B000'36\u2033"), 1.01);
    EXPECT_FALSE(parseSignedAngle_deg("3\u00B015\"")); // minutes are missing
    EXPECT_FALSE(parseSignedAngle_deg("W 3 W"));
}

TEST(SignedAngle, refusesAnOBecauseItIsEastOrWest)
{
    for (const char* text : {"3 O", "3\u00B015'O", "3 Ost", "3 Ouest"})
        EXPECT_THAT(parseSignedAngle_deg(text).error().message.english(), testing::HasSubstr("east in German and west in French")) << text;
    for (const char* text : {"NO", "O", "oso"})
        EXPECT_THAT(parseHeading_deg(text).error().message.english(), testing::HasSubstr("east in German and west in French")) << text;
}

TEST(SignedAngle, namesWhatTheEyeCannotSee)
{
    EXPECT_THAT(parseSignedAngle_deg("3.5\u200B").error().message.english(), testing::HasSubstr("\"3.5[U+200B]\""));
    EXPECT_THAT(parseSignedAngle_deg("3.5 \u0415").error().message.english(), testing::HasSubstr("[U+0415]")); // a Cyrillic E
    EXPECT_THAT(parseHeading_deg("\uFEFF358").error().message.english(), testing::HasSubstr("\"[U+FEFF]358\""));
}

TEST(PlainAngle, hasASignAndNoLetter)
{
    EXPECT_EQ(*parsePlainAngle_deg("\u22122\u00B030'", 90), -2.5);
    EXPECT_FALSE(parsePlainAngle_deg("2 W", 90));
    EXPECT_THAT(parsePlainAngle_deg("91", 90).error().message.english(), testing::HasSubstr("-90 to 90"));
}

TEST(Latitude, isNorthOrSouth)
{
    EXPECT_EQ(*parseLatitude_deg("51.55 N"), 51.55);
    EXPECT_EQ(*parseLatitude_deg("S 33\u00B054'"), -33.9);
    EXPECT_EQ(*parseLatitude_deg("-33,9"), -33.9);
    EXPECT_DOUBLE_EQ(*parseLatitude_deg("52\u00B013'48\"N"), 52.23);
    for (const char* text : {"90.1", "51 E", "-33 S", "91 S"})
        EXPECT_FALSE(parseLatitude_deg(text)) << text;
}

TEST(HeadingText, takesPointsAndBearings)
{
    const std::pair<const char*, double> kPoints[] = {{"N", 0}, {"NbE", 11.25}, {"N by E", 11.25}, {"nne", 22.5}, {"NE", 45},
        {"NE/E", 56.25}, {"E", 90}, {"SE by S", 146.25}, {" S ", 180}, {"SSW", 202.5}, {"W", 270}, {"NW", 315}, {"NbW", 348.75}};
    for (const auto& [text, heading_deg] : kPoints)
        EXPECT_EQ(headingOf(text), heading_deg) << text;
    EXPECT_EQ(headingOf("N 3 E"), 3.0);
    EXPECT_EQ(headingOf("N45\u00B0W"), 315.0);
    EXPECT_EQ(headingOf("S 12\u00B030' E"), 167.5);
    EXPECT_EQ(headingOf("S 12 30 W"), 192.5);
    EXPECT_EQ(headingOf("3.58E+02"), 358.0);
    for (const char* text : {"NEN", "NNN", "N 91 E", "N -3 E", "N 3", "N 3 T", "NO", "E 3 N", "N by"})
        EXPECT_FALSE(parseHeading_deg(text)) << text;
}

TEST(HeadingText, knowsFromWhichNorthItWasSaid)
{
    EXPECT_EQ(parseWrittenHeading("274\u00B0T")->north, North::True);
    EXPECT_EQ(parseWrittenHeading("274 m")->north, North::Magnetic);
    EXPECT_EQ(*parseHeading_deg("274C", North::Compass), 274.0);
    EXPECT_EQ(*parseHeading_deg("274", North::Compass), 274.0);
    EXPECT_THAT(parseHeading_deg("274T", North::Compass).error().message.english(),
        testing::AllOf(testing::HasSubstr("a true heading"), testing::HasSubstr("expected a compass heading")));
    EXPECT_FALSE(parseHeading_deg("274T"));
    EXPECT_TRUE(parseWrittenHeading("360")->fullTurn);
    EXPECT_FALSE(parseWrittenHeading("000")->fullTurn);
    EXPECT_FALSE(parseWrittenHeading("N")->fullTurn);
}

TEST(FormatHeading, hasThreeFiguresAndNeverThreeHundredAndSixty)
{
    EXPECT_EQ(formatHeading(47.5), "047.5\u00B0");
    EXPECT_EQ(formatHeading(7), "007.0\u00B0");
    EXPECT_EQ(formatHeading(123.456, AngleStyle::DecimalDegrees, 2), "123.46\u00B0");
    EXPECT_EQ(formatHeading(5, AngleStyle::DecimalDegrees, 0), "005\u00B0");
    EXPECT_EQ(formatHeading(359.94), "359.9\u00B0");
    EXPECT_EQ(formatHeading(359.96), "000.0\u00B0");
    EXPECT_EQ(formatHeading(359.6, AngleStyle::DecimalDegrees, 0), "000\u00B0");
    EXPECT_EQ(formatHeading(360), "000.0\u00B0");
    EXPECT_EQ(formatHeading(-0.01), "000.0\u00B0");
}

TEST(AngleText, PrintedHeadingsAreBelow360WithTheirDecimals)
{
    EXPECT_EQ(printedHeading_deg(359.996, 2), 0.0);
    EXPECT_EQ(printedHeading_deg(359.994, 2), 359.994);
    EXPECT_EQ(printedHeading_deg(359.5, 0), 0.0);
    EXPECT_EQ(printedHeading_deg(359.4, 0), 359.4);
    EXPECT_EQ(printedHeading_deg(-1e-6, 3), 0.0);
    EXPECT_EQ(printedHeading_deg(540.25, 1), 180.25);
}

TEST(FormatHeading, minutesCarryIntoTheDegrees)
{
    EXPECT_EQ(formatHeading(47.5, AngleStyle::DegreesMinutes), "047\u00B030'");
    EXPECT_EQ(formatHeading(7 + 59.96 / 60, AngleStyle::DegreesMinutes), "008\u00B000'");
    EXPECT_EQ(formatHeading(359 + 59.96 / 60, AngleStyle::DegreesMinutes), "000\u00B000'");
}

TEST(FormatSignedAngle, hasASignOrALetterButNoneAtZero)
{
    EXPECT_EQ(formatSignedAngle(3.25, AngleStyle::DecimalDegrees, 2), "+3.25\u00B0");
    EXPECT_EQ(formatSignedAngle(-3.25, AngleStyle::DecimalDegrees, 2), "\u22123.25\u00B0");
    EXPECT_EQ(formatSignedAngle(0), "0.0\u00B0");
    EXPECT_EQ(formatSignedAngle(-0.04), "0.0\u00B0");
    EXPECT_EQ(formatSignedAngle(3.25, AngleStyle::DegreesMinutes), "3\u00B015'E");
    EXPECT_EQ(formatSignedAngle(-3.25, AngleStyle::DegreesMinutes), "3\u00B015'W");
    EXPECT_EQ(formatSignedAngle(-0.004, AngleStyle::DegreesMinutes), "0\u00B000'");
    EXPECT_EQ(formatSignedAngle(-2 - 59.96 / 60, AngleStyle::DegreesMinutes), "3\u00B000'W");
}

TEST(AngleText, whatIsShownReadsBack)
{
    for (int minutes = -180 * 60; minutes <= 180 * 60; minutes += 7) {
        const double angle_deg = minutes / 60.0;
        for (const auto style : {AngleStyle::DecimalDegrees, AngleStyle::DegreesMinutes})
            EXPECT_NEAR(signedOf(formatSignedAngle(angle_deg, style, 6).c_str()), angle_deg, 1e-6);
        EXPECT_NEAR(wrap180(headingOf(formatHeading(angle_deg, AngleStyle::DegreesMinutes).c_str()) - angle_deg), 0.0, 1e-9);
    }
}

} // namespace lubberline::test
