// The list of a fleet: what the rules are given, the order, the calendar, the crew's words, the JSON.

#include <gtest/gtest.h>

#include <algorithm>

#include <nlohmann/json.hpp>

#include "core/due/DueList.h"
#include "core/format/results/DueJson.h"
#include "core/record/RecordWords.h"

namespace lubberline {
namespace {

DueCompass compass(int id, const std::string& registration, std::vector<Date> swings)
{
    DueCompass made;
    made.compass = {id};
    made.typeRecord = "type-1";
    made.compassRecord = "compass-" + std::to_string(id);
    made.typeName = "Su-22";
    made.registration = registration;
    made.compassName = "standby compass";
    made.signedSwings = std::move(swings);
    return made;
}

Event event(const std::string& record, Date date, DueCause cause, const std::string& words)
{
    Event made;
    made.record = record;
    made.date = date;
    made.cause = cause;
    made.kind = words;
    return made;
}

const std::vector<DueRule> kTwoYears{{"r1", "two years", 24, 30, 60, "a document", "1", {}}};

TEST(DueList, theMostUrgentIsFirst)
{
    auto struck = compass(4, "4", {"2026-10-01"});
    struck.events = {event("e1", "2026-10-05", DueCause::Lightning, "lightning strike")};
    const std::vector<DueCompass> fleet{compass(1, "1", {"2026-01-01"}), compass(2, "2", {"2024-12-01"}), compass(3, "3", {"2020-01-01"}),
        struck, compass(5, "5", {"2024-11-01"}), compass(6, "6", {}), compass(7, "7", {"2019-01-01"})};
    std::string order;
    std::vector<std::string> states;
    for (const auto& line : dueList(fleet, kTwoYears, {}, "2026-11-23")) {
        order += line.compass.registration;
        states.emplace_back(nameOf(line.answer.state));
    }
    EXPECT_EQ(order, "7364521"); // never swung goes before what is due since some day; 4: struck in October; 5: in its grace
    EXPECT_EQ(states, (std::vector<std::string>{"overdue", "overdue", "due", "due", "due", "due_soon", "not_due"}));
}

TEST(DueList, withoutRulesOnlyEventsCount)
{
    auto struck = compass(1, "1", {});
    struck.events
        = {event("e1", "2026-10-05", DueCause::Lightning, "lightning strike"), event("e2", "2026-10-06", DueCause::Other, "washed")};
    const std::vector<DueCompass> fleet{compass(2, "2", {}), struck};
    const auto lines = dueList(fleet, {}, {}, "2026-11-23");
    EXPECT_EQ(lines[0].answer.state, DueState::Due);
    ASSERT_EQ(lines[0].answer.flags.size(), 1u);
    EXPECT_EQ(lines[0].answer.flags[0].reason.english(), "lightning strike");
    EXPECT_EQ(lines[1].answer.state, DueState::NotDue);
}

TEST(DueList, aMoveIsOfItsOwnCompass)
{
    const std::vector<DueCompass> fleet{compass(1, "1", {"2026-10-01"}), compass(2, "2", {"2026-10-01"}), compass(3, "3", {"2026-10-01"})};
    const std::vector<MovePrediction> moves{{{2}, Message::verbatim(std::string("based at Far: up to 13 deg"))}, {{3}, {}}};
    const auto lines = dueList(fleet, kTwoYears, moves, "2026-11-23");
    EXPECT_EQ(lines[0].compass.registration, "2");
    EXPECT_EQ(lines[0].answer.flags.at(0).reason.english(), "based at Far: up to 13 deg");
    EXPECT_EQ(lines[1].answer.state, DueState::NotDue);
    EXPECT_EQ(lines[2].answer.state, DueState::NotDue);
}

TEST(DueList, aSignatureTakesNoCompassOutOfItsLimitsOffTheList)
{
    const auto found = [](Date date, SwingStage stage, bool isSigned, double most_deg) {
        return LimitsFinding{date, stage, isSigned, most_deg > 10 ? Status::OutOfLimits : Status::InLimits, most_deg};
    };
    const auto answer = [&](std::vector<LimitsFinding> findings) {
        auto one = compass(1, "1", {"2026-11-20"});
        one.limit_deg = 10;
        one.limitDocument = "14 CFR 25.1327";
        one.findings = std::move(findings);
        return dueOf(inputFor(one, kTwoYears, {}, "2026-11-23"));
    };
    const auto out = answer({found("2026-11-20", SwingStage::AsLeft, true, 12.34), found("2024-11-20", SwingStage::AsLeft, true, 3)});
    ASSERT_EQ(out.flags.size(), 1u);
    EXPECT_EQ(out.state, DueState::Due);
    EXPECT_EQ(out.flags[0].since, Date("2026-11-20"));
    EXPECT_EQ(out.flags[0].reason.english(), "OUT OF LIMITS by the swing of 2026-11-20: up to 12.3°, 10° is allowed (14 CFR 25.1327)");
    // As found it was out, as left it is within: of one day the compass is as it was left.
    EXPECT_EQ(answer({found("2026-11-20", SwingStage::AsFound, true, 15), found("2026-11-20", SwingStage::AsLeft, true, 4)}).state,
        DueState::NotDue);
    // One state of the radio is enough.
    EXPECT_EQ(
        answer({found("2026-11-20", SwingStage::AsLeft, true, 4), found("2026-11-20", SwingStage::AsLeft, true, 11)}).state, DueState::Due);
    // A newer one that nobody signed can say that it is out, and not that it is within again.
    EXPECT_EQ(answer({found("2026-11-22", SwingStage::AsLeft, false, 11), found("2026-11-20", SwingStage::AsLeft, true, 4)}).state,
        DueState::Due);
    EXPECT_EQ(answer({found("2026-11-22", SwingStage::AsLeft, false, 4), found("2026-11-20", SwingStage::AsLeft, true, 11)}).state,
        DueState::Due);
    EXPECT_EQ(answer({found("2026-11-22", SwingStage::AsLeft, true, 4), found("2026-11-20", SwingStage::AsLeft, true, 11)}).state,
        DueState::NotDue);
    EXPECT_EQ(answer({found("2026-11-22", SwingStage::AsLeft, false, 4), found("2026-11-20", SwingStage::AsLeft, true, 4)}).state,
        DueState::NotDue);
    EXPECT_EQ(answer({{"2026-11-20", SwingStage::AsLeft, true, Status::NotKnown, 12}}).state, DueState::NotDue); // no limit is set
}

TEST(DueList, wordsThatDoNotTellTheCauseAreGivenIt)
{
    auto one = compass(1, "1", {});
    one.events = {event("e1", "2026-10-05", DueCause::HardLanding, "incident 14"), event("e2", "2026-10-06", DueCause::EngineChange, "")};
    const auto input = inputFor(one, {}, {}, "2026-11-23");
    EXPECT_EQ(input.events[0].reason.english(), "incident 14 (hard landing or shock)");
    EXPECT_EQ(input.events[1].reason.english(), "engine change");
}

TEST(DueList, theCrewsWordsTellTheCause)
{
    const std::vector<std::pair<const char*, DueCause>> words{{"Struck by LIGHTNING, nose cone", DueCause::Lightning},
        {"thunderstorm", DueCause::ElectricalStorm}, {"severe electrical storm", DueCause::ElectricalStorm},
        {"hail storm at the stand", DueCause::ElectricalStorm}, {"Heavy landing", DueCause::HardLanding},
        {"engine change, No. 2", DueCause::EngineChange}, {"avionics bay modified", DueCause::Modification},
        {"electrical panel changed", DueCause::ElectricalChange}, {"magnetic cargo", DueCause::MagneticCargo},
        {"magneto changed", DueCause::EngineChange}, {"moved to Singapore", DueCause::Moved},
        {"flux valve removed", DueCause::PartsReplaced}, {"paint restored", DueCause::Other}, {"a look at its history", DueCause::Other},
        {"stored two years", DueCause::ParkedOverAYear}, {"parked on 090 since 2024", DueCause::ParkedOverAYear},
        {"new compass fitted", DueCause::PartsReplaced}, {"compass re-installed", DueCause::PartsReplaced},
        {"accuracy suspected", DueCause::AccuracySuspected}, {"washed", DueCause::Other}, {"", DueCause::Other}};
    for (const auto& [text, cause] : words)
        EXPECT_EQ(fileWord(causeInWords(text)), fileWord(cause)) << text;
    for (int i = 1; i < kDueCauses; ++i)
        EXPECT_EQ(causeInWords(inWords(static_cast<DueCause>(i))), static_cast<DueCause>(i)) << inWords(static_cast<DueCause>(i));
}

TEST(DueList, shippedRulesNameWhatWasRead)
{
    const auto rules = knownRules();
    ASSERT_EQ(rules.size(), 2u); // procedures: CASA by way of the trade press, South Africa as quoted; no other interval was read
    EXPECT_EQ(rules[0].months, 24);
    EXPECT_EQ(rules[1].months, 12);
    for (const auto& rule : rules) {
        EXPECT_FALSE(rule.document.empty());
        EXPECT_TRUE(rule.type.empty());
    }
}

TEST(DueList, theCalendarHasOneEntryForEachDay)
{
    auto struck = compass(1, "1", {"2024-11-23"});
    struck.events = {event("e1", "2026-10-05", DueCause::Lightning, "lightning strike")};
    auto moved = compass(2, "2", {"2026-01-01"});
    const std::vector<DueCompass> fleet{struck, moved, compass(3, "3", {})};
    const std::vector<MovePrediction> moves{{{2}, Message::verbatim(std::string("based at Far"))}};
    const auto entries = calendarOf(dueList(fleet, kTwoYears, moves, "2026-12-24"));
    std::vector<std::pair<std::string, std::string>> told;
    for (const auto& entry : entries)
        told.emplace_back(entry.uid, entry.date.text());
    std::sort(told.begin(), told.end());
    EXPECT_EQ(told,
        (std::vector<std::pair<std::string, std::string>>{{"event-e1-compass-1@lubberline", "2026-10-05"},
            {"place-compass-2@lubberline", "2026-12-24"}, {"swing-compass-1@lubberline", "2026-11-23"},
            {"swing-compass-2@lubberline", "2028-01-01"}}));
    EXPECT_EQ(calendarOf({}).size(), 0u);
}

TEST(DueList, whatTheFleetsHistoryExpectsIsAReasonOfItsOwn)
{
    const std::vector<DueCompass> fleet{compass(1, "1", {"2026-10-01"}), compass(2, "2", {"2026-10-01"}), compass(3, "3", {"2026-10-01"}),
        compass(4, "4", {"2026-10-01"}), compass(5, "5", {"2026-11-01"})};
    const Message drifts = Message::verbatim(std::string("B drifts by +0.45\u00B0 a year"));
    const std::vector<CompassForecast> forecasts{{{1}, {0.19, "2028-10-01", {}, "2026-10-01", drifts}},
        {{2}, {0.2, "2028-10-01", "2030-01-01", "2026-10-01", drifts}}, {{3}, {0.5, "2028-10-01", "2028-01-01", "2026-10-01", drifts}},
        {{4}, {0.9995, "2028-10-01", "2027-01-01", "2026-10-01", drifts}}, {{5}, {0.9, "2028-10-01", "2027-01-01", "2026-10-01", drifts}}};
    const auto lines = dueList(fleet, kTwoYears, {}, "2026-11-23", forecasts);
    std::string order;
    for (const auto& line : lines)
        order += line.compass.registration + std::string(nameOf(line.answer.state)) + " ";
    EXPECT_EQ(order, "4due 3due 2due_soon 1not_due 5not_due "); // 5: swung and signed since
    const auto& flag = lines[1].answer.flags.at(0);
    EXPECT_EQ(flag.reason.english(), "50 % likely out of limits by 2028-10-01: B drifts by +0.45\u00B0 a year");
    EXPECT_EQ(flag.since, Date("2028-01-01"));
    EXPECT_EQ(flag.probability, 0.5);
    EXPECT_TRUE(lines[0].answer.flags[0].reason.english().starts_with("over 99 % likely"));
    EXPECT_EQ(lines[2].answer.flags[0].since, Date("2028-10-01"));
    std::vector<std::string> told;
    for (const auto& entry : calendarOf(lines))
        if (entry.uid.starts_with("forecast-"))
            told.push_back(entry.date.text() + " " + entry.summary);
    EXPECT_EQ(told,
        (std::vector<std::string>{"2027-01-01 Compass swing of 4, standby compass is due",
            "2028-01-01 Compass swing of 3, standby compass is due", "2028-10-01 Compass swing of 2, standby compass is due soon"}));
    const auto json = nlohmann::json::parse(toJson(lines, {}, "2026-11-23"))["compasses"];
    EXPECT_EQ(json[1]["flags"][0]["probability"], 0.5);
    EXPECT_TRUE(json[3]["flags"].empty());
}

TEST(DueList, whatThereIsNoneOfIsNull)
{
    const std::vector<DueCompass> fleet{compass(1, "SP-\"X\"", {})};
    const std::vector<Message> warnings{Message::verbatim(std::string("no position"))};
    const auto json = nlohmann::json::parse(toJson(dueList(fleet, kTwoYears, {}, "2026-11-23"), warnings, "2026-11-23"));
    EXPECT_EQ(json["today"], "2026-11-23");
    const auto& line = json["compasses"][0];
    EXPECT_EQ(line["aircraft"], "SP-\"X\"");
    EXPECT_EQ(line["state"], "due");
    EXPECT_TRUE(line["last_signed"].is_null());
    EXPECT_TRUE(line["next_by_calendar"].is_null());
    EXPECT_TRUE(line["flags"][0]["since"].is_null());
    EXPECT_TRUE(line["flags"][0]["event"].is_null());
    EXPECT_EQ(json["warnings"], nlohmann::json::array({"no position"}));
    EXPECT_TRUE(nlohmann::json::parse(toJson({}, {}, "2026-11-23"))["compasses"].empty());
}

} // namespace
} // namespace lubberline
