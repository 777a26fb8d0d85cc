// Tables of many swings by command: told from a file of one swing, mapped columns, all or nothing.

#include <gmock/gmock.h>

#include "tests/app/Program.h"

namespace lubberline::test {

using testing::HasSubstr;

TEST(YearsCommand, aTableIsToldByItsColumnsAndStored)
{
    const Sandbox sandbox;
    sandbox.write("years.csv",
        "type,aircraft,compass,date,stage,0,90,180,270\nSu-22,3201,standby,2019-05-01,as_found,1,2,-1,-2\n"
        "Su-22,3202,standby,2019-05-02,as_found,1,2,-1,-2\n");
    const auto unsaid = sandbox.run({"import", "years.csv", "--db", "a.db"});
    EXPECT_EQ(unsaid.status, 1);
    EXPECT_THAT(unsaid.err, HasSubstr("years.csv:1: headings are columns (0"));
    EXPECT_FALSE(std::filesystem::exists(sandbox.path("a.db"))); // nothing is made for what cannot be stored
    const auto stored = sandbox.run({"import", "years.csv", "--cells", "deviation", "--db", "a.db"});
    ASSERT_EQ(stored.status, 0) << stored.err;
    EXPECT_THAT(stored.err, HasSubstr("stored 2 new swings with 8 readings, of 2 new aircraft and 2 new compass systems"));
    EXPECT_THAT(sandbox.run({"import", "years.csv", "--cells", "deviation", "--db", "a.db"}).err, HasSubstr("there already: 2 swings"));
    EXPECT_EQ(sandbox.run({"fleet", "--db", "a.db", "--json"}).json()["selection"]["used"], 2);
}

TEST(YearsCommand, columnsAreMappedAndAllFilesOrNoneAreStored)
{
    const Sandbox sandbox;
    const std::string head = "Nr;Data;KK;KM\n";
    sandbox.write("a.csv", head + "3201;1.5.2019;0,5;359,5\n3201;1.5.2019;90;91\n3201;1.5.2019;180;181\n3201;1.5.2019;270;269\n");
    sandbox.write("b.csv", head + "3202;1.5.2019;0;359\n3202;32.5.2019;90;91\n");
    std::vector<std::string> arguments{"import", "a.csv", "b.csv", "--column", "aircraft=Nr", "--column", "date=Data", "--column",
        "magnetic_heading_deg=KM", "--column", "compass_heading_deg=KK", "--set", "stage=as_found", "--type", "Su-22", "--dates", "dmy",
        "--db", "a.db"};
    const auto broken = sandbox.run(arguments);
    EXPECT_EQ(broken.status, 1);
    EXPECT_THAT(broken.err, HasSubstr("b.csv:3: date: \"32.5.2019\" is no day; expected day, month and year"));
    EXPECT_FALSE(std::filesystem::exists(sandbox.path("a.db")));
    arguments.erase(arguments.begin() + 2);
    ASSERT_EQ(sandbox.run(arguments).status, 0);
    const auto swing = sandbox.run({"swings", "--db", "a.db", "--json"}).json()["swings"].at(0);
    EXPECT_EQ(swing["date"], "2019-05-01");
    EXPECT_EQ(sandbox.run({"import", "a.csv", "--column", "aircraft", "--db", "a.db"}).status, 1);
    EXPECT_EQ(sandbox.run({"import", "a.csv", "--cells", "needle", "--db", "a.db"}).status, 2);
}

} // namespace lubberline::test
