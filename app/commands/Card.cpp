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
#include "core/format/results/AnalysisJson.h"
#include "ui/swing/RecordDocuments.h"

namespace lubberline::app {

namespace {

struct CardArguments {
    std::string file, second, swing, from = "fit", form = "placard";
    Output output;
    CardOptions card;
    bool json = false;
};

/// The contract's object; a second card stands in it under "second_column".
std::string jsonOf(const std::vector<Card>& cards, const std::vector<std::string>& labels)
{
    auto object = nlohmann::ordered_json::parse(toJson(cards.front()));
    if (cards.size() > 1) {
        object["heading"] = labels[0];
        object["second_column"] = nlohmann::ordered_json::parse(toJson(cards[1]));
        object["second_column"]["heading"] = labels[1];
    }
    return object.dump(2);
}

int writeCardFile(const CardArguments& options, ui::CardInput input)
{
    input.madeAtUtc = nowUtc();
    if (const auto written = ui::writeCard(input, QString::fromStdString(options.output.path)); !written)
        return fail(written.error());
    sayWritten(options.output);
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

int cardCommand(CardArguments options, const std::string& database)
{
    options.card.source = options.from == "fit" ? CardSource::Fit : CardSource::Readings;
    const bool placard = options.form == "placard" || options.form == "card";
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
        auto input = ui::cardOf(**stores, *id, options.card, nowUtc(), true);
        sheet = input ? Result<CardSheet>(CardSheet{std::move(input.value()), {}}) : Result<CardSheet>(input.error());
    }
    if (!sheet)
        return fail(sheet.error());
    warn(sheet->warnings);
    std::vector<Card> cards;
    std::vector<std::string> labels;
    for (const auto& column : sheet->input.columns) {
        cards.push_back(column.card);
        labels.push_back(column.heading.toStdString());
    }
    if (options.output.toStandardOutput())
        return writeCardFile(options, sheet->input);
    if (options.json)
        std::printf("%s\n", jsonOf(cards, labels).c_str());
    else if (options.output.empty())
        std::fputs(tableOf(cards, labels).c_str(), stdout);
    return options.output.empty() ? kDone : writeCardFile(options, sheet->input);
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
    command->add_option("--step", options->card.step_deg, "degrees between headings: 30 or 45")
        ->check(CLI::IsMember({30, 45}))
        ->capture_default_str();
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
