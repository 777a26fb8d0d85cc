// What is due, from the command line: signed swings, calendar rules, events and waivers in a database, the calendar file.

#include <gmock/gmock.h>

#include "tests/app/Program.h"
#include "tests/app/Published.h"

namespace lubberline::test {

namespace {

using nlohmann::json;

/// SP-TST, whose standby compass was swung and signed on the day.
class SignedOn {
public:
    Sandbox sandbox;

    explicit SignedOn(const std::string& date)
    {
        const auto file = sandbox.write("k.csv",
            "# aircraft: SP-TST\n# type: PZL-130\n# compass: standby\n# site: Deblin\n# date: " + date + "\n" + kWorksheet[0].check);
        EXPECT_EQ(run({"import", file}).status, 0);
        const std::string swing = run({"swings", "--json"}).json()["swings"][0]["record"];
        EXPECT_EQ(run({"complete", swing}).status, 0);
        EXPECT_EQ(run({"sign", swing, "--role", "performer", "--name", "A. Kowalska"}).status, 0);
        EXPECT_EQ(run({"sign", swing, "--role", "inspector", "--name", "J. Nowak"}).status, 0);
    }
    [[nodiscard]] Outcome run(std::vector<std::string> arguments) const
    {
        arguments.insert(arguments.end(), {"--db", "a.db"});
        return sandbox.run(arguments);
    }
    [[nodiscard]] json due(const std::string& today, const std::vector<std::string>& more = {"--all"}) const
    {
        std::vector<std::string> arguments{"due", "--today", today, "--json"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const auto outcome = run(arguments);
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        return outcome.json()["compasses"];
    }
    void setRule(int months, int grace, int warn) const
    {
        EXPECT_EQ(
            run({"rule", "ours", "--months", std::to_string(months), "--grace", std::to_string(grace), "--warn", std::to_string(warn)})
                .status,
            0);
    }
};

} // namespace

TEST(DueCommand, theDayItself)
{
    const SignedOn fleet("2024-02-29");
    EXPECT_EQ(fleet.due("2030-01-01")[0]["state"], "not_due"); // no rule applies before somebody sets one
    fleet.setRule(12, 5, 30);
    const std::vector<std::pair<const char*, const char*>> states{{"2024-02-29", "not_due"}, {"2025-01-28", "not_due"},
        {"2025-01-29", "due_soon"}, {"2025-02-28", "due_soon"}, {"2025-03-01", "due"}, {"2025-03-05", "due"}, {"2025-03-06", "overdue"}};
    for (const auto& [today, state] : states)
        EXPECT_EQ(fleet.due(today)[0]["state"], state) << today;
    const auto line = fleet.due("2025-03-06")[0];
    EXPECT_EQ(line["last_signed"], "2024-02-29");
    EXPECT_EQ(line["next_by_calendar"], "2025-02-28");
    EXPECT_EQ(line["flags"][0]["since"], "2025-02-28");
    EXPECT_TRUE(line["flags"][0]["event"].is_null());
    EXPECT_THAT(line["flags"][0]["reason"].get<std::string>(), testing::HasSubstr("ours: 12 months after the swing of 2024-02-29"));
    EXPECT_TRUE(fleet.due("2024-06-01", {}).empty());
    EXPECT_EQ(fleet.due("2024-06-01", {"--within", "271"}).size(), 0u); // 272 days to go
    EXPECT_EQ(fleet.due("2024-06-01", {"--within", "272"}).size(), 1u);
}

TEST(DueCommand, anEventIsAnsweredByASwingOrAWaiver)
{
    const SignedOn fleet("2026-05-01");
    const auto struck = fleet.run({"event", "SP-TST", "--cause", "lightning", "--date", "2026-06-10", "--note", "port wing tip", "--json"});
    ASSERT_EQ(struck.status, 0) << struck.err;
    const auto changed = fleet.run({"event", "SP-TST", "engine change, No. 1", "--date", "2026-06-11", "--json"});
    EXPECT_EQ(changed.json()["cause"], "engine_change"); // told from the words
    EXPECT_EQ(fleet.due("2026-06-09")[0]["state"], "not_due");
    EXPECT_EQ(fleet.due("2026-06-10")[0]["flags"].size(), 1u);
    EXPECT_EQ(fleet.due("2026-06-11")[0]["flags"].size(), 2u);
    EXPECT_EQ(fleet.due("2026-06-11")[0]["flags"][0]["reason"], "lightning strike");
    const std::string event = struck.json()["event"];
    const auto listed = fleet.run({"due", "--today", "2026-06-11"});
    EXPECT_THAT(listed.out, testing::HasSubstr("[event " + event.substr(0, 8) + "], and 1 more"));
    const auto waived = fleet.run({"waive", event.substr(0, 8), "--reason", "two headings 90 degrees apart show no change", "--by",
        "J. Nowak", "--date", "2026-06-12", "--json"});
    ASSERT_EQ(waived.status, 0) << waived.err;
    EXPECT_EQ(waived.json()["event"], event);
    const auto left = fleet.due("2026-06-12")[0]["flags"];
    ASSERT_EQ(left.size(), 1u);
    EXPECT_EQ(left[0]["reason"], "engine change, No. 1");
    ASSERT_EQ(fleet.run({"export", "-o", "a.lubberline.json"}).status, 0); // who answered goes with the fleet
    EXPECT_THAT(fleet.sandbox.read("a.lubberline.json"), testing::HasSubstr("two headings 90 degrees apart"));
}

TEST(DueCommand, theCalendarIsWritten)
{
    const SignedOn fleet("2024-11-23");
    fleet.setRule(24, 0, 60);
    ASSERT_EQ(fleet.run({"due", "--today", "2026-11-23", "--ics", "swings.ics"}).status, 0);
    const std::string file = fleet.sandbox.read("swings.ics");
    EXPECT_EQ(file.rfind("BEGIN:VCALENDAR\r\nVERSION:2.0\r\n", 0), 0u);
    EXPECT_THAT(file,
        testing::HasSubstr(
            "DTSTART;VALUE=DATE:20261123\r\nDTEND;VALUE=DATE:20261124\r\nSUMMARY:Compass swing of SP-TST\\, standby falls due\r\n"));
    EXPECT_THAT(file, testing::EndsWith("END:VCALENDAR\r\n"));
    ASSERT_EQ(fleet.run({"due", "--today", "2026-11-24", "--ics", "again.ics"}).status, 0);
    const auto uid
        = [](const std::string& text) { return text.substr(text.find("UID:"), text.find("\r\n", text.find("UID:")) - text.find("UID:")); };
    EXPECT_EQ(uid(fleet.sandbox.read("again.ics")), uid(file)); // imported again, the entry is changed and not doubled
}

TEST(DueCommand, rulesAreDataWithASource)
{
    const SignedOn fleet("2025-06-01");
    ASSERT_EQ(fleet.run({"rule", "--known"}).status, 0);
    ASSERT_EQ(fleet.run({"rule", "--known"}).status, 0); // twice is once
    auto rules = fleet.run({"rule", "--json"}).json()["rules"];
    ASSERT_EQ(rules.size(), 2u);
    EXPECT_EQ(rules[0]["months"], 24);
    EXPECT_THAT(rules[0]["document"].get<std::string>(), testing::HasSubstr("AWB 34-008"));
    ASSERT_EQ(
        fleet.run({"rule", "trainers", "--months", "6", "--type", "PZL-130", "--document", "our programme", "--issue", "2"}).status, 0);
    EXPECT_EQ(fleet.due("2025-06-02")[0]["next_by_calendar"], "2025-12-01"); // the type's own goes first
    ASSERT_EQ(fleet.run({"rule", "trainers", "--months", "9"}).status, 0);
    EXPECT_EQ(fleet.due("2025-06-02")[0]["next_by_calendar"], "2026-03-01");
    rules = fleet.run({"rule", "--json"}).json()["rules"];
    EXPECT_EQ(rules[2]["document"], "our programme"); // what was not said stays
    EXPECT_EQ(rules[2]["type"], "PZL-130");
    ASSERT_EQ(fleet.run({"rule", "trainers", "--remove"}).status, 0);
    EXPECT_EQ(fleet.due("2025-06-02")[0]["next_by_calendar"], "2027-06-01");
    EXPECT_EQ(fleet.run({"rule", "trainers", "--remove"}).status, 1);
    EXPECT_EQ(fleet.run({"rule", "x", "--months", "0"}).status, 2);
    EXPECT_THAT(fleet.run({"rule", "x", "--type", "Concorde"}).err, testing::HasSubstr("Concorde"));
}

TEST(DueCommand, badInputChangesNothing)
{
    const SignedOn fleet("2026-05-01");
    EXPECT_EQ(fleet.run({"due", "--today", "2026-02-29"}).status, 1);
    EXPECT_EQ(fleet.run({"due", "--within", "-1"}).status, 2);
    EXPECT_EQ(fleet.run({"event", "SP-TST"}).status, 2); // neither words nor cause
    const auto misspelt = fleet.run({"event", "SP-TST", "--cause", "lightnin"});
    EXPECT_EQ(misspelt.status, 1);
    EXPECT_THAT(misspelt.err, testing::HasSubstr("did you mean lightning?"));
    EXPECT_EQ(fleet.run({"event", "SP-NOT", "lightning"}).status, 1);
    EXPECT_EQ(fleet.run({"event", "SP-TST", "lightning", "--date", "yesterday"}).status, 1);
    EXPECT_EQ(fleet.run({"waive", "abcd", "--reason", "r", "--by", "b"}).status, 1);
    EXPECT_EQ(fleet.run({"waive", "", "--reason", "r", "--by", "b"}).status, 1);
    ASSERT_EQ(fleet.run({"event", "SP-TST", "lightning", "--date", "2026-06-10"}).status, 0);
    const std::string event = fleet.due("2026-06-11")[0]["flags"][0]["event"];
    EXPECT_EQ(fleet.run({"waive", event, "--reason", "", "--by", "b"}).status, 1);
    EXPECT_EQ(fleet.run({"waive", event, "--reason", "r", "--by", ""}).status, 1);
    EXPECT_EQ(fleet.run({"waive", event, "--reason", "r"}).status, 2);
    EXPECT_EQ(fleet.due("2026-06-11")[0]["flags"].size(), 1u);
    EXPECT_EQ(fleet.sandbox.run({"event", "SP-TST", "lightning", "--db", "none.db"}).status, 1);
    EXPECT_FALSE(std::filesystem::exists(fleet.sandbox.path("none.db")));
}

} // namespace lubberline::test
