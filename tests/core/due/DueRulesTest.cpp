// When a swing is due, at the edges: the day itself, leap years, same-day events, waivers.

#include <gtest/gtest.h>

#include "core/due/DueRules.h"
#include "core/record/RecordWords.h"

namespace lubberline {
namespace {

Message said(const char* words) { return Message::verbatim(std::string(words)); }

DueInput input(Date today, std::vector<Date> swings = {})
{
    DueInput made;
    made.today = today;
    made.signedSwings = std::move(swings);
    made.rule = DueRule{"rule", "24 months", 24, 10, 30, "AWB 34-008", "3", {}};
    return made;
}

TEST(DueRules, calendarOnTheDayItself)
{
    const auto on = [](Date today) { return dueOf(input(today, {"2020-01-01", "2024-11-23"})); };
    EXPECT_EQ(on("2026-10-23").state, DueState::NotDue);
    EXPECT_EQ(on("2026-10-24").state, DueState::DueSoon); // 30 days before
    EXPECT_EQ(on("2026-11-23").state, DueState::DueSoon); // good through the day
    EXPECT_EQ(on("2026-11-24").state, DueState::Due);
    EXPECT_EQ(on("2026-12-03").state, DueState::Due); // ten days of grace
    EXPECT_EQ(on("2026-12-04").state, DueState::Overdue);
    EXPECT_EQ(on("2026-10-23").nextByCalendar, Date("2026-11-23"));
    EXPECT_EQ(on("2026-10-23").lastSigned, Date("2024-11-23"));
}

TEST(DueRules, leapDay)
{
    auto leap = input("2025-02-28", {"2024-02-29"});
    leap.rule->months = 12;
    EXPECT_EQ(dueOf(leap).state, DueState::DueSoon);
    leap.today = "2025-03-01";
    EXPECT_EQ(dueOf(leap).state, DueState::Due);
}

TEST(DueRules, neverSwung)
{
    EXPECT_EQ(dueOf(input("2026-11-23")).state, DueState::Due);
    auto without = input("2026-11-23");
    without.rule.reset();
    EXPECT_EQ(dueOf(without).state, DueState::NotDue);
}

TEST(DueRules, anEventWhoseDayCannotBeRightStaysOpenWhateverIsSigned)
{
    auto made = input("2026-11-23", {"2026-05-01"});
    for (const Date day : {Date(), Date("2062-06-10"), Date("1980-01-06"), Date("0026-06-10")}) {
        made.events = {{"e1", day, DueCause::Lightning, said("struck")}};
        const auto due = dueOf(made);
        ASSERT_EQ(due.flags.size(), 1u) << day.text();
        EXPECT_EQ(due.state, DueState::Due);
        EXPECT_EQ(due.flags[0].event, "e1");
        EXPECT_TRUE(due.flags[0].since.empty());
        EXPECT_NE(due.flags[0].reason.english().find("may have been after the last swing"), std::string::npos);
    }
    made.waivers = {Waiver{"w", "e1", "2026-11-01", "read again: 2024", "Ada"}};
    EXPECT_EQ(dueOf(made).state, DueState::NotDue);
    // An installation that is still to come hides nothing that happened.
    made.waivers.clear();
    made.installed = "2062-01-01";
    made.events = {{"e1", "2026-06-10", DueCause::Lightning, said("struck")}};
    EXPECT_EQ(dueOf(made).state, DueState::Due);
}

TEST(DueRules, anEventStaysOpenUntilALaterSignedSwingOrAWaiver)
{
    auto made = input("2026-11-23", {"2026-05-01"});
    made.events = {{"e1", "2026-06-10", DueCause::Lightning, said("lightning strike, nose")},
        {"e2", "2026-06-11", DueCause::Other, said("washed")}, {"e3", "2026-12-01", DueCause::EngineChange, said("planned")}};
    auto due = dueOf(made);
    ASSERT_EQ(due.flags.size(), 1u);
    EXPECT_EQ(due.flags[0].event, "e1");
    EXPECT_EQ(due.state, DueState::Due);
    made.signedSwings.push_back("2026-06-10"); // the same day: nothing tells which came first
    EXPECT_EQ(dueOf(made).state, DueState::Due);
    made.signedSwings.back() = "2026-06-11";
    EXPECT_EQ(dueOf(made).state, DueState::NotDue);
    made.signedSwings.pop_back();
    made.waivers = {{"w1", "e1", "2026-06-12", "two headings 90 deg apart show no change", "inspector"}};
    EXPECT_EQ(dueOf(made).state, DueState::NotDue);
    made.waivers[0].event = "another";
    EXPECT_EQ(dueOf(made).state, DueState::Due);
}

TEST(DueRules, eventsBeforeTheCompassWasInstalledAreNotItsOwn)
{
    auto made = input("2026-11-23", {"2026-01-01"});
    made.events = {{"e1", "2026-02-10", DueCause::HardLanding, said("hard landing")}};
    made.installed = "2026-02-11";
    auto due = dueOf(made);
    ASSERT_EQ(due.flags.size(), 1u);
    EXPECT_TRUE(due.flags[0].event.empty()); // the installation's own
    made.installed = "2026-02-10";
    due = dueOf(made);
    ASSERT_EQ(due.flags.size(), 2u);
    made.installed = "2025-06-01"; // before the swing: only the landing is open
    due = dueOf(made);
    ASSERT_EQ(due.flags.size(), 1u);
    EXPECT_EQ(due.flags[0].event, "e1");
}

TEST(DueRules, anInstallationWantsASwing)
{
    auto made = input("2026-11-23", {"2026-01-01"});
    made.rule.reset();
    made.installed = "2026-03-01";
    ASSERT_EQ(dueOf(made).flags.size(), 1u);
    EXPECT_EQ(dueOf(made).flags[0].since, Date("2026-03-01"));
    EXPECT_EQ(dueOf(made).state, DueState::Due);
    made.signedSwings.push_back("2026-03-01"); // on the day: there was no compass to swing before
    EXPECT_EQ(dueOf(made).state, DueState::NotDue);
    made.signedSwings.clear();
    EXPECT_EQ(dueOf(made).state, DueState::Due);
    made.installed = "2026-11-24"; // tomorrow
    EXPECT_EQ(dueOf(made).state, DueState::NotDue);
}

TEST(DueRules, eachOfTwoEventsWantsItsOwnWaiver)
{
    auto made = input("2026-11-23", {"2026-05-01"});
    made.events = {
        {"e1", "2026-06-10", DueCause::Lightning, said("lightning")}, {"e2", "2026-06-10", DueCause::EngineChange, said("engine change")}};
    made.waivers = {{"w1", "e1", "2026-06-12", "two headings agree", "inspector"}};
    const auto due = dueOf(made);
    ASSERT_EQ(due.flags.size(), 1u);
    EXPECT_EQ(due.flags[0].event, "e2");
    made.waivers.push_back({"w2", "e2", "2026-06-13", "the maker says so", "inspector"});
    EXPECT_EQ(dueOf(made).state, DueState::NotDue);
}

TEST(DueRules, anEventOfTodayIsOpenToday)
{
    auto made = input("2028-02-29", {"2028-02-28"});
    made.events = {{"e1", "2028-02-29", DueCause::HardLanding, said("hard landing")}};
    EXPECT_EQ(dueOf(made).state, DueState::Due);
    made.today = "2028-02-28"; // UTC: east of Greenwich it is the 29th already
    EXPECT_EQ(dueOf(made).state, DueState::NotDue);
    made.today = "2028-02-27"; // nobody plans a hard landing: the day is wrong
    EXPECT_EQ(dueOf(made).state, DueState::Due);
    made.events[0].cause = DueCause::EngineChange;
    EXPECT_EQ(dueOf(made).state, DueState::NotDue);
}

TEST(DueRules, graceEndsAcrossTheLeapDay)
{
    auto made = input("2028-02-29", {"2026-02-20"}); // good through 20 February 2028, ten days of grace
    EXPECT_EQ(dueOf(made).state, DueState::Due);
    made.today = "2028-03-01";
    EXPECT_EQ(dueOf(made).state, DueState::Due);
    made.today = "2028-03-02";
    EXPECT_EQ(dueOf(made).state, DueState::Overdue);
    made.rule->graceDays = 0;
    made.today = "2028-02-21";
    EXPECT_EQ(dueOf(made).state, DueState::Overdue);
    made.today = "2028-02-20";
    EXPECT_EQ(dueOf(made).state, DueState::DueSoon);
}

TEST(DueRules, theMostUrgentFlagIsFirst)
{
    auto made = input("2027-06-01", {"2024-11-23"});
    made.events = {{"e1", "2026-02-10", DueCause::Moved, said("moved to Singapore")}};
    made.predictedOutOfLimits = true;
    made.predictedReason = Message::verbatim(std::string("13 degrees expected"));
    const auto due = dueOf(made);
    ASSERT_EQ(due.flags.size(), 3u);
    EXPECT_EQ(due.state, DueState::Overdue);
    EXPECT_EQ(due.flags[1].event, "e1");
}

TEST(DueRules, causesHaveStableNames)
{
    for (int i = 0; i < kDueCauses; ++i)
        EXPECT_EQ(choiceOf<DueCause>(fileWord(static_cast<DueCause>(i))), static_cast<DueCause>(i));
    EXPECT_FALSE(choiceOf<DueCause>("earthquake"));
}

TEST(DueRules, aTypesOwnRuleGoesFirst)
{
    const std::vector<DueRule> rules{{"r1", "all", 24, 0, 30, {}, {}, {}}, {"r2", "fighters", 12, 0, 30, {}, {}, "type-1"}};
    EXPECT_EQ(ruleFor(rules, "type-1")->name, "fighters");
    EXPECT_EQ(ruleFor(rules, "type-2")->name, "all");
    EXPECT_FALSE(ruleFor({}, "type-1"));
}

} // namespace
} // namespace lubberline
