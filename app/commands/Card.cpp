#include <algorithm>
#include <cstdio>

#include <nlohmann/json.hpp>

#include "app/CardSource.h"
#include "app/Console.h"
#include "app/OpenStores.h"
#include "app/Outputs.h"
#include "app/Paths.h"
#include "app/QtSession.h"
#include "app/Tables.h"
#include "app/commands/Command.h"
#include "core/angle/PrintedHeading.h"
#include "core/format/results/AnalysisJson.h"
#include "core/record/RecordWords.h"
#include "ui/report/page/DataHash.h"
#include "ui/swing/RecordDocuments.h"

namespace lubberline::app {

namespace {

struct CardArguments {
    std::string file, second, swing, from = "fit", by = "magnetic", form = "placard";
    Output output;
    std::optional<double> at_deg;
    CardOptions card;
    bool json = false;
};

/// Whose figures a column has, and whether a signature stands for them.
nlohmann::ordered_json jsonOf(const ui::CardColumn& column)
{
    auto object = nlohmann::ordered_json::parse(toJson(column.card, column.record));
    object["record"] = column.record.swing.record;
    object["data_sha256"] = ui::dataHash(column.record).toStdString();
    object["state"] = std::string(fileWord(column.record.swing.state));
    object["signed"] = column.isSigned();
    object["out_of_limits"] = column.outOfLimits();
    return object;
}

/// What is between the rows, where it was asked for.
nlohmann::ordered_json jsonOf(double at_deg, const BetweenRows& between)
{
    return {{"heading_deg", at_deg}, {"interpolated_deg", between.interpolated_deg},
        {"curve_deg", between.curve_deg ? nlohmann::ordered_json(*between.curve_deg) : nlohmann::ordered_json()}};
}

/// The contract's object; a second card stands in it under "second_column".
std::string jsonOf(const ui::CardInput& input, const std::vector<BetweenRows>& between, std::optional<double> at_deg)
{
    auto object = jsonOf(input.columns.front());
    if (at_deg)
        object["at"] = jsonOf(*at_deg, between.front());
    if (input.columns.size() > 1) {
        object["heading"] = input.columns[0].heading.toStdString();
        object["second_column"] = jsonOf(input.columns[1]);
        object["second_column"]["heading"] = input.columns[1].heading.toStdString();
        if (at_deg)
            object["second_column"]["at"] = jsonOf(*at_deg, between[1]);
    }
    return object.dump(2);
}

std::string textOf(const ui::CardInput& input, const std::vector<BetweenRows>& between, double at_deg)
{
    std::string out;
    for (std::size_t i = 0; i < between.size(); ++i) {
        out += text("%s %05.1f: %05.1f between the rows", input.columns[i].heading.toStdString().c_str(), printedHeading_deg(at_deg, 1),
            printedHeading_deg(between[i].interpolated_deg, 1));
        out += between[i].curve_deg ? text(", %05.1f by the curve\n", printedHeading_deg(*between[i].curve_deg, 1)) : "\n";
    }
    return out;
}

/// A signed card that is written is the first or a reprint: the database remembers. One that cannot be written to is none the worse.
void noteWritten(const ui::CardInput& input, const std::string& database)
{
    if (std::none_of(input.columns.begin(), input.columns.end(), [](const ui::CardColumn& column) { return column.isSigned(); }))
        return;
    auto stores = openStores(database, db::OpenMode::ReadWriteCreate);
    const auto noted = stores ? ui::noteCards(**stores, input) : Result<void>(stores.error());
    if (!noted)
        say("the next card of it will not be called a reprint: " + describe(noted.error()));
}

int writeCardFile(const CardArguments& options, ui::CardInput input, const std::string& database)
{
    input.madeAtUtc = nowUtc();
    if (const auto written = ui::writeCard(input, QString::fromStdString(options.output.path)); !written)
        return fail(written.error());
    sayWritten(options.output);
    if (!options.swing.empty())
        noteWritten(input, database);
    return kDone;
}

/// The forms that are made of a record of the database alone.
int writeForm(const CardArguments& options, db::Stores& stores, SwingId swing)
{
    const QString path = QString::fromStdString(options.output.path);
    Result<void> written;
    if (options.form == "job") {
        const auto input = ui::jobCardOf(stores, swing, nowUtc());
        written = input ? ui::writeJobCard(*input, path) : Result<void>(input.error());
    } else {
        const auto sheet = ui::sheet1613Of(stores, swing, nowUtc());
        written = sheet ? ui::write1613(*sheet, path) : Result<void>(sheet.error());
    }
    if (!written)
        return fail(written.error());
    sayWritten(options.output);
    return kDone;
}

Result<CardSheet> cardFromDatabase(db::Stores& stores, SwingId swing, const CardOptions& options)
{
    auto input = ui::cardOf(stores, swing, options, nowUtc(), true);
    if (!input)
        return input.error();
    CardSheet sheet{std::move(input.value()), {}, {}};
    for (const auto& column : sheet.input.columns) {
        auto analysis = stores.results.resultOf(column.record);
        if (!analysis)
            return analysis.error();
        sheet.analyses.push_back(std::move(analysis.value()));
    }
    return sheet;
}

int cardCommand(CardArguments options, const std::string& database)
{
    options.card.source = options.from == "fit" ? CardSource::Fit : CardSource::Readings;
    options.card.by = options.by == "magnetic" ? CardBy::Magnetic : CardBy::Compass;
    const bool placard = options.form == "placard" || options.form == "card";
    if (!options.second.empty() && options.file.empty()) {
        say("card: --second expects a Swing CSV before it; a swing of the database finds its other radio state by itself");
        return kUsage;
    }
    if (options.file.empty() == options.swing.empty() || (!placard && (options.swing.empty() || options.output.empty()))) {
        say(placard ? "card: expected a Swing CSV or --swing ID, and not both"
                    : "card: --form " + options.form + " expects --swing ID and --output FILE.pdf");
        return kUsage;
    }
    // One for the storage and the drawing: Qt takes its options only once.
    const auto session = options.swing.empty() && options.output.empty() ? nullptr : makeDrawingSession();
    Result<CardSheet> sheet = CardSheet{};
    if (options.swing.empty()) {
        std::vector<std::string> files{options.file};
        if (!options.second.empty())
            files.push_back(options.second);
        sheet = cardFromFiles(files, options.card);
    } else {
        auto stores = openStores(database, db::OpenMode::ReadOnly);
        if (!stores)
            return fail(stores.error());
        const auto id = (*stores)->swings.named(options.swing);
        if (!id)
            return fail(id.error());
        if (!placard)
            return writeForm(options, **stores, *id);
        sheet = cardFromDatabase(**stores, *id, options.card);
    }
    if (!sheet)
        return fail(sheet.error());
    warn(sheet->warnings);
    std::vector<BetweenRows> between;
    for (std::size_t i = 0; options.at_deg && i < sheet->input.columns.size(); ++i) {
        const auto one = betweenRows(sheet->analyses[i], sheet->input.columns[i].card, *options.at_deg);
        if (!one)
            return fail(one.error());
        between.push_back(*one);
    }
    if (options.output.toStandardOutput())
        return writeCardFile(options, sheet->input, database);
    if (options.json)
        put("%s\n", jsonOf(sheet->input, between, options.at_deg).c_str());
    else if (options.output.empty())
        putText(tableOf(sheet->input) + (options.at_deg ? textOf(sheet->input, between, *options.at_deg) : ""));
    return options.output.empty() ? kDone : writeCardFile(options, sheet->input, database);
}

} // namespace

void addCard(CLI::App& app, Invocation& invocation)
{
    auto options = std::make_shared<CardArguments>();
    auto* command = app.add_subcommand("card", "the correction card: what to steer by compass");
    addInputOption(*command, invocation, "SWING.csv", options->file, "a Swing CSV");
    command->add_option(
        "--swing", options->swing, "a swing of the database, to print its card again: its record id or the beginning of it");
    command
        ->add_option("--form", options->form,
            "placard (or card): FOR and STEER, cut to size; dd1613: a sheet in the style of DD 1613; job: a blank job card to carry out")
        ->check(CLI::IsMember({"placard", "card", "dd1613", "job"}))
        ->capture_default_str();
    addDatabaseOption(*command, invocation);
    addInputOption(
        *command, invocation, "--second", options->second, "a second swing of the same compass for a second STEER column (radio off)");
    command->add_option("--step", options->card.step_deg, "degrees between headings: 10, 15, 30 or 45")
        ->check(CLI::IsMember(std::vector<int>(kCardSteps_deg.begin(), kCardSteps_deg.end())))
        ->capture_default_str();
    command->add_option("--by", options->by, "magnetic: what to steer for it; compass: the magnetic heading when the compass reads so much")
        ->check(CLI::IsMember({"magnetic", "compass"}))
        ->capture_default_str();
    command->add_option("--at", options->at_deg, "also the value at this heading between the rows: interpolated, and by the curve")
        ->check(CLI::Range(0.0, 360.0));
    command->add_option("--from", options->from, "fit: the exact fit; readings: the deviation read nearest to each heading")
        ->check(CLI::IsMember({"fit", "readings"}))
        ->capture_default_str();
    addRemoveOption(*command, options->card.removed, "coefficients taken out mechanically after the swing, as in A,B,C");
    command->add_flag("--json", options->json, "one JSON object on standard output");
    addOutputOption(*command, invocation, "-o,--output", options->output, "write the card, at the size of a cockpit placard", {".pdf"});
    command->callback(
        [options, &invocation] { invocation.action = [options, &invocation] { return cardCommand(*options, invocation.database); }; });
}

} // namespace lubberline::app
