// Deviation from winds: a fleet with known errors comes back within its own standard errors, and what figures cannot tell is said.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/core/inflight/SimulatedFleets.h"

using namespace lubberline;
using namespace lubberline::test;

namespace {

TEST(WindStudy, aFleetIsWithinItsOwnStandardErrors)
{
    const auto fleet = someAircraft(16, 3);
    const WindResult result = studyOf(fleet, 7);
    ASSERT_EQ(result.aircraft.size(), fleet.size());
    double squares = 0, before = 0, after = 0, longBefore = 0, longAfter = 0;
    int within3 = 0;
    for (std::size_t i = 0; i < fleet.size(); ++i) {
        const auto& one = result.aircraft[i];
        const std::array<double, 3> truth{fleet[i].c_deg, fleet[i].a_deg, fleet[i].b_deg};
        for (int column = 0; column < 3; ++column) {
            const double z = (one.fit.fit.value(column) - truth[static_cast<std::size_t>(column)]) / one.fit.fit.standardError(column);
            squares += z * z;
            within3 += std::abs(z) < 3;
        }
        EXPECT_LT(one.fit.fit.standardError(1), 0.2);
        before += one.before.transverse_kt;
        after += one.after->transverse_kt;
        longBefore += one.before.longitudinal_kt;
        longAfter += one.after->longitudinal_kt;
        EXPECT_NEAR(*one.airspeedOffset_kt, 3.0, 4 * *one.airspeedOffsetError_kt);
    }
    EXPECT_GE(within3, 46); // of 48: 0.9973 each
    EXPECT_NEAR(std::sqrt(squares / 48), 1.0, 0.3);
    EXPECT_LT(after, 0.5 * before);                        // 13 kt across the track fall to the reference's own 3
    EXPECT_NEAR(longAfter, longBefore, 0.05 * longBefore); // an airspeed offset of 3 kt stays in it
}

TEST(WindStudy, reportsOfAFlightAreNoIndependentWitnesses)
{
    SimulatedAircraft one;
    one.legs = 6;
    one.reports = 60;
    const WindResult result = studyOf({one}, 5, {3.0, 0.5, 0, 0});
    const ClusteredFit& fit = result.aircraft[0].fit.fit;
    // 1200 reports that scatter by some 0.2° would give 0.01°; 20 flights that are each wrong by 3 kt of 430 (0.4°) give 0.09°.
    EXPECT_GT(fit.standardError(1), 0.05);
    EXPECT_LT(fit.standardError(1), 0.2);
    EXPECT_NEAR(fit.value(1), one.a_deg, 3 * fit.standardError(1));
}

TEST(WindStudy, aRecalibrationIsFoundWithinThreeFlights)
{
    auto fleet = someAircraft(12, 11);
    for (std::size_t i = 0; i < 6; ++i) {
        fleet[i].changesAfter = fleet[i].flights - 4; // three flights after it
        fleet[i].aAfter_deg = fleet[i].a_deg + 1.5;
        fleet[i].bAfter_deg = fleet[i].b_deg;
    }
    const WindResult result = studyOf(fleet, 13);
    int placed = 0;
    for (std::size_t i = 0; i < fleet.size(); ++i) {
        const auto& changes = result.aircraft[i].changes;
        ASSERT_EQ(changes.size(), i < 6 ? 1u : 0u) << fleet[i].name;
        if (i >= 6)
            continue;
        EXPECT_LT(changes[0].p, 0.05);
        const std::string& after = changes[0].afterFlight; // of a hundred, 96 are found at the very flight
        EXPECT_TRUE(after == "F115" || after == "F116" || after == "F117") << after;
        if (after != "F116")
            continue;
        ++placed;
        EXPECT_EQ(changes[0].beforeFlight, "F117");
        EXPECT_NEAR(changes[0].step_deg(1), 1.5, 0.8);
        EXPECT_EQ(result.aircraft[i].flightsFitted, 3);
        EXPECT_NEAR(result.aircraft[i].fit.fit.value(1), fleet[i].aAfter_deg, 3 * result.aircraft[i].fit.fit.standardError(1));
    }
    EXPECT_GE(placed, 5);
}

TEST(WindStudy, aChangeIsSeldomFoundWhereNoneIs)
{
    // One aircraft alone. Flights of one heading tell of the errors that they share far less than their number says.
    for (const int legs : {1, 3}) {
        int found = 0;
        constexpr int kFleets = 60;
        for (int i = 0; i < kFleets; ++i) {
            SimulatedAircraft one;
            one.flights = 10;
            one.legs = legs;
            found += !studyOf({one}, static_cast<std::uint64_t>(2000 + i)).aircraft[0].changes.empty();
        }
        EXPECT_LE(found, 8) << legs; // 5 %: 3, and 9 or more once in 400
    }
}

TEST(WindStudy, theSecondOrderIsUsedWhereItIsThere)
{
    SimulatedAircraft plain, curved;
    plain.legs = curved.legs = 8;
    curved.name = "SP-LRB";
    curved.d_deg = 1.0;
    const WindResult result = studyOf({plain, curved}, 17);
    EXPECT_TRUE(result.aircraft[0].secondOrderTold);
    EXPECT_FALSE(result.aircraft[0].secondOrderUsed());
    const auto& bent = result.aircraft[1];
    ASSERT_TRUE(bent.secondOrderUsed());
    EXPECT_NEAR(bent.fit.fit.value(3), 1.0, 3 * bent.fit.fit.standardError(3));
    EXPECT_TRUE(says(bent.warnings, "no sine"));
    // Its table is no sine: opposite points do not add up to twice the offset alone.
    const auto table = bent.table_deg(TableFactor::None);
    EXPECT_GT(std::abs(table[1] + table[5] - 2 * -bent.fit.fit.value(0)), 1.5);
}

TEST(WindStudy, tableFactorsAreNamed)
{
    EXPECT_EQ(tableFactor(TableFactor::Paper), 1.05);
    EXPECT_NEAR(tableFactor(TableFactor::Exact), 1.053029, 1e-6);
    EXPECT_EQ(tableFactor(TableFactor::None), 1.0);
    AircraftWinds one;
    one.fit.fit.value << 0.5, 2.0, 0.0, 0.0, 0.0;
    const auto exact = one.table_deg(TableFactor::Exact);
    EXPECT_NEAR(exact[2], -(0.5 + 2 * 1.053029), 1e-5); // deviation's sign
    // Joined by straight lines the first harmonic is the sine itself.
    double product = 0;
    constexpr int kSteps = 3600;
    for (int i = 0; i < kSteps; ++i) {
        const double heading = 360.0 * i / kSteps, place = heading / 45.0;
        const auto left = static_cast<std::size_t>(place);
        const double line = exact[left] + (exact[(left + 1) % 8] - exact[left]) * (place - std::floor(place));
        product += line * std::sin(toRadians(heading)) * 2.0 / kSteps;
    }
    EXPECT_NEAR(product, -2.0, 1e-5);
}

TEST(WindStudy, twoOppositeHeadingsTellNoMoreThanTheyCan)
{
    // East and west only: A and B are told, C is not.
    SimulatedWinds winds(23);
    WindStudy eastWest{WindOptions{}};
    for (int flight = 0; flight < 10; ++flight)
        for (int i = 0; i < 20; ++i) {
            const double heading_deg = (i < 10 ? 90.0 : 270.0) + 0.5 * winds.normal();
            const double e_deg = 0.5 + 2.0 * std::sin(toRadians(heading_deg));
            const Eigen::Vector2d wind(5, 10), ground = velocityOf(heading_deg, 400) + wind;
            const Eigen::Vector2d reported = ground - velocityOf(heading_deg + e_deg + 0.1 * winds.normal(), 400);
            WindReport report;
            report.groundSpeed_kt = ground.norm();
            report.track_deg = directionOf_deg(ground);
            report.wind_kt = reported.norm();
            report.windFrom_deg = directionOf_deg(-reported);
            report.reference_kt = wind.norm();
            report.referenceFrom_deg = directionOf_deg(-wind);
            report.time_s = 1.7e9 + 86400.0 * flight + 300.0 * i;
            eastWest.add(report);
        }
    const auto result = eastWest.finish();
    const auto& found = result.aircraft[0];
    ASSERT_TRUE(found.fitted);
    ASSERT_TRUE(found.fit.offset_deg() && found.fit.inPhase_deg());
    EXPECT_NEAR(*found.fit.offset_deg(), 0.5, 0.05);
    EXPECT_NEAR(*found.fit.inPhase_deg(), 2.0, 0.05);
    EXPECT_GT(found.fit.fit.standardError(0), 0.03); // 3° from opposite: a thirtieth of an untold C is in A
    EXPECT_FALSE(found.fit.quadrature_deg().has_value());
    EXPECT_TRUE(says(found.warnings, "do not tell C"));
}

TEST(WindStudy, oneFlightHasNoErrorsThatCouldBeTrusted)
{
    SimulatedAircraft one;
    one.flights = 1;
    const auto result = studyOf({one}, 29);
    const auto& found = result.aircraft[0];
    EXPECT_FALSE(found.fit.fit.errorsTold);
    EXPECT_FALSE(found.after.has_value());
    EXPECT_TRUE(says(found.warnings, "one flight only"));
}

TEST(WindStudy, windsTowardsAndMetresASecondAreAskedFor)
{
    const auto towards = [](WindReport& report) { report.windFrom_deg = wrap360(report.windFrom_deg + 180); };
    auto result = studyOf({SimulatedAircraft{}}, 31, {}, towards);
    EXPECT_FALSE(result.aircraft[0].fitted);
    EXPECT_TRUE(says(result.aircraft[0].warnings, "blowing towards"));
    result = studyOf(
        {SimulatedAircraft{}}, 31, {}, [](WindReport& report) { report.referenceFrom_deg = wrap360(report.referenceFrom_deg + 180); });
    EXPECT_TRUE(says(result.aircraft[0].warnings, "blow against each other"));
    result = studyOf({SimulatedAircraft{}}, 31, {}, [](WindReport& report) { report.wind_kt *= 1852.0 / 3600.0; });
    EXPECT_FALSE(result.aircraft[0].fitted);
    EXPECT_TRUE(says(result.aircraft[0].warnings, "m/s"));
    result = studyOf({SimulatedAircraft{}}, 31);
    EXPECT_TRUE(result.aircraft[0].fitted);
}

TEST(WindStudy, duplicatesCountOnceAndOrderDoesNotMatter)
{
    std::vector<WindReport> reports;
    SimulatedWinds winds(37);
    SimulatedAircraft one;
    winds.fly(one, {}, [&](WindReport& report) {
        report.flight = {};
        report.aircraft = "SP-LRA";
        reports.push_back(report);
    });
    WindStudy straight{WindOptions{}}, doubled{WindOptions{}};
    for (const auto& report : reports)
        straight.add(report);
    std::shuffle(reports.begin(), reports.end(), std::mt19937_64(1));
    for (const auto& report : reports)
        doubled.add(report);
    for (const auto& report : reports)
        doubled.add(report);
    const auto a = straight.finish(), b = doubled.finish();
    EXPECT_EQ(b.aircraft[0].leftOut[static_cast<std::size_t>(LeftOut::Duplicate)], 400);
    EXPECT_EQ(b.aircraft[0].used, a.aircraft[0].used);
    EXPECT_EQ(b.aircraft[0].flights, 20); // by gaps of time
    for (int column = 0; column < 3; ++column)
        EXPECT_NEAR(a.aircraft[0].fit.fit.value(column), b.aircraft[0].fit.fit.value(column), 0.02);
}

TEST(WindStudy, filtersSayWhatTheyLeaveOut)
{
    int row = 0;
    const auto result = studyOf({SimulatedAircraft{}}, 41, {}, [&](WindReport& report) {
        switch (row++ % 5) {
        case 0: report.roll_deg = 12; break;
        case 1: report.reference_kt = kMissing; break;
        case 2: report.wind_kt = kMissing; break; // no heading column, either
        default: break;
        }
    });
    const auto& left = result.aircraft[0].leftOut;
    EXPECT_EQ(left[static_cast<std::size_t>(LeftOut::Rolling)], 80);
    EXPECT_EQ(left[static_cast<std::size_t>(LeftOut::NoReference)], 80);
    EXPECT_EQ(left[static_cast<std::size_t>(LeftOut::NoWind)], 80);
    EXPECT_EQ(result.aircraft[0].used, 160);
}

/// Half of the flights in knots, the other half in metres a second: no change of the deviation, and nothing to fit.
TEST(WindStudy, aUnitThatChangesIsAskedAndNotFitted)
{
    for (const double factor : {0.514444, 1.9438445}) {
        int row = 0;
        const auto result = studyOf({SimulatedAircraft{}}, 41, {}, [&](WindReport& report) {
            if (row++ >= 200) // after ten flights of twenty reports
                report.wind_kt *= factor;
        });
        const auto& one = result.aircraft[0];
        EXPECT_FALSE(one.fitted) << factor;
        EXPECT_TRUE(one.changes.empty());
        EXPECT_TRUE(says(one.warnings, "as knots and metres a second would")) << factor;
    }
    EXPECT_TRUE(studyOf({SimulatedAircraft{}}, 41, {}, [](WindReport&) {}).aircraft[0].fitted);
}

TEST(WindStudy, aConstantErrorOfTheReferenceIsNotToldFromTheFleet)
{
    const auto fleet = someAircraft(9, 43);
    const auto result = studyOf(fleet, 47, {1.0, 1.0, 0.0, 6.0});
    ASSERT_TRUE(result.common.has_value());
    EXPECT_TRUE(says(result.warnings, "in common"));
    EXPECT_TRUE(says(result.warnings, "95 %)"));
    EXPECT_GT(result.common->asWind_kt(), 2.0);
    EXPECT_FALSE(studyOf({fleet[0]}, 47).common.has_value());
    EXPECT_TRUE(says(studyOf({fleet[0]}, 47).warnings, "too few aircraft"));
}

TEST(WindStudy, theArgumentIsMagneticWhereThePlaceIsKnown)
{
    const auto here = studyOf({SimulatedAircraft{}}, 53, {}, [](WindReport& report) {
        report.latitude_deg = 52;
        report.longitude_deg = -120; // declination some 15° east
    });
    const auto there = studyOf({SimulatedAircraft{}}, 53);
    EXPECT_TRUE(here.aircraft[0].declinationOut);
    EXPECT_GT(here.aircraft[0].meanDeclination_deg, 10);
    EXPECT_TRUE(says(there.aircraft[0].warnings, "declination is not taken out"));
    // The same errors, told in headings that are less by the declination: the sine turns.
    const auto& magnetic = here.aircraft[0].fit.fit.value;
    const auto& geographic = there.aircraft[0].fit.fit.value;
    const double turn = toRadians(here.aircraft[0].meanDeclination_deg);
    EXPECT_NEAR(magnetic(1), geographic(1) * std::cos(turn) - geographic(2) * std::sin(turn), 0.02);
    EXPECT_NEAR(magnetic(2), geographic(1) * std::sin(turn) + geographic(2) * std::cos(turn), 0.02);
}

TEST(WindStudy, dotsStandForAllReports)
{
    SimulatedAircraft aircraft;
    aircraft.flights = 200;
    const auto one = studyOf({aircraft}, 5).aircraft[0];
    EXPECT_GE(one.dots.size(), 300u);
    EXPECT_LT(one.dots.size(), 600u);
    ASSERT_TRUE(one.changes.empty()); // the fit below is of all flights, as the dots are
    double sum = 0;
    for (const WindDot& dot : one.dots)
        sum += dot.error_deg - one.errorAt_deg(dot.heading_deg);
    EXPECT_NEAR(sum / static_cast<double>(one.dots.size()), 0, 0.06); // 0.013 rms over 50 seeds
}

TEST(WindStudy, whyNoReportCanBeUsedIsSaid)
{
    const auto result = studyOf({SimulatedAircraft{}}, 59, {}, [](WindReport& report) { report.reference_kt = kMissing; });
    EXPECT_FALSE(result.aircraft[0].fitted);
    EXPECT_TRUE(says(result.aircraft[0].warnings, "400 of 400 are left out for this: no reference wind"));
}

TEST(WindStudy, windZeroAndSlowReportsDoNoHarm)
{
    WindStudy study{WindOptions{}};
    for (int i = 0; i < 40; ++i) {
        WindReport report;
        report.groundSpeed_kt = i % 4 == 0 ? 20 : 300; // hovering into the wind
        report.track_deg = 9.0 * i;
        report.wind_kt = 0;
        report.reference_kt = 0;
        report.time_s = 1.7e9 + 4000.0 * i;
        study.add(report);
    }
    const auto result = study.finish();
    EXPECT_EQ(result.aircraft[0].leftOut[static_cast<std::size_t>(LeftOut::Slow)], 10);
    EXPECT_NEAR(result.aircraft[0].fit.fit.value(1), 0.0, 1e-9);
}

} // namespace
