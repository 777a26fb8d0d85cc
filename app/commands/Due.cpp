#include <QDateTime>

#include <cstdio>

#include <nlohmann/json.hpp>

#include "app/Console.h"
#include "app/DbStorage.h"
#include "app/QtSession.h"
#include "app/TextFile.h"
#include "app/commands/Command.h"
#include "core/due/Calendar.h"
#include "core/format/FileText.h"
#include "ui/storage/DueWork.h"

namespace lubberline::app {

namespace {

struct Options {
    std::string today, calendar;
    int within = 0;
    bool json = false, all = false;
};

struct EventOptions {
    std::string aircraft, cause, date, note, words;
};

struct WaiverOptions {
    std::string event, date, reason, by;
};

std::string todayUtc()
{
    return QDateTime::currentDateTimeUtc().date().toString(Qt::ISODate).toStdString();
}

Result<std::string> dayOr(const std::string& option, const char* name)
{
    if (option.empty())
        return todayUtc();
    if (!isIsoDate(option))
        return Error{ErrorCode::InvalidInput, std::string(name) + ": '" + option + "' is no day of the calendar; expected YYYY-MM-DD"};
    return option;
}

std::string dayOf(const DueLine& line)
{
    return line.answer.flags.empty() ? line.answer.nextByCalendar : line.answer.flags.front().since;
}

/// Due now, or by the calendar within so many days.
bool wanted(const DueLine& line, const Options& options, const std::string& today)
{
    if (options.all || line.answer.state >= DueState::Due)
        return true;
    const std::string& next = line.answer.nextByCalendar;
    return options.within > 0 ? !next.empty() && daysBetween(today, next) <= options.within : line.answer.state == DueState::DueSoon;
}

std::string jsonOf(const std::vector<DueLine>& lines, const std::string& today)
{
    nlohmann::ordered_json array = nlohmann::ordered_json::array();
    for (const auto& line : lines) {
        nlohmann::ordered_json flags = nlohmann::ordered_json::array();
        for (const auto& flag : line.answer.flags)
            flags.push_back({{"state", nameOf(flag.state)}, {"since", flag.since}, {"reason", flag.reason}, {"event", flag.event}});
        array.push_back({{"type", line.compass.typeName}, {"aircraft", line.compass.registration}, {"compass", line.compass.compassName},
            {"state", nameOf(line.answer.state)}, {"last_signed", line.answer.lastSigned}, {"next_by_calendar", line.answer.nextByCalendar}, {"flags", flags}});
    }
    return nlohmann::ordered_json{{"today", today}, {"compasses", array}}.dump(2);
}

int dueCommand(const Options& options, const std::string& database)
{
    const auto session = makeDrawingSession();
    const auto today = dayOr(options.today, "--today");
    if (!today)
        return fail(today.error());
    auto storage = openStorage(database, db::OpenMode::ReadOnly);
    if (!storage)
        return fail(storage.error());
    const auto news = ui::dueNews(**storage, *today, {});
    if (!news)
        return fail(news.error());
    std::vector<DueLine> lines;
    for (const auto& line : news->lines)
        if (wanted(line, options, *today))
            lines.push_back(line);
    for (const auto& warning : news->warnings)
        std::fprintf(stderr, "lubberline: not predicted after a move: %s\n", warning.c_str());
    if (!options.calendar.empty())
        if (const auto written = writeTextFile(options.calendar, writeCalendar(calendarOf(news->lines), *today + "T00:00:00Z")); !written)
            return fail(written.error());
    if (options.json) {
        std::printf("%s\n", jsonOf(lines, *today).c_str());
        return kDone;
    }
    std::printf("%-9s %-10s %-10s %-18s %-10s  %s\n", "state", "type", "aircraft", "compass", "since", "reason");
    for (const auto& line : lines)
        std::printf("%-9s %-10s %-10s %-18s %-10s  %s\n", std::string(nameOf(line.answer.state)).c_str(), line.compass.typeName.c_str(),
            line.compass.registration.c_str(), line.compass.compassName.c_str(), dayOf(line).c_str(),
            line.answer.flags.empty() ? "" : line.answer.flags.front().reason.c_str());
    if (news->rules.empty())
        std::fprintf(stderr, "lubberline: no calendar rule is set; only events are looked at\n");
    return kDone;
}

int eventCommand(const EventOptions& options, const std::string& database)
{
    const auto session = makeDrawingSession();
    const auto date = dayOr(options.date, "--date");
    if (!date)
        return fail(date.error());
    const auto cause = options.cause.empty() ? std::optional(causeInWords(options.words)) : dueCauseNamed(options.cause);
    if (!cause)
        return fail(Error{ErrorCode::InvalidInput, "--cause: '" + options.cause + "' is not known; expected one as lightning, hard_landing, engine_change, parts_replaced"});
    auto storage = openStorage(database, db::OpenMode::ReadWriteCreate);
    if (!storage)
        return fail(storage.error());
    const auto aircraft = (*storage)->aircraftNamed(options.aircraft);
    if (!aircraft)
        return fail(aircraft.error());
    Event event;
    event.record = newRecordId();
    event.aircraft = *aircraft;
    event.date = *date;
    event.kind = options.words;
    event.cause = *cause;
    event.note = options.note;
    if (const auto saved = (*storage)->save(event); !saved)
        return fail(saved.error());
    std::printf("%s  %s: %s\n", event.record.c_str(), std::string(nameOf(event.cause)).c_str(),
        event.cause == DueCause::Other ? "opens no due flag" : "a swing is due until a later one is signed, or a waiver answers");
    return kDone;
}

int waiveCommand(const WaiverOptions& options, const std::string& database)
{
    const auto session = makeDrawingSession();
    const auto date = dayOr(options.date, "--date");
    if (!date)
        return fail(date.error());
    auto storage = openStorage(database, db::OpenMode::ReadWriteCreate);
    if (!storage)
        return fail(storage.error());
    if (const auto saved = (*storage)->save(Waiver{{}, options.event, *date, options.reason, options.by}); !saved)
        return fail(saved.error());
    return kDone;
}

} // namespace

void addDue(CLI::App& app, Invocation& invocation)
{
    auto options = std::make_shared<Options>();
    auto* command = app.add_subcommand("due", "which compasses are to be swung, and why; the most urgent first");
    command->add_option("--today", options->today, "as if it were this day (YYYY-MM-DD); default: today, UTC");
    command->add_option("--within", options->within, "also what falls due by the calendar within so many days")->check(CLI::Range(0, 36500));
    command->add_flag("--all", options->all, "every compass");
    command->add_option("--ics", options->calendar, "write the dates as an iCalendar file");
    command->add_flag("--json", options->json, "one JSON object on standard output");
    addDatabaseOption(*command, invocation);
    command->callback([options, &invocation] { invocation.action = [options, &invocation] { return dueCommand(*options, invocation.database); }; });

    auto event = std::make_shared<EventOptions>();
    auto* record = app.add_subcommand("event", "record what happened to an aircraft; some events make a swing due");
    record->add_option("AIRCRAFT", event->aircraft, "its registration")->required();
    record->add_option("WORDS", event->words, "what happened, as \"lightning strike\"")->required();
    record->add_option("--cause", event->cause, "what it is to the due rules; default: told from the words");
    record->add_option("--date", event->date, "YYYY-MM-DD; default: today, UTC");
    record->add_option("--note", event->note, "a note");
    addDatabaseOption(*record, invocation);
    record->callback([event, &invocation] { invocation.action = [event, &invocation] { return eventCommand(*event, invocation.database); }; });

    auto waiver = std::make_shared<WaiverOptions>();
    auto* waive = app.add_subcommand("waive", "answer an event for which no swing is needed; kept for ever");
    waive->add_option("EVENT", waiver->event, "its record id, as `lubberline due --json` tells it")->required();
    waive->add_option("--reason", waiver->reason, "as \"two headings 90 degrees apart show no change\"")->required();
    waive->add_option("--by", waiver->by, "who answers for it")->required();
    waive->add_option("--date", waiver->date, "YYYY-MM-DD; default: today, UTC");
    addDatabaseOption(*waive, invocation);
    waive->callback([waiver, &invocation] { invocation.action = [waiver, &invocation] { return waiveCommand(*waiver, invocation.database); }; });
}

} // namespace lubberline::app
