// Every kind of bad input: one clear error that names the file, the line where there is one, and what was expected; exit status
// 1; nothing changed.

#include <gmock/gmock.h>

#include <algorithm>

#include "tests/app/Program.h"
#include "tests/app/Published.h"

namespace lubberline::test {

namespace {

struct Damage {
    const char* name;
    std::string content;
    int line;         ///< named in the message; 0: none
    const char* says; ///< part of the message
};

void PrintTo(const Damage& damage, std::ostream* stream) // GoogleTest's name for it
{
    *stream << damage.name;
}

const std::string kRow = "0,358\n90,88\n180,181\n270,272\n";

const std::vector<Damage> kDamages = {
    {"empty", "", 0, "empty"},
    {"binary",
        std::string("\x7f"
                    "ELF\x02\x01\x00\x00\x00",
            9),
        0, "binary"},
    {"headerOnly", kHeader, 0, "reading"},
    {"missingColumn", "magnetic_heading_deg,note\n0,a\n", 1, "compass_heading_deg"},
    {"doubledColumn", "magnetic_heading_deg,compass_heading_deg,compass_heading_deg\n0,1,2\n", 1, "compass_heading_deg"},
    {"shortRow", kHeader + "0,358\n90\n180,181\n", 3, "2"},
    {"longRow", kHeader + "0,358\n90,88,7\n180,181\n", 3, "3"},
    {"letters", kHeader + "0,358\nninety,88\n180,181\n", 3, "ninety"},
    {"nan", kHeader + "0,358\nnan,88\n180,181\n", 3, "nan"},
    {"inf", kHeader + "0,358\n90,inf\n180,181\n", 3, "inf"},
    {"tooLargeNumber", kHeader + "0,358\n1e400,88\n180,181\n", 3, "1e400"},
    {"headingBelow", kHeader + "0,358\n-1,88\n180,181\n", 3, "-1"},
    {"headingAbove", kHeader + "0,358\n90,361\n180,181\n", 3, "361"},
    {"deviationAbove", "magnetic_heading_deg,deviation_deg\n0,1\n90,180.5\n180,2\n", 3, "180.5"},
    {"tooFew", kHeader + "0,358\n90,88\n", 0, "3"},
    {"oneHeading", kHeader + "45,44\n45,43\n45,44\n45,44\n", 0, "heading"},
    {"decimalCommaWithCommas", kHeader + "0,5,358\n90,5,88\n", 2, "cells"},
    {"utf16",
        std::string("\xff\xfe"
                    "m\0a\0",
            6),
        0, "UTF-16"},
    {"contradiction", "magnetic_heading_deg,compass_heading_deg,deviation_deg\n0,358,2\n90,88,-2\n180,181,-1\n", 3, "deviation"},
};

} // namespace

class BadFile : public testing::TestWithParam<Damage> {};

TEST_P(BadFile, isRefusedByEveryCommandWithOneClearError)
{
    const Sandbox sandbox;
    const auto& damage = GetParam();
    const auto file = sandbox.write("bad.csv", damage.content);
    for (const std::vector<std::string>& command : {std::vector<std::string>{"analyse", file, "--json"},
             {"card", file, "-o", sandbox.path("out.pdf")}, {"report", file, "-o", sandbox.path("out.pdf")}}) {
        const auto outcome = sandbox.run(command);
        EXPECT_EQ(outcome.status, 1) << command[0] << ": " << outcome.err;
        EXPECT_EQ(outcome.out, "");
        const std::string place = damage.line > 0 ? "bad.csv:" + std::to_string(damage.line) + ": " : "bad.csv";
        EXPECT_THAT(
            outcome.err, testing::AllOf(testing::StartsWith("lubberline: "), testing::HasSubstr(place), testing::HasSubstr(damage.says)));
        EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    }
    EXPECT_EQ(sandbox.files(), std::vector<std::string>{"bad.csv"});
}

INSTANTIATE_TEST_SUITE_P(Kinds, BadFile, testing::ValuesIn(kDamages), [](const auto& one) { return std::string(one.param.name); });

TEST(GoodFile, comesInManyForms)
{
    const Sandbox sandbox;
    const auto plain = sandbox.run({"analyse", sandbox.write("a.csv", kHeader + kRow), "--json"});
    ASSERT_EQ(plain.status, 0) << plain.err;
    const std::string crlf = "\xEF\xBB\xBFmagnetic_heading_deg,compass_heading_deg\r\n0,358\r\n90,88\r\n180,181\r\n270,272\r\n";
    EXPECT_EQ(sandbox.run({"analyse", sandbox.write("b.csv", crlf), "--json"}).out, plain.out);
    const std::string german = "compass_heading_deg;magnetic_heading_deg\n358,0;0,0\n88,0;90,0\n181;180\n272;270\n";
    EXPECT_EQ(sandbox.run({"analyse", sandbox.write("c.csv", german), "--json"}).out, plain.out);
    const std::string north = kHeader + "360,358\n90,88\n180,181\n270,272\n";
    EXPECT_EQ(sandbox.run({"analyse", sandbox.write("d.csv", north), "--json"}).out, plain.out);
    const std::string deviations = "magnetic_heading_deg\tdeviation_deg\n0\t2\n90\t2\n180\t-1\n270\t-2\n";
    EXPECT_EQ(sandbox.run({"analyse", sandbox.write("e.csv", deviations), "--json"}).out, plain.out);
    const std::string trueHeadings = "# variation_deg: 6\ntrue_heading_deg,compass_heading_deg\n6,358\n96,88\n186,181\n276,272\n";
    EXPECT_EQ(sandbox.run({"analyse", sandbox.write("f.csv", trueHeadings), "--json"}).out, plain.out);
}

TEST(GoodFile, theSameHeadingTwiceCountsTwice)
{
    const Sandbox sandbox;
    const auto outcome = sandbox.run({"analyse", sandbox.write("a.csv", kHeader + kRow + "0,356\n"), "--json"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.json()["readings"].size(), 5u);
}

TEST(MissingFile, isNamed)
{
    const Sandbox sandbox;
    const auto outcome = sandbox.run({"analyse", "nowhere.csv"});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.err, testing::HasSubstr("nowhere.csv"));
    EXPECT_EQ(sandbox.run({"analyse", sandbox.path("")}).status, 1); // a folder
}

TEST(Report, intoAFolderThatIsNotThereLeavesNothing)
{
    const Sandbox sandbox;
    const auto file = sandbox.write("a.csv", kHeader + kRow);
    const auto outcome = sandbox.run({"report", file, "-o", sandbox.path("none/out.pdf")});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.err, testing::HasSubstr("none"));
    const auto ending = sandbox.run({"report", file, "-o", sandbox.path("out.docx")});
    EXPECT_EQ(ending.status, 2);
    EXPECT_THAT(ending.err, testing::HasSubstr(".pdf"));
    EXPECT_EQ(sandbox.files(), std::vector<std::string>{"a.csv"});
}

} // namespace lubberline::test
