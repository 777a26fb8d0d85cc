#include <gmock/gmock.h>

#include <map>
#include <set>

#include "tests/app/Program.h"

namespace lubberline::test {

TEST(DemoCommand, writesTheDatabaseTheReportAndThePlots)
{
    const Sandbox sandbox;
    const auto outcome = sandbox.run({"demo", "--db", "demo.db", "-o", "out"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    for (const char* file : {"swing-report.pdf", "correction-card.pdf", "swing-polar.png", "swing-curve.svg", "swing-spectrum.png"}) {
        EXPECT_THAT(outcome.out, testing::HasSubstr(file));
        EXPECT_GT(sandbox.read(std::string("out/") + file).size(), 1000u) << file;
    }
    EXPECT_THAT(outcome.err, testing::HasSubstr("no display"));
}

/// Offscreen and minimal are no display: the window would be seen by nobody, and the command would wait for it for ever.
TEST(DemoCommand, aPlatformThatNobodySeesIsNoDisplay)
{
    for (const char* platform : {"offscreen", "minimal", "offscreen:size=800x600", "xcb"}) {
        const Sandbox sandbox;
        const auto outcome
            = sandbox.run({"demo", "--db", "demo.db", "-o", "out"}, std::string("QT_QPA_PLATFORM='") + platform + "' timeout 60");
        ASSERT_EQ(outcome.status, 0) << platform << ": " << outcome.err;
        EXPECT_THAT(outcome.err, testing::HasSubstr("no display")) << platform;
        const auto window = sandbox.run({"--db", "demo.db"}, std::string("QT_QPA_PLATFORM='") + platform + "' timeout 60");
        EXPECT_EQ(window.status, 1) << platform;
        EXPECT_THAT(window.err, testing::HasSubstr("no display")) << platform;
    }
}

TEST(DemoCommand, theFleetIsWorthLookingAt)
{
    const Sandbox sandbox;
    ASSERT_EQ(sandbox.run({"demo", "--db", "demo.db", "--no-window", "-o", "out"}).status, 0);
    std::set<std::string> types, aircraft, out, years;
    const auto listed = sandbox.run({"swings", "--db", "demo.db", "--json"}).json();
    for (const auto& swing : listed["swings"]) {
        types.insert(swing["type"]);
        aircraft.insert(swing["aircraft"]);
        years.insert(swing["date"].get<std::string>().substr(0, 4));
        if (swing["status"] == "out of limits")
            out.insert(swing["aircraft"]);
    }
    EXPECT_GE(types.size(), 3u);
    EXPECT_GE(aircraft.size(), 12u);
    EXPECT_GE(years.size(), 3u);
    EXPECT_GE(out.size(), 2u);
    EXPECT_LT(out.size(), aircraft.size() / 2);
}

TEST(DemoCommand, aSecondRunChangesNothing)
{
    const Sandbox sandbox;
    ASSERT_EQ(sandbox.run({"demo", "--db", "demo.db", "--no-window", "-o", "out"}).status, 0);
    const auto before = sandbox.run({"swings", "--db", "demo.db"}).out;
    ASSERT_EQ(sandbox.run({"demo", "--db", "demo.db", "--no-window", "-o", "out"}).status, 0);
    EXPECT_EQ(sandbox.run({"swings", "--db", "demo.db"}).out, before);
}

} // namespace lubberline::test
