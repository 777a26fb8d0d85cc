#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>

#include "tests/core/fleet/SimulatedFleet.h"

using namespace lubberline;
using namespace lubberline::test;

namespace {

/// Everything that a report says in figures.
std::vector<double> figuresOf(const FleetReport& report, const FleetSwings& fleet)
{
    std::vector<double> all;
    const auto add = [&](std::optional<double> value) { all.push_back(value.value_or(-999)); };
    for (const auto& p : report.pattern.points)
        for (const auto& value : {p.mean_deg, p.standardDeviation_deg, p.between_deg, p.percentile5_deg, p.percentile95_deg})
            add(value);
    for (const auto& c : report.pattern.coefficients)
        for (const auto& value : {c.mean_deg, c.between_deg, c.percentile50_deg})
            add(value);
    for (const auto& order : report.pattern.spread)
        add(order.amplitude_rad());
    add(report.exceedance.expectedShare);
    add(report.exceedance.threeSigmaShare);
    for (const auto& c : report.variance)
        if (c.report)
            for (const double value : {c.report->residual.variance, c.report->residual.interval.low, c.report->criterion})
                add(value);
    for (const auto& jump : report.changes.jumps) {
        add(jump.p);
        add(jump.change_deg);
        add(fleet.swings[jump.beforeRow].day);
    }
    for (const auto& drift : report.changes.drifts)
        add(drift.drift.p);
    for (const auto& ranked : report.ranking.compasses) {
        add(ranked.probability);
        add(ranked.compass);
        add(ranked.reached50_day ? std::optional<double>(*ranked.reached50_day) : std::nullopt);
    }
    if (report.plants.training)
        add(report.plants.training->change);
    return all;
}

FleetSwings shuffled(const FleetSwings& fleet, std::uint32_t seed)
{
    std::mt19937 random(seed);
    FleetSwings other;
    other.sites = fleet.sites;
    other.crews = fleet.crews;
    std::vector<std::int32_t> compasses(fleet.compasses.size());
    std::iota(compasses.begin(), compasses.end(), 0);
    std::ranges::shuffle(compasses, random);
    std::vector<std::int32_t> place(compasses.size());
    for (std::size_t i = 0; i < compasses.size(); ++i) {
        other.compasses.push_back(fleet.compasses[static_cast<std::size_t>(compasses[i])]);
        other.compasses.back().id = CompassId{static_cast<std::int64_t>(i + 1)};
        place[static_cast<std::size_t>(compasses[i])] = static_cast<std::int32_t>(i);
    }
    std::vector<std::size_t> order(fleet.swings.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::shuffle(order, random);
    for (const auto row : order) {
        FleetSwing swing = fleet.swings[row];
        std::vector<std::uint32_t> readings(swing.count);
        std::iota(readings.begin(), readings.end(), swing.first);
        std::ranges::shuffle(readings, random);
        swing.first = static_cast<std::uint32_t>(other.magnetic_deg.size());
        swing.compass = place[static_cast<std::size_t>(swing.compass)];
        swing.id = SwingId{static_cast<std::int64_t>(random())};
        other.swings.push_back(swing);
        for (const auto reading : readings) {
            other.magnetic_deg.push_back(fleet.magnetic_deg[reading]);
            other.compass_deg.push_back(fleet.compass_deg[reading]);
        }
    }
    return other;
}

} // namespace

TEST(FleetReport, doesNotDependOnTheOrderOfRecordsToTheLastDigit)
{
    Truth truth;
    truth.pairs = true;
    truth.extra = [](int a, int s, std::size_t c) { return a == 3 && s >= 4 && c == 1 ? 4.0 : a == 5 && c == 2 ? 0.5 * s : 0.0; };
    const SimulatedFleet simulated(truth);
    const auto figures = figuresOf(reported(simulated.fleet), simulated.fleet);
    EXPECT_GT(figures.size(), 100u);
    for (const std::uint32_t seed : {1u, 2u}) {
        FleetSwings other = shuffled(simulated.fleet, seed);
        putInOrder(other);
        EXPECT_EQ(figuresOf(reported(other), other), figures);
    }
}

TEST(FleetReport, findsThePopulationThatItCameFrom)
{
    Truth truth;
    truth.aircraft = 400;
    truth.swings = 2;
    truth.noise_deg = 0.7;
    const SimulatedFleet simulated(truth);
    const auto report = reported(simulated.fleet, {.variance = false});
    for (std::size_t c = 0; c < 5; ++c) {
        const auto& spread = report.pattern.coefficients[c];
        EXPECT_NEAR(*spread.mean_deg, truth.mean[c], 3.5 * *spread.standardError_deg);
        EXPECT_NEAR(*spread.between_deg, truth.between[c], 3.5 * *spread.standardDeviation_deg / std::sqrt(2.0 * 399));
        EXPECT_GT(*spread.standardDeviation_deg, *spread.between_deg);
    }
    for (const auto& point : report.pattern.points) {
        const FiveTerms x = termsAt(point.heading_deg);
        double variance = 0;
        for (std::size_t c = 0; c < 5; ++c)
            variance += std::pow(x[c] * truth.between[c], 2);
        EXPECT_EQ(point.units, 400);
        EXPECT_NEAR(*point.between_deg, std::sqrt(variance), 0.12 * std::sqrt(variance));
        EXPECT_EQ(point.moved, 0);
    }
    EXPECT_EQ(report.counts.aircraft, 400);
    EXPECT_EQ(report.counts.used, 800);
}

TEST(FleetReport, fitErrorIsTakenOutOfTheSpreadOfASingleSwing)
{
    // Eight readings of 0.7° on aircraft that differ by 1° read 14 % too wide: √(1 + 0.49·5/8).
    Truth truth;
    truth.aircraft = 3000;
    truth.swings = 1;
    truth.noise_deg = 0.7;
    truth.mean = {};
    truth.between = {1, 0, 0, 0, 0};
    const SimulatedFleet simulated(truth);
    const auto curves = curvesOf(simulated.fleet);
    const auto pattern = patternOf(simulated.fleet, *curves, {});
    for (const auto& point : pattern.points)
        EXPECT_NEAR(*point.between_deg, 1.0, 0.05);
    double wide = 0;
    for (const auto& curve : curves->curves)
        wide += std::pow(curveAtCompass_deg(curve.value_deg, 0), 2) / 3000;
    EXPECT_NEAR(std::sqrt(wide), 1.143, 0.05);
}

TEST(FleetReport, typeLikeThePapersHasItsMaximaAndMinima)
{
    Truth truth;
    truth.mean = {0.9, 0.5, 0.1, -2.2, 0.1}; // D, A, B dominate; maxima of −sin 2ψ at 135° and 315°
    truth.between = {0.6, 0.5, 0.5, 0.1, 0.1};
    const SimulatedFleet simulated(truth);
    const auto report = reported(simulated.fleet, {.variance = false});
    EXPECT_EQ(report.pattern.maxima_deg, (std::vector<double>{135, 315}));
    EXPECT_EQ(report.pattern.minima_deg, (std::vector<double>{45, 225}));
    ASSERT_EQ(report.pattern.mean.size(), 5u);
    EXPECT_NEAR(toDegrees(report.pattern.mean[2].sin_rad), -2.2, 0.15);
}

TEST(FleetReport, jumpsAreFoundAtTheStatedFalseDiscoveryRate)
{
    int found = 0, wrong = 0, there = 0;
    for (std::uint32_t seed = 1; seed <= 4; ++seed) {
        Truth truth;
        truth.seed = seed;
        truth.aircraft = 250;
        truth.swings = 10;
        truth.swing_deg = 0.3;
        // σ of B is 0.5·√(2/8) = 0.25: jumps of six of them in every tenth aircraft
        truth.extra = [](int a, int s, std::size_t c) { return a % 10 == 0 && c == 1 && s >= 5 ? 1.5 : 0.0; };
        const SimulatedFleet simulated(truth);
        const auto report = reported(simulated.fleet, {.variance = false});
        there += 25;
        for (const auto& jump : report.changes.jumps) {
            const bool right = jump.compass % 10 == 0 && jump.coefficient == 1
                && simulated.fleet.swings[jump.beforeRow].day / 365 - simulated.fleet.swings[jump.afterRow].day / 365 == 1;
            (right ? found : wrong) += 1;
            if (right) {
                EXPECT_NEAR(jump.change_deg, 1.5, 4.5 * jump.standardError_deg);
            }
        }
    }
    EXPECT_GE(found, 0.9 * there);
    EXPECT_LE(wrong, 0.2 * (found + wrong)); // 10 % is the mean of many fleets
}

TEST(FleetReport, driftsAndCorrectionsAreNotTakenForJumps)
{
    Truth truth;
    truth.pairs = true;
    truth.aircraft = 120;
    truth.extra = [](int a, int s, std::size_t c) { return a % 4 == 0 && c == 2 ? 0.4 * s : 0.0; };
    const SimulatedFleet simulated(truth);
    const auto report = reported(simulated.fleet, {.variance = false});
    EXPECT_LE(report.changes.jumps.size(), 4u);
}

TEST(FleetReport, exceedanceIsThatOfTheFoundPopulation)
{
    Truth truth;
    truth.pairs = true;
    truth.aircraft = 300;
    truth.swings = 3;
    truth.mean = {0.5, -1.0, 0.8, 0.5, 0.2};
    truth.limit_deg = 3.0;
    // After each correction A, B and C wander anew.
    auto random = std::make_shared<std::mt19937>(7);
    truth.extra = [random](int, int, std::size_t c) { return c < 3 ? 0.9 * std::normal_distribution<>()(*random) : 0.0; };
    const SimulatedFleet simulated(truth);
    const auto report = reported(simulated.fleet, {.variance = false});
    const auto& exceedance = report.exceedance;
    EXPECT_EQ(exceedance.pairs, 600);
    const double share = static_cast<double>(exceedance.exceeded) / 600;
    ASSERT_TRUE(exceedance.expectedShare);
    EXPECT_GE(*exceedance.expectedShare, exceedance.share95->low);
    EXPECT_LE(*exceedance.expectedShare, exceedance.share95->high);
    EXPECT_LT(*exceedance.threeSigmaShare, *exceedance.expectedShare); // one heading is beyond less often than any of them
    EXPECT_EQ(exceedance.byType.size(), 1u);
    EXPECT_NEAR(share, *exceedance.expectedShare, 0.06);
}

TEST(FleetReport, rankingPutsDriftFirstAndTheSingleSwingNotAtTheHead)
{
    Truth truth;
    truth.aircraft = 60;
    truth.limit_deg = 6.0;
    truth.mean = {0.2, 0.5, 0.5, 1.0, 0.1};
    truth.between = {0.2, 0.5, 0.5, 0.2, 0.2};
    truth.extra = [](int a, int s, std::size_t c) { return a == 17 && c == 1 ? 0.5 * s : 0.0; };
    SimulatedFleet simulated(truth);
    // Another that was swung once, by bad readings.
    auto& fleet = simulated.fleet;
    fleet.compasses.push_back(fleet.compasses.back());
    fleet.compasses.back().aircraft = "SIM-2000";
    FleetSwing swing;
    swing.compass = 60;
    swing.day = 16000;
    swing.first = static_cast<std::uint32_t>(fleet.magnetic_deg.size());
    swing.count = 8;
    fleet.swings.push_back(swing);
    for (int r = 0; r < 8; ++r) {
        fleet.magnetic_deg.push_back(45.0 * r);
        fleet.compass_deg.push_back(wrap360(45.0 * r - 2.8 * std::sin(toRadians(45.0 * r)) - 1.0 * std::sin(toRadians(90.0 * r))));
    }
    const auto report = reported(fleet, {.variance = false});
    ASSERT_EQ(report.ranking.compasses.size(), 61u);
    const auto& first = report.ranking.compasses.front();
    EXPECT_EQ(fleet.compasses[static_cast<std::size_t>(first.compass)].aircraft, "SIM-1017");
    EXPECT_EQ(first.reason, RankReason::Drift);
    EXPECT_NEAR(first.drift_deg_year[1], 0.5, 0.15);
    EXPECT_EQ(inWords(first).english().substr(0, 10), "B drifts b");
    ASSERT_FALSE(report.changes.drifts.empty());
    EXPECT_EQ(report.changes.drifts.front().compass, 17);
    EXPECT_NEAR(report.changes.drifts.front().drift.perYear, 0.5, 0.1);
    ASSERT_TRUE(first.reached50_day);
    EXPECT_LT(*first.reached5_day, *first.reached50_day);
}

TEST(FleetReport, fallOfAAtATrainingDateIsFound)
{
    Truth truth;
    truth.aircraft = 80;
    truth.swings = 10;
    truth.between[0] = 0.0;
    truth.mean[0] = 0;
    truth.noise_deg = 0.1;
    auto random = std::make_shared<std::mt19937>(3);
    truth.extra
        = [random](int, int s, std::size_t c) { return c == 0 ? (s < 5 ? 1.5 : 0.3) * std::normal_distribution<>()(*random) : 0.0; };
    const SimulatedFleet simulated(truth);
    const auto report = reported(simulated.fleet, {.variance = false});
    ASSERT_TRUE(report.plants.training);
    const auto& training = *report.plants.training;
    EXPECT_NEAR(training.day, 14000 + 5 * 365, 25);
    EXPECT_NEAR(training.change, -0.8, 0.06);
    EXPECT_LE(training.change95.low, -0.8);
    EXPECT_GE(training.change95.high, -0.8);
    EXPECT_EQ(training.compassesOnBothSides, 80);
    // The crews' error is not taken for the compasses'.
    EXPECT_LE(std::ranges::count(report.changes.jumps, std::size_t{0}, &FleetJump::coefficient), 3);
    const auto given = reported(simulated.fleet, {.training_day = 14000 + 5 * 365, .variance = false});
    EXPECT_TRUE(given.plants.training->given);
    EXPECT_NEAR(given.plants.training->change, -0.8, 0.06);
}

TEST(FleetReport, anAlarmIsToldOnceWithItsFirstAndItsLastDay)
{
    Truth truth;
    truth.aircraft = 40;
    truth.swings = 10;
    truth.between[0] = 0.0;
    truth.mean[0] = 0;
    truth.noise_deg = 0.1;
    auto random = std::make_shared<std::mt19937>(5);
    // Three years of ten stand off by five times the scatter of the others.
    truth.extra = [random](int, int s, std::size_t c) {
        return c == 0 ? (s >= 4 && s < 7 ? 1.5 : 0.0) + 0.3 * std::normal_distribution<>()(*random) : 0.0;
    };
    SimulatedFleet simulated(truth);
    simulated.fleet.sites = {"one base"};
    for (auto& swing : simulated.fleet.swings)
        swing.site = 0;
    const auto report = reported(simulated.fleet, {.variance = false});
    ASSERT_TRUE(report.plants.charts);
    std::vector<ChartAlarm> ofBase;
    for (const auto& alarm : report.plants.charts->alarms)
        if (!alarm.crew && alarm.high)
            ofBase.push_back(alarm);
    ASSERT_EQ(ofBase.size(), 1u);
    EXPECT_TRUE(ofBase[0].ewma);
    EXPECT_TRUE(ofBase[0].cusum);
    EXPECT_NEAR(ofBase[0].day, 14000 + 4 * 365, 60);
    EXPECT_GE(ofBase[0].last_day, 14000 + 6 * 365);
    EXPECT_LE(ofBase[0].last_day, 14000 + 7 * 365 + 20); // the average comes back within some swings of the next year
    EXPECT_NEAR(ofBase[0].level_deg, 1.5, 0.5);
    EXPECT_TRUE(inWords(ofBase[0]).english().starts_with("base one base: from 20"));
}

TEST(FleetReport, nothingIsFoundWhereThereIsNothing)
{
    Truth truth;
    truth.aircraft = 100;
    const SimulatedFleet simulated(truth);
    const auto report = reported(simulated.fleet);
    EXPECT_FALSE(report.plants.training);
    EXPECT_LE(report.changes.jumps.size(), 3u);
    EXPECT_LE(report.changes.drifts.size(), 3u);
    ASSERT_TRUE(report.variance[1].report);
    const auto& B = *report.variance[1].report;
    EXPECT_NEAR(B.residual.variance, 0.0625, 0.01); // 0.5²·2/8
    EXPECT_GT(B.aircraft->interval.high, 1.0);
    EXPECT_LT(B.aircraft->interval.low, 1.0);
}

TEST(VarianceComponents, tellCrewsFromBasesAndAircraft)
{
    std::mt19937 random(11);
    std::normal_distribution<> normal;
    std::vector<double> aircraft(150), crew(25), site(12);
    for (auto* levels : {&aircraft, &crew, &site})
        for (auto& level : *levels)
            level = normal(random);
    std::vector<VarianceRow> rows;
    for (int i = 0; i < 1500; ++i) {
        const auto a = static_cast<std::int32_t>(random() % 150), c = static_cast<std::int32_t>(random() % 25),
                   s = static_cast<std::int32_t>(random() % 12);
        rows.push_back({1.0 * aircraft[static_cast<std::size_t>(a)] + 0.7 * crew[static_cast<std::size_t>(c)]
                + 0.4 * site[static_cast<std::size_t>(s)] + 0.5 * normal(random),
            a, c, s});
    }
    const auto report = varianceComponents(rows);
    ASSERT_TRUE(report);
    const auto holds = [](const std::optional<VarianceComponent>& component, double variance) {
        ASSERT_TRUE(component);
        EXPECT_LT(component->interval.low, variance);
        EXPECT_GT(component->interval.high, variance);
        EXPECT_LT(component->interval.low, component->variance);
        EXPECT_GT(component->interval.high, component->variance);
    };
    holds(report->aircraft, 1.0);
    holds(report->crew, 0.49);
    holds(report->site, 0.16);
    holds(report->residual, 0.25);
    // Each base with one crew: they cannot be told apart, and it is said.
    for (auto& row : rows)
        row.site = row.crew;
    const auto nested = varianceComponents(rows);
    ASSERT_TRUE(nested);
    EXPECT_FALSE(nested->crew);
    EXPECT_TRUE(nested->site);
    EXPECT_FALSE(nested->notTold.empty());
}
