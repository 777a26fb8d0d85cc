// Logs with wrong variations, wrong dates and made-up fixes: what cannot be right is said, and widens what is stated.

#include <algorithm>

#include "core/nmea/NmeaBase.h"
#include "core/nmea/NmeaSources.h"
#include "tests/core/nmea/MadeTurn.h"

namespace lubberline {
namespace {

using namespace test;

TEST(NmeaSources, theLikeliestCompassIsTheOneOfTheStandardsTalkerThatReadsUncorrected)
{
    std::vector<NmeaSource> heard{{"II", "VHW"}, {"HC", "VHW"}, {"II", "HDM"}, {"II", "HDG"}, {"HC", "HDM"}, {"HC", "HDG"}, {"AP", "HDG"}};
    std::sort(heard.begin(), heard.end(), likelierCompass);
    std::string order;
    for (const auto& source : heard)
        order += nameOf(source) + " ";
    EXPECT_EQ(order, "HCHDG HCHDM APHDG IIHDG IIHDM HCVHW IIVHW ");
}

TEST(NmeaTurn, theVariationIsHeldAgainstTheModel)
{
    Flight flight;
    EXPECT_FALSE(answerOf(logOf(flight)).says("apart, and A with them")); // WMM2025 says 14.97° E there
    flight.variationTold_deg = 0.0;
    const auto zero = answerOf(logOf(flight));
    EXPECT_TRUE(zero.says("15.0° apart"));
    EXPECT_GE(zero.errorOf(Coefficient::A), 14.9);
    NmeaOptions model;
    model.variation = VariationOfModel{};
    EXPECT_NEAR(answerOf(logOf(flight), model).of(Coefficient::A), 0.8 + 0.23, 0.05);
    flight.variationTold_deg = -15.2; // E and W mixed up
    EXPECT_TRUE(answerOf(logOf(flight)).says("30.2° apart"));
}

TEST(NmeaTurn, oneZeroBesideARightVariationIsNotTaken)
{
    std::string log;
    for (int i = 0; i < 360; i += 5)
        log += makeNmea(formatted("HCHDG,%d.0,0.0,E,0.0,E", i)) + "\n"
            + makeNmea(formatted("GPRMC,09%02d%02d,A,4736.0,N,12218.0,W,6.0,%.1f,201125,15.2,E,A", i / 60, i % 60, wrap360(i + 15.2)))
            + "\n";
    const auto answer = answerOf(log);
    EXPECT_NEAR(answer.swing.variation->degrees(), 15.2, 1e-9);
    EXPECT_TRUE(answer.says("HCHDG 0.0°, GPRMC +15.2°"));
}

TEST(NmeaTurn, datesThatCannotBeAreDoubtedAloud)
{
    Flight flight;
    const auto dated = [&](const char* date) {
        flight.date = date;
        NmeaOptions stated;
        stated.variation = Variation::fromDegrees(15.2);
        return answerOf(logOf(flight), stated);
    };
    EXPECT_FALSE(dated("201125").says("dated"));
    EXPECT_FALSE(dated("271126").says("dated")); // somewhere it is tomorrow already
    EXPECT_TRUE(dated("060406").says(
        "dated 2006-04-06: a receiver that missed the turn of the GPS week count (1024 weeks) writes so for 2025-11-20"));
    EXPECT_TRUE(dated("210806").says("writes so for 2026-04-06"));
    EXPECT_TRUE(dated("060199").says("writes so for 2018-08-22")); // two turns would be beyond today
    EXPECT_TRUE(dated("060180").says("1980-01-06, a day on which the GPS week count began"));
    EXPECT_TRUE(dated("070419").says("2019-04-07, a day on which the GPS week count began"));
    EXPECT_TRUE(dated("010531").says("dated 2031-05-01, and today is 2026-11-26"));
    NmeaOptions right;
    right.date = "2025-11-20";
    flight.date = "060406";
    const auto answer = answerOf(logOf(flight), right);
    EXPECT_EQ(answer.swing.date, Date("2025-11-20"));
    EXPECT_FALSE(answer.says("week count"));
}

TEST(NmeaTurn, whatIsKnownOfTheVariationWidensA)
{
    NmeaOptions storm;
    storm.variation = Variation::fromDegrees(15.2);
    const Flight both{{{1.0, 400.0}, {-1.0, 400.0}}};
    const double calm = answerOf(logOf(both), storm).errorOf(Coefficient::A);
    EXPECT_LT(calm, 0.05);
    storm.variationError_deg = 1.5;
    const auto answer = answerOf(logOf(both), storm);
    EXPECT_NEAR(answer.errorOf(Coefficient::A), 1.5, 0.01);
    EXPECT_NEAR(answer.errorOf(Coefficient::B), answerOf(logOf(both)).errorOf(Coefficient::B), 1e-9); // A alone
}

TEST(NmeaTurn, aBaseWhoseSurveyIsNotTheModelsWidensA)
{
    Site base;
    base.name = "rose";
    base.latitude_deg = 47.61;
    base.longitude_deg = -122.29;
    for (const double declination : {16.9, 17.0, 17.1})
        base.survey.push_back({0.0, 0.0, 1.0, declination, {}});
    NmeaOptions model;
    model.variation = VariationOfModel{};
    auto answer = answerOf(logOf({{{1.0, 400.0}, {-1.0, 400.0}}}), model);
    const double before = answer.errorOf(Coefficient::A);
    NmeaSwing far = answer.swing;
    base.latitude_deg = 48.6;
    holdAgainstBases(far, model, {&base, 1});
    EXPECT_EQ(far.doubts.size(), answer.swing.doubts.size());
    base.latitude_deg = 47.61;
    holdAgainstBases(answer.swing, model, {&base, 1});
    EXPECT_TRUE(answer.says("the survey of rose has the declination +17.0°"));
    const auto widened = analyse(observationsOf(toSwing(answer.swing)), {.shared = toSwing(answer.swing).sharedErrors});
    EXPECT_NEAR(toDegrees(*widened->approximate.standardError[indexOf(Coefficient::A)]), std::hypot(before, 2.03),
        0.01); // WMM2025 says 14.97° there
}

TEST(NmeaTurn, receiversThatMakeItUpAreTold)
{
    const auto ending = [](const std::string& log, const char* mode) {
        std::string other;
        std::istringstream lines(log);
        for (std::string line; std::getline(lines, line);)
            other += (line.find("RMC") == std::string::npos ? line : makeNmea(line.substr(1, line.find('*') - 2) + mode)) + "\n";
        return other;
    };
    EXPECT_TRUE(answerOf(ending(logOf({}), "E")).says("400 estimated tracks or headings (mode E, dead reckoning)"));
    EXPECT_TRUE(answerOf(ending(logOf({}), "S")).says("simulator (mode S)"));
    std::string own;
    for (int i = 0; i < 360; i += 5)
        own += makeNmea(formatted("GPRMC,09%02d%02d,A,4736.0,N,12218.0,W,6.0,%.1f,201125,15.2,E,A", i / 60, i % 60, wrap360(i + 15.2)))
            + "\n" + makeNmea(formatted("HCHDG,%d.0,2.5,W,,", i)) + "\n";
    EXPECT_TRUE(answerOf(own).says("72 HDG sentences with a deviation of their own (up to −2.5°"));
}

} // namespace
} // namespace lubberline
