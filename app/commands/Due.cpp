#include <array>
#include <set>

#include "app/Console.h"
#include "app/OpenStores.h"
#include "app/Outputs.h"
#include "app/Paths.h"
#include "app/QtSession.h"
#include "app/commands/Command.h"
#include "core/base/NearWord.h"
#include "core/base/OutputFile.h"
#include "core/base/TerminalText.h"
#include "core/format/json/JsonWriter.h"
#include "core/format/results/DueJson.h"
#include "core/record/RecordWords.h"
#include "ui/due/DueWork.h"

namespace lubberline::app {

namespace {

struct DueArguments {
    std::string today;
    Output calendar;
    int within = 0;
    bool json = false, all = false;
};

struct EventOptions {
    std::string aircraft, cause, date, note, words;
    bool json = false;
};

struct WaiverOptions {
    std::string event, date, reason, by;
    bool json = false;
};

Result<Date> dayOr(const std::string& option, const char* name)
{
    if (option.empty())
        return today();
    const auto day = Date::read(option);
    if (!day)
        return Error{
            ErrorCode::InvalidInput, {MARKED("app", "%1: '%2' is no day of the calendar; expected YYYY-MM-DD"), std::string(name), option}};
    return *day;
}

Date dayOf(const DueLine& line) { return line.answer.flags.empty() ? line.answer.nextByCalendar : line.answer.flags.front().since; }

/// Due now, or by the calendar within so many days.
bool wanted(const DueLine& line, const DueArguments& options, Date today)
{
    if (options.all || line.answer.state >= DueState::Due)
        return true;
    const Date next = line.answer.nextByCalendar;
    return options.within > 0 ? !next.empty() && daysBetween(today, next) <= options.within : line.answer.state == DueState::DueSoon;
}

/// With the event by which `waive` answers it.
std::string reasonOf(const DueLine& line)
{
    constexpr std::size_t kEnough = 8;
    if (line.answer.flags.empty())
        return {};
    const DueFlag& flag = line.answer.flags.front();
    const std::string more = line.answer.flags.size() > 1 ? text(", and %zu more", line.answer.flags.size() - 1) : std::string();
    return flag.reason.english() + (flag.event.empty() ? "" : " [event " + flag.event.substr(0, kEnough) + "]") + more;
}

void print(const std::vector<DueLine>& lines)
{
    put("%-9s %-10s %-10s %-18s %-10s  %s\n", "state", "type", "aircraft", "compass", "since", "reason");
    for (const auto& line : lines)
        put("%-9s %-10s %-10s %-18s %-10s  %s\n", std::string(nameOf(line.answer.state)).c_str(), inOneLine(line.compass.typeName).c_str(),
            inOneLine(line.compass.registration).c_str(), inOneLine(line.compass.compassName).c_str(), dayOf(line).text().c_str(),
            inOneLine(reasonOf(line)).c_str());
}

int dueCommand(const DueArguments& options, const std::string& database)
{
    const auto session = makeDrawingSession();
    const auto today = dayOr(options.today, "--today");
    if (!today)
        return fail(today.error());
    auto stores = openStores(database, db::OpenMode::ReadOnly);
    if (!stores)
        return fail(stores.error());
    auto forecasts = ui::dueForecasts(**stores, *today, consoleProgress("the history of the fleet"));
    if (!forecasts)
        return fail(forecasts.error());
    const auto news = ui::dueNews(**stores, *today, {}, std::move(forecasts.value()));
    if (!news)
        return fail(news.error());
    std::vector<DueLine> lines;
    for (const auto& line : news->lines)
        if (wanted(line, options, *today))
            lines.push_back(line);
    for (const auto& warning : news->warnings)
        say("not predicted after a move: " + warning.english());
    if (!options.calendar.empty()) {
        if (const auto written
            = writeWholeFile(options.calendar.path, writeCalendar(calendarOf(news->lines), today->text() + "T00:00:00Z"));
            !written)
            return fail(written.error());
        if (options.calendar.toStandardOutput())
            return kDone;
    }
    if (options.json)
        putText(toJson(lines, news->warnings, *today));
    else
        print(lines);
    if (news->rules.empty())
        say("no calendar rule is set; only events are looked at");
    return kDone;
}

/// For writing. A database that is not there is an error, not made: what is recorded is of an aircraft that is known.
Result<std::unique_ptr<db::Stores>> openKnown(const std::string& database)
{
    if (const auto there = openStores(database, db::OpenMode::ReadOnly); !there && there.error().code == ErrorCode::NotFound)
        return there.error();
    return openStores(database, db::OpenMode::ReadWriteCreate);
}

Result<DueCause> causeOf(const EventOptions& options)
{
    if (options.cause.empty())
        return causeInWords(options.words);
    if (const auto cause = choiceOf<DueCause>(options.cause))
        return *cause;
    std::array<std::string_view, kDueCauses> names;
    std::string known;
    for (int i = 0; i < kDueCauses; ++i) {
        names[static_cast<std::size_t>(i)] = fileWord(static_cast<DueCause>(i));
        known += (i > 0 ? ", " : "") + std::string(fileWord(static_cast<DueCause>(i)));
    }
    const auto near = nearWord(options.cause, names);
    return Error{ErrorCode::InvalidInput,
        near.empty()
            ? Message{MARKED("app", "--cause: '%1' is not known; expected one of %2"), options.cause, known}
            : Message{MARKED("app", "--cause: '%1' is not known; expected one of %2 (did you mean %3?)"), options.cause, known, near}};
}

/// What the event makes due now, in words: as the list will tell it.
Result<Message> dueBy(db::Stores& stores, const Event& event)
{
    if (event.cause == DueCause::Other)
        return Message(MARKED("app", "opens no due flag"));
    auto compasses = stores.due.compasses();
    if (!compasses)
        return compasses.error();
    std::erase_if(*compasses, [&](const DueCompass& one) { return one.aircraft != event.aircraft; });
    std::vector<Message> due;
    Date answered;
    for (const DueLine& line : dueList(*compasses, {}, {}, today())) {
        const auto flag = std::ranges::find(line.answer.flags, event.record, &DueFlag::event);
        if (flag != line.answer.flags.end())
            due.push_back({MARKED("app", "%1: %2"), line.compass.compassName, flag->reason});
        else
            answered = std::max(answered, line.answer.lastSigned);
    }
    if (!due.empty())
        return Message{MARKED("app", "a swing is due until a later one is signed, or a waiver answers (%1)"), together(due)};
    if (event.date > today())
        return Message{MARKED("app", "is still to come: a swing is due from %1 on"), event.date};
    return answered.empty() ? Message(MARKED("app", "the aircraft has no compass that it makes due"))
                            : Message{MARKED("app", "makes nothing due: the swing of %1 was signed after it"), answered};
}

int eventCommand(const EventOptions& options, const std::string& database)
{
    const auto session = makeDrawingSession();
    const auto date = dayOr(options.date, "--date");
    const auto cause = causeOf(options);
    if (!date || !cause)
        return fail(date ? cause.error() : date.error());
    auto stores = openKnown(database);
    if (!stores)
        return fail(stores.error());
    const auto aircraft = (*stores)->fleet.aircraftNamed(options.aircraft);
    if (!aircraft)
        return fail(aircraft.error());
    Event event;
    event.record = newRecordId();
    event.aircraft = *aircraft;
    event.date = *date;
    event.kind = options.words.empty() ? inWords(*cause) : options.words;
    event.cause = *cause;
    event.note = options.note;
    if (const auto saved = (*stores)->fleet.add(event); !saved)
        return fail(saved.error());
    if (options.json) {
        JsonWriter json;
        json.beginObject();
        json.text("event", event.record);
        json.text("cause", fileWord(event.cause));
        json.text("date", event.date.text());
        json.end();
        putText(json.take());
        return kDone;
    }
    const auto what = dueBy(**stores, event);
    if (!what)
        return fail(what.error());
    put("%s  %s: %s\n", event.record.c_str(), std::string(fileWord(event.cause)).c_str(), what->english().c_str());
    return kDone;
}

/// By its record id, or as much of its beginning as tells it apart.
Result<RecordId> eventNamed(db::Stores& stores, const std::string& id)
{
    const auto compasses = stores.due.compasses();
    if (!compasses)
        return compasses.error();
    std::set<RecordId> found;
    for (const auto& compass : *compasses)
        for (const auto& event : compass.events)
            if (!id.empty() && event.record.starts_with(id))
                found.insert(event.record);
    if (found.empty())
        return Error{ErrorCode::NotFound, {MARKED("app", "there is no event '%1'; expected a record id as `lubberline due` tells it"), id}};
    if (found.size() > 1)
        return Error{ErrorCode::InvalidInput, {MARKED("app", "'%1' begins %2 events; expected more of the record id"), id, found.size()}};
    return *found.begin();
}

int waiveCommand(const WaiverOptions& options, const std::string& database)
{
    const auto session = makeDrawingSession();
    const auto date = dayOr(options.date, "--date");
    if (!date)
        return fail(date.error());
    auto stores = openKnown(database);
    if (!stores)
        return fail(stores.error());
    const auto event = eventNamed(**stores, options.event);
    if (!event)
        return fail(event.error());
    const Waiver waiver{newRecordId(), *event, *date, options.reason, options.by};
    if (const auto saved = (*stores)->due.add(waiver); !saved)
        return fail(saved.error());
    if (options.json) {
        JsonWriter json;
        json.beginObject();
        json.text("waiver", waiver.record);
        json.text("event", waiver.event);
        json.end();
        putText(json.take());
    } else {
        put("%s  answers event %s; kept for ever\n", waiver.record.c_str(), waiver.event.c_str());
    }
    return kDone;
}

} // namespace

void addDue(CLI::App& app, Invocation& invocation)
{
    auto options = std::make_shared<DueArguments>();
    auto* command = app.add_subcommand("due", "which compasses are to be swung, and why; the most urgent first");
    command->add_option("--today", options->today, "as if it were this day (YYYY-MM-DD); default: today, UTC");
    command->add_option("--within", options->within, "also what falls due by the calendar within so many days")
        ->check(CLI::Range(0, 36500));
    command->add_flag("--all", options->all, "every compass");
    addOutputOption(*command, invocation, "--ics", options->calendar, "write the dates as an iCalendar file", {".ics"});
    command->add_flag("--json", options->json, "one JSON object on standard output");
    addDatabaseOption(*command, invocation);
    command->callback(
        [options, &invocation] { invocation.action = [options, &invocation] { return dueCommand(*options, invocation.database); }; });

    auto event = std::make_shared<EventOptions>();
    auto* record = app.add_subcommand("event", "record what happened to an aircraft; some events make a swing due");
    record->add_option("AIRCRAFT", event->aircraft, "its registration")->required();
    auto* words
        = record->add_option("WORDS", event->words, "what happened, as \"lightning strike\"; may be left out where --cause says it");
    auto* cause = record->add_option("--cause", event->cause, "what it is to the due rules, as lightning; default: told from the words");
    record->add_option("--date", event->date, "YYYY-MM-DD; default: today, UTC");
    record->add_option("--note", event->note, "a note");
    record->add_flag("--json", event->json, "one JSON object on standard output");
    addDatabaseOption(*record, invocation);
    record->callback([event, words, cause, &invocation] {
        if (words->empty() && cause->empty())
            throw CLI::RequiredError("WORDS or --cause: what happened");
        invocation.action = [event, &invocation] { return eventCommand(*event, invocation.database); };
    });

    auto waiver = std::make_shared<WaiverOptions>();
    auto* waive = app.add_subcommand("waive", "answer an event for which no swing is needed; kept for ever");
    waive->add_option("EVENT", waiver->event, "its record id or the beginning of it, as `lubberline due` tells it")->required();
    waive->add_option("--reason", waiver->reason, "as \"two headings 90 degrees apart show no change\"")->required();
    waive->add_option("--by", waiver->by, "who answers for it")->required();
    waive->add_option("--date", waiver->date, "YYYY-MM-DD; default: today, UTC");
    waive->add_flag("--json", waiver->json, "one JSON object on standard output");
    addDatabaseOption(*waive, invocation);
    waive->callback(
        [waiver, &invocation] { invocation.action = [waiver, &invocation] { return waiveCommand(*waiver, invocation.database); }; });
}

} // namespace lubberline::app
