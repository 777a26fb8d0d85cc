#include "app/Outputs.h"

#include <algorithm>
#include <cstdio>

#include "app/Console.h"
#include "app/Paths.h"
#include "core/base/OutputFile.h"
#include "db/engine/Database.h"

namespace lubberline::app {

namespace {

/// Everything else on the command line that may be a file, and the database with the files that SQLite keeps beside it.
std::vector<std::string> inputsBeside(const CLI::App& command, const CLI::Option& output, const std::string& database)
{
    std::vector<std::string> inputs;
    for (const CLI::Option* option : command.get_options())
        if (option != &output)
            inputs.insert(inputs.end(), option->results().begin(), option->results().end());
    if (command.get_option_no_throw("--db"))
        if (const auto path = databasePath(database))
            for (auto& file : db::filesOf(*path))
                inputs.push_back(std::move(file));
    return inputs;
}

} // namespace

CLI::Option* addOutputOption(CLI::App& command, Invocation& invocation, const std::string& name, std::string& file, const std::string& help)
{
    auto* option = command.add_option(name, file, help);
    invocation.outputs.push_back(option);
    return option;
}

Result<void> checkOutputs(const CLI::App& app, const Invocation& invocation)
{
    for (const CLI::App* command : app.get_subcommands())
        for (const CLI::Option* option : command->get_options())
            if (std::find(invocation.outputs.begin(), invocation.outputs.end(), option) != invocation.outputs.end())
                for (const std::string& path : option->results())
                    if (!isStandardOutput(path))
                        if (auto allowed = checkOutput(path, inputsBeside(*command, *option, invocation.database)); !allowed)
                            return allowed;
    return {};
}

bool isStandardOutput(const std::string& path) { return path == "-"; }

Result<void> writeOutput(const std::string& path, const std::string& content)
{
    if (!isStandardOutput(path))
        return writeWholeFile(path, content);
    if (std::fwrite(content.data(), 1, content.size(), stdout) != content.size() || std::fflush(stdout) != 0)
        return Error{ErrorCode::Io, MARKED("app", "standard output takes no more; expected one that is read to its end"), path};
    return {};
}

void sayWritten(const std::string& path)
{
    if (!isStandardOutput(path))
        say("wrote " + path);
}

} // namespace lubberline::app
