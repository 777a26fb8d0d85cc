#include "core/format/exchange/DueRuleJson.h"

#include "core/format/exchange/OptionalKeys.h"
#include "core/record/Ranges.h"

namespace lubberline {

void writeDueRule(JsonWriter& json, const DueRule& rule)
{
    json.text("record", rule.record);
    json.text("name", rule.name);
    json.integer("months", rule.months);
    json.integer("grace_days", rule.graceDays);
    json.integer("warn_days", rule.warnDays);
    textIfAny(json, "document", rule.document);
    textIfAny(json, "issue", rule.issue);
    textIfAny(json, "type", rule.type);
}

DueRule readDueRule(JsonObject& object)
{
    DueRule rule;
    rule.record = object.recordId("record");
    rule.name = object.requiredText("name");
    rule.months = static_cast<int>(object.requiredNumber("months", kMonthsRange));
    rule.graceDays = object.integer("grace_days", kDaysRange).value_or(0);
    rule.warnDays = object.integer("warn_days", kDaysRange).value_or(0);
    rule.document = object.text("document");
    rule.issue = object.text("issue");
    if (object.has("type"))
        rule.type = object.recordId("type");
    object.finish();
    return rule;
}

void writeWaiver(JsonWriter& json, const Waiver& waiver)
{
    json.text("record", waiver.record);
    json.text("date", waiver.date.text());
    json.text("reason", waiver.reason);
    json.text("by", waiver.by);
}

Waiver readWaiver(JsonObject& object, const RecordId& event)
{
    Waiver waiver;
    waiver.record = object.recordId("record");
    waiver.event = event;
    waiver.date = object.date("date");
    waiver.reason = object.requiredText("reason");
    waiver.by = object.requiredText("by");
    object.finish();
    return waiver;
}

} // namespace lubberline
