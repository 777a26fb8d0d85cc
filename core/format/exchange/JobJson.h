#pragma once
/// Guided swings as JSON: the plan, and the events in the order in which they happened. The particulars are those of the swing
/// that the job belongs to, and are not repeated here.

#include <string>
#include <string_view>

#include "core/base/Result.h"
#include "core/record/SwingJob.h"

namespace lubberline {

class JsonObject;
class JsonWriter;

/// One event in one line, without a line end: what storage keeps the moment it happens.
[[nodiscard]] std::string writeJobEvent(const JobEvent& event);
/// Errors: Format, InvalidInput, naming the key. `name` is named in errors.
Result<JobEvent> readJobEvent(std::string_view text, const std::string& name);

/// Plan, datum instrument, checklist and resolution, without the events.
[[nodiscard]] std::string writeJobPlan(const SwingJob& job);
Result<SwingJob> readJobPlan(std::string_view text, const std::string& name);

/// The keys of a whole job (record, plan, events) inside another object: for the exchange file.
void writeJob(JsonWriter& json, const SwingJob& job);
[[nodiscard]] SwingJob readJob(JsonObject& object);

} // namespace lubberline
