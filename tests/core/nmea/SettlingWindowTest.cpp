#include <gtest/gtest.h>

#include <cmath>

#include "core/angle/Angle.h"
#include "core/nmea/SettlingWindow.h"

namespace lubberline {
namespace {

TEST(SettlingWindow, settlesWhenTheWindowIsFullAndQuiet)
{
    SettlingWindow window(5.0, 1.0);
    EXPECT_FALSE(window.at(0));
    for (int i = 0; i <= 40; ++i)
        window.add(i * 0.1, 359.8 + 0.4 * (i % 2));
    EXPECT_FALSE(window.at(4.0)->settled); // not full yet
    for (int i = 41; i <= 60; ++i)
        window.add(i * 0.1, wrap360(359.8 + 0.4 * (i % 2)));
    const auto settled = window.at(6.0);
    ASSERT_TRUE(settled);
    EXPECT_TRUE(settled->settled);
    EXPECT_NEAR(wrap180(settled->mean_deg), 0.0, 0.01);
    EXPECT_NEAR(settled->spread_deg, 0.4, 1e-9);
    EXPECT_NEAR(settled->standardDeviation_deg, 0.2, 0.01);
}

TEST(SettlingWindow, aSwingingCardIsNotSettled)
{
    SettlingWindow window(5.0, 1.0);
    for (int i = 0; i <= 100; ++i)
        window.add(i * 0.1, 90.0 + 2.0 * std::sin(i * 0.5));
    EXPECT_FALSE(window.at(10.0)->settled);
    EXPECT_GT(window.at(10.0)->spread_deg, 3.0);
}

TEST(SettlingWindow, silenceAndClocksThatJump)
{
    SettlingWindow window(5.0, 1.0);
    for (int i = 0; i <= 60; ++i)
        window.add(100 + i * 0.1, 45.0);
    EXPECT_TRUE(window.at(106.0)->settled);
    EXPECT_FALSE(window.at(112.0)); // silent
    window.add(50.0, 47.0);         // set back
    const auto anew = window.at(50.0);
    ASSERT_TRUE(anew);
    EXPECT_EQ(anew->count, 1);
    EXPECT_FALSE(anew->settled);
    EXPECT_DOUBLE_EQ(anew->mean_deg, 47.0);
}

TEST(SettlingWindow, tellsHowFastItTurns)
{
    SettlingWindow window(5.0, 1.0);
    window.add(0.0, 350.0);
    window.add(0.5, 351.0);
    EXPECT_FALSE(window.at(0.5)->turnRate_deg_s); // of half a second
    for (int i = 2; i < 20; ++i)
        window.add(0.5 * i, wrap360(350.0 + 2.0 * 0.5 * i));
    EXPECT_NEAR(*window.at(9.5)->turnRate_deg_s, 2.0, 1e-9); // through north
    SettlingWindow back(5.0, 1.0);
    for (int i = 0; i < 10; ++i)
        back.add(i, wrap360(3.0 - 0.5 * i));
    EXPECT_NEAR(*back.at(9.0)->turnRate_deg_s, -0.5, 1e-9);
}

} // namespace
} // namespace lubberline
