#include <cmath>

#include <gmock/gmock.h>

#include "core/format/exchange/ElectricalJson.h"
#include "tests/app/Program.h"
#include "tests/app/Published.h"

namespace lubberline::test {

namespace {

double wrap(double angle_deg) { return std::remainder(angle_deg, 360.0); }

} // namespace

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

TEST(CorrectCommand, turnsNoScrewForReadingsThatCannotBeRight)
{
    const Sandbox sandbox;
    // West misread by 100: no coefficient follows, and "make the compass read 41" is for no crew.
    const auto refused = sandbox.run({"correct", sandbox.write("c.csv", kHeader + "0,357\n90,91\n180,183\n271,171\n")});
    EXPECT_EQ(refused.status, 1);
    EXPECT_EQ(refused.out, "");
    EXPECT_THAT(refused.err, testing::HasSubstr("no deviation can be told"));
    const auto reciprocal = sandbox.run({"correct", sandbox.write("c.csv", kHeader + "0,180\n90,270\n180,0\n270,90\n"), "--json"});
    EXPECT_EQ(reciprocal.status, 0);
    EXPECT_THAT(reciprocal.err, testing::HasSubstr("reads the reciprocal"));
    EXPECT_THAT(reciprocal.json()["warnings"].dump(), testing::HasSubstr("reads the reciprocal"));
    const auto one = sandbox.run({"correct", sandbox.write("c.csv", kHeader + "0,357\n90,91\n180,183\n270,303\n")}); // 273 was read
    EXPECT_THAT(one.err, testing::HasSubstr("one of the readings is likely misread"));
    const auto large = sandbox.run({"correct", sandbox.write("c.csv", kHeader + "0,0\n90,60\n180,180\n270,300\n")});
    EXPECT_EQ(large.status, 0);
    EXPECT_THAT(large.err, testing::HasSubstr("B is +30.0°, more than a corrector takes"));
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

TEST(CardCommand, theSecondSwingIsAnotherOneOfTheSameCompass)
{
    const Sandbox sandbox;
    const std::string head = "# aircraft: 3713\n# compass: standby\n# date: 2026-11-23\n";
    const auto on = sandbox.write("on.csv", head + "# radio: on\n" + kWorksheet[0].check);
    const auto refuses = [&](const std::string& name, const std::string& text) {
        const auto outcome = sandbox.run({"card", on, "--second", sandbox.write(name, text), "--json"});
        EXPECT_EQ(outcome.status, 1) << name;
        EXPECT_THAT(outcome.err, testing::HasSubstr(name));
    };
    EXPECT_EQ(sandbox.run({"card", on, "--second", on, "--json"}).status, 1);
    EXPECT_EQ(sandbox.run({"card", on, "--second", sandbox.path("./on.csv"), "--json"}).status, 1);
    refuses("copy.csv", head + "# radio: on\n" + kWorksheet[0].check);
    refuses("both_on.csv", head + "# radio: on\n" + kWorksheet[1].check);
    refuses("aircraft.csv", "# aircraft: 3714\n# compass: standby\n# date: 2026-11-23\n# radio: off\n" + kWorksheet[1].check);
    refuses("compass.csv", "# aircraft: 3713\n# compass: No. 1\n# date: 2026-11-23\n# radio: off\n" + kWorksheet[1].check);
    refuses("unnamed.csv", "# radio: off\n" + kWorksheet[1].check);
    refuses("left.csv", head + "# stage: as_left\n# radio: off\n" + kWorksheet[1].check);
    const auto both
        = sandbox.run({"card", on, "--second", sandbox.write("off.csv", head + "# radio: off\n" + kWorksheet[1].check), "--json"});
    ASSERT_EQ(both.status, 0) << both.err;
    EXPECT_NE(both.json()["record"], both.json()["second_column"]["record"]);
    EXPECT_NE(both.json()["data_sha256"], both.json()["second_column"]["data_sha256"]);
    EXPECT_EQ(both.json()["signed"], false);
}

TEST(CardCommand, byCompassInFineStepsAndBetweenRows)
{
    const Sandbox sandbox;
    const auto file = sandbox.write("k.csv", kNga501);
    for (const int step : {10, 15, 30, 45})
        EXPECT_EQ(sandbox.run({"card", file, "--step", std::to_string(step), "--json"}).json()["rows"].size(), std::size_t(360 / step));
    const auto by = sandbox.run({"card", file, "--by", "compass", "--step", "45", "--from", "readings", "--at", "22.5", "--json"}).json();
    // The handbook's swing was read on compass headings: each row is a reading, magnetic = compass + deviation.
    const std::array deviation{10.5, 20.0, 11.5, -1.2, -5.5, -8.0, -12.5, -6.8};
    for (std::size_t i = 0; i < 8; ++i) {
        EXPECT_EQ(by["rows"][i]["steer_deg"], 45.0 * double(i));
        EXPECT_NEAR(wrap(double(by["rows"][i]["for_deg"]) - 45.0 * double(i) - deviation[i]), 0, 1e-9) << i;
    }
    EXPECT_NEAR(by["at"]["interpolated_deg"], (10.5 + 65.0) / 2, 1e-9);
    EXPECT_EQ(sandbox.run({"card", file, "--by", "true"}).status, 2);
    EXPECT_EQ(sandbox.run({"card", file, "--at", "400"}).status, 2);
    EXPECT_EQ(sandbox.run({"card", file, "--by", "compass", "--step", "10", "-o", sandbox.path("c.pdf")}).status, 0);
}

TEST(CardCommand, noCardOfACompassThatFolds)
{
    const Sandbox sandbox;
    const auto model = sandbox.write("m.json", R"({"field":{"H_nT":700,"dip_deg":89.3},"hard_iron_nT":[800,0,0]})");
    ASSERT_EQ(sandbox.run({"simulate", model, "-o", sandbox.path("fold.csv")}).status, 0);
    for (const std::string step : {"10", "15", "30", "45"})
        for (const std::string from : {"fit", "readings"}) {
            const auto outcome = sandbox.run({"card", sandbox.path("fold.csv"), "--step", step, "--from", from, "--json"});
            EXPECT_EQ(outcome.status, 1) << step << from;
            EXPECT_THAT(outcome.err, testing::ContainsRegex("[0-9]{3}°")) << outcome.err;
            EXPECT_EQ(outcome.out, "");
        }
    EXPECT_EQ(sandbox.run({"card", sandbox.path("fold.csv"), "-o", sandbox.path("fold.pdf")}).status, 1);
}

/// One compass, one day: radio on signed, radio off a draft.
TEST(CardCommand, aSignatureStandsOverItsOwnColumnOnly)
{
    const Sandbox sandbox;
    const std::string head = "# type: M28\n# aircraft: 3713\n# compass: standby\n# date: 2026-11-23\n# radio: ";
    const auto listed = [&sandbox] { return sandbox.run({"swings", "--db", "a.db", "--json"}).json()["swings"]; };
    ASSERT_EQ(sandbox.run({"import", sandbox.write("on.csv", head + "on\n" + kWorksheet[0].check), "--db", "a.db"}).status, 0);
    const std::string on = listed()[0]["record"];
    ASSERT_EQ(sandbox.run({"import", sandbox.write("off.csv", head + "off\n" + kWorksheet[1].check), "--db", "a.db"}).status, 0);
    std::string off;
    for (const auto& swing : listed())
        if (swing["record"] != on)
            off = swing["record"];
    const auto completed = sandbox.run({"complete", on, "--db", "a.db"});
    ASSERT_EQ(completed.status, 0) << completed.err;
    ASSERT_EQ(sandbox.run({"sign", on, "--role", "performer", "--name", "Ada", "--db", "a.db"}).status, 0);
    EXPECT_EQ(sandbox.run({"sign", on, "--role", "inspector", "--name", "ADA", "--db", "a.db"}).status, 1); // nobody signs as both
    ASSERT_EQ(sandbox.run({"sign", on, "--role", "inspector", "--name", "Ben", "--db", "a.db"}).status, 0);
    const auto card = sandbox.run({"card", "--swing", on, "--db", "a.db", "--json"}).json();
    EXPECT_EQ(card["heading"], "RADIO ON");
    const auto &first = card, &second = card["second_column"];
    EXPECT_NE(first["record"], second["record"]);
    EXPECT_NE(first["data_sha256"], second["data_sha256"]);
    EXPECT_EQ(first["signed"], first["record"] == on);
    EXPECT_EQ(second["signed"], second["record"] == on);
    EXPECT_NE(first["signed"], second["signed"]);
    EXPECT_EQ(sandbox.run({"card", "--swing", on, "--db", "a.db", "--remove", "A", "--json"}).json()["signed"], false);
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

TEST(ElectricalCommand, writesItsRecordAndNeverOverItsSheet)
{
    const Sandbox sandbox;
    ElectricalSwing swing;
    swing.date = "2026-11-20";
    swing.after.indicated_deg = {0.3, 90.1, 180.4, 270.4};
    const auto file = sandbox.write("sheet.json", writeElectricalJson(swing));
    const auto outcome = sandbox.run({"electrical", file, "--json", "-o", sandbox.path("record.pdf")});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_NEAR(outcome.json()["after"]["pair_90_270_deg"], 0.3, 1e-9);
    EXPECT_EQ(sandbox.read("record.pdf").substr(0, 5), "%PDF-");
    EXPECT_EQ(sandbox.run({"electrical", file, "-o", file}).status, 2);
    EXPECT_EQ(sandbox.run({"electrical", file, "-o", sandbox.path("record.txt")}).status, 2);
}

TEST(AnalyseCommand, tellsArcsThatNobodyReadWhateverTheConditionNumber)
{
    const Sandbox sandbox;
    std::string text = kHeader;
    for (int heading = 0; heading <= 240; heading += 10)
        text += std::to_string(heading) + "," + std::to_string(heading + (heading % 20 == 0 ? 1 : 0)) + "\n";
    const auto json = sandbox.run({"analyse", sandbox.write("arc.csv", text), "--json"}).json();
    EXPECT_LT(json["approximate"]["condition_number"], 10);
    EXPECT_THAT(json["warnings"].dump(), testing::HasSubstr("no reading between 241° and 001° (compass), an arc of 120°"));
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
