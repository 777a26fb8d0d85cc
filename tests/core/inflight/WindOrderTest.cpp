// Rows of wind reports come in any order, and directions wrap: neither may change what is found.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/core/inflight/SimulatedFleets.h"

using namespace lubberline;
using namespace lubberline::test;

namespace {

struct OwnedReport {
    WindReport report;
    std::string aircraft, flight;
};

/// Flights with turns: the track of every tenth report is on its way to another, 20 s after the one before.
std::vector<OwnedReport> turningReports(int flights)
{
    std::vector<OwnedReport> reports;
    SimulatedWinds winds(41);
    SimulatedAircraft one;
    one.flights = flights;
    one.reports = 40;
    int place = 0;
    winds.fly(one, {}, [&](WindReport& report) {
        if (place++ % 10 == 5) {
            OwnedReport turning{report, std::string(report.aircraft), std::string(report.flight)};
            turning.report.time_s += 20;
            turning.report.track_deg = wrap360(report.track_deg + 40);
            turning.report.windFrom_deg = wrap360(report.windFrom_deg + 90); // made with a heading that lags
            reports.push_back(turning);
        }
        reports.push_back({report, std::string(report.aircraft), std::string(report.flight)});
    });
    return reports;
}

AircraftWinds studied(const std::vector<OwnedReport>& reports)
{
    WindStudy study{WindOptions{}};
    for (const auto& one : reports) {
        WindReport report = one.report;
        report.aircraft = one.aircraft;
        report.flight = one.flight;
        study.add(report);
    }
    return study.finish().aircraft.at(0);
}

std::int64_t turningIn(const AircraftWinds& one) { return one.leftOut[static_cast<std::size_t>(LeftOut::Turning)]; }

} // namespace

TEST(WindOrder, aShuffledFileTellsWhatAnOrderedOneTells)
{
    auto reports = turningReports(12);
    std::stable_sort(reports.begin(), reports.end(), [](const auto& a, const auto& b) { return a.report.time_s < b.report.time_s; });
    const AircraftWinds ordered = studied(reports);
    ASSERT_EQ(turningIn(ordered), 48);
    std::mt19937_64 engine(5);
    for (int round = 0; round < 3; ++round) {
        if (round == 0)
            std::reverse(reports.begin(), reports.end());
        else
            std::shuffle(reports.begin(), reports.end(), engine);
        const AircraftWinds other = studied(reports);
        EXPECT_EQ(turningIn(other), 48);
        EXPECT_EQ(other.used, ordered.used);
        EXPECT_EQ(other.late, 0);
        for (int column = 0; column < 3; ++column) {
            EXPECT_NEAR(other.fit.fit.value(column), ordered.fit.fit.value(column), 1e-9);
            EXPECT_NEAR(other.fit.fit.standardError(column), ordered.fit.fit.standardError(column), 1e-9);
        }
        EXPECT_FALSE(says(other.warnings, "later ones of their flight"));
    }
}

TEST(WindOrder, reportsThatComeTooLateAreCounted)
{
    // More reports than are held, in no order at all.
    auto reports = turningReports(500);
    std::mt19937_64 engine(6);
    std::shuffle(reports.begin(), reports.end(), engine);
    const AircraftWinds one = studied(reports);
    EXPECT_GT(one.late, 500); // of 22 000, of which 4096 are held
    EXPECT_LT(one.late, one.observations);
    EXPECT_TRUE(says(one.warnings, std::to_string(one.late) + " reports came long after later ones of their flight"));
    // In order of time they are judged all, however many.
    std::stable_sort(reports.begin(), reports.end(), [](const auto& a, const auto& b) { return a.report.time_s < b.report.time_s; });
    const AircraftWinds ordered = studied(reports);
    EXPECT_EQ(ordered.late, 0);
    EXPECT_EQ(turningIn(ordered), 4 * 500);
}

TEST(WindOrder, aCompassThatReadsTheOtherEndIsTold)
{
    for (const double c_deg : {179.0, -178.0, 180.0}) {
        auto fleet = someAircraft(4, 3);
        for (auto& one : fleet)
            one.c_deg = c_deg;
        fleet[3].c_deg = 0.5;
        const WindResult result = studyOf(fleet, 8);
        for (std::size_t i = 0; i < 3; ++i) {
            const AircraftWinds& one = result.aircraft[i];
            ASSERT_TRUE(one.fitted) << c_deg;
            EXPECT_NEAR(wrap180(one.fit.fit.value(0) - c_deg), 0.0, 3 * one.fit.fit.standardError(0)) << c_deg;
            EXPECT_LE(std::abs(one.fit.fit.value(0)), 180.0);
            EXPECT_NEAR(one.fit.fit.value(1), fleet[i].a_deg, 3.5 * one.fit.fit.standardError(1));
            EXPECT_NEAR(one.fit.fit.value(2), fleet[i].b_deg, 3.5 * one.fit.fit.standardError(2));
            EXPECT_LT(one.fit.fit.standardError(0), 0.5);
            EXPECT_TRUE(one.changes.empty());
            EXPECT_TRUE(says(one.warnings, "the other end of the needle"));
            EXPECT_FALSE(one.after.has_value()); // a correction by half a turn is no small one
        }
        EXPECT_FALSE(says(result.aircraft[3].warnings, "the other end of the needle"));
        EXPECT_NEAR(result.aircraft[3].fit.fit.value(0), 0.5, 0.5);
    }
}

TEST(WindOrder, oneWildReportTurnsNoAircraftRound)
{
    SimulatedAircraft one;
    int place = 0;
    const WindResult result = studyOf({one}, 9, {}, [&](WindReport& report) {
        if (place++ == 0) { // read the wrong way round: the first of all
            const Eigen::Vector2d ground = velocityOf(report.track_deg, report.groundSpeed_kt);
            const Eigen::Vector2d air = ground - velocityOf(report.windFrom_deg, -report.wind_kt), reported = ground + air;
            report.wind_kt = reported.norm();
            report.windFrom_deg = directionOf_deg(-reported);
        }
    });
    EXPECT_NEAR(result.aircraft[0].fit.fit.value(0), one.c_deg, 4 * result.aircraft[0].fit.fit.standardError(0));
    EXPECT_FALSE(says(result.aircraft[0].warnings, "the other end of the needle"));
}
