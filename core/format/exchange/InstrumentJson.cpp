#include "core/format/exchange/InstrumentJson.h"

#include "core/format/exchange/OptionalKeys.h"
#include "core/format/exchange/RecordChoice.h"
#include "core/record/Ranges.h"

namespace lubberline {

void writeInstrument(JsonWriter& json, const DatumInstrument& instrument)
{
    textIfAny(json, "record", instrument.record);
    textIfAny(json, "name", instrument.name);
    json.text("kind", fileWord(instrument.kind));
    textIfAny(json, "maker", instrument.maker);
    textIfAny(json, "serial_number", instrument.serialNumber);
    textIfAny(json, "calibration_due", instrument.calibrationDue);
    json.text("ahead", fileWord(instrument.ahead));
    json.boolean("gives_true", instrument.givesTrue);
    json.number("zero_deg", instrument.zero_deg);
    json.number("resolution_deg", instrument.resolution_deg);
    textIfAny(json, "note", instrument.note);
}

DatumInstrument readInstrument(JsonObject& object)
{
    DatumInstrument instrument;
    if (object.has("record"))
        instrument.record = object.recordId("record");
    instrument.name = object.text("name");
    instrument.kind = choice<DatumKind>(object, "kind");
    instrument.maker = object.text("maker");
    instrument.serialNumber = object.text("serial_number");
    instrument.calibrationDue = object.date("calibration_due");
    instrument.ahead = choice<SightingDirection>(object, "ahead");
    instrument.givesTrue = object.boolean("gives_true");
    instrument.zero_deg = object.requiredNumber("zero_deg", kFigureRange);
    instrument.resolution_deg = object.requiredNumber("resolution_deg", kInstrumentResolutionRange);
    instrument.note = object.text("note");
    object.finish();
    return instrument;
}

} // namespace lubberline
