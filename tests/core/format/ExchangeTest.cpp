#include <gmock/gmock.h>

#include <algorithm>

#include <nlohmann/json.hpp>

#include "core/demo/DemoFleet.h"
#include "core/format/exchange/Exchange.h"
#include "tests/core/format/Support.h"

namespace lubberline::test {

namespace {

Fleet wholeFleet()
{
    Fleet fleet = toFleet(wholeRecord());
    Event event;
    event.id = EventId{1};
    event.record = "77777777-7777-4777-8777-777777777777";
    event.aircraft = AircraftId{1};
    event.date = "2025-07-01";
    event.kind = "lightning";
    event.note = "nose";
    fleet.events = {event};
    return fleet;
}

Result<Fleet> read(const std::string& text) { return readExchange(text, "fleet.lubberline.json"); }

} // namespace

TEST(Exchange, everyFieldComesBack)
{
    const Fleet fleet = wholeFleet();
    const auto back = read(writeExchange(fleet));
    ASSERT_TRUE(back) << describe(back.error());
    EXPECT_EQ(*back, fleet);
}

TEST(Exchange, aSecondRoundIsByteForByteTheSame)
{
    for (const Fleet& fleet : {wholeFleet(), demoFleet(), Fleet{}}) {
        const std::string first = writeExchange(fleet);
        const auto back = read(first);
        ASSERT_TRUE(back) << describe(back.error());
        EXPECT_EQ(writeExchange(*back), first);
        EXPECT_EQ(*read(writeExchange(*back)), *back);
    }
}

TEST(Exchange, theOrderInMemoryLeavesNoTrace)
{
    const Fleet fleet = demoFleet();
    Fleet turned = fleet;
    std::reverse(turned.swings.begin(), turned.swings.end());
    std::reverse(turned.compasses.begin(), turned.compasses.end());
    std::reverse(turned.aircraft.begin(), turned.aircraft.end());
    std::reverse(turned.types.begin(), turned.types.end());
    std::reverse(turned.sites.begin(), turned.sites.end());
    std::reverse(turned.limits.begin(), turned.limits.end());
    std::reverse(turned.events.begin(), turned.events.end());
    EXPECT_EQ(writeExchange(turned), writeExchange(fleet));
}

TEST(Exchange, nothingOfTheDemonstrationFleetIsLost)
{
    const Fleet fleet = demoFleet();
    const auto back = read(writeExchange(fleet));
    ASSERT_TRUE(back);
    ASSERT_EQ(back->swings.size(), fleet.swings.size());
    EXPECT_EQ(back->events.size(), fleet.events.size());
    for (const Swing& swing : fleet.swings) {
        const auto same
            = std::find_if(back->swings.begin(), back->swings.end(), [&](const Swing& one) { return one.record == swing.record; });
        ASSERT_NE(same, back->swings.end());
        EXPECT_EQ(same->readings, swing.readings);
        const auto& compass = back->compasses[static_cast<std::size_t>(same->compass.value) - 1];
        EXPECT_EQ(compass.record, fleet.compasses[static_cast<std::size_t>(swing.compass.value) - 1].record);
    }
}

TEST(Exchange, hasKeysInAFixedOrderAndLeavesOutWhatIsNotStated)
{
    SwingRecord record;
    record.aircraft.registration = "SP-TST";
    Reading reading;
    reading.magnetic = MagneticHeading::fromDegrees(359);
    reading.compass = CompassHeading::fromDegrees(2.5);
    record.swing.readings = {reading, Reading{}};
    const std::string text = writeExchange(toFleet(record));
    EXPECT_THAT(text,
        testing::StartsWith(
            "{\n  \"format\": \"lubberline\",\n  \"version\": 1,\n  \"limits\": [],\n  \"sites\": [],\n  \"types\": [\n    {\n      \"record\": \""));
    EXPECT_THAT(text, testing::HasSubstr("{\"magnetic_heading_deg\": 359, \"compass_heading_deg\": 2.5},\n"));
    EXPECT_THAT(text, testing::HasSubstr("{}\n")); // a row that is laid out and not read yet
    EXPECT_THAT(text, testing::EndsWith("}\n"));
    EXPECT_EQ(text.find("note"), std::string::npos);
    EXPECT_EQ(text.find("null"), std::string::npos);
    EXPECT_TRUE(nlohmann::json::accept(text));
}

TEST(Exchange, textOfAnyKindComesBack)
{
    SwingRecord record = wholeRecord();
    record.swing.note = "tab\t quote \" backslash \\ newline \n control \x01 compass \U0001F9ED";
    const auto back = read(writeExchange(toFleet(record)));
    ASSERT_TRUE(back) << describe(back.error());
    EXPECT_EQ(back->swings[0].note, record.swing.note);
}

TEST(Exchange, textThatIsNoUtf8IsMendedNotWritten)
{
    SwingRecord record = wholeRecord();
    record.swing.note = "3\xB0";
    const auto back = read(writeExchange(toFleet(record)));
    ASSERT_TRUE(back) << describe(back.error());
    EXPECT_EQ(back->swings[0].note, "3\uFFFD");
}

TEST(Exchange, aPartOfAFleetIsEnough)
{
    const auto empty = read(R"({"format": "lubberline", "version": 1})");
    ASSERT_TRUE(empty) << describe(empty.error());
    EXPECT_EQ(*empty, Fleet{});
    const auto sites = read(
        "\xEF\xBB\xBF"
        R"({"format": "lubberline", "version": 1, "sites": [{"record": "44444444-4444-4444-8444-444444444444", "name": "Mielec"}]})");
    ASSERT_TRUE(sites) << describe(sites.error());
    EXPECT_EQ(sites->sites.at(0).name, "Mielec");
}

} // namespace lubberline::test
