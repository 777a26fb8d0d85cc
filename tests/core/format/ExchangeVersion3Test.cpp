// Version 3 of the exchange file: guided swings, signatures, bases, rules: everything reads back equal, is written again the same, and damage is named by
// its path.

#include <gmock/gmock.h>

#include "core/format/exchange/Exchange.h"
#include "core/format/exchange/SignedContent.h"
#include "core/record/SwingDifferences.h"

namespace lubberline {
namespace {

Swing signedSwing()
{
    Swing swing;
    swing.date = "2026-11-23";
    swing.datum = {"B-16", "117", "2027-01-01", "from ahead: reciprocal"};
    swing.startUtc = "2026-11-23T09:00:00Z";
    swing.endUtc = "2026-11-23T10:15:00Z";
    swing.siteOverride = "certificate expired: only base that is open";
    swing.weather = "8 kt, −4 °C, K 2";
    swing.supersedes = newRecordId();
    swing.amendment = "the wrong date";
    swing.revision = 2;
    swing.signatures = {{SignatureRole::Performer, "Ada", "PL 12", "2026-11-23T11:00:00Z", std::string(64, 'a')}};
    for (const double heading : {0.0, 90.0, 180.0, 270.0}) {
        Reading reading;
        reading.magnetic = MagneticHeading::fromDegrees(heading);
        reading.compass = CompassHeading::fromDegrees(heading + 1);
        reading.raw = {{heading, heading + 0.5}, {wrap360(heading + 180)}, {heading + 1}};
        reading.timeUtc = "2026-11-23T09:05:00Z";
        swing.readings.push_back(reading);
    }
    return swing;
}

Fleet fullFleet()
{
    SwingRecord record;
    record.swing = signedSwing();
    record.type.name = "Su-22";
    record.aircraft.registration = "3713";
    record.compass.name = "standby";
    record.site.emplace();
    record.site->name = "Rose 2";
    record.site->siteClass = SiteClass::Class2;
    record.site->certificateExpiry = "2026-11-22";
    record.site->paintedVariation_deg = 5.5;
    record.site->survey = {{0, 0, 1.5, 6.2, 49500.0}, {10, -5, 1.5, {}, 49504.0}};
    Fleet fleet = toFleet(record);
    fleet.aircraft.front().base = fleet.sites.front().id;
    fleet.compasses.front().installed = "2020-02-29";
    Event event;
    event.id = EventId{1};
    event.record = newRecordId();
    event.aircraft = fleet.aircraft.front().id;
    event.date = "2026-10-01";
    event.kind = "lightning";
    event.cause = DueCause::Lightning;
    fleet.events = {event};
    fleet.waivers = {{newRecordId(), event.record, "2026-10-02", "two headings 90 degrees apart show no change", "Dora"}};
    SwingJob job;
    job.record = newRecordId();
    job.plan = {ProcedureKind::HalfError, 12, {"radio on"}};
    job.checklist = {"tools"};
    job.datum.name = "B-16";
    job.datum.ahead = SightingDirection::Reciprocal;
    job.events = {{"2026-11-23T09:00:00Z", job::Ticked{"tools"}}, {"2026-11-23T09:00:05Z", job::Prepared{}}};
    fleet.jobs = {{fleet.swings.front().id, job}};
    ElectricalSwing electrical;
    electrical.record = newRecordId();
    electrical.E1 = {1.25, -1.27};
    electrical.before.indicated_deg = {0.5, 89.0, 180.6, 269.3};
    electrical.headings = {{0, 0.1}, {15, {}}};
    fleet.electrical = {{fleet.compasses.front().id, electrical}};
    DatumInstrument instrument;
    instrument.record = newRecordId();
    instrument.name = "theodolite 3";
    instrument.kind = DatumKind::Theodolite;
    instrument.zero_deg = -12.5;
    fleet.instruments = {instrument};
    fleet.dueRules = {{newRecordId(), "two years", 24, 10, 60, "AWB 34-008", "3", fleet.types.front().record}};
    return fleet;
}

TEST(ExchangeVersion3, readsBackEqualAndIsWrittenTheSame)
{
    const Fleet fleet = fullFleet();
    EXPECT_EQ(exchangeVersionOf(fleet), 3);
    const std::string text = writeExchange(fleet);
    const auto again = readExchange(text, "ramp.json");
    ASSERT_TRUE(again) << again.error().message.english();
    EXPECT_EQ(*again, fleet);
    EXPECT_EQ(writeExchange(*again), text);
}

TEST(ExchangeVersion3, errorsThatReadingsShareAreOfVersionSix)
{
    Fleet fleet = fullFleet();
    fleet.swings.front().sharedErrors.of_deg = {0.6, 0, 0.125, 0, 0};
    EXPECT_EQ(exchangeVersionOf(fleet), 6);
    const std::string text = writeExchange(fleet);
    EXPECT_THAT(text, testing::HasSubstr("\"shared_error_deg\": [0.6, 0, 0.125, 0, 0]"));
    EXPECT_EQ(*readExchange(text, "ramp.json"), fleet);
    std::string wrong = text;
    wrong.replace(wrong.find("[0.6,"), 5, "[-1, ");
    EXPECT_FALSE(readExchange(wrong, "ramp.json"));
}

TEST(ExchangeVersion3, howSureASensorModelIsIsOfVersionSeven)
{
    Fleet fleet = fullFleet();
    SensorRecord sensor;
    sensor.id = SensorModelId{1};
    sensor.record = newRecordId();
    sensor.compass = fleet.compasses.front().id;
    sensor.name = "calibrated";
    sensor.uncertainty.emplace();
    sensor.uncertainty->covariance.diagonal().setConstant(0.25);
    sensor.uncertainty->covariance(0, 11) = sensor.uncertainty->covariance(11, 0) = 0.125;
    fleet.sensors = {sensor};
    EXPECT_EQ(exchangeVersionOf(fleet), 7);
    const std::string text = writeExchange(fleet);
    const auto back = readExchange(text, "ramp.json");
    ASSERT_TRUE(back) << back.error().message.english();
    EXPECT_EQ(back->sensors.front().uncertainty, sensor.uncertainty);
    EXPECT_EQ(writeExchange(*back), text);
    fleet.sensors.front().uncertainty.reset();
    EXPECT_LT(exchangeVersionOf(fleet), 7);
}

TEST(ExchangeVersion3, coilBenchesAreOfVersionEight)
{
    Fleet fleet = fullFleet();
    CoilBench bench;
    bench.record = newRecordId();
    bench.date = "2026-05-01";
    bench.serialNumber = "S 12";
    bench.log = "bench.csv";
    for (int i = 0; i < 9; ++i) {
        bench.readings.push_back({1000.0 * i, -0.5 * i, 0, 1001.25 * i, 3, -4});
        bench.temperature_c.push_back(20 + 0.125 * i);
    }
    CoilBench counts = bench;
    counts.record = newRecordId();
    counts.inCounts = true;
    counts.temperature_c.clear();
    const CompassId compass = fleet.compasses.front().id;
    fleet.coilBenches = {{compass, bench}, {compass, counts}};
    std::sort(fleet.coilBenches.begin(), fleet.coilBenches.end(),
        [](const auto& one, const auto& other) { return one.bench.record < other.bench.record; });
    EXPECT_EQ(exchangeVersionOf(fleet), 8);
    const std::string text = writeExchange(fleet);
    const auto back = readExchange(text, "ramp.json");
    ASSERT_TRUE(back) << back.error().message.english();
    EXPECT_EQ(*back, fleet);
    EXPECT_EQ(writeExchange(*back), text);
    for (const auto& [good, bad] :
        {std::pair{"\"count\": 9", "\"count\": 8"}, {"\"count\": 9", "\"count\": 100000000"}, {"\"date\": \"2026-05-01\",\n", ""}}) {
        std::string wrong = text;
        const auto at = wrong.find("coil_benches");
        wrong.replace(wrong.find(good, at), std::string(good).size(), bad);
        EXPECT_FALSE(readExchange(wrong, "ramp.json")) << bad;
    }
}

TEST(ExchangeVersion3, aFleetWithoutItStaysInTheOlderVersion)
{
    Fleet fleet = fullFleet();
    fleet.jobs.clear();
    fleet.electrical.clear();
    fleet.waivers.clear();
    fleet.instruments.clear();
    fleet.dueRules.clear();
    fleet.events.clear();
    fleet.sites.clear();
    fleet.aircraft.front().base = {};
    fleet.compasses.front().installed = {};
    Swing& swing = fleet.swings.front();
    Swing plain;
    plain.id = swing.id;
    plain.record = swing.record;
    plain.compass = swing.compass;
    plain.date = swing.date;
    swing = plain;
    EXPECT_EQ(exchangeVersionOf(fleet), 1);
    EXPECT_EQ(writeExchange(fleet).find("revision"), std::string::npos);
}

TEST(ExchangeVersion3, damageIsNamedByItsPath)
{
    const std::string text = writeExchange(fullFleet());
    const auto refused = [&](const std::string& from, const std::string& to) {
        std::string damaged = text;
        const auto at = damaged.find(from);
        EXPECT_NE(at, std::string::npos) << from;
        const auto fleet = readExchange(damaged.replace(at, from.size(), to), "ramp.json");
        return fleet ? std::string("it was read") : fleet.error().message.english();
    };
    EXPECT_THAT(refused("\"performer\"", "\"pilot\""), testing::HasSubstr("performer, inspector or authority"));
    EXPECT_THAT(refused("aaaaaaaa", "AAAAAAAA"), testing::HasSubstr("SHA-256"));
    EXPECT_THAT(refused("\"2026-11-23T09:05:00Z\"", "\"half past nine\""),
        testing::AllOf(testing::HasSubstr("time_utc"), testing::HasSubstr("is no moment")));
    EXPECT_THAT(refused("\"start_utc\": \"2026-11-23T09:00:00Z\"", "\"start_utc\": \"2026-11-23\""), testing::HasSubstr("start_utc"));
    EXPECT_THAT(refused("\"lightning\",\n          \"cause\": \"lightning\"", "\"lightning\",\n          \"cause\": \"thunder\""),
        testing::HasSubstr("cause"));
    EXPECT_THAT(refused("\"half_error\"", "\"whole_error\""), testing::HasSubstr("procedure"));
    EXPECT_THAT(refused("\"selected_deg\": 90", "\"selected_deg\": 91"), testing::HasSubstr("0, 90, 180 and 270"));
    EXPECT_THAT(refused("\"class_2\"", "\"class_9\""), testing::HasSubstr("class_1"));
    EXPECT_THAT(refused("\"months\": 24", "\"months\": 0"), testing::HasSubstr("months"));
    EXPECT_THAT(refused("\"revision\": 2", "\"revision\": 0"), testing::HasSubstr("revision"));
}

TEST(SignedContent, isWhatWasReadAndNotWhatItIsCalled)
{
    SwingRecord record;
    record.swing = signedSwing();
    record.swing.record = newRecordId();
    record.type.record = newRecordId();
    record.aircraft.record = newRecordId();
    record.compass.record = newRecordId();
    const std::string content = signedContent(record, {});
    SwingRecord other = record;
    other.swing.state = SwingState::Complete;
    other.swing.signatures.clear();
    other.aircraft.registration = "renamed";
    EXPECT_EQ(signedContent(other, {}), content);
    other.swing.readings[0].compass = CompassHeading::fromDegrees(2);
    EXPECT_NE(signedContent(other, {}), content);
    EXPECT_NE(signedContent(record, SwingJob{newRecordId(), {}, {}, {}, {}, 1.0, {}}), content);
}

TEST(SignedContent, aVersionNamesItselfAndStandsInTheFile)
{
    SwingRecord record;
    record.swing = signedSwing();
    record.swing.record = newRecordId();
    record.swing.supersedes.clear();
    record.type.record = record.type.name = newRecordId();
    record.aircraft.record = record.aircraft.registration = newRecordId();
    record.compass.record = record.compass.name = newRecordId();
    EXPECT_TRUE(signedContent(record, {}, 1).starts_with("{"));
    EXPECT_EQ(signedContent(record, {}, 2), "lubberline signed content 2\n" + signedContent(record, {}, 1));
    record.swing.signatures.push_back(record.swing.signatures.front());
    record.swing.signatures.back().contents = 2;
    const Fleet fleet = toFleet(record);
    EXPECT_EQ(exchangeVersionOf(fleet), 4);
    const auto back = readExchange(writeExchange(fleet), "file");
    ASSERT_TRUE(back) << describe(back.error());
    EXPECT_EQ(back->swings.front().signatures, record.swing.signatures);
    std::string other = writeExchange(fleet);
    other.replace(other.find("\"contents\": 2"), 13, "\"contents\": 9");
    const auto refused = readExchange(other, "file");
    ASSERT_FALSE(refused);
    EXPECT_THAT(describe(refused.error()), testing::HasSubstr("contents"));
}

TEST(SwingDifferences, nameTheFieldAndBothValues)
{
    const Swing before = signedSwing();
    Swing after = before;
    EXPECT_TRUE(differencesBetween(before, after).empty());
    after.date = "2026-11-22";
    after.readings[2].compass = CompassHeading::fromDegrees(182.5);
    after.readings[3].exclusion = Exclusion{"misread"};
    after.readings.push_back(before.readings[0]);
    const auto all = differencesBetween(before, after);
    std::vector<std::string> said;
    for (const auto& one : all)
        said.push_back(one.what.english() + ": " + one.before.english() + " > " + one.after.english());
    said.resize(3);
    EXPECT_EQ(said,
        (std::vector<std::string>{"date: 2026-11-23 > 2026-11-22", "reading 3, compass: 181 > 182.5", "reading 4, excluded:  > misread"}));
    EXPECT_EQ(all[3].what.english(), "reading 5, magnetic");
    EXPECT_TRUE(all[3].before.empty());
}

} // namespace
} // namespace lubberline
