#pragma once
/// One file per command: each adds its subcommand, and sets the action to run when it was the one that was called.

#include <functional>
#include <string>

#include <CLI/CLI.hpp>

namespace lubberline::app {

/// What all commands share.
struct Invocation {
    int& argc;
    char** argv;
    std::string database;        ///< --db, or empty
    std::function<int()> action; ///< set by the command that was called; returns the exit status
};

void addAnalyse(CLI::App& app, Invocation& invocation);
void addCard(CLI::App& app, Invocation& invocation);
void addCorrect(CLI::App& app, Invocation& invocation);
void addReport(CLI::App& app, Invocation& invocation);
void addImport(CLI::App& app, Invocation& invocation);
void addExport(CLI::App& app, Invocation& invocation);
void addSwings(CLI::App& app, Invocation& invocation);
void addDb(CLI::App& app, Invocation& invocation);
void addDemo(CLI::App& app, Invocation& invocation);

/// Adds `--db FILE` to a command that uses the database.
void addDatabaseOption(CLI::App& command, Invocation& invocation);

} // namespace lubberline::app
