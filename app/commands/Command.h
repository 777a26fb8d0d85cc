#pragma once
/// One file per command: each adds its subcommand, and sets the action to run when it was the one that was called.

#include <functional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "core/deviation/Smith.h"

namespace lubberline::db {
class Stores;
enum class OpenMode;
} // namespace lubberline::db

namespace lubberline::app {

/// What all commands share.
struct Invocation {
    int& argc;
    char** argv;
    std::string database;                    ///< --db, or empty
    std::function<int()> action;             ///< set by the command that was called; returns the exit status
    std::vector<const CLI::Option*> outputs; ///< that name a file to write
    std::vector<const CLI::Option*> inputs;  ///< that name files to read
};

/// The file that a command writes.
struct Output {
    std::string path; ///< "-": standard output, where nothing else goes then; empty: none is written
    std::string kind; ///< its ending, as ".csv"; that of --format for standard output
    [[nodiscard]] bool empty() const { return path.empty(); }
    [[nodiscard]] bool toStandardOutput() const;
};

void addAnalyse(CLI::App& app, Invocation& invocation);
void addCalibrate(CLI::App& app, Invocation& invocation);
void addCompensate(CLI::App& app, Invocation& invocation);
void addCard(CLI::App& app, Invocation& invocation);
void addCorrect(CLI::App& app, Invocation& invocation);
void addElectrical(CLI::App& app, Invocation& invocation);
void addIron(CLI::App& app, Invocation& invocation);
void addNmea(CLI::App& app, Invocation& invocation);
void addField(CLI::App& app, Invocation& invocation);
void addSmith(CLI::App& app, Invocation& invocation);
void addMap(CLI::App& app, Invocation& invocation);
void addReference(CLI::App& app, Invocation& invocation);
void addCheck(CLI::App& app, Invocation& invocation);   ///< the two-minute check
void addCompare(CLI::App& app, Invocation& invocation); ///< of two compasses
void addSun(CLI::App& app, Invocation& invocation);
void addAlignment(CLI::App& app, Invocation& invocation);
void addGrid(CLI::App& app, Invocation& invocation);
void addPredict(CLI::App& app, Invocation& invocation);
void addSeparate(CLI::App& app, Invocation& invocation);
void addCompensator(CLI::App& app, Invocation& invocation);
void addSimulate(CLI::App& app, Invocation& invocation);
void addReport(CLI::App& app, Invocation& invocation);
void addImport(CLI::App& app, Invocation& invocation);
void addExport(CLI::App& app, Invocation& invocation);
void addFleet(CLI::App& app, Invocation& invocation);
void addDue(CLI::App& app, Invocation& invocation);          ///< due, event, waive
void addRule(CLI::App& app, Invocation& invocation);         ///< the calendar rules of due
void addInstallation(CLI::App& app, Invocation& invocation); ///< locate, distances, site-check
void addLineOfSight(CLI::App& app, Invocation& invocation);
void addCoil(CLI::App& app, Invocation& invocation);
void addSensorTests(CLI::App& app, Invocation& invocation); ///< spectrum, interference
void addSign(CLI::App& app, Invocation& invocation);        ///< complete, reopen, sign, amend, audit
void addKeys(CLI::App& app, Invocation& invocation);        ///< list, add, remove the keys that the station knows
void addVerify(CLI::App& app, Invocation& invocation);      ///< a signature that was written as files
void addSwings(CLI::App& app, Invocation& invocation);
void addDb(CLI::App& app, Invocation& invocation);
void addContinuous(CLI::App& app, Invocation& invocation);
void addLegs(CLI::App& app, Invocation& invocation);
void addWinds(CLI::App& app, Invocation& invocation);
void addDemo(CLI::App& app, Invocation& invocation);

/// Adds `--remove A,B,C` to a command; another letter is a usage error.
void addRemoveOption(CLI::App& command, CoefficientSet& removed, const std::string& help);

/// Adds `--db FILE` to a command that uses the database.
void addDatabaseOption(CLI::App& command, Invocation& invocation);

/// The action of a command that uses the database: adds `--db FILE`, and opens it before `act`, which returns the exit status.
void actOnStores(CLI::App& command, Invocation& invocation, db::OpenMode mode, std::function<int(db::Stores&)> act);

/// Adds an option that names a file to write, with the endings that it may have; another one is a usage error. "-" writes the first of them
/// to standard output, or what --format says, which is added where there are several. Before its command runs, the name is held against
/// everything else on the command line and the database: a file that the command reads is never written over, and a place that takes no
/// file is told before any work.
CLI::Option* addOutputOption(CLI::App& command, Invocation& invocation, const std::string& name, Output& output, const std::string& help,
    const std::vector<std::string>& endings);

/// Adds an option that names a file to read; "-" is standard input.
CLI::Option* addInputOption(CLI::App& command, Invocation& invocation, const std::string& name, std::string& file, const std::string& help);
CLI::Option* addInputOption(
    CLI::App& command, Invocation& invocation, const std::string& name, std::vector<std::string>& files, const std::string& help);

} // namespace lubberline::app
