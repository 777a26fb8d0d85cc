// The attitude fit: what it finds, what it says cannot be told, and what it refuses.
#include "core/calibration/AttitudeFit.h"

#include <gmock/gmock.h>

#include "core/calibration/ModelHeader.h"
#include "tests/core/calibration/LogMaker.h"

namespace lubberline::test {
namespace {

using testing::HasSubstr;

SensorModel unsymmetric()
{
    SensorModel model;
    model.softIron << 0.05, 0.02, -0.01, 0.03, -0.04, 0.015, -0.02, 0.005, 0.03;
    model.hardIron_nT = {3000, -2000, 1500};
    return model;
}

std::string said(const std::vector<Message>& messages) { return together(messages).english(); }

TEST(AttitudeFit, theTruthComesOut)
{
    const LogPlan plan{.model = unsymmetric(), .tilt_deg = 20, .noise_nT = 100, .samples = 3000};
    const auto result = fitAttitude(makeLog(plan), {plan.field});
    ASSERT_TRUE(result) << describe(result.error());
    EXPECT_EQ(result->verdict, CalibrationVerdict::Good) << said(result->reasons);
    EXPECT_EQ(result->rank, 12);
    EXPECT_LT((result->model.softIron - plan.model.softIron).cwiseAbs().maxCoeff(), 0.002);
    EXPECT_LT((result->model.hardIron_nT - plan.model.hardIron_nT).cwiseAbs().maxCoeff(), 80);
    EXPECT_NEAR(result->sigma_nT, 100, 3);
    ASSERT_TRUE(result->validation);
    EXPECT_EQ(result->validation->blocks, 8);
    EXPECT_NEAR(result->validation->field_nT, 100 * std::sqrt(3), 15);
    EXPECT_LT(result->validation->heading_deg, 0.6);
}

/// Designs of 24 and 120 samples, 100 nT: ranks of a level swing and of one on two headings.
TEST(AttitudeFit, levelTellsNineAndTwoHeadingsTellSix)
{
    LogPlan plan{.model = unsymmetric(), .tilt_deg = 0, .noise_nT = 0, .samples = 24};
    const auto level = fitAttitude(makeLog(plan), {plan.field});
    ASSERT_TRUE(level) << describe(level.error());
    EXPECT_EQ(level->rank, 9);
    EXPECT_NEAR(level->model.softIron(0, 0), 0.05, 1e-9);
    // Z is 34 641 nT: P holds P + c Z, and c is not told.
    EXPECT_NEAR(level->model.hardIron_nT.x(), 3000 - 0.01 * 20000 * std::tan(toRadians(60)), 1e-4);
    EXPECT_EQ(level->softTold(0, 2), 0);
    EXPECT_THAT(said(level->notSeparable), HasSubstr("c and P, f and Q, k and R cannot be told apart"));
    EXPECT_THAT(said(level->notSeparable), HasSubstr("c \u00B7 34641 nT + P"));
    EXPECT_EQ(level->verdict, CalibrationVerdict::Doubtful);
    for (const auto& parameter : level->parameters)
        EXPECT_EQ(
            parameter.value.has_value(), parameter.name != "c" && parameter.name != "f" && parameter.name != "k" && parameter.unit != "nT");

    SensorLog log = makeLog(plan);
    const SensorResponse response = responseOf(plan.model);
    for (std::size_t row = 0; row < log.size(); ++row) {
        log.heading_deg[row] = row % 2 ? 90 : 270;
        const Eigen::Vector3d m
            = response.gain * fieldInBody(plan.field, {MagneticHeading::fromDegrees(log.heading_deg[row])}) + response.offset_nT;
        for (std::size_t axis = 0; axis < 3; ++axis)
            log.field[axis][row] = m[static_cast<Eigen::Index>(axis)];
    }
    const auto two = fitAttitude(log, {plan.field});
    ASSERT_TRUE(two) << describe(two.error());
    EXPECT_EQ(two->rank, 6);
    EXPECT_THAT(said(two->notSeparable), HasSubstr("a, d, g cannot be told"));
    EXPECT_EQ(two->verdict, CalibrationVerdict::NotDetermined) << "no swing";
    EXPECT_THAT(said(two->reasons), HasSubstr("2 of 4 can be told"));
}

TEST(AttitudeFit, currentsAreRegressors)
{
    const LogPlan plan{.model = unsymmetric(), .tilt_deg = 20, .noise_nT = 20, .samples = 1000};
    SensorLog log = makeLog(plan);
    log.currents.push_back({"landing light", {}});
    for (std::size_t row = 0; row < log.size(); ++row) {
        log.currents[0].values.push_back(row % 3 == 0 ? 10.0 : 0.0);
        log.field[1][row] += 45.0 * log.currents[0].values.back();
    }
    const auto result = fitAttitude(log, {plan.field});
    ASSERT_TRUE(result) << describe(result.error());
    ASSERT_EQ(result->model.circuits.size(), 1u);
    EXPECT_NEAR(result->model.circuits[0].field_nT_per_A.y(), 45, 1);
    EXPECT_NEAR(result->model.circuits[0].field_nT_per_A.x(), 0, 1);
    EXPECT_EQ(result->rank, 15);
    for (auto& value : log.currents[0].values)
        value = 0;
    EXPECT_THAT(said(fitAttitude(log, {plan.field})->notSeparable), HasSubstr("the current is never other than 0"));
}

/// 1° of attitude noise biases R by hundreds of nT; stated, it is taken out.
TEST(AttitudeFit, attitudeNoiseIsTakenOut)
{
    Eigen::Vector3d plain = Eigen::Vector3d::Zero(), corrected = Eigen::Vector3d::Zero();
    for (unsigned seed = 1; seed <= 6; ++seed) {
        const LogPlan plan{.model = unsymmetric(), .tilt_deg = 20, .noise_nT = 100, .samples = 4000, .seed = seed};
        SensorLog log = makeLog(plan);
        std::mt19937_64 random(seed + 100);
        std::normal_distribution<double> normal;
        for (std::size_t row = 0; row < log.size(); ++row) {
            log.heading_deg[row] = wrap360(log.heading_deg[row] + normal(random));
            log.pitch_deg[row] += normal(random);
            log.roll_deg[row] += normal(random);
        }
        plain += (fitAttitude(log, {plan.field})->model.hardIron_nT - plan.model.hardIron_nT) / 6;
        corrected += (fitAttitude(log, {plan.field, 1.0})->model.hardIron_nT - plan.model.hardIron_nT) / 6;
    }
    EXPECT_GT(std::abs(plain.z()), 200);
    EXPECT_LT(std::abs(corrected.z()), 0.35 * std::abs(plain.z()));
}

TEST(AttitudeFit, theMountIsTold)
{
    SensorModel model;
    model.misalignment = {toRadians(1.5), toRadians(-2), toRadians(3)};
    const LogPlan plan{.model = model, .tilt_deg = 30, .noise_nT = 5, .samples = 1000};
    const auto result = fitAttitude(makeLog(plan), {plan.field});
    ASSERT_TRUE(result) << describe(result.error());
    EXPECT_NEAR(toDegrees(result->misalignment.roll_rad), 1.5, 0.02);
    EXPECT_NEAR(toDegrees(result->misalignment.pitch_rad), -2, 0.02);
    EXPECT_NEAR(toDegrees(result->misalignment.yaw_rad), 3, 0.02);
    EXPECT_LT(result->symmetric.cwiseAbs().maxCoeff(), 1e-3);
}

TEST(AttitudeFit, swappedAxesAreNamed)
{
    const LogPlan plan{.model = unsymmetric(), .tilt_deg = 20, .samples = 500};
    SensorLog log = makeLog(plan);
    std::swap(log.field[0], log.field[1]);
    for (auto& value : log.field[2])
        value = -value;
    const auto result = fitAttitude(log, {plan.field});
    ASSERT_TRUE(result) << describe(result.error());
    EXPECT_THAT(said(result->reasons), HasSubstr("x = +y of the log, y = +x of the log, z = \u2212z of the log"));
    EXPECT_NE(result->verdict, CalibrationVerdict::Good);
}

TEST(AttitudeFit, trueHeadingsAreDoubted)
{
    const LogPlan plan{.model = unsymmetric(), .tilt_deg = 20, .samples = 1000};
    SensorLog log = makeLog(plan);
    for (auto& heading : log.heading_deg)
        heading = wrap360(heading + 7);
    const auto result = fitAttitude(log, {plan.field, 0, Variation::fromDegrees(7)});
    ASSERT_TRUE(result) << describe(result.error());
    EXPECT_EQ(result->verdict, CalibrationVerdict::Doubtful);
    EXPECT_THAT(said(result->reasons), HasSubstr("look true instead of magnetic"));
}

/// Nobody says where the log was taken: of a tilted one the angle itself is found; magnetic headings of a turned sensor are not doubted.
TEST(AttitudeFit, trueHeadingsAreDoubtedWithoutAPlace)
{
    SensorModel turned = unsymmetric();
    turned.misalignment.yaw_rad = toRadians(-5);
    for (const double variation_deg : {7.0, -12.5, 0.0}) {
        const LogPlan plan{.model = turned, .tilt_deg = 20, .samples = 1000};
        SensorLog log = makeLog(plan);
        for (auto& heading : log.heading_deg)
            heading = wrap360(heading + variation_deg);
        const auto result = fitAttitude(log, {plan.field});
        ASSERT_TRUE(result) << describe(result.error());
        if (variation_deg == 0) {
            EXPECT_EQ(result->verdict, CalibrationVerdict::Good) << said(result->reasons);
            continue;
        }
        EXPECT_EQ(result->verdict, CalibrationVerdict::Doubtful);
        EXPECT_THAT(said(result->reasons), testing::ContainsRegex(variation_deg > 0 ? "turned by .(6.9|7.0|7.1)" : "turned by .*12.[456]"));
    }
}

/// Level, a turned sensor and headings that are off are the same log.
TEST(AttitudeFit, levelTrueHeadingsAreAskedAbout)
{
    const LogPlan plan{.tilt_deg = 0, .noise_nT = 20, .samples = 500};
    SensorLog log = makeLog(plan);
    for (auto& heading : log.heading_deg)
        heading = wrap360(heading + 6);
    EXPECT_THAT(
        said(fitAttitude(log, {plan.field, 0, Variation::fromDegrees(6)})->warnings), HasSubstr("are the headings true instead of"));
    EXPECT_THAT(said(fitAttitude(log, {plan.field})->warnings), HasSubstr("nothing tells that from headings that are off by it"));
    EXPECT_THAT(said(fitAttitude(makeLog(plan), {plan.field})->warnings), testing::Not(HasSubstr("seems turned")));
}

TEST(AttitudeFit, whatIsRefused)
{
    const LogPlan plan{.model = unsymmetric(), .tilt_deg = 20, .samples = 400};
    const auto refusal = [&](const SensorLog& log) {
        const auto result = fitAttitude(log, {plan.field});
        return result ? std::string("it was taken") : describe(result.error());
    };
    SensorLog log = makeLog(plan);
    for (auto* column : {&log.heading_deg, &log.pitch_deg, &log.roll_deg})
        for (auto& value : *column)
            value = toRadians(value);
    EXPECT_THAT(refusal(log), HasSubstr("look like radians"));
    log = makeLog(plan);
    for (auto* column : {&log.pitch_deg, &log.roll_deg})
        for (auto& value : *column)
            value = toRadians(value);
    EXPECT_THAT(refusal(log), HasSubstr("pitch and roll look like radians"));
    LogPlan tumbling = plan; // a roll goes to π
    tumbling.tilt_deg = 180;
    log = makeLog(tumbling);
    for (auto* column : {&log.heading_deg, &log.pitch_deg, &log.roll_deg})
        for (auto& value : *column)
            value = toRadians(column == &log.pitch_deg ? value / 2 : value);
    log.field = makeLog(tumbling).field;
    for (std::size_t row = 0; row < log.size(); ++row) {
        const Eigen::Vector3d m
            = fieldInBody(tumbling.field, {MagneticHeading::fromRadians(log.heading_deg[row]), log.pitch_deg[row], log.roll_deg[row]});
        for (std::size_t axis = 0; axis < 3; ++axis)
            log.field[axis][row] = m[static_cast<Eigen::Index>(axis)];
    }
    EXPECT_THAT(refusal(log), HasSubstr("look like radians"));
    log = makeLog(plan);
    log.roll_deg.clear();
    EXPECT_THAT(refusal(log), HasSubstr("has no attitude"));
    log = makeLog(plan);
    log.unit = FieldUnit::Counts;
    EXPECT_THAT(refusal(log), HasSubstr("is in counts"));
}

/// Columns of the attitude in another convention are named; the fit that fails for them tells nothing of the log's field.
TEST(AttitudeFit, misnamedAnglesAreNamed)
{
    const LogPlan plan{.model = unsymmetric(), .tilt_deg = 20, .noise_nT = 100, .samples = 3000};
    const auto doubted = [&](auto&& change) {
        SensorLog log = makeLog(plan);
        for (std::size_t row = 0; row < log.size(); ++row)
            change(log.heading_deg[row], log.pitch_deg[row], log.roll_deg[row]);
        const auto result = fitAttitude(log, {plan.field});
        if (!result)
            return describe(result.error());
        EXPECT_EQ(result->verdict, CalibrationVerdict::NotDetermined);
        EXPECT_EQ(result->reasons.size(), 1u) << said(result->reasons);
        return said(result->reasons);
    };
    EXPECT_THAT(doubted([](double& heading, double&, double&) { heading = wrap360(heading + 180); }),
        HasSubstr("headings are reciprocal, 180° off: so taken the samples are explained to 10"));
    EXPECT_THAT(doubted([](double&, double& pitch, double&) { pitch = -pitch; }), HasSubstr("pitch has the other sign"));
    EXPECT_THAT(doubted([](double&, double&, double& roll) { roll = -roll; }), HasSubstr("roll has the other sign"));
    EXPECT_THAT(doubted([](double&, double& pitch, double& roll) { std::swap(pitch, roll); }), HasSubstr("pitch stands for roll"));
    EXPECT_THAT(doubted([](double& heading, double&, double&) { heading = wrap360(-heading); }), HasSubstr("headings run anticlockwise"));
    EXPECT_THAT(doubted([](double& heading, double&, double&) { heading = wrap360(heading + 90); }), HasSubstr("headings are 90° off"));
    // Attitudes of another log altogether.
    LogPlan other = plan;
    other.seed = 77;
    const SensorLog strange = makeLog(other);
    SensorLog log = makeLog(plan);
    log.heading_deg = strange.heading_deg;
    log.pitch_deg = strange.pitch_deg;
    log.roll_deg = strange.roll_deg;
    const auto result = fitAttitude(log, {plan.field});
    ASSERT_TRUE(result) << describe(result.error());
    EXPECT_EQ(result->verdict, CalibrationVerdict::NotDetermined);
    EXPECT_THAT(said(result->reasons), HasSubstr("heading, pitch and roll explain 0 % of how the readings vary"));
    EXPECT_THAT(said(result->reasons), testing::Not(HasSubstr("the log's field is")));
}

/// The compass's own heading behind a filter: no row agrees with the field, and yet it shows no deviation where iron must make some.
TEST(AttitudeFit, itsOwnHeadingSmoothedIsRefusedAndAReferenceIsNot)
{
    SensorModel model;
    model.hardIron_nT = {4000, -2500, 800};
    const MeridianField field = MeridianField::fromDip(18800, toRadians(67));
    const SensorResponse response = responseOf(model);
    std::mt19937_64 random(4);
    std::normal_distribution<double> normal;
    SensorLog log;
    double sine = 0, cosine = 1;
    std::vector<double> reference;
    for (int i = 0; i < 3000; ++i) {
        const double turn = i / 3000.0;
        const Attitude attitude{MagneticHeading::fromDegrees(360 * 6 * turn), 0.4 * std::sin(46 * turn), 0.4 * std::sin(32 * turn + 1)};
        Eigen::Vector3d m = response.gain * fieldInBody(field, attitude) + response.offset_nT;
        for (int axis = 0; axis < 3; ++axis)
            log.field[static_cast<std::size_t>(axis)].push_back(m[axis] += 60 * normal(random));
        log.time_s.push_back(0.05 * i);
        log.pitch_deg.push_back(toDegrees(attitude.pitch_rad));
        log.roll_deg.push_back(toDegrees(attitude.roll_rad));
        reference.push_back(attitude.heading.degrees());
        const double own = toRadians(headingOf_deg(m, log.pitch_deg.back(), log.roll_deg.back()));
        sine += 0.3 * (std::sin(own) - sine);
        cosine += 0.3 * (std::cos(own) - cosine);
        log.heading_deg.push_back(wrap360(toDegrees(std::atan2(sine, cosine))));
    }
    const auto own = fitAttitude(log, {field});
    ASSERT_FALSE(own);
    EXPECT_THAT(describe(own.error()), HasSubstr("smoothed or delayed"));
    log.heading_deg = reference;
    EXPECT_TRUE(fitAttitude(log, {field}));
}

/// Level or tilt-compensated, turned by a constant, or in whole degrees: it is the compass's own all the same.
TEST(AttitudeFit, aReferenceFromTheCompassItselfIsRefused)
{
    const LogPlan plan{.model = unsymmetric(), .tilt_deg = 20, .samples = 400};
    for (const bool levelled : {true, false})
        for (const bool whole : {true, false}) {
            SensorLog log = makeLog(plan);
            for (std::size_t row = 0; row < log.size(); ++row) {
                const double own = headingOf_deg(log.at(row), levelled ? log.pitch_deg[row] : 0, levelled ? log.roll_deg[row] : 0);
                log.heading_deg[row] = whole ? std::round(own) : wrap360(own + 5.5);
            }
            const auto result = fitAttitude(log, {plan.field});
            ASSERT_FALSE(result);
            EXPECT_THAT(describe(result.error()), HasSubstr("is what this compass itself reads"));
        }
}

/// Its own heading late by half a second, over a second in the mean, or noisy by a degree, in a steady turn: P was 1400 nT wrong, and only
/// "doubtful". A reference with the same faults is taken.
TEST(AttitudeFit, itsOwnHeadingLateOrNoisyIsRefusedAndAReferenceIsNot)
{
    const MeridianField field = MeridianField::fromDip(20133, toRadians(66));
    const SensorResponse response = responseOf(unsymmetric());
    std::mt19937_64 random(4);
    std::normal_distribution<double> normal;
    SensorLog log;
    std::vector<double> own, reference;
    for (int i = 0; i < 6000; ++i) {
        const double t = 0.05 * i;
        const Attitude attitude{
            MagneticHeading::fromDegrees(6 * t), 0.35 * std::sin(2 * kPi * t / 37), 0.35 * std::sin(2 * kPi * t / 23 + 1)};
        Eigen::Vector3d m = response.gain * fieldInBody(field, attitude) + response.offset_nT;
        for (int axis = 0; axis < 3; ++axis)
            log.field[static_cast<std::size_t>(axis)].push_back(m[axis] += 100 * normal(random));
        log.time_s.push_back(t);
        log.pitch_deg.push_back(toDegrees(attitude.pitch_rad));
        log.roll_deg.push_back(toDegrees(attitude.roll_rad));
        reference.push_back(attitude.heading.degrees());
        own.push_back(headingOf_deg(m, log.pitch_deg.back(), log.roll_deg.back()));
    }
    const auto late = [](const std::vector<double>& headings, std::size_t rows, std::size_t mean) {
        std::vector<double> result;
        for (std::size_t row = 0; row < headings.size(); ++row) {
            double sine = 0, cosine = 0;
            for (std::size_t k = 0; k < mean; ++k) {
                const double one = toRadians(headings[row >= rows + k ? row - rows - k : 0]);
                sine += std::sin(one);
                cosine += std::cos(one);
            }
            result.push_back(wrap360(toDegrees(std::atan2(sine, cosine))));
        }
        return result;
    };
    const auto noisy = [&](std::vector<double> headings) {
        for (double& heading : headings)
            heading = wrap360(heading + normal(random));
        return headings;
    };
    const auto taken = [&](const std::vector<double>& headings) {
        log.heading_deg = headings;
        const auto result = fitAttitude(log, {field});
        return result ? std::string("taken") : describe(result.error());
    };
    EXPECT_THAT(taken(late(own, 10, 1)), HasSubstr("smoothed or delayed"));
    EXPECT_THAT(taken(late(own, 0, 20)), HasSubstr("smoothed or delayed"));
    EXPECT_THAT(taken(noisy(own)), HasSubstr("smoothed or delayed"));
    EXPECT_EQ(taken(reference), "taken");
    EXPECT_EQ(taken(late(reference, 10, 1)), "taken");
    EXPECT_EQ(taken(late(reference, 0, 20)), "taken");
    EXPECT_EQ(taken(noisy(reference)), "taken");
}

} // namespace
} // namespace lubberline::test
