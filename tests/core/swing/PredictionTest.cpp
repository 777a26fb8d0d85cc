// What a compass will read at another base.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/earth/FieldModel.h"
#include "core/sensor/PoissonSmith.h"
#include "core/sensor/SensorReading.h"
#include "core/swing/Analysis.h"
#include "core/swing/Prediction.h"
#include "core/swing/ReadingError.h"
#include "core/swing/SwingPlaces.h"

namespace lubberline {
namespace {

const MeridianField kWarsaw = MeridianField::fromDip(18700, toRadians(67.5));
const MeridianField kPerth = MeridianField::fromDip(23500, toRadians(-66));

SwingAtPlace swingOf(const SensorModel& model, const MeridianField& field)
{
    const auto smith = smithOf(model, field);
    EXPECT_TRUE(smith);
    return {smith->exact, {}, field, "a base"};
}

TEST(Prediction, fromAModelIsTheSimulatedSwingThere)
{
    SensorModel model;
    model.softIron << 0.04, 0.01, 0.03, 0.02, -0.01, -0.015, 0.02, 0, 0.05;
    model.hardIron_nT = {900, -600, 300};
    const auto prediction = predict(model, {kWarsaw, kPerth}, 36);
    ASSERT_TRUE(prediction);
    EXPECT_FALSE(prediction->assumed);
    ASSERT_EQ(prediction->points.size(), 36u);
    double change = 0;
    for (const auto& point : prediction->points) {
        EXPECT_NEAR(point.deviation->degrees(), readSensor(model, kPerth, {point.magnetic, 0, 0}).deviation->degrees(), 1e-9);
        EXPECT_NEAR(deviationAt(*prediction->exact, point.magnetic).degrees(), point.deviation->degrees(), 1e-9);
        EXPECT_EQ(*point.lowest_rad, *point.highest_rad);
        const double here = readSensor(model, kWarsaw, {point.magnetic, 0, 0}).deviation->degrees();
        change = std::max(change, std::abs(point.deviation->degrees() - here));
    }
    EXPECT_NEAR(toDegrees(prediction->change->bound_rad), change, 1e-9);
    const auto again = swingAgainAfterMove(*prediction, {});
    EXPECT_TRUE(again->needed);
    EXPECT_NE(again->reason.english().find("by the model"), std::string::npos);
    EXPECT_FALSE(swingAgainAfterMove(*predict(model, {{}, kPerth}), {})); // nowhere to come from
}

/// By hand, for iron of exactly the assumed sizes (very many degrees of freedom) and a swing without error: 𝔅 = c t + P/H + κ is
/// known, and of c remains the standard deviation σc √(1 − σc² t²/σ𝔅²); where the vertical field is the same and H not, c does
/// not matter at all.
TEST(Prediction, whatOneSwingLeavesOpenIsThePriorAcrossIt)
{
    AssumedIron assumed;
    assumed.degreesOfFreedom = 100000;
    const double t = kWarsaw.down_nT / kWarsaw.horizontal_nT, soft = assumed.verticalSoft * t;
    const double hard = std::hypot(assumed.hardIron_nT, assumed.compensator_nT) / kWarsaw.horizontal_nT,
                 own = toRadians(assumed.compassOneCycle_deg);
    SwingAtPlace swing;
    swing.exact.B = 0.1;
    swing.standardError = {1e-6, 1e-6, 1e-6, 1e-6, 1e-6};
    swing.field = kWarsaw;
    const auto iron = ironOf(std::vector{swing}, assumed);
    ASSERT_EQ(iron.draws.size(), std::size_t(kIronDraws));
    const double whole = std::hypot(soft, hard, own);
    EXPECT_NEAR(iron.mean.c, 0.1 * soft * soft / (whole * whole) / t, 1e-4);
    EXPECT_NEAR(iron.mean.P_nT, 0.1 * hard * hard / (whole * whole) * kWarsaw.horizontal_nT, 2);
    double squares = 0;
    for (const auto& draw : iron.draws) {
        squares += std::pow(draw.c - iron.mean.c, 2) / kIronDraws;
        EXPECT_NEAR(draw.at(kWarsaw).B, 0.1, 1e-4);
    }
    const double open = assumed.verticalSoft * std::sqrt(1 - soft * soft / (whole * whole));
    EXPECT_NEAR(std::sqrt(squares), open, 0.04 * open);
}

/// A compass by a population of aircraft, swung by whole degrees, and what it would read elsewhere.
class Population {
public:
    Population(double soft, double hard_nT, double own_deg, bool normal, bool compensated)
        : m_soft(soft)
        , m_hard_nT(hard_nT)
        , m_own_rad(toRadians(own_deg))
        , m_isNormal(normal)
        , m_compensated(compensated)
    {
    }
    void make(const MeridianField& here)
    {
        m_model = {};
        m_model.softIron << 0.02 * normal(), 0.01 * normal(), size(m_soft), 0.01 * normal(), 0.02 * normal(), size(m_soft), 0, 0, 0;
        m_model.hardIron_nT = {size(m_hard_nT), size(m_hard_nT), 0};
        if (m_compensated) // magnets that take B and C away to a degree
            m_model.hardIron_nT = {hardAgainst(m_model.softIron(0, 2), here), hardAgainst(m_model.softIron(1, 2), here), 0};
        m_ownB = m_own_rad * normal() / std::sqrt(2.0);
        m_ownC = m_own_rad * normal() / std::sqrt(2.0);
    }
    /// With the compass's own one-cycle error, which is the same everywhere.
    double deviation_rad(const MeridianField& field, double heading_deg) const
    {
        const auto read = readSensor(m_model, field, {MagneticHeading::fromDegrees(heading_deg), 0, 0});
        return read.deviation->radians() + m_ownB * std::sin(read.compass->radians()) + m_ownC * std::cos(read.compass->radians());
    }
    /// None where the iron turns the compass so far that its readings tell no coefficients.
    std::optional<SwingAtPlace> swung(const MeridianField& field, int readings)
    {
        std::vector<Observation> observations;
        for (int i = 0; i < readings; ++i) {
            const double heading_deg = 360.0 * i / readings;
            const double compass_deg = std::round(heading_deg - toDegrees(deviation_rad(field, heading_deg)) + 0.3 * normal());
            observations.push_back({MagneticHeading::fromDegrees(heading_deg), CompassHeading::fromDegrees(compass_deg)});
        }
        const auto analysis = analyse(observations, {.maxOrder = 0, .readingError_rad = readingError_rad(1), .findSlips = false});
        if (!analysis)
            return {};
        const auto swing = swingAtPlace(analysis->exact, field, "a base");
        return swing ? std::optional(*swing) : std::nullopt;
    }
    double unit() { return static_cast<double>(m_engine() >> 11) * 0x1p-53; }
    double normal()
    {
        double sum = -6;
        for (int i = 0; i < 12; ++i)
            sum += unit();
        return sum;
    }
    /// Anywhere where a compass is of use, by the area of the Earth.
    MeridianField place()
    {
        static const FieldModel model = wmm2025();
        while (true) {
            const double latitude_deg = toDegrees(std::asin(2 * unit() - 1)), longitude_deg = 360 * unit() - 180;
            const auto where = makePlace(latitude_deg, longitude_deg);
            const auto field = model.evaluate(*where, 2026.5)->field.meridian();
            if (field.horizontal_nT > kCautionHorizontal_nT)
                return field;
        }
    }

private:
    double size(double scale) { return m_isNormal ? scale * normal() : scale * (2 * unit() - 1); }
    double hardAgainst(double soft, const MeridianField& here) { return -soft * here.down_nT + 0.02 * normal() * here.horizontal_nT; }

    double m_soft, m_hard_nT, m_own_rad;
    bool m_isNormal, m_compensated;
    SensorModel m_model;
    double m_ownB = 0, m_ownC = 0;
    std::mt19937_64 m_engine{20261126};
};

struct Score {
    int worlds = 0, wholeCurve = 0, change = 0, noNeed = 0, falseNoNeed = 0;
    double needless_rad = 0; ///< by how much the bound of the change lies above the true one, mean
};

Score scoreOf(Population population, bool nextDoor)
{
    constexpr int kWorlds = 40, kHeadings = 24;
    Score score;
    for (int world = 0; world < kWorlds; ++world) {
        const auto here = population.place();
        auto there = population.place();
        if (nextDoor) { // H by 5 %, dip by 2°: some 300 km
            const double share = 0.95 + 0.1 * population.unit(), dip_deg = 4 * population.unit() - 2;
            there = MeridianField::fromDip(here.horizontal_nT * share, here.inclination_rad() + toRadians(dip_deg));
        }
        population.make(here);
        const auto swing = population.swung(here, world % 2 == 0 ? 8 : 12);
        if (!swing)
            continue;
        const auto prediction = predict(*swing, there, kHeadings);
        double change = 0;
        bool inside = true;
        for (const auto& point : prediction->points) {
            const double truth = population.deviation_rad(there, point.magnetic.degrees());
            const double off = std::remainder(truth - point.deviation->radians(), 2 * kPi);
            inside = inside && std::abs(off) <= (*point.highest_rad - *point.lowest_rad) / 2;
            change = std::max(change, std::abs(std::remainder(truth - population.deviation_rad(here, point.magnetic.degrees()), 2 * kPi)));
        }
        ++score.worlds;
        score.wholeCurve += inside;
        score.change += change <= prediction->change->bound_rad;
        score.needless_rad += (prediction->change->bound_rad - change) / kWorlds;
        const auto again = swingAgainAfterMove(*prediction, {});
        score.noNeed += !again->needed;
        score.falseNoNeed += !again->needed && (change > prediction->change->bound_rad || toDegrees(change) > 3);
    }
    return score;
}

/// What the bounds say must be so in 95 % of the cases, whatever the aircraft are: of the assumed sizes, twice smaller, evenly
/// spread up to the largest published ones (c, f 0.1; P, Q 3000 nT), of one kind of iron only, and with hard iron that takes the
/// soft iron's deviation away, as a compensator does.
TEST(Prediction, theTruthLiesWithinTheBoundsInNineteenOfTwenty)
{
    const std::vector<std::pair<const char*, Population>> populations{{"as assumed", {0.06, 4000, 0.7, true, false}},
        {"half", {0.03, 2000, 0.5, true, false}}, {"even", {0.1, 3000, 0.7, false, false}}, {"hard only", {0, 3000, 0.7, false, false}},
        {"soft only", {0.1, 0, 0.7, false, false}}, {"compensated", {0.05, 0, 0.5, true, true}},
        {"compensated, even", {0.1, 0, 0.7, false, true}}};
    int worlds = 0, wholeCurve = 0, change = 0, noNeed = 0, falseNoNeed = 0;
    for (const auto& [name, population] : populations)
        for (const bool nextDoor : {false, true}) {
            const Score score = scoreOf(population, nextDoor);
            EXPECT_GE(score.wholeCurve, 0.85 * score.worlds) << name << (nextDoor ? ", next door" : "");
            EXPECT_GE(score.change, 0.85 * score.worlds) << name << (nextDoor ? ", next door" : "");
            if (nextDoor) {
                EXPECT_GE(score.noNeed, 0.7 * score.worlds) << name; // not uselessly wide
                EXPECT_LT(toDegrees(score.needless_rad), 2.5) << name;
            }
            worlds += score.worlds;
            wholeCurve += score.wholeCurve;
            change += score.change;
            noNeed += score.noNeed;
            falseNoNeed += score.falseNoNeed;
        }
    EXPECT_GE(wholeCurve, 0.95 * worlds);
    EXPECT_GE(change, 0.95 * worlds);
    EXPECT_LE(falseNoNeed, 0.05 * noNeed);
}

/// c tan I = +10°, P/H = −8°: 2° here, and some 9° elsewhere. Nothing that lies between "all hard" and "all soft" holds it.
TEST(Prediction, ironThatOpposesItselfIsWithinTheBand)
{
    SensorModel model;
    model.softIron(0, 2) = std::sin(toRadians(10)) * kWarsaw.horizontal_nT / kWarsaw.down_nT;
    model.hardIron_nT.x() = -std::sin(toRadians(8)) * kWarsaw.horizontal_nT;
    auto swing = swingOf(model, kWarsaw);
    EXPECT_LT(toDegrees(std::abs(swing.exact.B)), 2.1);
    swing.standardError = {0.004, 0.005, 0.005, 0.005, 0.005};
    swing.degreesOfFreedom = 3;
    const auto prediction = predict(swing, kPerth, 36);
    ASSERT_TRUE(prediction);
    double change = 0;
    for (const auto& point : prediction->points) {
        const double truth = readSensor(model, kPerth, {point.magnetic, 0, 0}).deviation->radians();
        EXPECT_GE(truth, *point.lowest_rad);
        EXPECT_LE(truth, *point.highest_rad);
        change = std::max(change, std::abs(truth - readSensor(model, kWarsaw, {point.magnetic, 0, 0}).deviation->radians()));
    }
    EXPECT_GT(toDegrees(change), 8);
    EXPECT_GE(prediction->change->bound_rad, change);
    const auto again = swingAgainAfterMove(*prediction, {});
    EXPECT_TRUE(again->needed);
    for (const char* const word : {"95 %", "assuming", "0.06", "nT"})
        EXPECT_NE(again->reason.english().find(word), std::string::npos) << again->reason.english();
}

/// Where nothing changes, nothing is said to change, and the swing's own errors remain: Student's with its degrees of freedom.
TEST(Prediction, atHomeItIsTheSwingAgain)
{
    SensorModel model;
    model.hardIron_nT = {1500, 700, 0};
    auto swing = swingOf(model, kWarsaw);
    swing.standardError = {0.001, 0.002, 0.002, 0.001, 0.001};
    const auto widthAtNorth = [&](int degreesOfFreedom) {
        swing.degreesOfFreedom = degreesOfFreedom;
        const auto prediction = predict(swing, kWarsaw, 8);
        for (const auto& point : prediction->points)
            EXPECT_NEAR(point.deviation->degrees(), deviationAt(swing.exact, point.magnetic).degrees(), degreesOfFreedom == 1 ? 0.1 : 0.01);
        EXPECT_LT(prediction->change->bound_rad, 1e-9);
        EXPECT_FALSE(swingAgainAfterMove(*prediction, {})->needed);
        return (*prediction->points[0].highest_rad - *prediction->points[0].lowest_rad) / 2;
    };
    const double known = widthAtNorth(0), three = widthAtNorth(3), one = widthAtNorth(1);
    EXPECT_GT(known, 1.96 * std::hypot(0.001, 0.002, 0.001)); // A, C and E act on north; wider, as all headings are to be inside
    EXPECT_LT(known, 3.4 * std::hypot(0.001, 0.002, 0.001));  // √χ²(5; 95 %) = 3.33 is the most that all headings can ask for
    EXPECT_GT(three, 1.3 * known);                            // 3.18 of Student for 1.96
    EXPECT_GT(one, 4 * known);                                // 12.7
}

TEST(Prediction, verdictsAndTheRule)
{
    LimitsProfile limits;
    limits.maxDeviation_deg = 10;
    SwingAtPlace swing;
    swing.exact.B = 0.1;
    swing.standardError = {0.002, 0.002, 0.002, 0.002, 0.002};
    swing.field = MeridianField::fromDip(20000, toRadians(60));
    const auto at = [&](double H, double dip_deg) { return *predict(swing, MeridianField::fromDip(H, toRadians(dip_deg))); };
    EXPECT_EQ(judge(at(20000, 60), limits), PredictedVerdict::InLimits);       // 5.7°
    EXPECT_EQ(judge(at(20000, 70), limits), PredictedVerdict::MayLeaveLimits); // all soft: 0.1 · tan 70°/tan 60° = 9.0°, and more is open
    EXPECT_EQ(judge(at(8000, 77), limits), PredictedVerdict::OutOfLimits);     // 0.1 · 2.5 either way: 14°
    EXPECT_EQ(judge(at(20000, 60), {}), PredictedVerdict::NoLimit);
    EXPECT_FALSE(swingAgainAfterMove(at(20000, 60), limits)->needed);
    EXPECT_TRUE(swingAgainAfterMove(at(8000, 77), limits)->needed);
    EXPECT_NE(swingAgainAfterMove(at(20000, 70), limits)->reason.english().find("95 %"), std::string::npos);
    const auto far = swingAgainAfterMove(at(38000, -20), {});
    EXPECT_TRUE(far->needed); // no limit is set, but the card is wrong
    EXPECT_NE(far->reason.english().find("changes by up to"), std::string::npos);
    const auto near = swingAgainAfterMove(at(20500, 59), {});
    EXPECT_FALSE(near->needed);
    EXPECT_NE(near->reason.english().find("with a probability of 95 %, assuming"), std::string::npos) << near->reason.english();
}

TEST(Prediction, otherAssumptionsMakeOtherBounds)
{
    SwingAtPlace swing;
    swing.standardError = {0.002, 0.002, 0.002, 0.002, 0.002};
    swing.field = kWarsaw;
    AssumedIron remote; // a sensor at a wing tip: hardly any iron
    remote.verticalSoft = 0.003;
    remote.hardIron_nT = remote.compensator_nT = 100;
    remote.compassOneCycle_deg = 0.2;
    const auto wide = predict(swing, kPerth), narrow = predict(std::span(&swing, 1), {kWarsaw, kPerth}, remote);
    EXPECT_TRUE(swingAgainAfterMove(*wide, {})->needed);
    EXPECT_FALSE(swingAgainAfterMove(*narrow, {})->needed);
    EXPECT_EQ(*narrow->assumed, remote);
    EXPECT_NE(swingAgainAfterMove(*narrow, {})->reason.english().find("0.003"), std::string::npos);
}

TEST(Prediction, edges)
{
    SwingAtPlace swing;
    swing.exact.B = 0.1;
    swing.field = {30000, 0};
    const auto fromTheEquator = predict(swing, kWarsaw);
    ASSERT_TRUE(fromTheEquator);
    ASSERT_FALSE(fromTheEquator->warnings.empty());
    for (const auto& point : fromTheEquator->points)
        EXPECT_TRUE(std::isfinite(*point.lowest_rad) && std::isfinite(*point.highest_rad));
    swing.field = MeridianField::fromDip(30000, toRadians(2));
    EXPECT_FALSE(predict(swing, kWarsaw)->warnings.empty()); // vertical soft iron hardly showed
    EXPECT_FALSE(predict(swing, {1500, 56000}));             // blackout
    EXPECT_FALSE(predict(swing, {0, 56000}));
    EXPECT_TRUE(predict(swing, MeridianField::fromDip(5000, toRadians(84)))->warnings.size() >= 1); // caution
    swing.field = {0, 0};
    EXPECT_FALSE(predict(swing, kWarsaw));
    swing.field = kWarsaw; // five readings: no errors are known
    swing.standardError = {};
    const auto unsure = predict(swing, kWarsaw);
    EXPECT_GT(*unsure->points[0].highest_rad - *unsure->points[0].lowest_rad, toRadians(2));
    ASSERT_EQ(unsure->warnings.size(), 1u);
    EXPECT_NE(unsure->warnings[0].english().find("1.0\u00b0 a reading is assumed"), std::string::npos);
    SensorModel cancels;
    cancels.hardIron_nT = {-kWarsaw.horizontal_nT, 0, 0}; // on north nothing is left
    const auto prediction = predict(cancels, {{}, kWarsaw}, 8);
    ASSERT_TRUE(prediction);
    EXPECT_FALSE(prediction->points[0].deviation);
    EXPECT_EQ(judge(*prediction, LimitsProfile{{}, {}, {}, {}, {}, {}, 10.0, {}}), PredictedVerdict::OutOfLimits);
}

TEST(Prediction, fromTwoPlacesTheBandIsNarrow)
{
    SensorModel model;
    model.softIron(0, 2) = 0.03;
    model.softIron(1, 2) = -0.02;
    model.hardIron_nT = {1000, 500, 0};
    auto a = swingOf(model, kWarsaw), b = swingOf(model, MeridianField::fromDip(41000, toRadians(-15)));
    a.standardError = b.standardError = {0.002, 0.002, 0.002, 0.002, 0.002};
    const auto prediction = predict(std::vector{a, b}, {kWarsaw, kPerth}, {}, 36), one = predict(a, kPerth, 36);
    ASSERT_TRUE(prediction);
    EXPECT_LT(prediction->change->bound_rad, one->change->bound_rad);
    EXPECT_FALSE(predict(std::vector{a, a}, {kWarsaw, kPerth})); // one place: nothing is told apart
    double widest = 0, widestOfOne = 0;
    for (std::size_t i = 0; i < 36; ++i) {
        const auto& point = prediction->points[i];
        const double truth = readSensor(model, kPerth, {point.magnetic, 0, 0}).deviation->radians();
        EXPECT_NEAR(point.deviation->radians(), truth, 0.02); // the compass's own error stays open
        EXPECT_LT(std::abs(truth - point.deviation->radians()), (*point.highest_rad - *point.lowest_rad) / 2);
        widest = std::max(widest, *point.highest_rad - *point.lowest_rad);
        widestOfOne = std::max(widestOfOne, *one->points[i].highest_rad - *one->points[i].lowest_rad);
    }
    EXPECT_LT(widest, widestOfOne / 3);
}

} // namespace
} // namespace lubberline
