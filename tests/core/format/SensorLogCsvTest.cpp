// What loggers write, and what is refused.
#include "core/format/csv/SensorLogCsv.h"

#include <gmock/gmock.h>

#include <sstream>

namespace lubberline::test {
namespace {

using testing::HasSubstr;

Result<SensorLog> read(const std::string& text, const SensorLogOptions& options = {})
{
    std::istringstream input(text);
    return readSensorLog(input, "log.csv", options);
}

std::string refusal(const std::string& text, const SensorLogOptions& options = {})
{
    const auto log = read(text, options);
    return log ? "it was read" : describe(log.error());
}

std::string warned(const SensorLog& log) { return together(log.warnings).english(); }

TEST(SensorLogCsv, columnsOfTheContractInAnyOrder)
{
    const auto log = read("# a log\nbz_nT,time_s,by_nT,bx_nT,heading_deg,roll_deg,pitch_deg,current_A:landing light,temperature_c\n"
                          "3,0,2,1,10,11,12,0.5,20\n6,0.1,5,4,20,21,22,0.6,21\n");
    ASSERT_TRUE(log) << describe(log.error());
    EXPECT_EQ(log->size(), 2u);
    EXPECT_EQ(log->at(1), Eigen::Vector3d(4, 5, 6));
    EXPECT_EQ(log->time_s, (std::vector<double>{0, 0.1}));
    EXPECT_EQ(log->heading_deg[0], 10);
    EXPECT_EQ(log->pitch_deg[0], 12);
    EXPECT_EQ(log->roll_deg[0], 11);
    ASSERT_EQ(log->currents.size(), 1u);
    EXPECT_EQ(log->currents[0].name, "landing light");
    EXPECT_EQ(log->currents[0].values[1], 0.6);
    ASSERT_EQ(log->others.size(), 1u);
    EXPECT_EQ(log->others[0].name, "temperature_c");
    EXPECT_EQ(log->unit, FieldUnit::Nanotesla);
}

TEST(SensorLogCsv, unitsBecomeNanotesla)
{
    EXPECT_EQ(read("bx_uT,by_uT,bz_uT\n20,30,-40\n")->at(0), Eigen::Vector3d(20000, 30000, -40000));
    EXPECT_EQ(read("bx_mG,by_mG,bz_mG\n200,300,-400\n")->at(0), Eigen::Vector3d(20000, 30000, -40000));
    EXPECT_EQ(read("bx_G,by_G,bz_G\n0.25,0.5,-0.25\n")->at(0), Eigen::Vector3d(25000, 50000, -25000));
}

TEST(SensorLogCsv, withoutAUnitCountsStayCounts)
{
    const auto log = read("bx,by,bz\n20.5,30.5,-10.5\n");
    EXPECT_EQ(log->unit, FieldUnit::Counts);
    EXPECT_EQ(log->at(0), Eigen::Vector3d(20.5, 30.5, -10.5));
    EXPECT_THAT(warned(*log), HasSubstr("would fit uT"));
    EXPECT_EQ(read("bx,by,bz\n20.5,30.5,-10.5\n", {.unit = FieldUnit::Microtesla})->at(0).x(), 20500);
}

/// Phones: the names of their loggers, and the unit by the size of the field where nothing says it.
TEST(SensorLogCsv, logsOfPhones)
{
    const auto phyphox = read(
        "\"Time (s)\",\"Magnetic field x (\u00B5T)\",\"Magnetic field y (\u00B5T)\",\"Magnetic field z (\u00B5T)\",\"Absolute field (\u00B5T)\"\n"
        "1.5E-2,2.05E1,-3.0E1,1.0E1,3.7E1\n");
    ASSERT_TRUE(phyphox) << describe(phyphox.error());
    EXPECT_EQ(phyphox->unit, FieldUnit::Microtesla);
    EXPECT_NEAR(phyphox->at(0).x(), 20500, 1e-9);
    EXPECT_NEAR(phyphox->time_s[0], 0.015, 1e-15);
    const auto logger = read("seconds_elapsed,z,y,x\n0.1,10.25,-30.5,20.5\n");
    EXPECT_EQ(logger->unit, FieldUnit::Microtesla);
    EXPECT_THAT(logger->unitReason.english(), HasSubstr("the field's size, 38.2"));
    EXPECT_NEAR(logger->at(0).z(), 10250, 1e-9);
    EXPECT_EQ(read("time_ms,mag_x,mag_y,mag_z\n500,301,-402,103\n")->time_s[0], 0.5);
    const auto android = read("MAGNETIC FIELD X (\u03BCT);MAGNETIC FIELD Y (\u03BCT);MAGNETIC FIELD Z (\u03BCT);Time since start in ms\n"
                              "20.5;-30.5;10.25;1500\n");
    ASSERT_TRUE(android) << describe(android.error());
    EXPECT_EQ(android->time_s[0], 1.5);
    EXPECT_EQ(
        read("Zeit (s);Magnetfeld x (\u00B5T);Magnetfeld y (\u00B5T);Magnetfeld z (\u00B5T)\n0,25;20,5;-30,5;10,25\n")->time_s[0], 0.25);
    EXPECT_EQ(read("mx,my,mz\n301,-402,103\n")->unit, FieldUnit::Counts) << "whole figures are counts";
}

TEST(SensorLogCsv, threeNumbersARowAndNoHeader)
{
    const auto log = read("-116.25 -82.5   420.75\n  -100 2 3\n");
    ASSERT_TRUE(log) << describe(log.error());
    EXPECT_EQ(log->size(), 2u);
    EXPECT_EQ(log->unit, FieldUnit::Milligauss);
    EXPECT_NEAR(log->at(0).z(), 42075, 1e-9);
    EXPECT_THAT(warned(*log), HasSubstr("no header"));
    EXPECT_EQ(read("0\t1\t2\t3\n1\t4\t5\t6\n")->time_s.size(), 2u);
    EXPECT_THAT(refusal("1,2\n3,4\n"), HasSubstr("2 numbers a row"));
}

TEST(SensorLogCsv, semicolonsAndDecimalCommas)
{
    const auto log = read("\xEF\xBB\xBFsep=;\r\nbx_nT;by_nT;bz_nT\r\n1,5;2,5;\"3,5\"\r\n");
    ASSERT_TRUE(log) << describe(log.error());
    EXPECT_EQ(log->at(0), Eigen::Vector3d(1.5, 2.5, 3.5));
}

TEST(SensorLogCsv, emptyAndNaNCellsAreCounted)
{
    const auto log = read("time_s,bx_nT,by_nT,bz_nT\n0,1,,3\n1,nan,2,3\n2,1,2\n3,1,2,x\n4,1,2,3\n");
    ASSERT_TRUE(log) << describe(log.error());
    EXPECT_EQ(log->counts.emptyCells, 1);
    EXPECT_EQ(log->counts.nanCells, 1);
    EXPECT_EQ(log->counts.shortRows, 1);
    EXPECT_EQ(log->counts.badCells, 1);
    EXPECT_FALSE(log->hasField(0));
    EXPECT_TRUE(log->hasField(4));
    EXPECT_THAT(warned(*log), HasSubstr("line 5: \"x\" in column \"bz_nT\""));
}

TEST(SensorLogCsv, whatIsRefused)
{
    EXPECT_THAT(refusal("time_s,bx_nT,by_nT,bz_nT\n0,1,2,3\n1,1,2,3\n0.5,1,2,3\n"), HasSubstr("log.csv:4: time goes back, from 1 to 0.5"));
    EXPECT_THAT(refusal("bx_nT,by_uT,bz_nT\n1,2,3\n"), HasSubstr("in different units"));
    EXPECT_THAT(refusal("bx_nT,by_nT\n1,2\n"), HasSubstr("has no column bz"));
    EXPECT_THAT(refusal("bx_nT,bx_nT,by_nT,bz_nT\n1,1,2,3\n"), HasSubstr("two columns are bx"));
    EXPECT_THAT(refusal("bx_nT,by_nT,bz_nT\n"), HasSubstr("holds no samples"));
    EXPECT_THAT(refusal(""), HasSubstr("is empty"));
    std::string words = "bx_nT,by_nT,bz_nT\n";
    for (int i = 0; i < 200; ++i)
        words += "a,b,c\n";
    EXPECT_THAT(refusal(words), HasSubstr("is no number, as more than 100 cells before it"));
    EXPECT_THAT(refusal(std::string("bx_nT\0by", 8)), HasSubstr("binary"));
}

/// A phone's logger writes its clock in nanoseconds under the name "time", and the seconds beside it.
TEST(SensorLogCsv, timeThatNamesNoUnit)
{
    const auto phone = read("time,seconds_elapsed,z,y,x\n1700000000000000000,0.0,40,3,20\n1700000000020000000,0.02,41,3,20\n"
                            "1700000000040000000,0.04,42,3,20\n");
    ASSERT_TRUE(phone) << describe(phone.error());
    EXPECT_NEAR(phone->time_s[0], 0, 1e-9);
    EXPECT_NEAR(phone->time_s[2], 0.04, 1e-6);
    EXPECT_EQ(phone->at(0), Eigen::Vector3d(20, 3, 40)); // by name of its axes: x, y, z
    EXPECT_THAT(warned(*phone), HasSubstr("taken for ns, counted from the first row"));
    const auto micro = read("timestamp,mx,my,mz\n5000000,20.5,3,40\n5010000,20,3,41\n5020000,20,3,42\n");
    ASSERT_TRUE(micro);
    EXPECT_NEAR(micro->time_s[1], 5.01, 1e-9);
    EXPECT_THAT(warned(*micro), HasSubstr("taken for us"));
    const auto clock = read("timestamp,mx,my,mz\n1700000000000,20.5,3,40\n1700000000020,20,3,41\n");
    ASSERT_TRUE(clock);
    EXPECT_NEAR(clock->time_s[1], 0.02, 1e-9);
    const auto slow = read("time,mx,my,mz\n0,20.5,3,40\n10,20,3,41\n20,20,3,42\n"); // a row in ten seconds is a log, too
    ASSERT_TRUE(slow);
    EXPECT_EQ(slow->time_s[1], 10);
    EXPECT_THAT(warned(*slow), testing::Not(HasSubstr("time column")));
}

TEST(SensorLogCsv, columnsByChoice)
{
    const std::string text = "Feld A,Feld B,Feld C\n1,2,3\n";
    EXPECT_THAT(refusal(text), HasSubstr("has no column bx"));
    const auto log = read(text, {.columns = {{"bx", "Feld B"}, {"by", "Feld A"}, {"bz", "Feld C"}}});
    ASSERT_TRUE(log) << describe(log.error());
    EXPECT_EQ(log->at(0), Eigen::Vector3d(2, 1, 3));
    EXPECT_THAT(refusal(text, {.columns = {{"bx", "Feld D"}}}), HasSubstr("there is no column \"Feld D\""));
    std::istringstream input("time_s,bx_nT,by_nT,bz_nT,note\n");
    const auto header = readSensorLogHeader(input, "log.csv");
    ASSERT_TRUE(header);
    EXPECT_EQ(header->recognised.at("bx"), "bx_nT");
    EXPECT_EQ(header->columns.size(), 5u);
}

} // namespace
} // namespace lubberline::test
