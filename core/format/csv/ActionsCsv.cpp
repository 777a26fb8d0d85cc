#include "core/format/csv/ActionsCsv.h"

#include "core/base/FileText.h"
#include "core/base/LineReader.h"
#include "core/base/Number.h"
#include "core/base/WholeFile.h"
#include "core/format/csv/RowSplitter.h"
#include "core/format/csv/TextCell.h"

namespace lubberline {

namespace {

constexpr Pattern kExpectedActions = MARKED("core", "expected a CSV with the columns time_s and action");

constexpr std::size_t kMostActions = 10'000, kLongestAction = 1000;

char actionSeparator(std::string_view header)
{
    return header.find(';') != std::string_view::npos ? ';' : header.find('\t') != std::string_view::npos ? '\t' : ',';
}

} // namespace

Result<std::vector<TimedAction>> readActions(std::istream& input, const std::string& name)
{
    const Progress none;
    LineReader lines(input, none);
    if (const Message other = otherEncoding(lines.beginning()); !other.empty())
        return Error{ErrorCode::Format, other, name};
    std::vector<TimedAction> actions;
    std::optional<RowSplitter> splitter;
    std::size_t timePlace = 0, actionPlace = 0;
    std::string line;
    const auto here = [&](const Message& message) { return Error{ErrorCode::InvalidInput, message, name, lines.lineNumber()}; };
    for (;;) {
        const LineOutcome outcome = lines.next(line);
        if (outcome == LineOutcome::End)
            break;
        if (outcome != LineOutcome::Line)
            return Error{ErrorCode::Format, {MARKED("core", "cannot be read as text; %1"), kExpectedActions}, name};
        if (line.starts_with(kByteOrderMark))
            line.erase(0, kByteOrderMark.size());
        if (trimmed(line).empty() || line.front() == '#')
            continue;
        if (!splitter) {
            splitter.emplace(actionSeparator(line));
            static_cast<void>(splitter->begin(line));
            std::optional<std::size_t> time, action;
            for (std::size_t i = 0; i < splitter->cells().size(); ++i) {
                const std::string cell = inSmallLetters(trimmed(splitter->cells()[i]));
                if (cell == "time_s")
                    time = i;
                if (cell == "action")
                    action = i;
            }
            if (!time || !action)
                return Error{ErrorCode::Format, {MARKED("core", "has no such header; %1"), kExpectedActions}, name, lines.lineNumber()};
            timePlace = *time;
            actionPlace = *action;
            continue;
        }
        if (splitter->begin(line) != RowSplitter::State::Complete || splitter->cells().size() <= std::max(timePlace, actionPlace))
            return here({MARKED("core", "is no row of a time and an action")});
        const FileNumber time = readNumber(trimmed(splitter->cells()[timePlace]), splitter->separator() != ',');
        if (time.fault != NumberFault::None)
            return here({MARKED("core", "%1 is no time; expected seconds"), figuresInQuotes(splitter->cells()[timePlace])});
        const std::string action = textOfCell(trimmed(splitter->cells()[actionPlace]));
        if (action.empty())
            return here({MARKED("core", "there is no action")});
        if (!actions.empty() && time.value <= actions.back().time_s)
            return here({MARKED("core", "time goes back, from %1 to %2; expected actions in order of time"),
                shortestNumber(actions.back().time_s), shortestNumber(time.value)});
        if (actions.size() == kMostActions || action.size() > kLongestAction)
            return here(
                {MARKED("core", "there are more than %1 actions, or one of more than %2 bytes; expected what was switched in a test"),
                    kMostActions, kLongestAction});
        actions.push_back({time.value, action});
    }
    if (actions.empty())
        return Error{ErrorCode::Format, {MARKED("core", "holds no actions; %1"), kExpectedActions}, name};
    return actions;
}

Result<std::vector<TimedAction>> readActionsFile(const std::string& path)
{
    const auto file = openInput(path, MARKED("core", "a CSV of actions"));
    return file ? readActions(**file, nameOfInput(path)) : Result<std::vector<TimedAction>>(file.error());
}

std::string writeActions(const std::vector<TimedAction>& actions)
{
    std::string text = "time_s,action\n";
    for (const TimedAction& action : actions)
        text += shortestNumber(action.time_s) + "," + csvTextCell(action.action) + "\n";
    return text;
}

} // namespace lubberline
