// Version 2 of the exchange file: sensor models and field stamps; and version 1 for all that has neither.

#include <gmock/gmock.h>

#include "core/format/exchange/Exchange.h"
#include "core/record/DerivedId.h"
#include "tests/core/format/Support.h"

namespace lubberline::test {

using testing::HasSubstr;

namespace {

Fleet fleetOfBoth()
{
    Fleet fleet = toFleet(wholeRecord());
    fleet.sensors = wholeSensors();
    fleet.swings[0].field = wholeStamp();
    fleet.swings[0].indexRemoved_deg = -2.5;
    return fleet;
}

Result<Fleet> read(const std::string& text) { return readExchange(text, "fleet.json"); }

std::string replaced(std::string text, const std::string& piece, const std::string& replacement)
{
    const auto place = text.find(piece);
    EXPECT_NE(place, std::string::npos) << piece;
    return place == std::string::npos ? text : text.replace(place, piece.size(), replacement);
}

struct Damage {
    const char* name;
    const char* piece;
    const char* replacement;
    ErrorCode code;
    std::vector<const char*> says;
};

constexpr auto kFormat = ErrorCode::Format;
constexpr auto kInvalid = ErrorCode::InvalidInput;

const std::vector<Damage> kDamages = {
    {"stampWithoutModel", "{\"model\": \"WMM2025\", ", "{", kFormat, {"swings[0].field.model: is missing"}},
    {"stampWithoutModelName", "\"model\": \"WMM2025\"", "\"model\": \"\"", kInvalid, {"swings[0].field.model: is empty"}},
    {"stampWithoutPlace", "\"height_m\": 117, ", "", kFormat, {"swings[0].field.height_m: is missing"}},
    {"stampBeyondThePole", "\"latitude_deg\": 51.55, \"longitude_deg\": 21.89, \"height_m\"",
        "\"latitude_deg\": 91, \"longitude_deg\": 21.89, \"height_m\"", kInvalid, {"swings[0].field.latitude_deg: 91", "-90 to 90"}},
    {"stampWithoutDate", "\"date\": \"2024-02-29\", \"north", "\"north", kFormat, {"swings[0].field.date: is missing"}},
    {"stampOfAnEmptyDate", "\"date\": \"2024-02-29\", \"north", "\"date\": \"\", \"north", kInvalid, {"swings[0].field.date: is empty"}},
    {"stampOfNoDay", "\"date\": \"2024-02-29\", \"north", "\"date\": \"2023-02-29\", \"north", kInvalid,
        {"swings[0].field.date", "YYYY-MM-DD"}},
    {"fieldOfAMagnet", "\"north_nT\": 18879.125", "\"north_nT\": 1e7", kInvalid, {"swings[0].field.north_nT"}},
    {"stampMisspelt", "\"north_nT\": 18879.125", "\"nort_nT\": 18879.125", kFormat, {"swings[0].field.nort_nT: is not known", "north_nT"}},
    {"stampDoubled", "\"north_nT\": 18879.125", "\"north_nT\": 1, \"north_nT\": 2", kFormat, {"swings[0].field.north_nT: is there twice"}},
    {"stampIsText", "\"field\": {", "\"field\": \"WMM\", \"other\": {", kFormat, {"swings[0].field", "expected"}},
    {"sensorWithoutName", "\"name\": \"as entered\",", "", kFormat, {"sensors[0].name: is missing"}},
    {"sensorsOfOneName", "\"name\": \"iron bench\"", "\"name\": \"as entered\"", kInvalid, {"sensors[1].name", "another sensor model"}},
    {"sensorOfNoOrigin", "\"origin\": \"iron_bench\"", "\"origin\": \"dreamt\"", kInvalid,
        {"sensors[1].origin", "entered, loaded, estimated_from_swings or iron_bench"}},
    {"sensorRecordTwice", "\"record\": \"88888888-8888-4888-8888-888888888888\"", "\"record\": \"33333333-3333-4333-8333-333333333333\"",
        kInvalid, {"sensors[0].record", "identity of another record"}},
    {"modelMissing", "\"model\": {", "\"modell\": {", kFormat, {"sensors[0].model: is missing"}},
    {"matrixCutShort", "\"hard_iron_nT\": [850, -420, 0.1]", "\"hard_iron_nT\": [850, -420]", kFormat,
        {"sensors[0].model.hard_iron_nT", "3 numbers"}},
    {"modelMisspelt", "\"hard_iron_nT\"", "\"hard_irn_nT\"", kFormat, {"sensors[0].model.hard_irn_nT", "did you mean"}},
    {"circuitIncomplete", "\"current_A\": 10, ", "", kFormat, {"sensors[0].model.circuits[0].current_A: is missing"}},
    {"benchIncomplete", "\"diameter_m\": 0.08,", "", kFormat, {"sensors[1].bench.parts[0]", "diameter_m"}},
    {"statesDoubled", "{\"group\": \"gear\", \"state\": \"extended\"}",
        "{\"group\": \"gear\", \"state\": \"a\"}, {\"group\": \"gear\", \"state\": \"b\"}", kInvalid,
        {"sensors[1].bench_states[1].group", "twice"}},
    {"indexBeyondATurn", "\"index_removed_deg\": -2.5", "\"index_removed_deg\": 181", kInvalid, {"swings[0].index_removed_deg: 181"}},
    {"sensorsInAnOldFile", "\"version\": 2", "\"version\": 1", kFormat, {"is not known"}},
    {"newerVersion", "\"version\": 2", "\"version\": 9", ErrorCode::NewerSchema, {"version 9", "up to 8"}},
};

} // namespace

TEST(ExchangeVersion, isTheLowestThatHoldsTheContent)
{
    Fleet fleet = toFleet(wholeRecord());
    EXPECT_EQ(exchangeVersionOf(fleet), 1);
    EXPECT_THAT(writeExchange(fleet), HasSubstr("\"version\": 1,"));
    fleet.swings[0].field = wholeStamp();
    EXPECT_EQ(exchangeVersionOf(fleet), 2);
    fleet.swings[0].field.reset();
    fleet.swings[0].indexRemoved_deg = 0.0;
    EXPECT_EQ(exchangeVersionOf(fleet), 2);
    fleet.swings[0].indexRemoved_deg.reset();
    fleet.sensors = wholeSensors();
    EXPECT_EQ(exchangeVersionOf(fleet), 2);
    EXPECT_THAT(writeExchange(fleet), HasSubstr("\"version\": 2,"));
}

TEST(ExchangeVersion, whatHasNeitherIsWrittenAsBeforeThereWasAVersion2)
{
    const std::string text = writeExchange(toFleet(wholeRecord()));
    for (const char* key : {"sensors", "field", "index_removed", "bench"})
        EXPECT_EQ(text.find(key), std::string::npos) << key;
}

TEST(ExchangeVersion, sensorsAndFieldsComeBackAndASecondRoundIsByteForByteTheSame)
{
    const Fleet fleet = fleetOfBoth();
    const std::string first = writeExchange(fleet);
    const auto back = read(first);
    ASSERT_TRUE(back) << describe(back.error());
    EXPECT_EQ(writeExchange(*back), first);
    EXPECT_EQ(back->swings, fleet.swings);
    ASSERT_EQ(back->sensors.size(), 2u);
    EXPECT_EQ(back->sensors[0].model.softIron, fleet.sensors[0].model.softIron);
    EXPECT_EQ(back->sensors[0].model.circuits, fleet.sensors[0].model.circuits);
    EXPECT_NEAR(back->sensors[0].model.misalignment.yaw_rad, 0.03, 1e-16);
    EXPECT_EQ(back->sensors[0].note, fleet.sensors[0].note);
    EXPECT_FALSE(back->sensors[0].bench);
    ASSERT_TRUE(back->sensors[1].bench);
    EXPECT_EQ(back->sensors[1].bench->parts[0].placements[0], fleet.sensors[1].bench->parts[0].placements[0]);
    EXPECT_NEAR(back->sensors[1].bench->parts[0].placements[1].pitch_rad, 1.25, 1e-12);
    EXPECT_EQ(back->sensors[1].bench->circuits, fleet.sensors[1].bench->circuits);
    EXPECT_EQ(back->sensors[1].benchStates, fleet.sensors[1].benchStates);
    EXPECT_EQ(back->sensors[1].origin, ModelOrigin::IronBench);
}

TEST(ExchangeVersion, theOrderOfSensorsInMemoryLeavesNoTrace)
{
    Fleet fleet = fleetOfBoth();
    const std::string text = writeExchange(fleet);
    std::swap(fleet.sensors[0], fleet.sensors[1]);
    EXPECT_EQ(writeExchange(fleet), text);
}

TEST(ExchangeVersion, version2MayHaveNeither)
{
    const auto fleet = read(replaced(writeExchange(toFleet(wholeRecord())), "\"version\": 1", "\"version\": 2"));
    ASSERT_TRUE(fleet) << describe(fleet.error());
    EXPECT_EQ(exchangeVersionOf(*fleet), 1);
}

class DamagedVersion2 : public testing::TestWithParam<Damage> {};

TEST_P(DamagedVersion2, isRefusedNamingThePath)
{
    const Damage& damage = GetParam();
    const auto fleet = read(replaced(writeExchange(fleetOfBoth()), damage.piece, damage.replacement));
    ASSERT_FALSE(fleet);
    EXPECT_EQ(fleet.error().code, damage.code) << fleet.error().message.english();
    for (const char* words : damage.says)
        EXPECT_THAT(fleet.error().message.english(), HasSubstr(words));
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, DamagedVersion2, testing::ValuesIn(kDamages), [](const auto& test) { return std::string(test.param.name); });

TEST(DerivedId, ofSensorsAndFieldsTellsThemApartAndLeavesTheOthersAlone)
{
    EXPECT_TRUE(isRecordId(recordIdOfSensor("SP-TST", "standby", "bench")));
    EXPECT_NE(recordIdOfSensor("SP-TST", "standby", "bench"), recordIdOfSensor("SP-TST", "standby", "entered"));
    EXPECT_NE(recordIdOfSensor("SP-TST", "standby", "bench"), recordIdOfSensor("SP-TST", "standbyb", "ench"));
    Swing swing = wholeRecord().swing;
    const auto idOf = [](const Swing& one) { return recordIdOfSwing(one, "SP-TST", "standby", "Mielec"); };
    const RecordId plain = idOf(swing);
    swing.field = wholeStamp();
    const RecordId stamped = idOf(swing);
    EXPECT_NE(stamped, plain);
    swing.field->model = "WMM2030"; // the same place by a later model: the same swing
    swing.field->field.north_nT += 20;
    EXPECT_EQ(idOf(swing), stamped);
    swing.field.reset();
    swing.indexRemoved_deg = 1.0;
    EXPECT_NE(idOf(swing), plain);
}

} // namespace lubberline::test
