#include "core/format/exchange/ModelJson.h"

#include <array>
#include <cmath>

#include "core/angle/Angle.h"
#include "core/angle/WrittenDegrees.h"
#include "core/base/WholeFile.h"
#include "core/format/json/JsonWriter.h"
#include "core/format/json/ReadObject.h"
#include "core/record/Ranges.h"

namespace lubberline {

namespace {

constexpr Pattern kExpectedModel = MARKED("core", "a Model JSON (a sensor on an aircraft)");

/// Far beyond any aircraft, and far from what a double cannot square.
constexpr NumberRange kAny{-1e9, 1e9};

using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

Eigen::Vector3d readVector(JsonObject& object, std::string_view key)
{
    Eigen::Vector3d vector = Eigen::Vector3d::Zero();
    object.numbers(key, {vector.data(), 3}, kAny);
    return vector;
}

Eigen::Matrix3d readMatrix(JsonObject& object, std::string_view key)
{
    RowMajor matrix = RowMajor::Zero();
    object.numberRows(key, {matrix.data(), 9}, 3, kAny);
    return matrix;
}

Circuit readSensorCircuit(JsonObject& object)
{
    object.only({"name", "field_nT_per_A", "current_A", "on"});
    for (const auto& [key, expected] : {std::pair{"name", MARKED("core", "text")}, {"field_nT_per_A", MARKED("core", "[S, T, V]")},
             {"current_A", MARKED("core", "a number")}, {"on", MARKED("core", "true or false")}})
        if (!object.has(key))
            object.missing(key, expected);
    return {object.text("name"), readVector(object, "field_nT_per_A"), object.number("current_A", kAny).value_or(0), object.boolean("on")};
}

Misalignment readMisalignment(JsonObject& object)
{
    object.only({"roll", "pitch", "yaw"});
    const auto angle_rad = [&](std::string_view key) { return toRadians(object.number(key, kFigureRange).value_or(0)); };
    return {angle_rad("roll"), angle_rad("pitch"), angle_rad("yaw")};
}

PlaceAndDate readPlace(JsonObject& object)
{
    object.only({"lat_deg", "lon_deg", "alt_m", "date"});
    const double latitude_deg = object.requiredNumber("lat_deg", {-90, 90});
    const double longitude_deg = object.requiredNumber("lon_deg", {-1e6, 1e6}); // wrapped
    const double height_m = object.number("alt_m", kAny).value_or(0);
    PlaceAndDate field;
    if (const auto place = makePlace(latitude_deg, longitude_deg, height_m))
        field.place = *place;
    else
        object.fault("alt_m", place.error().message);
    field.date = object.requiredText("date", MARKED("core", "a date as YYYY-MM-DD, or a decimal year as text"));
    if (const auto year = decimalYear(field.date); !year)
        object.fault("date", year.error().message);
    return field;
}

MeridianField readMeridian(JsonObject& object)
{
    object.only({"H_nT", "dip_deg", "Z_nT"});
    const double horizontal_nT = object.requiredNumber("H_nT", {0, 1e9});
    if (object.has("Z_nT")) {
        if (object.has("dip_deg"))
            object.fault("dip_deg", MARKED("core", "says again what Z_nT says; expected one of them"));
        return {horizontal_nT, object.number("Z_nT", kAny).value_or(0)};
    }
    const double dip_deg = object.requiredNumber("dip_deg", {-90, 90});
    if (std::abs(dip_deg) == 90)
        object.fault("dip_deg",
            MARKED("core", "is that of a magnetic pole, where H is 0 and the dip does not tell the field; expected H_nT with Z_nT"));
    return MeridianField::fromDip(horizontal_nT, toRadians(dip_deg));
}

std::variant<MeridianField, PlaceAndDate, TotalField> readField(JsonObject& object)
{
    if (object.has("F_nT")) {
        object.only({"F_nT"});
        return TotalField{object.requiredNumber("F_nT", {0, 1e9})};
    }
    for (const char* key : {"lat_deg", "lon_deg", "alt_m", "date"})
        if (object.has(key))
            return readPlace(object);
    return readMeridian(object);
}

/// What calibrations of before wrote into the note of a model whose dip nobody knew.
constexpr std::string_view kOldDipNote = "the dip is not known and stands as 0";

/// The keys of SensorModel, and those before it.
constexpr std::array<std::string_view, 8> kKeys{
    "note", "field", "covariance", "soft_iron", "hard_iron_nT", "soft_constant_nT", "circuits", "misalignment_deg"};

SensorSetup readSetup(JsonObject& object)
{
    object.only(kKeys);
    SensorSetup setup;
    setup.note = object.text("note");
    if (!object.has("field"))
        object.missing("field", MARKED("core", "{H_nT, dip_deg} or {lat_deg, lon_deg, alt_m, date}"));
    object.object("field", [&](JsonObject& field) { setup.field = readField(field); });
    if (const auto* given = std::get_if<MeridianField>(&setup.field);
        given && given->down_nT == 0 && setup.note.find(kOldDipNote) != std::string::npos)
        setup.field = TotalField{given->horizontal_nT};
    setup.model = readSensorModel(object);
    setup.uncertainty = readCovariance(object);
    return setup;
}

SensorModel readOnlyModel(JsonObject& object)
{
    object.only(std::span(kKeys).subspan(3));
    return readSensorModel(object);
}

void writePlace(JsonWriter& json, const PlaceAndDate& field)
{
    json.number("lat_deg", field.place.latitude_deg);
    json.number("lon_deg", field.place.longitude_deg);
    json.number("alt_m", field.place.height_m);
    json.text("date", field.date);
}

/// The dip that reads back to the very field, short where a short one does; none where no dip does.
std::optional<double> writtenDip_deg(const MeridianField& field)
{
    const double plain_deg = toDegrees(field.inclination_rad());
    for (const double dip_deg :
        {std::round(plain_deg * 1e9) / 1e9, plain_deg, std::nextafter(plain_deg, -90.0), std::nextafter(plain_deg, 90.0)})
        if (std::abs(dip_deg) < 90 && MeridianField::fromDip(field.horizontal_nT, toRadians(dip_deg)) == field)
            return dip_deg;
    return {};
}

void writeMeridian(JsonWriter& json, const MeridianField& field)
{
    json.number("H_nT", field.horizontal_nT);
    if (const auto dip_deg = writtenDip_deg(field))
        json.number("dip_deg", *dip_deg);
    else
        json.number("Z_nT", field.down_nT);
}

void writeCircuit(JsonWriter& json, const Circuit& circuit)
{
    json.beginObject({}, true);
    json.text("name", circuit.name);
    json.numbers("field_nT_per_A", {circuit.field_nT_per_A.data(), 3});
    json.number("current_A", circuit.current_A);
    json.boolean("on", circuit.on);
    json.end();
}

} // namespace

SensorModel readSensorModel(JsonObject& object)
{
    SensorModel model;
    model.softIron = readMatrix(object, "soft_iron");
    model.hardIron_nT = readVector(object, "hard_iron_nT");
    model.softConstant_nT = readVector(object, "soft_constant_nT");
    object.objects("circuits", [&](JsonObject& circuit) { model.circuits.push_back(readSensorCircuit(circuit)); });
    object.object("misalignment_deg", [&](JsonObject& misalignment) { model.misalignment = readMisalignment(misalignment); });
    return model;
}

void writeSensorModel(JsonWriter& json, const SensorModel& model)
{
    const RowMajor softIron = model.softIron;
    json.beginArray("soft_iron");
    for (int row = 0; row < 3; ++row)
        json.numbers({}, {softIron.data() + 3 * row, 3});
    json.end();
    json.numbers("hard_iron_nT", {model.hardIron_nT.data(), 3});
    json.numbers("soft_constant_nT", {model.softConstant_nT.data(), 3});
    json.beginArray("circuits");
    for (const auto& circuit : model.circuits)
        writeCircuit(json, circuit);
    json.end();
    json.beginObject("misalignment_deg", true);
    json.number("roll", writtenDegrees(model.misalignment.roll_rad));
    json.number("pitch", writtenDegrees(model.misalignment.pitch_rad));
    json.number("yaw", writtenDegrees(model.misalignment.yaw_rad));
    json.end();
}

Result<SensorSetup> readModelJson(std::string_view text, const std::string& name)
{
    return readJsonObject<SensorSetup>(text, name, kExpectedModel, readSetup);
}

std::optional<ModelUncertainty> readCovariance(JsonObject& object)
{
    if (!object.has("covariance"))
        return std::nullopt;
    ModelUncertainty uncertainty; // symmetric: rows are columns
    object.numberRows(
        "covariance", {uncertainty.covariance.data(), static_cast<std::size_t>(uncertainty.covariance.size())}, kUncertainParameters, kAny);
    const auto& c = uncertainty.covariance;
    if (c.diagonal().minCoeff() < 0 || (c - c.transpose()).cwiseAbs().maxCoeff() > 1e-6 * c.diagonal().maxCoeff())
        object.fault("covariance", MARKED("core", "is none: expected a symmetric matrix with no negative figure on its diagonal"));
    return uncertainty;
}

void writeCovariance(JsonWriter& json, const std::optional<ModelUncertainty>& uncertainty)
{
    if (!uncertainty)
        return;
    json.beginArray("covariance");
    for (Eigen::Index row = 0; row < kUncertainParameters; ++row)
        json.numbers({}, {uncertainty->covariance.col(row).data(), kUncertainParameters});
    json.end();
}

Result<ModelUncertainty> readUncertaintyJson(std::string_view text, const std::string& name)
{
    return readJsonObject<ModelUncertainty>(text, name, kExpectedModel, [](JsonObject& object) {
        object.only({"covariance"});
        if (!object.has("covariance"))
            object.missing("covariance", MARKED("core", "twelve rows of twelve numbers"));
        return readCovariance(object).value_or(ModelUncertainty());
    });
}

std::string writeUncertaintyJson(const ModelUncertainty& uncertainty)
{
    JsonWriter json;
    json.beginObject();
    writeCovariance(json, uncertainty);
    json.end();
    return json.take();
}

Result<SensorModel> readSensorModelJson(std::string_view text, const std::string& name)
{
    return readJsonObject<SensorModel>(text, name, kExpectedModel, readOnlyModel);
}

Result<SensorSetup> readModelJsonFile(const std::string& path)
{
    const auto text = readWholeFile(path, kExpectedModel);
    if (!text)
        return text.error();
    return readModelJson(*text, nameOfInput(path));
}

std::string writeModelJson(const SensorSetup& setup)
{
    JsonWriter json;
    json.beginObject();
    if (!setup.note.empty())
        json.text("note", setup.note);
    json.beginObject("field", true);
    if (const auto* given = std::get_if<MeridianField>(&setup.field))
        writeMeridian(json, *given);
    else if (const auto* total = std::get_if<TotalField>(&setup.field))
        json.number("F_nT", total->total_nT);
    else
        writePlace(json, std::get<PlaceAndDate>(setup.field));
    json.end();
    writeSensorModel(json, setup.model);
    writeCovariance(json, setup.uncertainty);
    json.end();
    return json.take();
}

std::string writeSensorModelJson(const SensorModel& model)
{
    JsonWriter json;
    json.beginObject();
    writeSensorModel(json, model);
    json.end();
    return json.take();
}

} // namespace lubberline
