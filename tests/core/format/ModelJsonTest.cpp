// Model JSON: every key, every kind of damage, and the way there and back.

#include <gmock/gmock.h>

#include "core/format/exchange/ModelJson.h"
#include "core/format/json/JsonObject.h"
#include "core/format/json/JsonWriter.h"
#include "tests/core/sensor/Chain.h"

namespace lubberline::test {

using testing::HasSubstr;

namespace {

const std::string kWhole = R"({
  "note": "invented",
  "field": {"H_nT": 18500, "dip_deg": 67},
  "soft_iron": [[0.01, 0.02, 0.03], [0.04, 0.05, 0.06], [0.07, 0.08, 0.09]],
  "hard_iron_nT": [100, -200, 300],
  "soft_constant_nT": [1, 2, 3],
  "circuits": [
    {"name": "landing light", "field_nT_per_A": [14, -38, 9], "current_A": 20, "on": true},
    {"name": "pitot heat", "field_nT_per_A": [1, 2, 3], "current_A": 8, "on": false}
  ],
  "misalignment_deg": {"roll": 1.5, "pitch": -2.5, "yaw": 30}
})";
const std::string kPlace = R"("field": {"lat_deg": 52.17, "lon_deg": 20.97, "alt_m": 110, "date": "2026-11-23"})";
const std::string kGiven = R"("field": {"H_nT": 18500, "dip_deg": 67})";

std::string inBraces(std::string text)
{
    text.insert(text.begin(), '{');
    text.push_back('}');
    return text;
}

std::string replaced(std::string text, const std::string& piece, const std::string& replacement)
{
    const auto at = text.find(piece);
    EXPECT_NE(at, std::string::npos) << piece;
    return at == std::string::npos ? text : text.replace(at, piece.size(), replacement);
}

TEST(ModelJson, everyKeyIsRead)
{
    const auto setup = readModelJson(kWhole, "model.json");
    ASSERT_TRUE(setup) << describe(setup.error());
    EXPECT_EQ(setup->note, "invented");
    const auto field = fieldOf(*setup);
    ASSERT_TRUE(field);
    EXPECT_EQ(field->horizontal_nT, 18500);
    EXPECT_NEAR(field->down_nT, 18500 * std::tan(toRadians(67)), 1e-9);
    const SensorModel& model = setup->model;
    for (int i = 0; i < 9; ++i)
        EXPECT_EQ(model.softIron(i / 3, i % 3), (i + 1) / 100.0) << "row after row: a b c, d e f, g h k";
    EXPECT_EQ(model.hardIron_nT, Eigen::Vector3d(100, -200, 300));
    EXPECT_EQ(model.softConstant_nT, Eigen::Vector3d(1, 2, 3));
    ASSERT_EQ(model.circuits.size(), 2u);
    EXPECT_EQ(model.circuits[0], (Circuit{"landing light", {14, -38, 9}, 20, true}));
    EXPECT_FALSE(model.circuits[1].on);
    EXPECT_EQ(model.misalignment, (Misalignment{toRadians(1.5), toRadians(-2.5), toRadians(30)}));
}

TEST(ModelJson, onlyTheFieldIsNeeded)
{
    const auto setup = readModelJson(inBraces(kGiven), "model.json");
    ASSERT_TRUE(setup);
    EXPECT_EQ(setup->model, SensorModel{});
    EXPECT_EQ(setup->note, "");
}

TEST(ModelJson, aPlaceAndADate)
{
    const auto setup = readModelJson(inBraces(kPlace), "model.json");
    ASSERT_TRUE(setup) << describe(setup.error());
    EXPECT_EQ(std::get<PlaceAndDate>(setup->field), (PlaceAndDate{{52.17, 20.97, 110}, "2026-11-23"}));
    const auto field = fieldOf(*setup);
    ASSERT_TRUE(field) << field.error().message.english();
    // Warsaw: H and dip of any recent main field model, to what a few years change.
    EXPECT_NEAR(field->horizontal_nT, 18900, 400);
    EXPECT_NEAR(toDegrees(field->inclination_rad()), 68, 1);

    const auto wrapped = readModelJson(inBraces(replaced(kPlace, "20.97", "540")), "model.json");
    ASSERT_TRUE(wrapped);
    EXPECT_EQ(std::get<PlaceAndDate>(wrapped->field).place.longitude_deg, -180);
    const auto sea = readModelJson(inBraces(replaced(kPlace, "\"alt_m\": 110, ", "")), "model.json");
    ASSERT_TRUE(sea);
    EXPECT_EQ(std::get<PlaceAndDate>(sea->field).place.height_m, 0);
    const auto decimal = readModelJson(inBraces(replaced(kPlace, "2026-11-23", "2026.9")), "model.json");
    ASSERT_TRUE(decimal);
    EXPECT_TRUE(fieldOf(*decimal));
}

TEST(ModelJson, aDateOutsideEveryModelNamesTheYears)
{
    const auto setup = readModelJson(inBraces(replaced(kPlace, "2026-11-23", "1850-01-01")), "model.json");
    ASSERT_TRUE(setup);
    const auto field = fieldOf(*setup);
    ASSERT_FALSE(field);
    EXPECT_THAT(field.error().message.english(), HasSubstr("1900"));
}

// Damage

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
    {"noField", "\"field\": {\"H_nT\": 18500, \"dip_deg\": 67},", "", kFormat,
        {"field: is missing", "H_nT, dip_deg", "lat_deg, lon_deg, alt_m, date"}},
    {"emptyField", "{\"H_nT\": 18500, \"dip_deg\": 67}", "{}", kFormat, {"field.H_nT: is missing"}},
    {"fieldInWords", "{\"H_nT\": 18500, \"dip_deg\": 67}", "\"Warsaw\"", kFormat, {"field: is not an object"}},
    {"noDip", ", \"dip_deg\": 67", "", kFormat, {"field.dip_deg: is missing"}},
    {"noH", "\"H_nT\": 18500, ", "", kFormat, {"field.H_nT: is missing"}},
    {"negativeH", "18500", "-18500", kInvalid, {"field.H_nT: -18500 is out of range"}},
    {"dipBeyond", "\"dip_deg\": 67", "\"dip_deg\": 91", kInvalid, {"field.dip_deg: 91 is out of range", "-90 to 90"}},
    {"dipOfAPole", "\"dip_deg\": 67", "\"dip_deg\": 90", kInvalid, {"field.dip_deg", "pole", "Z_nT"}},
    {"dipAndZ", "\"dip_deg\": 67", "\"dip_deg\": 67, \"Z_nT\": 40000", kInvalid, {"field.dip_deg", "Z_nT"}},
    {"twoFields", "\"dip_deg\": 67", "\"lat_deg\": 52", kFormat, {"field.H_nT: is not known", "lat_deg, lon_deg, alt_m, date"}},
    {"misspeltField", "\"field\"", "\"feild\"", kFormat, {"feild: is not known; did you mean \"field\"?"}},
    {"misspeltSoftIron", "\"soft_iron\"", "\"soft_irn\"", kFormat, {"soft_irn: is not known; did you mean \"soft_iron\"?"}},
    {"otherCase", "\"hard_iron_nT\"", "\"Hard_Iron_NT\"", kFormat, {"Hard_Iron_NT: is not known; did you mean \"hard_iron_nT\"?"}},
    {"missingUnit", "\"H_nT\"", "\"H_mT\"", kFormat, {"field.H_mT: is not known; did you mean \"H_nT\"?"}},
    {"unknownKey", "\"note\": \"invented\"", "\"colour\": \"red\"", kFormat,
        {"colour: is not known; expected only note, field, covariance, soft_iron"}},
    {"doubledKey", "\"hard_iron_nT\": [100, -200, 300],", "\"hard_iron_nT\": [1, 2, 3], \"hard_iron_nT\": [1, 2, 3],", kFormat,
        {"hard_iron_nT: is there twice"}},
    {"doubledInside", "\"roll\": 1.5", "\"roll\": 1.5, \"roll\": 1.5", kFormat, {"misalignment_deg.roll: is there twice"}},
    {"twoRows", ", [0.07, 0.08, 0.09]]", "]", kFormat, {"soft_iron: is not an array of 3 rows"}},
    {"fourRows", "[[0.01", "[[0, 0, 0], [0.01", kFormat, {"soft_iron: is not an array of 3 rows"}},
    {"shortRow", "[0.04, 0.05, 0.06]", "[0.04, 0.05]", kFormat, {"soft_iron[1]: is not an array of 3"}},
    {"longRow", "[0.04, 0.05, 0.06]", "[0.04, 0.05, 0.06, 0]", kFormat, {"soft_iron[1]: is not an array of 3"}},
    {"rowIsNumber", "[0.04, 0.05, 0.06]", "4", kFormat, {"soft_iron[1]: is not an array of 3"}},
    {"ironInWords", "0.06", "\"much\"", kFormat, {"soft_iron[1][2]: has a value of the wrong kind; expected a number"}},
    {"ironIsNull", "0.06", "null", kFormat, {"soft_iron[1][2]", "a number"}},
    {"ironIsTooMuch", "0.06", "1e10", kInvalid, {"soft_iron[1][2]: 1e+10 is out of range"}},
    {"numberForVector", "[100, -200, 300]", "100", kFormat, {"hard_iron_nT: is not an array of 3"}},
    {"twoOfThree", "[100, -200, 300]", "[100, -200]", kFormat, {"hard_iron_nT: is not an array of 3"}},
    {"notFinite", "-200, 300", "-200, 1e400", kInvalid, {"hard_iron_nT[2]", "out of range"}},
    {"nanIsNoJson", "-200, 300", "-200, NaN", kFormat, {"not well-formed JSON", "Model JSON"}},
    {"circuitsObject", "\"circuits\": [", "\"soft_circuits\": [], \"circuits\": [", kFormat, {"soft_circuits: is not known"}},
    {"circuitIsNumber", "{\"name\": \"pitot heat\", \"field_nT_per_A\": [1, 2, 3], \"current_A\": 8, \"on\": false}", "7", kFormat,
        {"circuits[1]: is not an object"}},
    {"circuitWithoutName", "\"name\": \"pitot heat\", ", "", kFormat, {"circuits[1].name: is missing"}},
    {"circuitWithoutField", "\"field_nT_per_A\": [1, 2, 3], ", "", kFormat, {"circuits[1].field_nT_per_A: is missing"}},
    {"circuitWithoutCurrent", "\"current_A\": 8, ", "", kFormat, {"circuits[1].current_A: is missing"}},
    {"circuitWithoutSwitch", ", \"on\": false", "", kFormat, {"circuits[1].on: is missing", "true or false"}},
    {"switchInWords", "\"on\": false", "\"on\": \"off\"", kFormat, {"circuits[1].on", "true or false"}},
    {"currentMisspelt", "\"current_A\": 8", "\"curent_A\": 8", kFormat,
        {"circuits[1].curent_A: is not known; did you mean \"current_A\"?"}},
    {"misalignmentInRadians", "\"misalignment_deg\"", "\"misalignment_rad\"", kFormat,
        {"misalignment_rad: is not known; expected only", "misalignment_deg"}},
    {"misalignmentKey", "\"yaw\": 30", "\"heading\": 30", kFormat,
        {"misalignment_deg.heading: is not known; expected only roll, pitch, yaw"}},
    {"misalignmentBeyond", "\"yaw\": 30", "\"yaw\": 361", kInvalid, {"misalignment_deg.yaw: 361 is out of range"}},
    {"noteIsNumber", "\"invented\"", "7", kFormat, {"note", "expected text"}},
};

class DamagedModel : public testing::TestWithParam<Damage> {};

TEST_P(DamagedModel, isRefusedByItsPath)
{
    const auto& damage = GetParam();
    const auto setup = readModelJson(replaced(kWhole, damage.piece, damage.replacement), "model.json");
    ASSERT_FALSE(setup);
    EXPECT_EQ(setup.error().code, damage.code) << setup.error().message.english();
    EXPECT_EQ(setup.error().file, "model.json");
    for (const char* words : damage.says)
        EXPECT_THAT(setup.error().message.english(), HasSubstr(words));
}

INSTANTIATE_TEST_SUITE_P(Kinds, DamagedModel, testing::ValuesIn(kDamages), [](const auto& one) { return std::string(one.param.name); });

struct PlaceDamage {
    const char* piece;
    const char* replacement;
    const char* says;
};

TEST(ModelJson, damagedPlaces)
{
    for (const auto& [piece, replacement, says] :
        {PlaceDamage{"52.17", "91", "field.lat_deg: 91 is out of range"}, {"\"lat_deg\": 52.17, ", "", "field.lat_deg: is missing"},
            {"\"lon_deg\": 20.97, ", "", "field.lon_deg: is missing"}, {", \"date\": \"2026-11-23\"", "", "field.date: is missing"},
            {"\"lat_deg\"", "\"lat_dge\"", "field.lat_dge: is not known; did you mean \"lat_deg\"?"},
            {"2026-11-23", "2026-02-30", "field.date: "}, {"2026-11-23", "soon", "field.date: "},
            {"\"2026-11-23\"", "2026", "field.date: "}, {"110", "1e8", "field.alt_m: "}}) {
        const auto setup = readModelJson(inBraces(replaced(kPlace, piece, replacement)), "model.json");
        ASSERT_FALSE(setup) << replacement;
        EXPECT_THAT(setup.error().message.english(), HasSubstr(says));
    }
}

TEST(ModelJson, whatIsNoModelAtAll)
{
    for (const char* text :
        {"", "  \n", "[]", "7", "null", "{", "{\"field\": {\"H_nT\": 1", "\xff\xfe", "magnetic_heading_deg,compass_heading_deg\n0,1\n"}) {
        const auto setup = readModelJson(text, "model.json");
        ASSERT_FALSE(setup) << text;
        EXPECT_EQ(setup.error().code, ErrorCode::Format) << text;
    }
    EXPECT_THAT(readModelJson("", "model.json").error().message.english(), HasSubstr("Model JSON"));
    EXPECT_FALSE(readModelJson(std::string(100'000, '['), "model.json"));
    EXPECT_EQ(readModelJsonFile("/no/such/model.json").error().code, ErrorCode::Io);
    EXPECT_EQ(readModelJsonFile("/").error().code, ErrorCode::Io);
}

TEST(ModelJson, everyCutOffFileIsRefused)
{
    for (std::size_t length = 0; length < kWhole.size(); ++length)
        EXPECT_FALSE(readModelJson(std::string_view(kWhole).substr(0, length), "model.json")) << length;
}

TEST(ModelJson, changedBytesAreRefusedOrReadBack)
{
    std::mt19937 random(30);
    const std::string bytes = "0123456789-+.eE\"{}[]:,tfn \n_\\\xff";
    int accepted = 0;
    for (int i = 0; i < 5000; ++i) {
        std::string text = i % 2 ? kWhole : replaced(kWhole, kGiven, kPlace);
        for (int change = 0; change <= i % 3; ++change) {
            const char byte = bytes[random() % bytes.size()];
            text[random() % text.size()] = byte;
        }
        const auto setup = readModelJson(text, "model.json");
        if (!setup) {
            EXPECT_FALSE(setup.error().message.english().empty());
            continue;
        }
        ++accepted;
        const auto back = readModelJson(writeModelJson(*setup), "back.json");
        ASSERT_TRUE(back) << describe(back.error()) << "\n" << text;
        EXPECT_EQ(writeModelJson(*back), writeModelJson(*setup));
    }
    EXPECT_GT(accepted, 100) << "digits changed for digits are models, too";
}

// There and back

TEST(ModelJson, writtenReadsBackEqualAndIsWrittenTheSame)
{
    for (const auto& text : {kWhole, inBraces(kGiven), inBraces(kPlace), replaced(kWhole, kGiven, kPlace)}) {
        const auto setup = readModelJson(text, "model.json");
        ASSERT_TRUE(setup);
        const std::string written = writeModelJson(*setup);
        const auto back = readModelJson(written, "written.json");
        ASSERT_TRUE(back) << describe(back.error());
        EXPECT_TRUE(*back == *setup) << written;
        EXPECT_EQ(writeModelJson(*back), written);
    }
    EXPECT_THAT(writeModelJson(*readModelJson(kWhole, "")), HasSubstr("\"field\": {\"H_nT\": 18500, \"dip_deg\": 67}"));
    EXPECT_THAT(
        writeModelJson(*readModelJson(kWhole, "")), HasSubstr("\"misalignment_deg\": {\"roll\": 1.5, \"pitch\": -2.5, \"yaw\": 30}"));
}

TEST(ModelJson, partsThatAreZeroAreWritten)
{
    const std::string written = writeModelJson(*readModelJson(inBraces(kGiven), ""));
    for (const char* key : {"\"soft_iron\": [", "\"hard_iron_nT\": [0, 0, 0]", "\"soft_constant_nT\": [0, 0, 0]", "\"circuits\": []",
             "\"misalignment_deg\": {"})
        EXPECT_THAT(written, HasSubstr(key));
    EXPECT_EQ(written.find("note"), std::string::npos);
}

TEST(ModelJson, randomModelsAndFieldsToTheLastBit)
{
    std::mt19937 random(31);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (int i = 0; i < 2000; ++i) {
        const MeridianField field{20000 + 19000 * unit(random), 60000 * unit(random)};
        const SensorSetup setup{field, randomModel(random, 0.3, 5000, kPi), {}};
        const auto once = readModelJson(writeModelJson(setup), "once.json");
        ASSERT_TRUE(once) << describe(once.error());
        EXPECT_EQ(once->field, setup.field);
        EXPECT_EQ(once->model.softIron, setup.model.softIron);
        EXPECT_EQ(once->model.circuits, setup.model.circuits);
        // Degrees cannot name every angle in radians, but what they named once they name for ever.
        EXPECT_NEAR(once->model.misalignment.roll_rad, setup.model.misalignment.roll_rad, 1e-15);
        EXPECT_NEAR(once->model.misalignment.pitch_rad, setup.model.misalignment.pitch_rad, 1e-15);
        const auto twice = readModelJson(writeModelJson(*once), "twice.json");
        ASSERT_TRUE(twice);
        EXPECT_TRUE(*twice == *once);
        EXPECT_EQ(writeModelJson(*once), writeModelJson(setup));
    }
}

TEST(ModelJson, fieldsThatNoDipCanTell)
{
    for (const auto& field :
        {MeridianField{0, 56000}, MeridianField{0, 0}, MeridianField{1e-3, -56000}, MeridianField{25000, 0}, MeridianField{0, -1}}) {
        const auto back = readModelJson(writeModelJson({field, {}, {}}), "field.json");
        ASSERT_TRUE(back) << describe(back.error());
        EXPECT_EQ(std::get<MeridianField>(back->field), field);
    }
}

TEST(ModelJson, anyTextAsNameAndNote)
{
    SensorSetup setup{MeridianField{20000, 40000}, {}, "two\nlines, \"quotes\", Dęblin"};
    setup.model.circuits = {{"", {1, 2, 3}, 4, true}, {"same", {}, 0, false}, {"same", {}, 0, true}};
    const auto back = readModelJson(writeModelJson(setup), "model.json");
    ASSERT_TRUE(back) << describe(back.error());
    EXPECT_TRUE(*back == setup);
}

TEST(SensorModelJson, theModelWithoutItsField)
{
    const SensorModel model = readModelJson(kWhole, "model.json").value().model;
    const std::string written = writeSensorModelJson(model);
    EXPECT_EQ(written.find("\"field\""), std::string::npos);
    const auto back = readSensorModelJson(written, "model");
    ASSERT_TRUE(back) << describe(back.error());
    EXPECT_EQ(*back, model);
    EXPECT_EQ(writeSensorModelJson(*back), written);
    EXPECT_EQ(*readSensorModelJson("{}", "model"), SensorModel{});
    const auto withField = readSensorModelJson(kWhole, "model");
    ASSERT_FALSE(withField);
    EXPECT_THAT(withField.error().message.english(), HasSubstr("field: is not known"));
}

TEST(SensorModelJson, insideAnotherObject)
{
    const SensorModel model = readModelJson(kWhole, "model.json").value().model;
    JsonWriter json;
    json.beginObject();
    json.text("name", "fin");
    json.beginObject("model");
    writeSensorModel(json, model);
    json.end();
    json.end();
    const std::string text = json.take();
    const auto document = nlohmann::json::parse(text);
    const std::string file = "whole.json";
    FirstFault fault(file);
    const JsonPath root;
    JsonObject object(document, root, fault);
    SensorModel back;
    object.object("model", [&](JsonObject& inner) {
        back = readSensorModel(inner);
        inner.finish();
    });
    EXPECT_EQ(object.text("name"), "fin");
    object.finish();
    EXPECT_FALSE(fault.error()) << fault.error()->message.english();
    EXPECT_EQ(back, model);
}

TEST(SensorModelJson, theSamplesAreModels)
{
    for (const char* sample : {"/example-sensor.json", "/example-sensor-at-place.json"}) {
        const auto setup = readModelJsonFile(std::string(LUBBERLINE_SAMPLES) + sample);
        ASSERT_TRUE(setup) << describe(setup.error());
        EXPECT_THAT(setup->note, HasSubstr("invented"));
        EXPECT_TRUE(fieldOf(*setup));
    }
}

TEST(ModelJson, aFieldWithoutADipIsNone)
{
    const auto setup = readModelJson(R"({"field": {"F_nT": 49800}, "hard_iron_nT": [1500, -2300, 800]})", "m.json");
    ASSERT_TRUE(setup) << describe(setup.error());
    EXPECT_EQ(std::get<TotalField>(setup->field).total_nT, 49800);
    const auto field = fieldOf(*setup);
    ASSERT_FALSE(field);
    EXPECT_NE(describe(field.error()).find("only its size is known (49800)"), std::string::npos) << describe(field.error());
    const auto back = readModelJson(writeModelJson(*setup), "m.json");
    ASSERT_TRUE(back);
    EXPECT_EQ(*back, *setup);
    EXPECT_FALSE(readModelJson(R"({"field": {"F_nT": 49800, "dip_deg": 67}})", "m.json"));
    // Calibrations of before wrote a dip of 0, and in their note that nobody knew it. A stated dip of 0 is the magnetic equator.
    const auto old = readModelJson(R"({"note": "good; the dip is not known and stands as 0: what rests on it (smith) needs --dip-deg",
        "field": {"H_nT": 49800, "dip_deg": 0}})",
        "m.json");
    EXPECT_EQ(std::get<TotalField>(old->field).total_nT, 49800);
    EXPECT_TRUE(fieldOf(*readModelJson(R"({"field": {"H_nT": 40000, "dip_deg": 0}})", "m.json")));
}

} // namespace
} // namespace lubberline::test
