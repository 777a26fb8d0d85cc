#include "app/ModelOptions.h"

#include <CLI/CLI.hpp>

#include "core/base/FileText.h"
#include "core/base/Number.h"

namespace lubberline::app {

Result<void> switchCircuits(SensorModel& model, const std::vector<std::string>& switches)
{
    for (const auto& text : switches) {
        const auto equals = text.rfind('=');
        const std::string name = text.substr(0, equals), state = equals == std::string::npos ? "" : text.substr(equals + 1);
        if (state != "on" && state != "off")
            return Error{ErrorCode::InvalidInput, {MARKED("app", "--switch \"%1\"; expected NAME=on or NAME=off"), text}};
        bool found = false;
        std::string names;
        for (auto& circuit : model.circuits) {
            names += (names.empty() ? "" : ", ") + circuit.name;
            if (circuit.name != name)
                continue;
            circuit.on = state == "on";
            found = true;
        }
        if (!found)
            return Error{ErrorCode::InvalidInput,
                names.empty() ? Message{MARKED("app", "there is no circuit \"%1\"; the model has none"), name}
                              : Message{MARKED("app", "there is no circuit \"%1\"; the model has %2"), name, names}};
    }
    return {};
}

double degreesIn(const std::string& option, std::string_view text, double least_deg, double most_deg)
{
    const FileNumber number = readNumber(trimmed(text));
    if (number.fault != NumberFault::None || number.value < least_deg || number.value > most_deg)
        throw CLI::ValidationError(option + ": " + inQuotes(text) + " is none; expected degrees from " + shortestNumber(least_deg) + " to "
            + shortestNumber(most_deg));
    return number.value;
}

} // namespace lubberline::app
