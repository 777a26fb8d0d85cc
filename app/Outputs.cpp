#include "app/Outputs.h"

#include <algorithm>
#include <filesystem>

#include "app/Console.h"
#include "app/Paths.h"
#include "core/base/FileText.h"
#include "core/base/OutputFile.h"
#include "core/base/WholeFile.h"
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
    if (std::any_of(inputs.begin(), inputs.end(), isStandardStream))
        inputs.emplace_back("/dev/stdin"); // "- < FILE": the file behind it
    if (command.get_option_no_throw("--db"))
        if (const auto path = databasePath(database))
            for (auto& file : db::filesOf(*path))
                inputs.push_back(std::move(file));
    return inputs;
}

/// Of a path, in small letters and with its point.
std::string endingOf(const std::string& path) { return inSmallLetters(std::filesystem::path(path).extension().string()); }

std::string listed(const std::vector<std::string>& endings)
{
    std::string text;
    for (std::size_t i = 0; i < endings.size(); ++i)
        text += (i == 0 ? "" : i + 1 < endings.size() ? ", " : " or ") + endings[i];
    return text;
}

} // namespace

bool Output::toStandardOutput() const { return isStandardStream(path); }

CLI::Option* addOutputOption(CLI::App& command, Invocation& invocation, const std::string& name, Output& output, const std::string& help,
    const std::vector<std::string>& endings)
{
    output.kind = endings.front();
    auto* option = command.add_option_function<std::string>(
        name,
        [&output](const std::string& path) {
            output.path = path;
            if (!isStandardStream(path))
                output.kind = endingOf(path);
        },
        help + ": " + listed(endings) + "; - is standard output");
    option->check([endings](const std::string& path) {
        const bool known = isStandardStream(path) || std::find(endings.begin(), endings.end(), endingOf(path)) != endings.end();
        return known || !checkOutput(path) // a device, a folder …: checkOutputs() says so
            ? std::string()
            : inQuotes(path) + " has another ending; expected " + listed(endings);
    });
    if (endings.size() > 1)
        command
            .add_option_function<std::string>(
                "--format",
                [&output](const std::string& kind) {
                    if (output.path.empty() || output.toStandardOutput())
                        output.kind = "." + kind;
                    else if (output.kind != "." + kind)
                        throw CLI::ValidationError("--format: " + inQuotes(output.path) + " is of another kind; expected it for -o -");
                },
                "what -o - writes: " + listed(endings) + ", without the point")
            ->default_str(endings.front().substr(1))
            ->needs(option)
            ->check([endings](const std::string& kind) {
                return std::find(endings.begin(), endings.end(), "." + kind) != endings.end()
                    ? std::string()
                    : inQuotes(kind) + " is none; expected one of " + listed(endings) + ", without the point";
            });
    invocation.outputs.push_back(option);
    return option;
}

CLI::Option* addInputOption(CLI::App& command, Invocation& invocation, const std::string& name, std::string& file, const std::string& help)
{
    auto* option = command.add_option(name, file, help);
    invocation.inputs.push_back(option);
    return option;
}

CLI::Option* addInputOption(
    CLI::App& command, Invocation& invocation, const std::string& name, std::vector<std::string>& files, const std::string& help)
{
    auto* option = command.add_option(name, files, help);
    invocation.inputs.push_back(option);
    return option;
}

Result<void> checkOutputs(const CLI::App& app, const Invocation& invocation)
{
    const auto isAmong = [](const std::vector<const CLI::Option*>& options, const CLI::Option* option) {
        return std::find(options.begin(), options.end(), option) != options.end();
    };
    for (const CLI::App* command : app.get_subcommands()) {
        std::ptrdiff_t read = 0;
        for (const CLI::Option* option : command->get_options()) {
            const auto results = option->results();
            if (isAmong(invocation.inputs, option))
                read += std::count_if(results.begin(), results.end(), isStandardStream);
            if (isAmong(invocation.outputs, option))
                for (const std::string& path : results) {
                    if (!isUtf8(path))
                        return Error{ErrorCode::InvalidInput,
                            MARKED("app", "the name of the file to write is not UTF-8; expected one that is"), path};
                    if (auto allowed = checkOutput(path, inputsBeside(*command, *option, invocation.database)); !allowed)
                        return allowed;
                }
        }
        if (read > 1)
            return Error{
                ErrorCode::InvalidInput, MARKED("app", "standard input (-) is named twice; expected it once, it can be read only once")};
    }
    return {};
}

void sayWritten(const Output& output)
{
    if (!output.toStandardOutput())
        say("wrote " + output.path);
}

} // namespace lubberline::app
