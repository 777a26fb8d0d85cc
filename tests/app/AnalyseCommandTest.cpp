#include <gmock/gmock.h>

#include "tests/app/Program.h"
#include "tests/app/Published.h"

namespace lubberline::test {

TEST(AnalyseCommand, givesBothPublishedAnswersForTheNgaSwing)
{
    const Sandbox sandbox;
    const auto outcome = sandbox.run({"analyse", sandbox.write("nga.csv", kNga501), "--json"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const auto json = outcome.json();
    // NGA Handbook art. 501, by the eight-point rules.
    EXPECT_NEAR(json["point_rules"]["A_deg"], 1.0, 1e-9);
    EXPECT_NEAR(json["point_rules"]["B_deg"], 12.0, 1e-9);
    EXPECT_NEAR(json["point_rules"]["C_deg"], 8.0, 1e-9);
    EXPECT_NEAR(json["point_rules"]["D_deg"], 5.0, 1e-9);
    EXPECT_NEAR(json["point_rules"]["E_deg"], 1.5, 1e-9);
    // Least squares on all eight: sums of deviation times sine over 4.
    EXPECT_NEAR(json["approximate"]["B_deg"], 11.9397, 5e-5);
    EXPECT_NEAR(json["approximate"]["C_deg"], 7.9598, 5e-5);
    EXPECT_NEAR(json["approximate"]["A_deg"], 1.0, 1e-9);
    EXPECT_NEAR(json["approximate"]["D_deg"], 5.0, 1e-9);
    EXPECT_NEAR(json["approximate"]["E_deg"], 1.5, 1e-9);
    EXPECT_NEAR(json["summary"]["max_abs_deviation_deg"], 20.0, 1e-9);
    EXPECT_NEAR(json["summary"]["at_magnetic_heading_deg"], 65.0, 1e-9);
}

TEST(AnalyseCommand, doubtsADateThatIsStillToCome)
{
    const Sandbox sandbox;
    const std::string rows = "magnetic_heading_deg,compass_heading_deg\n0,358\n90,84\n180,182\n270,275\n";
    const auto later = sandbox.write("later.csv", "# aircraft: SP-XYZ\n# compass: standby\n# date: 2991-05-01\n" + rows);
    EXPECT_THAT(sandbox.run({"analyse", later}).err, testing::HasSubstr("2991-05-01 is still to come"));
    EXPECT_THAT(sandbox.run({"analyse", later, "--json"}).json()["warnings"][0], testing::HasSubstr("2991-05-01 is still to come"));
    EXPECT_THAT(sandbox.run({"import", later}).err, testing::HasSubstr("2991-05-01 is still to come"));
    EXPECT_THAT(sandbox.run({"analyse", sandbox.write("then.csv", "# date: 2025-05-01\n" + rows)}).err,
        testing::Not(testing::HasSubstr("still to come")));
}

TEST(AnalyseCommand, saysThatAnAircraftStoodNoseUp)
{
    const Sandbox sandbox;
    const auto csv
        = sandbox.write("up.csv", "magnetic_heading_deg,compass_heading_deg,pitch_deg\n0,358,4.5\n90,84,4.5\n180,182,4.5\n270,275,4.5\n");
    EXPECT_THAT(sandbox.run({"analyse", csv}).err, testing::HasSubstr("NOT LEVEL: swung at pitch +4.5°"));
    EXPECT_THAT(sandbox.run({"analyse", csv, "--json"}).json()["warnings"].dump(), testing::HasSubstr("NOT LEVEL"));
}

TEST(AnalyseCommand, hasEveryKeyOfTheContract)
{
    const Sandbox sandbox;
    const auto json = sandbox.run({"analyse", sandbox.write("a.csv", kWorksheet[0].check), "--json"}).json();
    for (const char* key : {"readings", "approximate", "exact", "point_rules", "harmonics", "summary", "warnings"})
        EXPECT_TRUE(json.contains(key)) << key;
    for (const char* key :
        {"magnetic_heading_deg", "compass_heading_deg", "deviation_deg", "residual_approximate_deg", "residual_exact_deg", "outlier"})
        EXPECT_TRUE(json["readings"][0].contains(key)) << key;
    for (const char* key :
        {"A_deg", "B_deg", "C_deg", "D_deg", "E_deg", "standard_error_deg", "rms_deg", "max_abs_residual_deg", "condition_number"})
        EXPECT_TRUE(json["approximate"].contains(key)) << key;
    for (const char* key : {"A", "B", "C", "D", "E", "standard_error", "rms_deg", "max_abs_residual_deg", "condition_number"})
        EXPECT_TRUE(json["exact"].contains(key)) << key;
    EXPECT_EQ(json["harmonics"]["argument"], "magnetic");
    for (const char* key : {"order", "sin_deg", "cos_deg", "amplitude_deg", "phase_deg"})
        EXPECT_TRUE(json["harmonics"]["orders"][0].contains(key)) << key;
    EXPECT_EQ(json["readings"].size(), 8u);
    EXPECT_EQ(json["readings"][0]["magnetic_heading_deg"], 317.0);
    EXPECT_EQ(json["readings"][0]["deviation_deg"], 1.0);
}

TEST(AnalyseCommand, fourCardinalsTellAllButD)
{
    const Sandbox sandbox;
    const auto json = sandbox.run({"analyse", sandbox.write("m.csv", kMilStd765), "--json"}).json();
    EXPECT_TRUE(json["approximate"]["D_deg"].is_null());
    EXPECT_TRUE(json["approximate"]["E_deg"].is_number());
    EXPECT_TRUE(json["exact"]["D"].is_null());
    EXPECT_TRUE(json["approximate"]["standard_error_deg"]["A_deg"].is_number()); // of the reading alone
    EXPECT_TRUE(json["approximate"]["interval_95_deg"]["A_deg"].is_null());
    EXPECT_TRUE(json["approximate"]["A_deg"].is_number());
    EXPECT_FALSE(json["warnings"].empty());
    // Duncan Aviation's figures with the sign turned: index +1.75, E/W -3, N/S +5.5 as error.
    EXPECT_NEAR(json["point_rules"]["A_deg"], -1.75, 1e-9);
    EXPECT_NEAR(json["point_rules"]["B_deg"], 3.0, 1e-9);
    EXPECT_NEAR(json["point_rules"]["C_deg"], -5.5, 1e-9);
}

TEST(AnalyseCommand, headingsOnOneSideLeaveNumbersOut)
{
    const Sandbox sandbox;
    const auto file = sandbox.write("b.csv", kHeader + "0,358\n10,8\n20,18\n30,27\n40,37\n50,47\n60,57\n70,67\n");
    const auto outcome = sandbox.run({"analyse", file, "--json"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_TRUE(outcome.json()["approximate"]["D_deg"].is_null());
    EXPECT_TRUE(outcome.json()["exact"]["E"].is_null());
    EXPECT_FALSE(outcome.json()["warnings"].empty());
    EXPECT_EQ(outcome.out.find("nan"), std::string::npos);
}

TEST(AnalyseCommand, theTableNamesSignsAndUnits)
{
    const Sandbox sandbox;
    const auto outcome = sandbox.run({"analyse", sandbox.write("a.csv", kWorksheet[0].check)});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_THAT(outcome.out, testing::HasSubstr("deviation = magnetic - compass, east positive"));
    EXPECT_THAT(outcome.out, testing::HasSubstr("8-point (deg)"));
}

TEST(AnalyseCommand, showsWhatWouldRemainWithoutComponents)
{
    const Sandbox sandbox;
    const auto file = sandbox.write("nga.csv", kNga501);
    const auto json = sandbox.run({"analyse", file, "--remove", "B,C", "--json"}).json();
    ASSERT_EQ(json["removal"]["remaining_deg"].size(), 8u);
    // On north the compass heading is 0: all of C (least squares 7.9598) is taken from 10.5.
    EXPECT_NEAR(json["removal"]["remaining_deg"][0], 10.5 - 7.9598, 1e-4);
    EXPECT_LT(json["removal"]["max_abs_deg"], json["summary"]["max_abs_deviation_deg"]);
    EXPECT_FALSE(sandbox.run({"analyse", file, "--json"}).json().contains("removal"));
    EXPECT_EQ(sandbox.run({"analyse", file, "--remove", "X"}).status, 2);
    EXPECT_EQ(sandbox.run({"analyse", sandbox.write("m.csv", kMilStd765), "--remove", "D"}).status, 1);
    EXPECT_THAT(sandbox.run({"analyse", file, "--remove", "B,C"}).out, testing::HasSubstr("would remain"));
}

TEST(AnalyseCommand, ordersAreCutOnRequest)
{
    const Sandbox sandbox;
    const auto file = sandbox.write("n.csv", "magnetic_heading_deg,deviation_deg\n0,1\n45,2\n90,1\n135,0\n180,-1\n225,-2\n270,-1\n315,0\n");
    EXPECT_EQ(sandbox.run({"analyse", file, "--json"}).json()["harmonics"]["orders"].size(), 5u); // 0…4
    EXPECT_EQ(sandbox.run({"analyse", file, "--json", "--orders", "2"}).json()["harmonics"]["orders"].size(), 3u);
}

} // namespace lubberline::test
