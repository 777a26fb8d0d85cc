#pragma once
/// The parts of the exchange file (version 3), of stored guided swings and of surveys that belong to the work on the ramp:
/// datum instruments, raw figures, signatures, compass bases, due rules and waivers. The keys of each go inside an object that
/// the caller opens and closes; readers call finish() or only() themselves where they own the whole object.

#include "core/format/json/JsonObject.h"
#include "core/format/json/JsonWriter.h"
#include "core/record/Aircraft.h"
#include "core/record/DatumInstrument.h"
#include "core/record/DueRule.h"
#include "core/record/Site.h"
#include "core/record/Swing.h"

namespace lubberline {

/// A key that is left out where nothing is stated.
void textIfAny(JsonWriter& json, std::string_view key, const std::string& value);
void numberIfAny(JsonWriter& json, std::string_view key, std::optional<double> value);

void writeInstrument(JsonWriter& json, const DatumInstrument& instrument);
[[nodiscard]] DatumInstrument readInstrument(JsonObject& object); ///< with its record; the whole object

/// "datum_read_deg", "astern_read_deg", "compass_read_deg", each where there are figures.
void writeRaw(JsonWriter& json, const RawFigures& raw);
[[nodiscard]] RawFigures readRaw(JsonObject& object);

/// The particulars of a swing that came with version 3, signatures included.
void writeRampParticulars(JsonWriter& json, const Swing& swing);
void readRampParticulars(JsonObject& object, Swing& swing);
[[nodiscard]] bool hasRampParticulars(const Swing& swing);

/// Owner, class, certificate, painted lines and survey of a compass base.
void writeBase(JsonWriter& json, const Site& site);
void readBase(JsonObject& object, Site& site);
[[nodiscard]] bool hasBase(const Site& site);

/// The survey's points alone, as one JSON text: what storage keeps. Errors: Format, InvalidInput.
[[nodiscard]] std::string writeSurvey(const std::vector<SurveyPoint>& points);
Result<std::vector<SurveyPoint>> readSurvey(std::string_view text, const std::string& name);

void writeDueRule(JsonWriter& json, const DueRule& rule);
[[nodiscard]] DueRule readDueRule(JsonObject& object);                      ///< the whole object
void writeWaiver(JsonWriter& json, const Waiver& waiver);                   ///< without the event, inside which it stands
[[nodiscard]] Waiver readWaiver(JsonObject& object, const RecordId& event); ///< the whole object

} // namespace lubberline
