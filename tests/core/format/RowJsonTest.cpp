// What rows of the database and lines of the recovery file keep as JSON: the bytes of earlier versions are written and read.

#include <algorithm>

#include <gtest/gtest.h>

#include "core/format/exchange/LostJson.h"
#include "core/format/exchange/RowJson.h"

namespace lubberline {
namespace {

TEST(RowJson, writesTheBytesThatRowsHaveAlwaysHad)
{
    const ExtraColumns extra{{"wind", "calm"}, {"", "7 \"kt\"\n\xC5\xBC"}};
    EXPECT_EQ(writeExtraRow({}), "[]");
    EXPECT_EQ(writeExtraRow(extra), "[[\"wind\",\"calm\"],[\"\",\"7 \\\"kt\\\"\\n\xC5\xBC\"]]");
    EXPECT_EQ(*readExtraRow(writeExtraRow(extra)), extra);

    const RawFigures raw{{317, 316.5, 317}, {}, {0.1 + 0.2}};
    EXPECT_EQ(writeRawRow({}), "");
    EXPECT_EQ(writeRawRow(raw), "[[317,316.5,317],[],[0.30000000000000004]]");
    EXPECT_EQ(*readRawRow(writeRawRow(raw)), raw);
    EXPECT_TRUE(readRawRow("")->empty());

    const BenchStates states{{"gear", "extended"}, {"hook", "stowed"}};
    EXPECT_EQ(writeStatesRow({}), "{}");
    EXPECT_EQ(writeStatesRow(states), R"({"gear":"extended","hook":"stowed"})");
    EXPECT_EQ(*readStatesRow(writeStatesRow(states)), states);
}

TEST(RowJson, whatDoesNotReadIsRefused)
{
    for (const char* text : {"", "[", "{}", "7", "[[\"a\"]]", "[[\"a\",1]]", "[\"a\",\"b\"]", "[[\"a\",\"b\",\"c\"]]"})
        EXPECT_FALSE(readExtraRow(text)) << text;
    for (const char* text : {"[", "{}", "[]", "[[1],[2]]", "[[1],[2],[3],[4]]", "[[1],[2],[\"x\"]]", "[1,2,3]", "[[1],[2],[null]]"})
        EXPECT_FALSE(readRawRow(text)) << text;
    for (const char* text : {"", "[]", "{\"gear\":1}", "{\"gear\":\"up\",\"gear\":\"down\"}"})
        EXPECT_FALSE(readStatesRow(text)) << text;
}

LostEntry entry(std::variant<LostStep, LostReading> what)
{
    return {"/a b/fleet.lubberline", SwingId{7}, "0e2d1d4c-6f0b-4a5e-9d5b-0b8f4a1c2d3e", "3713, \"standby\"", std::move(what)};
}

TEST(LostJson, isOneLineThatReadsBack)
{
    LostReading reading{2, {}};
    reading.reading.nominal_deg = 90;
    reading.reading.compass = CompassHeading::fromDegrees(92.5);
    reading.reading.note = "typed while\nthe drive was full";
    reading.reading.exclusion = Exclusion{"misread"};
    reading.reading.raw = {{90, 91}, {}, {}};
    reading.reading.extra = {{"wind", "calm"}};
    LostReading replacing = reading;
    replacing.id = ReadingId{12};
    replacing.before = Reading();
    replacing.before->compass = CompassHeading::fromDegrees(91);
    LostEntry dated = entry(replacing);
    dated.file = "0e2d1d4c-6f0b-4a5e-9d5b-0b8f4a1c2d3f";
    dated.timeUtc = "2026-11-23T09:00:00Z";
    for (const LostEntry& lost : {entry(reading), dated, entry(LostStep{3, {"2026-11-23T09:00:00Z", job::Ticked{"tools"}}})}) {
        const std::string line = writeLostEntry(lost);
        EXPECT_EQ(std::count(line.begin(), line.end(), '\n'), 1);
        const auto back = readLostEntry(line);
        ASSERT_TRUE(back) << describe(back.error());
        EXPECT_EQ(*back, lost);
        for (std::size_t cut = 0; cut + 2 < line.size(); ++cut)
            EXPECT_FALSE(readLostEntry(line.substr(0, cut))) << cut;
    }
}

TEST(LostJson, linesOfEarlierVersionsRead)
{
    const auto reading = readLostEntry(
        R"({"database":"/f.lubberline","reading":{"compass_heading_deg":92.5,"magnetic_heading_deg":90,"note":"","roll_deg":-2},)"
        R"("record":"0e2d1d4c-6f0b-4a5e-9d5b-0b8f4a1c2d3e","row":2,"subject":"3713","swing":7})");
    ASSERT_TRUE(reading) << describe(reading.error());
    const auto& lost = std::get<LostReading>(reading->what);
    EXPECT_EQ(lost.row, 2);
    EXPECT_EQ(lost.reading.compass->degrees(), 92.5);
    EXPECT_EQ(lost.reading.magnetic->degrees(), 90);
    EXPECT_EQ(lost.reading.roll_deg, -2);
    const auto step
        = readLostEntry(R"({"database":"/f.lubberline","event":"{\"time_utc\": \"2026-11-23T09:00:00Z\", \"what\": \"ticked\", )"
                        R"(\"item\": \"tools\", \"done\": true}","place":4,"record":"","subject":"","swing":7})");
    ASSERT_TRUE(step) << describe(step.error());
    EXPECT_EQ(std::get<LostStep>(step->what).place, 4u);
}

} // namespace
} // namespace lubberline
