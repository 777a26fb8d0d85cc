#pragma once
/// Compass bases as JSON: what a site holds since version 3 of the exchange file, and its survey as storage keeps it.

#include <string>
#include <string_view>
#include <vector>

#include "core/base/Result.h"
#include "core/format/json/JsonObject.h"
#include "core/format/json/JsonWriter.h"
#include "core/record/Site.h"

namespace lubberline {

/// Owner, class, certificate, painted lines and survey. The keys go inside an object that the caller opens and closes.
void writeBase(JsonWriter& json, const Site& site);
void readBase(JsonObject& object, Site& site);
[[nodiscard]] bool hasBase(const Site& site);

/// The survey's points alone, as one JSON text: what storage keeps. Errors: Format, InvalidInput.
[[nodiscard]] std::string writeSurvey(const std::vector<SurveyPoint>& points);
Result<std::vector<SurveyPoint>> readSurvey(std::string_view text, const std::string& name);

} // namespace lubberline
