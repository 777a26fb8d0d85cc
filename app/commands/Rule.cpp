#include <algorithm>
#include <cstdio>

#include "app/Console.h"
#include "app/OpenStores.h"
#include "app/QtSession.h"
#include "app/commands/Command.h"
#include "core/base/TerminalText.h"
#include "core/due/DueList.h"
#include "core/format/json/JsonWriter.h"

namespace lubberline::app {

namespace {

/// What is not said stays as it is on record.
struct RuleArguments {
    std::string name;
    std::optional<int> months, grace, warn;
    std::optional<std::string> document, issue, type;
    bool known = false, remove = false, json = false;
    [[nodiscard]] bool writes() const { return known || !name.empty(); }
};

/// Types by name: those that have a compass, as rules are of no use to others.
struct TypeNames {
    std::vector<std::pair<RecordId, std::string>> names;

    [[nodiscard]] std::string nameOf(const RecordId& record) const
    {
        const auto found = std::find_if(names.begin(), names.end(), [&](const auto& one) { return one.first == record; });
        return found == names.end() ? std::string() : found->second;
    }
    [[nodiscard]] Result<RecordId> named(const std::string& name) const
    {
        if (name.empty() || name == "all")
            return RecordId();
        const auto found = std::find_if(names.begin(), names.end(), [&](const auto& one) { return one.second == name; });
        if (found == names.end())
            return Error{ErrorCode::NotFound,
                {MARKED("app", "there is no aircraft type '%1' with a compass; expected one of the fleet, or all"), name}};
        return found->first;
    }
};

Result<TypeNames> typesOf(db::Stores& stores)
{
    const auto compasses = stores.due.compasses();
    if (!compasses)
        return compasses.error();
    TypeNames types;
    for (const auto& one : *compasses)
        if (types.nameOf(one.typeRecord).empty())
            types.names.emplace_back(one.typeRecord, one.typeName);
    return types;
}

Result<void> addKnown(db::Stores& stores, const std::vector<DueRule>& rules)
{
    for (const DueRule& known : knownRules()) {
        const bool there = std::any_of(rules.begin(), rules.end(), [&](const DueRule& rule) { return rule.name == known.name; });
        if (there)
            continue;
        if (const auto stored = stores.due.add(known); !stored)
            return stored.error();
    }
    return {};
}

Result<void> change(db::Stores& stores, const std::vector<DueRule>& rules, const TypeNames& types, const RuleArguments& options)
{
    const auto there = std::find_if(rules.begin(), rules.end(), [&](const DueRule& rule) { return rule.name == options.name; });
    if (options.remove && there == rules.end())
        return Error{
            ErrorCode::NotFound, {MARKED("app", "there is no rule '%1'; expected one that `lubberline rule` lists"), options.name}};
    if (options.remove)
        return stores.due.removeRule(there->record);
    DueRule rule = there == rules.end() ? DueRule() : *there;
    rule.name = options.name;
    rule.months = options.months.value_or(rule.months);
    rule.graceDays = options.grace.value_or(rule.graceDays);
    rule.warnDays = options.warn.value_or(rule.warnDays);
    rule.document = options.document.value_or(rule.document);
    rule.issue = options.issue.value_or(rule.issue);
    if (options.type) {
        const auto type = types.named(*options.type);
        if (!type)
            return type.error();
        rule.type = *type;
    }
    if (there != rules.end())
        return stores.due.change(*there, rule);
    return noValue(stores.due.add(rule));
}

std::string jsonOf(const std::vector<DueRule>& rules, const TypeNames& types)
{
    JsonWriter json;
    json.beginObject();
    json.beginArray("rules");
    for (const auto& rule : rules) {
        json.beginObject();
        json.text("name", rule.name);
        json.integer("months", rule.months);
        json.integer("grace_days", rule.graceDays);
        json.integer("warn_days", rule.warnDays);
        json.text("document", rule.document);
        json.text("issue", rule.issue);
        if (rule.type.empty())
            json.null("type");
        else
            json.text("type", types.nameOf(rule.type));
        json.end();
    }
    json.end();
    json.end();
    return json.take();
}

void print(const std::vector<DueRule>& rules, const TypeNames& types)
{
    put("%-28s %6s %12s %11s  %-10s  %s\n", "rule", "months", "grace (days)", "warn (days)", "type", "document, issue");
    for (const auto& rule : rules)
        put("%-28s %6d %12d %11d  %-10s  %s\n", inOneLine(rule.name).c_str(), rule.months, rule.graceDays, rule.warnDays,
            rule.type.empty() ? "all" : inOneLine(types.nameOf(rule.type)).c_str(),
            inOneLine(rule.document + (rule.issue.empty() ? "" : ", " + rule.issue)).c_str());
}

int ruleCommand(const RuleArguments& options, const std::string& database)
{
    const auto session = makeDrawingSession();
    if (const auto there = openStores(database, db::OpenMode::ReadOnly); !there && there.error().code == ErrorCode::NotFound)
        return fail(there.error()); // a rule makes no database
    auto stores = openStores(database, options.writes() ? db::OpenMode::ReadWriteCreate : db::OpenMode::ReadOnly);
    if (!stores)
        return fail(stores.error());
    const auto types = typesOf(**stores);
    auto rules = (*stores)->due.rules();
    if (!types || !rules)
        return fail(types ? rules.error() : types.error());
    if (options.writes()) {
        const auto done = options.known ? addKnown(**stores, *rules) : change(**stores, *rules, *types, options);
        if (!done)
            return fail(done.error());
        rules = (*stores)->due.rules();
        if (!rules)
            return fail(rules.error());
    }
    if (options.json)
        putText(jsonOf(*rules, *types));
    else
        print(*rules, *types);
    return kDone;
}

} // namespace

void addRule(CLI::App& app, Invocation& invocation)
{
    constexpr int kMost = 100000;
    auto options = std::make_shared<RuleArguments>();
    auto* command
        = app.add_subcommand("rule", "calendar rules: after how many months a compass is to be swung; without a name, those that are set");
    auto* name = command->add_option("NAME", options->name, "the rule to make or change");
    command->add_option("--months", options->months, "after the last signed swing; default: 24")->check(CLI::Range(1, kMost))->needs(name);
    command->add_option("--grace", options->grace, "overdue only after so many days more; default: 0")
        ->check(CLI::Range(0, kMost))
        ->needs(name);
    command->add_option("--warn", options->warn, "due soon so many days before; default: 30")->check(CLI::Range(0, kMost))->needs(name);
    command->add_option("--document", options->document, "where the rule stands")->needs(name);
    command->add_option("--issue", options->issue, "and its issue")->needs(name);
    command->add_option("--type", options->type, "for this aircraft type only; its own rule goes before one for all")->needs(name);
    auto* remove = command->add_flag("--remove", options->remove, "remove the rule")->needs(name);
    command->add_flag("--known", options->known, "take over the rules whose source was read: CASA, South Africa")
        ->excludes(name)
        ->excludes(remove);
    command->add_flag("--json", options->json, "one JSON object on standard output");
    addDatabaseOption(*command, invocation);
    command->callback(
        [options, &invocation] { invocation.action = [options, &invocation] { return ruleCommand(*options, invocation.database); }; });
}

} // namespace lubberline::app
