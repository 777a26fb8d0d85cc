#include <gmock/gmock.h>

#include "tests/app/Program.h"
#include "tests/app/Published.h"

namespace lubberline::test {

namespace {

const std::string kNamed = "# aircraft: SP-TST\n# type: PZL-130\n# compass: standby\n# site: Deblin\n# date: 2026-11-20\n";

} // namespace

TEST(DatabaseCommands, importListReportAndExport)
{
    const Sandbox sandbox;
    const auto file = sandbox.write("k.csv", kNamed + kWorksheet[0].check);
    ASSERT_EQ(sandbox.run({"import", file, "--db", "a.db"}).status, 0);
    const auto listed = sandbox.run({"swings", "--db", "a.db", "--json"}).json()["swings"];
    ASSERT_EQ(listed.size(), 1u);
    EXPECT_EQ(listed[0]["aircraft"], "SP-TST");
    EXPECT_EQ(listed[0]["readings"], 8);
    EXPECT_EQ(listed[0]["max_abs_deviation_deg"], 5.0);
    const auto report
        = sandbox.run({"report", "--swing", listed[0]["record"].get<std::string>().substr(0, 8), "--db", "a.db", "-o", "r.pdf"});
    EXPECT_EQ(report.status, 0) << report.err;
    EXPECT_EQ(sandbox.read("r.pdf").substr(0, 8), "%PDF-1.6");
    EXPECT_EQ(sandbox.run({"export", "--db", "a.db", "-o", "a.lubberline.json"}).status, 0);
    EXPECT_THAT(sandbox.read("a.lubberline.json"), testing::HasSubstr("SP-TST"));
}

TEST(DatabaseCommands, exportReadsBackByteForByte)
{
    const Sandbox sandbox;
    ASSERT_EQ(sandbox.run({"demo", "--db", "a.db", "--no-window", "-o", "out"}).status, 0);
    ASSERT_EQ(sandbox.run({"export", "--db", "a.db", "-o", "one.lubberline.json"}).status, 0);
    ASSERT_EQ(sandbox.run({"import", "one.lubberline.json", "--db", "b.db"}).status, 0);
    ASSERT_EQ(sandbox.run({"export", "--db", "b.db", "-o", "two.lubberline.json"}).status, 0);
    EXPECT_EQ(sandbox.read("one.lubberline.json"), sandbox.read("two.lubberline.json"));
    EXPECT_GT(sandbox.read("one.lubberline.json").size(), 10000u);
}

TEST(DatabaseCommands, aReportIsReadBackFromItsPdf)
{
    const Sandbox sandbox;
    const auto file = sandbox.write("k.csv", kNamed + kWorksheet[1].check);
    ASSERT_EQ(sandbox.run({"import", file, "--db", "a.db"}).status, 0);
    const std::string record = sandbox.run({"swings", "--db", "a.db", "--json"}).json()["swings"][0]["record"];
    ASSERT_EQ(sandbox.run({"report", "--swing", record, "--db", "a.db", "-o", "r.pdf"}).status, 0);
    const auto imported = sandbox.run({"import", "r.pdf", "--db", "b.db"});
    ASSERT_EQ(imported.status, 0) << imported.err;
    EXPECT_EQ(sandbox.run({"swings", "--db", "b.db", "--json"}).json()["swings"][0]["record"], record);
    const auto archive = sandbox.run({"report", "--swing", record, "--db", "a.db", "--archive", "-o", "archive.pdf"});
    ASSERT_EQ(archive.status, 0) << archive.err;
    EXPECT_EQ(sandbox.run({"import", "archive.pdf", "--db", "b.db"}).status, 1);
}

TEST(DatabaseCommands, aReportOfANamelessFileReadsBackAsNotStated)
{
    const Sandbox sandbox;
    ASSERT_EQ(sandbox.run({"report", sandbox.write("nga.csv", kNga501), "-o", "r.pdf"}).status, 0);
    const auto imported = sandbox.run({"import", "r.pdf", "--db", "a.db"});
    ASSERT_EQ(imported.status, 0) << imported.err;
    EXPECT_EQ(sandbox.run({"swings", "--db", "a.db", "--json"}).json()["swings"][0]["aircraft"], "aircraft not stated");
}

TEST(DatabaseCommands, theSameFileTwiceIsThereOnce)
{
    const Sandbox sandbox;
    const auto file = sandbox.write("k.csv", kNamed + kWorksheet[0].check);
    ASSERT_EQ(sandbox.run({"import", file, "--db", "a.db"}).status, 0);
    const auto again = sandbox.run({"import", file, file, "--db", "a.db"});
    EXPECT_EQ(again.status, 0);
    EXPECT_EQ(sandbox.run({"swings", "--db", "a.db", "--json"}).json()["swings"].size(), 1u);
}

TEST(DatabaseCommands, oneBadFileOfSeveralStoresNothing)
{
    const Sandbox sandbox;
    const auto good = sandbox.write("good.csv", kNamed + kWorksheet[0].check);
    const auto bad = sandbox.write("bad.csv", kNamed + kHeader + "0,x\n");
    const auto outcome = sandbox.run({"import", good, bad, "--db", "a.db"});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.err, testing::HasSubstr("bad.csv:7"));
    EXPECT_FALSE(std::filesystem::exists(sandbox.path("a.db")));
}

TEST(DatabaseCommands, aCsvThatNamesNoAircraftSaysHowToNameIt)
{
    const Sandbox sandbox;
    const auto file = sandbox.write("k.csv", kWorksheet[0].check);
    const auto outcome = sandbox.run({"import", file, "--db", "a.db"});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.err, testing::HasSubstr("aircraft"));
    EXPECT_EQ(sandbox.run({"import", file, "--db", "a.db", "--aircraft", "SP-X", "--type", "T", "--compass", "standby"}).status, 0);
}

TEST(DatabaseCommands, aNewSwingGetsTheFieldOfItsSite)
{
    const Sandbox sandbox;
    const auto placed = sandbox.write("placed.csv", kNamed + "# latitude_deg: 51.55\n# longitude_deg: 21.89\n" + kWorksheet[0].check);
    const auto named = sandbox.write("named.csv", kNamed + kWorksheet[1].check); // the site is known by its name, and so where it is
    ASSERT_EQ(sandbox.run({"import", placed, named, "--db", "a.db"}).status, 0);
    ASSERT_EQ(sandbox.run({"export", "--db", "a.db", "-o", "a.lubberline.json"}).status, 0);
    const auto fleet = nlohmann::json::parse(sandbox.read("a.lubberline.json"));
    EXPECT_EQ(fleet["version"], 2);
    for (const auto& swing : fleet["aircraft"][0]["compasses"][0]["swings"]) {
        EXPECT_EQ(swing["field"]["model"], "WMM2025");
        EXPECT_NEAR(swing["field"]["down_nT"].get<double>(), 46785, 60);
    }
    const auto again = sandbox.run({"import", placed, named, "a.lubberline.json", "--db", "a.db"});
    EXPECT_EQ(again.status, 0) << again.err;
    EXPECT_EQ(sandbox.run({"swings", "--db", "a.db", "--json"}).json()["swings"].size(), 2u);
}

TEST(DatabaseCommands, whatWasSignedWithoutAFieldStaysSo)
{
    const Sandbox sandbox;
    ASSERT_EQ(sandbox.run({"import", sandbox.write("k.csv", kNamed + kWorksheet[0].check), "--db", "a.db"}).status, 0);
    ASSERT_EQ(sandbox.run({"export", "--db", "a.db", "-o", "plain.lubberline.json"}).status, 0);
    auto fleet = nlohmann::json::parse(sandbox.read("plain.lubberline.json"));
    EXPECT_EQ(fleet["version"], 1); // no place, no field
    fleet["sites"][0]["latitude_deg"] = 51.55;
    fleet["sites"][0]["longitude_deg"] = 21.89;
    for (const char* state : {"signed", "complete"}) {
        fleet["aircraft"][0]["compasses"][0]["swings"][0]["state"] = state;
        const std::string database = std::string(state) + ".db",
                          file = sandbox.write(std::string(state) + ".lubberline.json", fleet.dump());
        ASSERT_EQ(sandbox.run({"import", file, "--db", database}).status, 0);
        const auto listed = sandbox.run({"swings", "--db", database, "--json"}).json()["swings"][0];
        EXPECT_EQ(listed["state"], state);
        EXPECT_EQ(listed["signed"], false); // the file does not say by whom
        EXPECT_EQ(listed["radio"], "not_stated");
        ASSERT_EQ(sandbox.run({"export", "--db", database, "-o", "out.lubberline.json"}).status, 0);
        EXPECT_EQ(nlohmann::json::parse(sandbox.read("out.lubberline.json"))["version"], std::string(state) == "signed" ? 1 : 2);
    }
}

TEST(DatabaseCommands, statusBackupAndVerify)
{
    const Sandbox sandbox;
    ASSERT_EQ(sandbox.run({"demo", "--db", "a.db", "--no-window", "-o", "out"}).status, 0);
    const auto status = sandbox.run({"db", "status", "--db", "a.db", "--json"});
    ASSERT_EQ(status.status, 0) << status.err;
    EXPECT_GE(status.json()["aircraft"], 12);
    EXPECT_GE(status.json()["types"], 3);
    EXPECT_EQ(status.json()["sensor_models"], 2);
    ASSERT_EQ(sandbox.run({"db", "backup", "copy.db", "--db", "a.db"}).status, 0);
    EXPECT_EQ(sandbox.run({"db", "verify", "--db", "copy.db"}).status, 0);
    const auto existing = sandbox.run({"db", "backup", "copy.db", "--db", "a.db"});
    EXPECT_EQ(existing.status, 1);
    EXPECT_THAT(existing.err, testing::HasSubstr("copy.db"));
}

TEST(DatabaseCommands, whatIsNotADatabaseIsRefusedAndLeftAlone)
{
    const Sandbox sandbox;
    const auto file = sandbox.write("k.csv", kNamed + kWorksheet[0].check);
    const std::string letter = "Dear headquarters, this is not a database. " + std::string(2000, '.');
    sandbox.write("letter.db", letter);
    for (const std::vector<std::string>& command :
        {std::vector<std::string>{"import", file, "--db", "letter.db"}, {"swings", "--db", "letter.db"},
            {"db", "verify", "--db", "letter.db"}, {"swings", "--db", "missing.db"}, {"swings", "--db", "none/a.db"}}) {
        const auto outcome = sandbox.run(command);
        EXPECT_EQ(outcome.status, 1) << command[0] << command.back();
        EXPECT_THAT(outcome.err, testing::HasSubstr(command.back()));
    }
    EXPECT_EQ(sandbox.read("letter.db"), letter);
    EXPECT_EQ(sandbox.files(), (std::vector<std::string>{"k.csv", "letter.db"}));
}

} // namespace lubberline::test
