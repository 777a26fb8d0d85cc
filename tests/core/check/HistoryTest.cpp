// A history is of one compass and has each swing once.

#include <gtest/gtest.h>

#include "core/check/History.h"

namespace lubberline {
namespace {

SourcedRecord swingOf(const char* source, const char* aircraft, const char* compass, Date date, double A_deg)
{
    SourcedRecord one{source, {}};
    one.record.aircraft.registration = aircraft;
    one.record.compass.name = compass;
    one.record.swing.date = date;
    for (int heading = 0; heading < 360; heading += 45) {
        Reading reading;
        reading.magnetic = MagneticHeading::fromDegrees(heading + A_deg);
        reading.compass = CompassHeading::fromDegrees(heading);
        one.record.swing.readings.push_back(reading);
    }
    return one;
}

const SourcedRecord kFirst = swingOf("h0.csv", "SP-CHK", "standby", Date("2024-05-01"), 1);
const SourcedRecord kSecond = swingOf("h1.csv", "SP-CHK", "standby", Date("2025-05-01"), 1);

TEST(History, ofOneCompass)
{
    EXPECT_TRUE(checkHistory(std::vector{kFirst, kSecond})); // the same readings on another day are another swing
    const auto refused = [](const SourcedRecord& third) {
        const auto checked = checkHistory(std::vector{kFirst, kSecond, third});
        return checked ? std::string() : describe(checked.error());
    };
    EXPECT_EQ(refused(swingOf("hx.csv", "SP-OTH", "no 2", Date("2026-05-01"), 0)),
        "hx.csv: this swing is of SP-OTH, no 2; expected the aircraft and compass of h0.csv (SP-CHK, standby)");
    EXPECT_NE(refused(swingOf("hy.csv", "SP-CHK", "main", Date("2026-05-01"), 0)), "");
    EXPECT_EQ(refused(swingOf("h1.csv", "SP-CHK", "standby", Date("2025-05-01"), 1)),
        "h1.csv: this is the swing of h1.csv once more; expected each swing once");
    // Under another name it is the same swing, and with the radio on it is another.
    EXPECT_NE(refused(swingOf("copy.csv", "", "", Date("2025-05-01"), 1)), "");
    SourcedRecord radio = kSecond;
    radio.record.swing.configuration.radio = RadioState::On;
    EXPECT_EQ(refused(radio), "");
    // What does not say of which compass it is cannot be refused, and is told.
    const SourcedRecord nameless = swingOf("h2.csv", "", "", Date("2026-05-01"), 1);
    EXPECT_EQ(refused(nameless), "");
    ASSERT_EQ(doubtsOfHistory(std::vector{kFirst, nameless}).size(), 1u);
    EXPECT_NE(doubtsOfHistory(std::vector{kFirst, nameless}).front().english().find("h2.csv does not say"), std::string::npos);
    EXPECT_TRUE(doubtsOfHistory(std::vector{nameless}).empty());
    EXPECT_TRUE(doubtsOfHistory(std::vector{kFirst, kSecond}).empty());
}

TEST(History, twoAreOfTwoCompassesOfOneAircraft)
{
    const std::vector first{kFirst, kSecond};
    const auto refused = [&](const SourcedRecord& other) {
        const auto checked = checkTwoCompasses(first, std::vector{other});
        return checked ? std::string() : describe(checked.error());
    };
    EXPECT_EQ(refused(swingOf("g0.csv", "SP-CHK", "main", Date("2025-05-01"), 2)), "");
    EXPECT_NE(refused(kFirst).find("which is the first compass's"), std::string::npos);
    EXPECT_NE(refused(swingOf("g0.csv", "SP-CHK", "standby", Date("2023-05-01"), 2)).find("expected another compass"), std::string::npos);
    EXPECT_NE(refused(swingOf("g0.csv", "SP-OTH", "main", Date("2023-05-01"), 2)).find("two compasses of one aircraft"), std::string::npos);
}

} // namespace
} // namespace lubberline
