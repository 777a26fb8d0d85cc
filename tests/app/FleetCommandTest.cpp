// Years of swings as a population, from the command line: the demonstration's, and what a database may lack.

#include <gmock/gmock.h>

#include <map>
#include <sstream>

#include "tests/app/Program.h"

namespace lubberline::test {

namespace {

using nlohmann::json;

/// The demonstration fleet, stored once for all tests here.
class FleetCommand : public testing::Test {
protected:
    static void SetUpTestSuite()
    {
        s_sandbox = new Sandbox;
        ASSERT_EQ(s_sandbox->run({"demo", "--db", "demo.db", "--no-window", "-o", "out"}).status, 0);
    }
    static void TearDownTestSuite()
    {
        delete s_sandbox;
        s_sandbox = nullptr;
    }
    static Outcome fleet(std::vector<std::string> arguments)
    {
        arguments.insert(arguments.begin(), {"fleet", "--db", "demo.db", "--today", "2026-11-26"});
        return s_sandbox->run(arguments);
    }
    static Sandbox* s_sandbox;
};
Sandbox* FleetCommand::s_sandbox = nullptr;

} // namespace

TEST_F(FleetCommand, tellsThePopulationThatWasPutIn)
{
    const auto outcome = fleet({"--type", "Su-22M4", "--json"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const json told = outcome.json();
    EXPECT_EQ(told["selection"]["aircraft"], 20);
    EXPECT_EQ(told["selection"]["used"], told["selection"]["swings"]);
    EXPECT_EQ(told["maxima_deg"], json({135, 315}));
    EXPECT_EQ(told["minima_deg"], json({45, 225}));
    ASSERT_EQ(told["pattern"].size(), 8u);
    for (const char* key : {"heading_deg", "aircraft", "mean_deg", "standard_deviation_deg", "between_aircraft_deg", "percentile_5_deg",
             "percentile_50_deg", "percentile_95_deg"})
        EXPECT_TRUE(told["pattern"][0].contains(key)) << key;
    EXPECT_NEAR(told["coefficients"]["D"]["mean_deg"].get<double>(), -2.2, 0.2);
    EXPECT_EQ(told["harmonics"]["mean"].size(), 5u);
    EXPECT_EQ(told["exceedance"]["limit_deg"], 6.0);
    EXPECT_EQ(told["exceedance"]["headings"].size(), 8u);
    EXPECT_GT(told["variance"]["A"]["residual_deg2"].get<double>(), told["variance"]["D"]["residual_deg2"].get<double>());
    EXPECT_EQ(told["variance"]["A"]["interval_95"]["residual_deg2"].size(), 2u);
    EXPECT_EQ(told["by_plant"].size(), 2u);
    EXPECT_NEAR(told["training"]["change_share"].get<double>(), -0.8, 0.08);
    // Before the training A stood off: one alarm a base and crew, and not one a date.
    std::map<std::string, int> alarms;
    for (const auto& alarm : told["charts"]["alarms"]) {
        EXPECT_EQ(alarm["date"], alarm["first_date"]); // as scripts have read it from the first
        EXPECT_EQ(alarm["chart"], alarm["cusum"] ? "cusum" : "ewma");
        EXPECT_LE(alarm["first_date"], alarm["last_date"]);
        ++alarms[alarm.value("site", "") + alarm.value("crew", "") + (alarm["average_A_deg"] > told["charts"]["centre_A_deg"] ? "+" : "-")];
    }
    EXPECT_FALSE(alarms.empty());
    for (const auto& [who, count] : alarms)
        EXPECT_LE(count, 3) << who;
    EXPECT_GE(told["jumps"].size(), 3u);
    EXPECT_LE(told["jumps"].size(), 5u);
    EXPECT_EQ(told["ranking"].size(), 20u);
    EXPECT_EQ(told["ranking"][0]["aircraft"], "3218");
    EXPECT_THAT(told["ranking"][0]["reason"].get<std::string>(), testing::HasSubstr("drifts"));
}

TEST_F(FleetCommand, writesEachFormatWhole)
{
    for (const char* file : {"fleet.pdf", "fleet.html", "fleet.csv", "fleet.json"}) {
        const auto outcome = fleet({"--type", "Su-22M4", "-o", file});
        ASSERT_EQ(outcome.status, 0) << outcome.err;
        EXPECT_GT(s_sandbox->read(file).size(), 2000u) << file;
    }
    EXPECT_THAT(s_sandbox->read("fleet.csv"), testing::StartsWith("# selection\naircraft,compasses,swings,used\n20,20,"));
    EXPECT_THAT(s_sandbox->read("fleet.html"), testing::HasSubstr("<svg"));
    EXPECT_THAT(s_sandbox->read("fleet.html"), testing::HasSubstr("Swing next: 3218"));
    EXPECT_EQ(json::parse(s_sandbox->read("fleet.json"))["selection"]["aircraft"], 20);
}

TEST_F(FleetCommand, tablesOfTheCsvAreTheArraysOfTheJson)
{
    ASSERT_EQ(fleet({"-o", "all.csv"}).status, 0);
    std::map<std::string, std::size_t> rows;
    std::istringstream csv(s_sandbox->read("all.csv"));
    std::string table;
    for (std::string line; std::getline(csv, line);) {
        if (line.starts_with("# ")) {
            table = line.substr(2);
            std::getline(csv, line); // what the columns are
        } else if (!line.empty())
            ++rows[table];
    }
    const auto all = fleet({"--json"}).json();
    EXPECT_EQ(rows["left out"], all["selection"]["left_out"].size());
    EXPECT_EQ(rows["pattern"], all["pattern"].size());
    EXPECT_EQ(rows["jumps"], all["jumps"].size());
    EXPECT_EQ(rows["drifts"], all["drifts"].size());
    EXPECT_EQ(rows["who next"], all["ranking"].size());
    EXPECT_EQ(rows["alarms of the control charts of A"], all["charts"]["alarms"].size());
    EXPECT_EQ(rows["A by base and crew"], all["by_plant"].size() + all["by_crew"].size());
}

TEST_F(FleetCommand, selectsAndCountsWhatIsLeftOut)
{
    const auto all = fleet({"--json"}).json();
    EXPECT_THAT(all["selection"]["left_out"],
        testing::Contains(testing::ResultOf([](const json& left) { return left["reason"].get<std::string>(); }, "draft")));
    EXPECT_THAT(all["warnings"].dump(), testing::HasSubstr("aircraft types are in one selection"));
    const auto found = fleet({"--type", "Su-22M4", "--stage", "found", "--json"}).json();
    EXPECT_EQ(found["selection"]["used"], 200);
    EXPECT_EQ(found["selection"]["left_out"][0]["reason"], "other stage");
    const auto one = fleet({"--aircraft", "3218", "--grid", "7", "--vote", "swing", "--limit", "3", "--json"}).json();
    EXPECT_EQ(one["pattern"].size(), 7u);
    EXPECT_EQ(one["pattern"][0]["aircraft"], 10); // votes are swings
    EXPECT_EQ(one["exceedance"]["limit_deg"], 3.0);
    EXPECT_EQ(one["exceedance"]["pairs"], 0); // it was never corrected
    EXPECT_EQ(one["exceedance"]["share_95"], nullptr);
    EXPECT_EQ(one["ranking"][0]["limit_deg"], 3.0);
    EXPECT_EQ(fleet({"--type", "Su-22M4", "--to", "2018-12-31", "--json"}).json()["training"], nullptr);
}

TEST_F(FleetCommand, saysWhatIsWrong)
{
    const auto unknown = fleet({"--type", "Su-23"});
    EXPECT_EQ(unknown.status, 1);
    EXPECT_THAT(unknown.err, testing::HasSubstr("aircraft type 'Su-23'"));
    const auto date = fleet({"--from", "2026-02-30"});
    EXPECT_EQ(date.status, 1);
    EXPECT_THAT(date.err, testing::HasSubstr("--from: '2026-02-30' is no day of the calendar"));
    const auto none = fleet({"--type", "Su-22M4", "--from", "2030-01-01"});
    EXPECT_EQ(none.status, 1);
    EXPECT_THAT(none.err, testing::HasSubstr("no swing is in the selection"));
    EXPECT_EQ(fleet({"--grid", "2"}).status, 2);
    EXPECT_EQ(fleet({"--stage", "lost"}).status, 2);
    EXPECT_EQ(fleet({"-o", "fleet.xls"}).status, 2);
}

TEST_F(FleetCommand, readsWithoutChangingAnything)
{
    const auto before = s_sandbox->read("demo.db");
    EXPECT_EQ(fleet({"--json"}).status, 0);
    EXPECT_EQ(s_sandbox->read("demo.db"), before);
}

} // namespace lubberline::test
