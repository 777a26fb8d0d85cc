#include "core/format/exchange/ElectricalJson.h"

#include "core/format/exchange/OptionalKeys.h"
#include "core/format/json/ReadObject.h"
#include "core/record/Ranges.h"

namespace lubberline {

namespace {

constexpr NumberRange kVolts{-1000, 1000};
constexpr NumberRange kDial{-360, 360};
constexpr std::size_t kMostHeadings = 360;

void voltage(JsonWriter& json, std::string_view key, const FieldVoltage& value)
{
    if (!value.normal_V && !value.reversed_V)
        return;
    json.beginObject(key, true);
    numberIfAny(json, "normal_V", value.normal_V);
    numberIfAny(json, "reversed_V", value.reversed_V);
    json.end();
}

FieldVoltage voltage(JsonObject& object, std::string_view key)
{
    FieldVoltage value;
    object.object(key, [&](JsonObject& one) {
        one.only({"normal_V", "reversed_V"});
        value.normal_V = one.number("normal_V", kVolts);
        value.reversed_V = one.number("reversed_V", kVolts);
    });
    return value;
}

void headings(JsonWriter& json, std::string_view key, const std::vector<SelectedHeading>& list)
{
    if (list.empty())
        return;
    json.beginArray(key);
    for (const auto& one : list) {
        json.beginObject({}, true);
        json.number("selected_deg", one.selected_deg);
        numberIfAny(json, "indicated_deg", one.indicated_deg);
        json.end();
    }
    json.end();
}

std::vector<SelectedHeading> headings(JsonObject& object, std::string_view key)
{
    std::vector<SelectedHeading> list;
    object.objects(key, [&](JsonObject& one) {
        one.only({"selected_deg", "indicated_deg"});
        const double selected_deg = one.requiredNumber("selected_deg", kHeadingRange);
        list.push_back({selected_deg, one.number("indicated_deg", kHeadingRange)});
    });
    if (list.size() > kMostHeadings)
        object.fault(key, MARKED("core", "are more than 360; expected the headings of an electrical swing"));
    return list;
}

/// Table F1 as a list of those of 0, 90, 180 and 270 that were read.
void table(JsonWriter& json, std::string_view key, const FourPointTable& value)
{
    std::vector<SelectedHeading> read;
    for (std::size_t i = 0; i < value.indicated_deg.size(); ++i)
        if (value.indicated_deg[i])
            read.push_back({90.0 * static_cast<double>(i), value.indicated_deg[i]});
    headings(json, key, read);
}

FourPointTable table(JsonObject& object, std::string_view key)
{
    FourPointTable value;
    for (const auto& one : headings(object, key)) {
        const double quarter = one.selected_deg / 90;
        if (quarter != 0 && quarter != 1 && quarter != 2 && quarter != 3)
            object.fault(key, MARKED("core", "holds a selected heading other than 0, 90, 180 and 270"));
        else if (value.indicated_deg[static_cast<std::size_t>(quarter)])
            object.fault(key, MARKED("core", "holds a selected heading twice; expected each once"));
        else
            value.indicated_deg[static_cast<std::size_t>(quarter)] = one.indicated_deg;
    }
    return value;
}

} // namespace

void writeElectrical(JsonWriter& json, const ElectricalSwing& swing)
{
    textIfAny(json, "record", swing.record);
    textIfAny(json, "date", swing.date);
    textIfAny(json, "line", swing.line);
    textIfAny(json, "calibrator", swing.calibrator);
    textIfAny(json, "calibrator_serial_number", swing.calibratorSerial);
    textIfAny(json, "sensor_sheet", swing.sensorSheet);
    voltage(json, "e1", swing.E1);
    voltage(json, "e2", swing.E2);
    numberIfAny(json, "misalignment_deg", swing.misalignment_deg);
    numberIfAny(json, "delta_180_deg", swing.delta180_deg);
    numberIfAny(json, "delta_270_deg", swing.delta270_deg);
    table(json, "table_f1_before", swing.before);
    table(json, "table_f1_after", swing.after);
    headings(json, "headings", swing.headings);
    headings(json, "self_check", swing.selfCheck);
    textIfAny(json, "by", swing.by);
    textIfAny(json, "note", swing.note);
}

ElectricalSwing readElectrical(JsonObject& object)
{
    ElectricalSwing swing;
    if (object.has("record"))
        swing.record = object.recordId("record");
    swing.date = object.date("date");
    swing.line = object.text("line");
    swing.calibrator = object.text("calibrator");
    swing.calibratorSerial = object.text("calibrator_serial_number");
    swing.sensorSheet = object.text("sensor_sheet");
    swing.E1 = voltage(object, "e1");
    swing.E2 = voltage(object, "e2");
    swing.misalignment_deg = object.number("misalignment_deg", kDial);
    swing.delta180_deg = object.number("delta_180_deg", kDial);
    swing.delta270_deg = object.number("delta_270_deg", kDial);
    swing.before = table(object, "table_f1_before");
    swing.after = table(object, "table_f1_after");
    swing.headings = headings(object, "headings");
    swing.selfCheck = headings(object, "self_check");
    swing.by = object.text("by");
    swing.note = object.text("note");
    object.finish();
    return swing;
}

std::string writeElectricalJson(const ElectricalSwing& swing)
{
    JsonWriter json;
    json.beginObject();
    writeElectrical(json, swing);
    json.end();
    return json.take();
}

Result<ElectricalSwing> readElectricalJson(std::string_view text, const std::string& name)
{
    return readJsonObject<ElectricalSwing>(text, name, MARKED("core", "an electrical swing"), readElectrical);
}

} // namespace lubberline
