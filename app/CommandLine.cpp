#include "app/CommandLine.h"

#include <memory>

#include "app/Console.h"
#include "app/OpenStores.h"
#include "app/Outputs.h"
#include "app/QtSession.h"
#include "app/Window.h"
#include "app/commands/Command.h"
#include "core/base/TerminalText.h"

namespace lubberline::app {

void addDatabaseOption(CLI::App& command, Invocation& invocation)
{
    command.add_option(
        "--db", invocation.database, "the database (SQLite file); default: LUBBERLINE_DB, else fleet.lubberline in the user's data folder");
}

void actOnStores(CLI::App& command, Invocation& invocation, db::OpenMode mode, std::function<int(db::Stores&)> act)
{
    addDatabaseOption(command, invocation);
    command.callback([&invocation, mode, act] {
        invocation.action = [&invocation, mode, act] {
            const auto session = makeDrawingSession();
            auto stores = openStores(invocation.database, mode);
            return stores ? act(**stores) : fail(stores.error());
        };
    });
}

void addRemoveOption(CLI::App& command, CoefficientSet& removed, const std::string& help)
{
    command
        .add_option_function<std::vector<std::string>>(
            "--remove",
            [&removed](const std::vector<std::string>& letters) {
                for (const auto& letter : letters)
                    removed.set(static_cast<std::size_t>(letter[0] - 'A'));
            },
            help)
        ->delimiter(',')
        ->check(CLI::IsMember({"A", "B", "C", "D", "E"}));
}

int runCommandLine(int argc, char** argv)
{
    CLI::App app{"Lubberline: aircraft magnetic deviation. Without a command it opens the window.\n"
                 "deviation = magnetic heading - compass heading, east positive",
        "lubberline"};
    app.set_version_flag(
        "--version", "lubberline " LUBBERLINE_VERSION "\nbased in part on the work of the Qwt project (http://qwt.sf.net)");
    app.footer("Exit status: 0 done, 1 the data or the operation failed, 2 usage.\n"
               "`lubberline COMMAND --help` tells of one command.");
    app.require_subcommand(0, 1);
    app.failure_message([](const CLI::App*, const CLI::Error& wrong) {
        return "lubberline: " + inOneLine(wrong.what()) + "; `lubberline --help` and `lubberline COMMAND --help` tell what is expected\n";
    });

    Invocation invocation{argc, argv, {}, {}, {}, {}};
    addDatabaseOption(app, invocation);
    addAnalyse(app, invocation);
    addCorrect(app, invocation);
    addCard(app, invocation);
    addReport(app, invocation);
    addNmea(app, invocation);
    addField(app, invocation);
    addSmith(app, invocation);
    addSimulate(app, invocation);
    addCompensator(app, invocation);
    addMap(app, invocation);
    addPredict(app, invocation);
    addSeparate(app, invocation);
    addIron(app, invocation);
    addCheck(app, invocation);
    addCompare(app, invocation);
    addReference(app, invocation);
    addSun(app, invocation);
    addAlignment(app, invocation);
    addGrid(app, invocation);
    addElectrical(app, invocation);
    addCalibrate(app, invocation);
    addCompensate(app, invocation);
    addCoil(app, invocation);
    addSensorTests(app, invocation);
    addInstallation(app, invocation);
    addLineOfSight(app, invocation);
    addImport(app, invocation);
    addExport(app, invocation);
    addSwings(app, invocation);
    addSign(app, invocation);
    addKeys(app, invocation);
    addVerify(app, invocation);
    addFleet(app, invocation);
    addDue(app, invocation);
    addRule(app, invocation);
    addDb(app, invocation);
    addWinds(app, invocation);
    addLegs(app, invocation);
    addContinuous(app, invocation);
    addDemo(app, invocation);

    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& wanted) { // --help, --version
        return app.exit(wanted);
    } catch (const CLI::ParseError& wrong) {
        app.exit(wrong);
        return kUsage;
    }
    if (!invocation.action)
        return openWindow(invocation);
    if (const auto allowed = checkOutputs(app, invocation); !allowed)
        return fail(allowed.error());
    return invocation.action();
}

} // namespace lubberline::app
