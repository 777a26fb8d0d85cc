#include <gmock/gmock.h>

#include "tests/app/Program.h"
#include "tests/app/Published.h"

namespace lubberline::test {

class Worksheet : public testing::TestWithParam<int> {
protected:
    const WorksheetSwing& swing() const { return kWorksheet[static_cast<std::size_t>(GetParam())]; }
};

TEST_P(Worksheet, correctionFiguresAreTheSheets)
{
    const Sandbox sandbox;
    const auto outcome = sandbox.run({"correct", sandbox.write("c.csv", swing().correction), "--json"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const auto json = outcome.json();
    EXPECT_EQ(json["C_deg"], swing().C);
    EXPECT_EQ(json["B_deg"], swing().B);
    ASSERT_EQ(json["steps"].size(), 4u);
    for (const auto& step : json["steps"]) {
        if (step["on"] == "S") {
            EXPECT_EQ(step["make_compass_read_deg"], swing().makeReadSouth);
        }
        if (step["on"] == "W") {
            EXPECT_EQ(step["make_compass_read_deg"], swing().makeReadWest);
        }
        EXPECT_EQ(step["coefficient"], step["on"] == "N" || step["on"] == "S" ? "C" : "B");
    }
}

TEST_P(Worksheet, allEightSteerFiguresAreTheSheets)
{
    const Sandbox sandbox;
    const auto file = sandbox.write("k.csv", swing().check);
    const auto outcome = sandbox.run({"card", file, "--step", "45", "--from", "readings", "--remove", "A", "--json"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const auto rows = outcome.json()["rows"];
    ASSERT_EQ(rows.size(), 8u);
    for (std::size_t i = 0; i < 8; ++i) {
        EXPECT_EQ(rows[i]["for_deg"], 45.0 * static_cast<double>(i));
        EXPECT_EQ(rows[i]["steer_deg"], swing().steer[i]);
        EXPECT_EQ(rows[i]["steer_rounded_deg"], swing().steer[i]);
    }
}

INSTANTIATE_TEST_SUITE_P(Questions, Worksheet, testing::Range(0, 3));

TEST(CorrectCommand, millstdExampleWithTheSignTurned)
{
    const Sandbox sandbox;
    const auto json = sandbox.run({"correct", sandbox.write("m.csv", kMilStd765), "--json"}).json();
    EXPECT_EQ(json["A_deg"], -1.75);
    EXPECT_EQ(json["B_deg"], 3.0);
    EXPECT_EQ(json["C_deg"], -5.5);
}

TEST(CorrectCommand, namesTheCardinalThatIsMissing)
{
    const Sandbox sandbox;
    const auto outcome = sandbox.run({"correct", sandbox.write("c.csv", kHeader + "0,1\n90,91\n180,181\n225,226\n")});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.err, testing::HasSubstr("W"));
    EXPECT_THAT(outcome.err, testing::HasSubstr("c.csv"));
}

TEST(CardCommand, thirtyDegreeStepsAreTheDefault)
{
    const Sandbox sandbox;
    const auto json = sandbox.run({"card", sandbox.write("k.csv", kWorksheet[0].check), "--json"}).json();
    EXPECT_EQ(json["rows"].size(), 12u);
    EXPECT_TRUE(json.contains("residual_max_abs_deg"));
}

TEST(CardCommand, writesAPdfOfOnePage)
{
    const Sandbox sandbox;
    const auto file = sandbox.write("k.csv", kWorksheet[0].check);
    const auto outcome = sandbox.run({"card", file, "-o", sandbox.path("card.pdf")});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(sandbox.read("card.pdf").substr(0, 5), "%PDF-");
}

TEST(CardCommand, twoSwingsGiveTwoColumns)
{
    const Sandbox sandbox;
    const auto on = sandbox.write("on.csv", "# radio: on\n" + kWorksheet[0].check);
    const auto off = sandbox.write("off.csv", "# radio: off\n" + kWorksheet[1].check);
    const auto outcome = sandbox.run({"card", on, "--second", off, "--json"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.json()["heading"], "RADIO ON");
    EXPECT_EQ(outcome.json()["second_column"]["heading"], "RADIO OFF");
    EXPECT_EQ(sandbox.run({"card", on, "--second", off, "-o", sandbox.path("two.pdf")}).status, 0);
}

TEST(CardCommand, ofAStoredSwingHasEveryForm)
{
    const Sandbox sandbox;
    const auto file
        = sandbox.write("k.csv", "# type: M28\n# aircraft: 3713\n# compass: standby\n# date: 2026-11-23\n" + kWorksheet[0].check);
    ASSERT_EQ(sandbox.run({"import", file, "--db", "a.db"}).status, 0);
    const std::string record = sandbox.run({"swings", "--db", "a.db", "--json"}).json()["swings"][0]["record"];
    for (const std::string form : {"placard", "card", "dd1613", "job"}) {
        const auto outcome
            = sandbox.run({"card", "--swing", record.substr(0, 8), "--db", "a.db", "--form", form, "-o", sandbox.path(form + ".pdf")});
        ASSERT_EQ(outcome.status, 0) << form << ": " << outcome.err;
        EXPECT_EQ(sandbox.read(form + ".pdf").substr(0, 5), "%PDF-") << form;
    }
    EXPECT_EQ(sandbox.run({"card", "--swing", record, "--db", "a.db", "--form", "job"}).status, 2);    // nowhere to write it
    EXPECT_EQ(sandbox.run({"card", file, "--form", "dd1613", "-o", sandbox.path("x.pdf")}).status, 2); // not of the database
    EXPECT_EQ(sandbox.run({"card", file, "--form", "poster"}).status, 2);
    EXPECT_EQ(sandbox.run({"card", "--swing", "ffffffff", "--db", "a.db"}).status, 1);
}

TEST(CardCommand, usageErrorsAreStatusTwo)
{
    const Sandbox sandbox;
    const auto file = sandbox.write("k.csv", kWorksheet[0].check);
    EXPECT_EQ(sandbox.run({"card", file, "--step", "40"}).status, 2);
    EXPECT_EQ(sandbox.run({"card", file, "--remove", "F"}).status, 2);
    EXPECT_EQ(sandbox.run({"card"}).status, 2);
    EXPECT_EQ(sandbox.run({"nonsense"}).status, 2);
}

} // namespace lubberline::test
