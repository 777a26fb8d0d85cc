#include "core/format/exchange/SignedContent.h"

#include <nlohmann/json.hpp>

#include "core/format/exchange/Exchange.h"
#include "core/format/exchange/OptionalKeys.h"
#include "core/format/exchange/RecordChoice.h"
#include "core/format/json/JsonDocument.h"
#include "core/format/json/ReadObject.h"
#include "core/record/RecordWords.h"

namespace lubberline {

namespace {

using OrderedJson = nlohmann::ordered_json;

constexpr std::string_view kHeadOfThird = "lubberline signed content 3\n";

Swing withoutState(const Swing& swing)
{
    Swing bare = swing;
    bare.state = SwingState::Draft;
    bare.signatures.clear();
    return bare;
}

/// What all versions say of a signature.
void writeWho(JsonWriter& json, const Signature& one)
{
    json.text("role", fileWord(one.role));
    json.text("name", one.name);
    json.text("licence", one.licence);
    json.text("time_utc", one.timeUtc);
    textIfAny(json, "key", one.key);
}

std::string signerText(const Signature& signature, std::span<const Signature> before)
{
    JsonWriter json;
    json.beginObject();
    writeWho(json, signature);
    json.text("file", signature.file);
    json.text("file_head", signature.fileHead);
    json.text("record_head", signature.recordHead);
    json.beginArray("before");
    for (const Signature& one : before) {
        json.beginObject();
        writeWho(json, one);
        json.integer("contents", one.contents);
        json.text("hash", one.hash);
        json.end();
    }
    json.end();
    json.end();
    return json.take();
}

/// The swing beside the particulars that the signature keeps. What does not read stands there as it is: no signature holds over it.
std::string swingText(const SwingRecord& record, const std::optional<SwingJob>& job, const std::string& particulars)
{
    auto fleet = readExchange(particulars, "particulars");
    if (!fleet || fleet->compasses.size() != 1 || fleet->sites.size() > 1)
        return particulars;
    Swing swing = withoutState(record.swing);
    swing.id = SwingId{1};
    swing.compass = fleet->compasses.front().id;
    swing.site = fleet->sites.empty() ? SiteId{} : fleet->sites.front().id;
    fleet->swings = {std::move(swing)};
    if (job) {
        fleet->jobs = {{SwingId{1}, *job}};
        fleet->jobs.front().job.particulars = {};
    }
    return writeExchange(*fleet);
}

struct Part {
    Pattern what; ///< of which of the particulars a key speaks
    OrderedJson now, then;
};

/// What of it is printed: neither who refers to what, nor notes.
OrderedJson printed(OrderedJson object)
{
    for (const char* key : {"record", "type", "limits", "base", "note", "compasses", "events", "survey"})
        object.erase(key);
    return object;
}

OrderedJson firstOf(const OrderedJson& document, const char* key)
{
    const auto found = document.find(key);
    return found == document.end() || found->empty() ? OrderedJson::object() : found->front();
}

std::string shown(const OrderedJson& object, const std::string& key)
{
    const auto found = object.find(key);
    if (found == object.end())
        return {};
    return found->is_string() ? found->get<std::string>() : found->dump();
}

/// Null where they do not read: they may be a forger's, nested a million deep, which no copy of such a document survives.
OrderedJson readParticulars(const std::string& text)
{
    return parseJson(text, {}, {}).ok() ? OrderedJson::parse(text, nullptr, false) : OrderedJson();
}

} // namespace

std::string signedContent(const SwingRecord& record, const std::optional<SwingJob>& job, int version)
{
    SwingRecord bare;
    bare.swing = withoutState(record.swing);
    bare.type.record = bare.type.name = record.type.record;
    bare.aircraft.record = bare.aircraft.registration = record.aircraft.record;
    bare.compass.record = bare.compass.name = record.compass.record;
    if (record.site) {
        bare.site.emplace();
        bare.site->record = bare.site->name = record.site->record;
    }
    Fleet fleet = toFleet(bare);
    if (job) {
        fleet.jobs = {{fleet.swings.front().id, *job}};
        fleet.jobs.front().job.particulars = {};
    }
    const std::string text = writeExchange(fleet);
    return version == 1 ? text : "lubberline signed content " + std::to_string(version) + "\n" + text;
}

std::string signedContent(
    const SwingRecord& record, const std::optional<SwingJob>& job, const Signature& signature, std::span<const Signature> before)
{
    if (signature.contents < 3)
        return signedContent(record, job, signature.contents);
    return std::string(kHeadOfThird) + signerText(signature, before) + swingText(record, job, signature.particulars);
}

Result<Signature> signerIn(const std::string& content, const std::string& name)
{
    const std::string_view end = "\n}\n"; // of the first object, whose keys are indented
    const auto last = content.find(end);
    if (!content.starts_with(kHeadOfThird) || last == std::string::npos)
        return Error{
            ErrorCode::Format, MARKED("core", "this is no signed content of version 3; expected what `export --signature` writes"), name};
    const std::string_view text(content);
    const auto object = text.substr(kHeadOfThird.size(), last + end.size() - kHeadOfThird.size());
    return readJsonObject<Signature>(object, name, MARKED("core", "signed content"), [](JsonObject& one) {
        one.only({"role", "name", "licence", "time_utc", "key", "file", "file_head", "record_head", "before"});
        Signature signature;
        signature.role = choice<SignatureRole>(one, "role");
        signature.name = one.requiredText("name");
        signature.licence = one.text("licence");
        signature.timeUtc = one.requiredText("time_utc");
        signature.key = one.text("key");
        signature.file = one.text("file");
        signature.fileHead = one.text("file_head");
        signature.recordHead = one.text("record_head");
        signature.contents = 3;
        return signature;
    });
}

std::string signedParticulars(const SwingRecord& record)
{
    Fleet fleet = toFleet(record);
    fleet.swings.clear();
    return writeExchange(fleet);
}

std::vector<SwingDifference> changedSince(const std::string& particulars, const SwingRecord& now)
{
    const OrderedJson then = readParticulars(particulars), today = readParticulars(signedParticulars(now));
    if (!then.is_object())
        return {{MARKED("core", "particulars"), Message(MARKED("core", "do not read")), Message(MARKED("core", "changed"))}};
    const auto compassOf = [](const OrderedJson& document) { return printed(firstOf(firstOf(document, "aircraft"), "compasses")); };
    const auto partOf = [](const OrderedJson& document, const char* key) { return printed(firstOf(document, key)); };
    const Part parts[] = {
        {MARKED("core", "%1 of the type"), partOf(today, "types"), partOf(then, "types")},
        {MARKED("core", "%1 of the aircraft"), partOf(today, "aircraft"), partOf(then, "aircraft")},
        {MARKED("core", "%1 of the compass"), compassOf(today), compassOf(then)},
        {MARKED("core", "%1 of the site"), partOf(today, "sites"), partOf(then, "sites")},
        {MARKED("core", "%1 of the limits"), partOf(today, "limits"), partOf(then, "limits")},
    };
    std::vector<SwingDifference> all;
    for (const Part& part : parts) {
        OrderedJson keys = part.then;
        keys.update(part.now);
        for (const auto& [key, value] : keys.items()) {
            const std::string before = shown(part.then, key), after = shown(part.now, key);
            if (before != after)
                all.push_back({{part.what, key}, Message::verbatim(before), Message::verbatim(after)});
        }
    }
    return all;
}

} // namespace lubberline
