// References that the log itself speaks against: a second receiver that says otherwise, and headings that are made of the compass.

#include <functional>

#include "core/nmea/NmeaBase.h"
#include "tests/core/nmea/MadeTurn.h"

namespace lubberline {
namespace {

using namespace test;

/// Field `index` of a sentence, and the log with what `made` answers behind each sentence of `type`.
std::string fieldOf(const std::string& line, int index)
{
    std::stringstream fields(line.substr(0, line.find('*')));
    std::string field;
    for (int i = 0; i <= index; ++i)
        std::getline(fields, field, ',');
    return field;
}

std::string withBehind(const std::string& log, const std::string& type, const std::function<std::string(const std::string&)>& made)
{
    std::stringstream lines(log);
    std::string all;
    for (std::string line; std::getline(lines, line);) {
        all += line + "\n";
        if (line.substr(3, 3) == type)
            all += makeNmea(made(line)) + "\r\n";
    }
    return all;
}

/// The compass's own heading once more, as multiplexers and plotters send it.
std::string repeated(const Flight& flight, double added_deg, const char* format)
{
    return withBehind(
        logOf(flight), "HDG", [&](const std::string& line) { return formatted(format, wrap360(std::stod(fieldOf(line, 1)) + added_deg)); });
}

const std::vector<Leg> kBothWays{{1.0, 400.0}, {-1.0, 400.0}};

TEST(NmeaAgreement, aHeadingMadeOfTheCompassIsNoReference)
{
    NmeaOptions ofTrue, ofMagnetic;
    ofTrue.reference = NmeaReference::HeadingTrue;
    ofMagnetic.reference = NmeaReference::Magnetic;
    for (const auto& legs : {kBothWays, std::vector<Leg>{{1.0, 400.0}}}) {
        const Flight flight{.legs = legs};
        EXPECT_TRUE(answerOf(repeated(flight, 15.2, "IIHDT,%.1f,T"), ofTrue).says("no card may be made of it"));
        EXPECT_TRUE(answerOf(repeated(flight, 15.2, "GPHDT,%.0f,T"), ofTrue).says("no card may be made of it"));
        EXPECT_TRUE(answerOf(repeated(flight, 15.2, "INTHS,%.2f,A"), ofTrue).says("no card may be made of it"));
        EXPECT_TRUE(answerOf(repeated(flight, 0.0, "IIHDM,%.1f,M"), ofMagnetic).says("no card may be made of it"));
        EXPECT_TRUE(answerOf(repeated(flight, 180.0, "IIHDM,%.1f,M"), ofMagnetic).says("no card may be made of it"));
    }
    // Its own track says otherwise, by the compass's 3° of B.
    EXPECT_TRUE(answerOf(repeated({.legs = kBothWays}, 15.2, "IIHDT,%.1f,T"), ofTrue).says("GPRMC and IIHDT disagree by ±3."));
}

TEST(NmeaAgreement, aSecondReceiverThatTellsOtherwiseIsTold)
{
    const auto second = [](double off_deg) {
        return withBehind(logOf({.legs = kBothWays, .noise_deg = 0.3}), "RMC", [off_deg](const std::string& line) {
            const auto body = line.substr(6, line.find('*') - 6);
            const auto track = fieldOf(line, 8);
            auto other = "GNRMC" + body;
            const auto at = other.find("," + track + ",201125");
            return other.replace(at, track.size() + 1, "," + formatted("%.1f", wrap360(std::stod(track) + off_deg)));
        });
    };
    for (const double off : {4.0, -7.0, 30.0, 180.0}) {
        const auto answer = answerOf(second(off));
        EXPECT_TRUE(answer.says("one of the two is wrong")) << off;
        EXPECT_GE(answer.errorOf(Coefficient::A), 0.7 * std::abs(off)) << off;
        EXPECT_NEAR(answer.of(Coefficient::B), -3.0, 0.1);
    }
    for (const double off : {0.0, 0.4})
        EXPECT_FALSE(answerOf(second(off)).says("one of the two is wrong")) << off;
}

TEST(NmeaAgreement, tracksThatJumpOrGoBackwardsAreNoTurnsTheOtherWay)
{
    const auto bent = [](int every, int from, int to, double by_deg) {
        std::stringstream lines(logOf({.legs = {{1.0, 400.0}}, .noise_deg = 0.3}));
        std::string all;
        int tracks = 0;
        for (std::string line; std::getline(lines, line);) {
            if (line.substr(3, 3) == "RMC" && ++tracks >= from && tracks < to && tracks % every == 0) {
                auto body = line.substr(1, line.find('*') - 1);
                const auto track = fieldOf(line, 8);
                const auto at = body.find("," + track + ",201125");
                line = makeNmea(body.replace(at, track.size() + 1, "," + formatted("%.1f", wrap360(std::stod(track) + by_deg)))) + "\r";
            }
            all += line + "\n";
        }
        return answerOf(all);
    };
    const auto right = bent(1000, 0, 0, 0.0);
    for (const auto& wrong : {bent(10, 0, 400, 30.0), bent(50, 0, 400, 90.0), bent(1, 100, 140, 180.0)}) {
        EXPECT_TRUE(wrong.says("left out that"));
        EXPECT_TRUE(wrong.says("the turn goes one way")); // what they seemed to tell of a delay was not there
        EXPECT_NEAR(wrong.of(Coefficient::A), right.of(Coefficient::A), 0.1);
        EXPECT_NEAR(wrong.of(Coefficient::B), -3.0, 0.15);
        EXPECT_NEAR(wrong.of(Coefficient::C), 2.0, 0.15);
        EXPECT_NEAR(wrong.errorOf(Coefficient::A), right.errorOf(Coefficient::A), 0.05);
    }
    EXPECT_FALSE(right.says("left out that"));
}

TEST(NmeaAgreement, instrumentsThatAgreeAreLeftInPeace)
{
    std::mt19937 random(3);
    std::normal_distribution<double> noise(0.0, 0.3);
    const Flight flight{.legs = kBothWays, .noise_deg = 1.5};
    const auto log = withBehind(logOf(flight), "RMC", [&](const std::string& line) { // the track's own noise is not the gyro's
        const int second = std::stoi(line.substr(7, 2)) * 3600 + std::stoi(line.substr(9, 2)) * 60 + std::stoi(line.substr(11, 2));
        return formatted("GPHDT,%.1f,T", wrap360(headingAt(flight, second - 9 * 3600) + 15.2 + noise(random)));
    });
    for (const auto reference : {NmeaReference::HeadingTrue, NmeaReference::Track}) {
        NmeaOptions options;
        options.reference = reference;
        const auto answer = answerOf(log, options);
        EXPECT_FALSE(answer.says("disagree")) << static_cast<int>(reference);
        EXPECT_FALSE(answer.says("no card may be made of it"));
        EXPECT_NEAR(answer.of(Coefficient::B), -3.0, 0.2);
    }
}

} // namespace
} // namespace lubberline
