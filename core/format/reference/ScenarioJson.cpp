#include "core/format/reference/ScenarioJson.h"

#include <array>
#include <cmath>

#include "core/angle/Angle.h"
#include "core/base/FileText.h"
#include "core/base/WholeFile.h"
#include "core/format/exchange/ModelJson.h"
#include "core/format/json/JsonDocument.h"
#include "core/format/json/JsonObject.h"
#include "core/format/json/JsonWriter.h"
#include "core/format/reference/ScenarioCsv.h"

namespace lubberline {

namespace {

constexpr NumberRange kSeconds{0, 1e7};
constexpr NumberRange kAnyRate{-1e6, 1e6};
constexpr NumberRange kNotNegative{0, 1e6};
constexpr std::array<std::string_view, 4> kLoops{"first", "damped", "integral", "third"};

template <std::size_t count>
std::size_t wordOf(JsonObject& object, std::string_view key, const std::array<std::string_view, count>& words, const std::string& allowed)
{
    const std::string word = object.text(key);
    for (std::size_t i = 0; i < count; ++i)
        if (word == words[i])
            return i;
    if (object.has(key))
        object.fault(key, {MARKED("core", "is %1; expected %2"), inQuotes(word), allowed});
    return 0;
}

Manoeuvre readManoeuvre(JsonObject& object)
{
    object.only({"from_s", "to_s", "turn_rate_deg_s", "acceleration_m_s2", "climb_m_s"});
    Manoeuvre manoeuvre;
    manoeuvre.from_s = object.requiredNumber("from_s", {-1e7, 1e7});
    manoeuvre.to_s = object.requiredNumber("to_s", {-1e7, 1e7});
    manoeuvre.turnRate_deg_s = object.number("turn_rate_deg_s", {-360, 360}).value_or(0);
    manoeuvre.acceleration_m_s2 = object.number("acceleration_m_s2", {-1000, 1000}).value_or(0);
    manoeuvre.climb_m_s = object.number("climb_m_s", {-1000, 1000}).value_or(0);
    return manoeuvre;
}

Gusts readGusts(JsonObject& object)
{
    object.only({"rms_m_s2", "peak_m_s2", "period_s", "seed"});
    Gusts gusts;
    gusts.regular = object.has("peak_m_s2");
    if (gusts.regular && object.has("rms_m_s2"))
        object.fault("peak_m_s2", MARKED("core", "says again what rms_m_s2 says; expected one of them"));
    gusts.rms_m_s2
        = gusts.regular ? object.requiredNumber("peak_m_s2", {0, 1000}) / std::sqrt(2.0) : object.requiredNumber("rms_m_s2", {0, 1000});
    gusts.period_s = object.number("period_s", kSeconds).value_or(gusts.period_s);
    gusts.seed = static_cast<std::uint32_t>(object.integer("seed", {0, 1e9}).value_or(1));
    return gusts;
}

AccelerationDrift readAccelerationDrift(JsonObject& object)
{
    return {object.number("unbalance_deg_h_g", kAnyRate).value_or(0), object.number("anisoelastic_deg_h_g2", kAnyRate).value_or(0)};
}

VerticalGyro readVertical(JsonObject& object)
{
    object.only({"loop", "tau1_s", "tau2_s", "tau3_s", "drift_deg_h", "cutoff_deg", "rate_limit_deg_min", "reverse_rate_limit_deg_min",
        "switch", "rate_compensation", "acceleration_correction", "turn_rate_error_deg_h", "exact_tilt", "initial_tilt_deg",
        "fast_levelling", "unbalance_deg_h_g", "anisoelastic_deg_h_g2"});
    VerticalGyro vertical;
    vertical.loop = static_cast<LoopKind>(wordOf(object, "loop", kLoops, "first, damped, integral or third"));
    vertical.tau1_s = object.number("tau1_s", kSeconds).value_or(vertical.tau1_s);
    vertical.tau2_s = object.number("tau2_s", kSeconds).value_or(vertical.tau2_s);
    vertical.tau3_s = object.number("tau3_s", kSeconds).value_or(vertical.tau3_s);
    vertical.drift_deg_h = object.number("drift_deg_h", kAnyRate).value_or(0);
    vertical.cutoff_deg = object.number("cutoff_deg", {0, 180});
    vertical.rateLimit_deg_min = object.number("rate_limit_deg_min", kNotNegative);
    vertical.reverseLimit_deg_min = object.number("reverse_rate_limit_deg_min", kNotNegative);
    object.object("switch", [&](JsonObject& inner) {
        inner.only({"dead_zone_deg", "rate_deg_min", "reverse_rate_deg_min"});
        LevelSwitch level;
        level.deadZone_deg = inner.number("dead_zone_deg", {0, 90}).value_or(level.deadZone_deg);
        level.rate_deg_min = inner.number("rate_deg_min", kNotNegative).value_or(level.rate_deg_min);
        level.reverseRate_deg_min = inner.number("reverse_rate_deg_min", kNotNegative).value_or(level.rate_deg_min);
        vertical.levelSwitch = level;
    });
    vertical.rateCompensation = object.boolean("rate_compensation");
    vertical.accelerationCorrection = object.boolean("acceleration_correction");
    vertical.turnRateError_deg_h = object.number("turn_rate_error_deg_h", kAnyRate).value_or(0);
    vertical.exactTilt = object.boolean("exact_tilt");
    vertical.initialTilt_deg = object.number("initial_tilt_deg", {-90, 90}).value_or(0);
    object.object("fast_levelling", [&](JsonObject& inner) {
        inner.only({"until_s", "tau1_s"});
        vertical.fastUntil_s = inner.requiredNumber("until_s", kSeconds);
        vertical.fastTau1_s = inner.number("tau1_s", kSeconds).value_or(vertical.fastTau1_s);
    });
    vertical.accelerationDrift = readAccelerationDrift(object);
    return vertical;
}

HeadingGyro readGyro(JsonObject& object)
{
    object.only({"drift_deg_h", "apparent_drift", "slaving_tau_s", "slaving_rate_deg_min", "fast_slaving", "slaving_cutout_deg_s",
        "outer_axis_tilt_deg", "spin_axis_deg", "level_outer_axis", "initial_error_deg", "unbalance_deg_h_g", "anisoelastic_deg_h_g2"});
    HeadingGyro gyro;
    gyro.drift_deg_h = object.number("drift_deg_h", kAnyRate).value_or(0);
    gyro.apparentDrift = object.boolean("apparent_drift");
    gyro.slavingTau_s = object.number("slaving_tau_s", kSeconds);
    gyro.slavingRate_deg_min = object.number("slaving_rate_deg_min", kNotNegative);
    object.object("fast_slaving", [&](JsonObject& inner) {
        inner.only({"above_deg", "rate_deg_min"});
        gyro.fastAbove_deg = inner.requiredNumber("above_deg", {0, 180});
        gyro.fastRate_deg_min = inner.number("rate_deg_min", kNotNegative).value_or(gyro.fastRate_deg_min);
    });
    gyro.cutoutTurnRate_deg_s = object.number("slaving_cutout_deg_s", kNotNegative);
    gyro.outerAxisTilt_deg = object.number("outer_axis_tilt_deg", {-90, 90}).value_or(0);
    gyro.spinAxis_deg = object.number("spin_axis_deg", {-360, 360}).value_or(0);
    gyro.levelOuterAxis = object.boolean("level_outer_axis");
    gyro.initialError_deg = object.number("initial_error_deg", {-180, 180}).value_or(0);
    gyro.accelerationDrift = readAccelerationDrift(object);
    return gyro;
}

CardInLiquid readCard(JsonObject& object)
{
    object.only({"period_s", "damping", "liquid_lag_s", "stop_deg"});
    CardInLiquid card;
    card.period_s = object.number("period_s", kSeconds).value_or(card.period_s);
    card.damping = object.number("damping", {0, 100}).value_or(card.damping);
    card.liquidLag_s = object.number("liquid_lag_s", kSeconds).value_or(card.liquidLag_s);
    card.stop_deg = object.number("stop_deg", {0, 90});
    return card;
}

/// The model that stands inside, taken out of it: it is read by its own reader. Errors: of the model, with the path to it.
Result<std::optional<SensorSetup>> takeModel(nlohmann::json& json, const std::string& name)
{
    if (!json.is_object() || !json.contains("compass") || !json["compass"].is_object() || !json["compass"].contains("model"))
        return std::optional<SensorSetup>();
    const nlohmann::json model = json["compass"]["model"];
    json["compass"].erase("model");
    if (model.is_null())
        return std::optional<SensorSetup>();
    auto setup = readModelJson(model.dump(), name);
    if (!setup)
        return Error{setup.error().code, {MARKED("core", "compass.model: %1"), setup.error().message}, name};
    return std::optional(std::move(setup.value()));
}

} // namespace

Result<Scenario> readScenarioJson(std::string_view text, const std::string& name)
{
    auto json = parseJson(text, name, MARKED("core", "a Scenario JSON (a flight and its heading references)"));
    if (!json)
        return json.error();
    const auto setup = takeModel(*json, name);
    if (!setup)
        return setup.error();
    FirstFault fault(name);
    const JsonPath root{};
    JsonObject object(*json, root, fault);
    object.only({"note", "latitude_deg", "dip_deg", "speed_m_s", "heading_deg", "step_s", "duration_s", "manoeuvres", "gusts", "vertical",
        "gyro", "compass"});
    Scenario scenario;
    static_cast<void>(object.text("note"));
    scenario.latitude_deg = object.number("latitude_deg", {-90, 90}).value_or(0);
    scenario.speed_m_s = object.number("speed_m_s", {0, 10000}).value_or(0);
    scenario.heading_deg = object.number("heading_deg", {-360, 360}).value_or(0);
    scenario.step_s = object.number("step_s", kSeconds).value_or(scenario.step_s);
    scenario.duration_s = object.number("duration_s", kSeconds).value_or(0);
    object.objects("manoeuvres", [&](JsonObject& inner) { scenario.manoeuvres.push_back(readManoeuvre(inner)); });
    object.object("gusts", [&](JsonObject& inner) { scenario.gusts = readGusts(inner); });
    object.object("vertical", [&](JsonObject& inner) { scenario.vertical = readVertical(inner); });
    object.object("gyro", [&](JsonObject& inner) { scenario.gyro = readGyro(inner); });
    object.object("compass", [&](JsonObject& inner) {
        inner.only({"kind", "card"});
        constexpr std::array<std::string_view, 2> kKinds{"needle", "flux valve"};
        if (inner.has("kind"))
            scenario.compass.type = static_cast<CompassType>(wordOf(inner, "kind", kKinds, "needle or flux valve"));
        inner.object("card", [&](JsonObject& card) { scenario.compass.card = readCard(card); });
    });
    std::optional<double> dip = object.number("dip_deg", {-90, 90});
    if (fault.error())
        return *fault.error();
    if (*setup) {
        const auto field = fieldOf(**setup);
        if (!field)
            return Error{field.error().code, {MARKED("core", "compass.model: %1"), field.error().message}, name};
        scenario.compass.model = (*setup)->model;
        scenario.compass.horizontal_nT = field->horizontal_nT;
        if (!dip)
            dip = toDegrees(field->inclination_rad());
    }
    scenario.dip_deg = dip.value_or(0);
    if (const auto fine = checkScenario(scenario); !fine)
        return Error{fine.error().code, fine.error().message, name};
    return scenario;
}

Result<Scenario> readScenarioFile(const std::string& path)
{
    const auto text = readWholeFile(path, MARKED("core", "a Scenario JSON or a table of manoeuvres"));
    if (!text)
        return text.error();
    const std::string name = nameOfInput(path);
    std::string_view content = *text;
    if (content.starts_with(kByteOrderMark))
        content.remove_prefix(kByteOrderMark.size());
    const auto first = content.find_first_not_of(" \t\r\n");
    if (first != std::string_view::npos && content[first] != '{' && content[first] != '[') {
        const auto json = scenarioCsvToJson(content, name);
        return json ? readScenarioJson(*json, name) : Result<Scenario>(json.error());
    }
    return readScenarioJson(*text, name);
}

namespace {

void writeNotZero(JsonWriter& json, std::string_view key, double value)
{
    if (value != 0)
        json.number(key, value);
}
void writeGiven(JsonWriter& json, std::string_view key, const std::optional<double>& value)
{
    if (value)
        json.number(key, *value);
}
void writeTrue(JsonWriter& json, std::string_view key, bool value)
{
    if (value)
        json.boolean(key, true);
}

void writeVertical(JsonWriter& json, const VerticalGyro& vertical)
{
    json.beginObject("vertical");
    json.text("loop", kLoops[static_cast<std::size_t>(vertical.loop)]);
    json.number("tau1_s", vertical.tau1_s);
    json.number("tau2_s", vertical.tau2_s);
    json.number("tau3_s", vertical.tau3_s);
    writeNotZero(json, "drift_deg_h", vertical.drift_deg_h);
    writeGiven(json, "cutoff_deg", vertical.cutoff_deg);
    writeGiven(json, "rate_limit_deg_min", vertical.rateLimit_deg_min);
    writeGiven(json, "reverse_rate_limit_deg_min", vertical.reverseLimit_deg_min);
    if (vertical.levelSwitch) {
        json.beginObject("switch", true);
        json.number("dead_zone_deg", vertical.levelSwitch->deadZone_deg);
        json.number("rate_deg_min", vertical.levelSwitch->rate_deg_min);
        json.number("reverse_rate_deg_min", vertical.levelSwitch->reverseRate_deg_min);
        json.end();
    }
    writeTrue(json, "rate_compensation", vertical.rateCompensation);
    writeTrue(json, "acceleration_correction", vertical.accelerationCorrection);
    writeNotZero(json, "turn_rate_error_deg_h", vertical.turnRateError_deg_h);
    writeTrue(json, "exact_tilt", vertical.exactTilt);
    writeNotZero(json, "initial_tilt_deg", vertical.initialTilt_deg);
    if (vertical.fastUntil_s > 0) {
        json.beginObject("fast_levelling", true);
        json.number("until_s", vertical.fastUntil_s);
        json.number("tau1_s", vertical.fastTau1_s);
        json.end();
    }
    writeNotZero(json, "unbalance_deg_h_g", vertical.accelerationDrift.unbalance_deg_h_g);
    writeNotZero(json, "anisoelastic_deg_h_g2", vertical.accelerationDrift.anisoelastic_deg_h_g2);
    json.end();
}

void writeGyro(JsonWriter& json, const HeadingGyro& gyro)
{
    json.beginObject("gyro");
    json.number("drift_deg_h", gyro.drift_deg_h);
    writeTrue(json, "apparent_drift", gyro.apparentDrift);
    writeGiven(json, "slaving_tau_s", gyro.slavingTau_s);
    writeGiven(json, "slaving_rate_deg_min", gyro.slavingRate_deg_min);
    if (gyro.fastAbove_deg) {
        json.beginObject("fast_slaving", true);
        json.number("above_deg", *gyro.fastAbove_deg);
        json.number("rate_deg_min", gyro.fastRate_deg_min);
        json.end();
    }
    writeGiven(json, "slaving_cutout_deg_s", gyro.cutoutTurnRate_deg_s);
    writeNotZero(json, "outer_axis_tilt_deg", gyro.outerAxisTilt_deg);
    writeNotZero(json, "spin_axis_deg", gyro.spinAxis_deg);
    writeTrue(json, "level_outer_axis", gyro.levelOuterAxis);
    writeNotZero(json, "initial_error_deg", gyro.initialError_deg);
    writeNotZero(json, "unbalance_deg_h_g", gyro.accelerationDrift.unbalance_deg_h_g);
    writeNotZero(json, "anisoelastic_deg_h_g2", gyro.accelerationDrift.anisoelastic_deg_h_g2);
    json.end();
}

void writeCompass(JsonWriter& json, const Scenario& scenario)
{
    const CompassSensor& compass = scenario.compass;
    json.beginObject("compass");
    json.text("kind", compass.type == CompassType::Needle ? "needle" : "flux valve");
    if (compass.model) {
        json.beginObject("model");
        json.beginObject("field", true);
        json.number("H_nT", compass.horizontal_nT);
        json.number("Z_nT", 0); // the scenario's dip counts
        json.end();
        writeSensorModel(json, *compass.model);
        json.end();
    }
    if (compass.card) {
        json.beginObject("card", true);
        json.number("period_s", compass.card->period_s);
        json.number("damping", compass.card->damping);
        json.number("liquid_lag_s", compass.card->liquidLag_s);
        writeGiven(json, "stop_deg", compass.card->stop_deg);
        json.end();
    }
    json.end();
}

} // namespace

std::string writeScenarioJson(const Scenario& scenario)
{
    JsonWriter json;
    json.beginObject();
    json.number("latitude_deg", scenario.latitude_deg);
    json.number("dip_deg", scenario.dip_deg);
    json.number("speed_m_s", scenario.speed_m_s);
    json.number("heading_deg", scenario.heading_deg);
    json.number("step_s", scenario.step_s);
    json.number("duration_s", scenario.duration_s);
    json.beginArray("manoeuvres");
    for (const Manoeuvre& manoeuvre : scenario.manoeuvres) {
        json.beginObject({}, true);
        json.number("from_s", manoeuvre.from_s);
        json.number("to_s", manoeuvre.to_s);
        writeNotZero(json, "turn_rate_deg_s", manoeuvre.turnRate_deg_s);
        writeNotZero(json, "acceleration_m_s2", manoeuvre.acceleration_m_s2);
        writeNotZero(json, "climb_m_s", manoeuvre.climb_m_s);
        json.end();
    }
    json.end();
    if (scenario.gusts) {
        json.beginObject("gusts", true);
        if (scenario.gusts->regular)
            json.number("peak_m_s2", scenario.gusts->rms_m_s2 * std::sqrt(2.0));
        else
            json.number("rms_m_s2", scenario.gusts->rms_m_s2);
        json.number("period_s", scenario.gusts->period_s);
        json.integer("seed", scenario.gusts->seed);
        json.end();
    }
    if (scenario.vertical)
        writeVertical(json, *scenario.vertical);
    if (scenario.gyro)
        writeGyro(json, *scenario.gyro);
    writeCompass(json, scenario);
    json.end();
    return json.take();
}

} // namespace lubberline
