#include <QString>

#include <fstream>
#include <iterator>

#include "app/Console.h"
#include "app/OpenStores.h"
#include "app/QtSession.h"
#include "app/SwingSource.h"
#include "app/commands/Command.h"
#include "core/base/WholeFile.h"
#include "db/transfer/Transfer.h"
#include "ui/intake/ImportFile.h"

namespace lubberline::app {

namespace {

struct ImportArguments {
    std::vector<std::string> files;
    ui::CsvParticulars particulars;
};

/// All files or none: they are read first, then stored in one transaction.
int importCommand(const ImportArguments& options, const std::string& database)
{
    std::vector<Fleet> fleets;
    for (const auto& file : options.files) {
        auto read = ui::readImportFile(QString::fromStdString(file), options.particulars, consoleProgress("reading " + nameOfInput(file)));
        if (!read)
            return fail(read.error());
        warn(read->warnings);
        fleets.push_back(std::move(read->fleet));
    }
    const auto session = makeDrawingSession();
    auto stores = openStores(database, db::OpenMode::ReadWriteCreate);
    if (!stores)
        return fail(stores.error());
    const auto imported = db::importAll((*stores)->database(), fleets, consoleProgress("storing"));
    if (!imported)
        return fail(imported.error());
    warn(imported->warnings);
    say(text("stored %d new swings of %d new aircraft; %d swings were there already", imported->swings, imported->aircraft,
        imported->alreadyThere));
    return kDone;
}

} // namespace

void addImport(CLI::App& app, Invocation& invocation)
{
    auto options = std::make_shared<ImportArguments>();
    auto* command = app.add_subcommand("import", "store swings from Swing CSV, exchange JSON or our own report PDF");
    addInputOption(*command, invocation, "FILE", options->files, "files of any of the three kinds, told by their endings; - by its content")
        ->required();
    command->add_option("--aircraft", options->particulars.aircraft, "for a CSV that does not state it: the registration");
    command->add_option("--type", options->particulars.type, "likewise: the aircraft type");
    command->add_option("--compass", options->particulars.compass, "likewise: the compass");
    addDatabaseOption(*command, invocation);
    command->callback(
        [options, &invocation] { invocation.action = [options, &invocation] { return importCommand(*options, invocation.database); }; });
}

} // namespace lubberline::app
