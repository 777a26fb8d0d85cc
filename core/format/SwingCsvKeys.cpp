#include "core/format/SwingCsvKeys.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/format/FileText.h"
#include "core/format/Number.h"
#include "core/format/RecordWords.h"

namespace lubberline::csv {

namespace {

/// Keys whose value is text as it is. The order is that of the written file.
struct TextKey {
    std::string_view key;
    std::string& (*field)(SwingFile& file);
};
constexpr std::array kTextKeys{
    TextKey{"aircraft", [](SwingFile& file) -> std::string& { return file.aircraft; }},
    TextKey{"type", [](SwingFile& file) -> std::string& { return file.type; }},
    TextKey{"compass", [](SwingFile& file) -> std::string& { return file.compass; }},
    TextKey{"site", [](SwingFile& file) -> std::string& { return file.site; }},
    TextKey{"operator", [](SwingFile& file) -> std::string& { return file.operatorName; }},
    TextKey{"engines", [](SwingFile& file) -> std::string& { return file.swing.configuration.engines; }},
    TextKey{"electrics", [](SwingFile& file) -> std::string& { return file.swing.configuration.electrics; }},
    TextKey{"configuration", [](SwingFile& file) -> std::string& { return file.swing.configuration.other; }},
    TextKey{"datum", [](SwingFile& file) -> std::string& { return file.swing.datum.instrument; }},
    TextKey{"datum_serial_number", [](SwingFile& file) -> std::string& { return file.swing.datum.serialNumber; }},
    TextKey{"datum_reader", [](SwingFile& file) -> std::string& { return file.swing.people.datumReader; }},
    TextKey{"cockpit_reader", [](SwingFile& file) -> std::string& { return file.swing.people.cockpitReader; }},
    TextKey{"adjuster", [](SwingFile& file) -> std::string& { return file.swing.people.adjuster; }},
    TextKey{"inspector", [](SwingFile& file) -> std::string& { return file.swing.people.inspector; }},
    TextKey{"procedure", [](SwingFile& file) -> std::string& { return file.swing.procedure; }},
    TextKey{"work_order", [](SwingFile& file) -> std::string& { return file.swing.workOrder; }},
    TextKey{"reason", [](SwingFile& file) -> std::string& { return file.swing.reason; }},
    TextKey{"note", [](SwingFile& file) -> std::string& { return file.swing.note; }},
};

Error wrongValue(const KeyLine& line, const std::string& expected)
{
    return {ErrorCode::InvalidInput, std::string(line.key) + ": " + inQuotes(line.value) + " is not allowed; expected " + expected};
}

template <class Choice>
Result<void> takeChoice(const KeyLine& line, Choice& into)
{
    const auto choice = choiceOf<Choice>(line.value);
    if (!choice)
        return wrongValue(line, allowedWords<Choice>());
    into = *choice;
    return {};
}

Result<void> takeDate(const KeyLine& line, std::string& into)
{
    if (!isIsoDate(line.value))
        return wrongValue(line, "a date of the calendar as YYYY-MM-DD");
    into = line.value;
    return {};
}

Result<void> takeVariation(const KeyLine& line, std::optional<double>& into)
{
    const auto number = readNumber(line.value, true); // no separator in this line: a comma is a decimal comma
    if (number.fault != NumberFault::None || std::abs(number.value) > 180.0)
        return wrongValue(line, "degrees from -180 to 180, east positive, such as 6.5");
    into = number.value;
    return {};
}

struct ValueKey {
    std::string_view key;
    Result<void> (*take)(SwingFile& file, const KeyLine& line);
};
constexpr std::array kValueKeys{
    ValueKey{"date", [](SwingFile& file, const KeyLine& line) { return takeDate(line, file.swing.date); }},
    ValueKey{"kind", [](SwingFile& file, const KeyLine& line) { return takeChoice(line, file.swing.kind); }},
    ValueKey{"stage", [](SwingFile& file, const KeyLine& line) { return takeChoice(line, file.swing.stage); }},
    ValueKey{"radio", [](SwingFile& file, const KeyLine& line) { return takeChoice(line, file.swing.configuration.radio); }},
    ValueKey{"datum_calibration_due", [](SwingFile& file, const KeyLine& line) { return takeDate(line, file.swing.datum.calibrationDue); }},
    ValueKey{"variation_deg", [](SwingFile& file, const KeyLine& line) { return takeVariation(line, file.swing.variation_deg); }},
};

template <std::size_t N, class Key>
const Key* find(const std::array<Key, N>& keys, std::string_view key)
{
    const auto found = std::find_if(keys.begin(), keys.end(), [&](const Key& one) { return one.key == key; });
    return found == keys.end() ? nullptr : &*found;
}

bool isKeyCharacter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

void write(std::string& text, std::string_view key, std::string value)
{
    // A key line is one line: breaks in a note become spaces.
    std::replace_if(value.begin(), value.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }, ' ');
    if (const auto shown = trimmed(value); !shown.empty())
        text += "# " + std::string(key) + ": " + std::string(shown) + "\n";
}

} // namespace

std::optional<KeyLine> keyLineOf(std::string_view line)
{
    const auto content = trimmed(line.substr(std::min(line.find_first_not_of('#'), line.size())));
    const auto end = std::find_if_not(content.begin(), content.end(), isKeyCharacter);
    const auto key = content.substr(0, static_cast<std::size_t>(end - content.begin()));
    const auto rest = trimmed(content.substr(key.size()));
    if (key.empty() || !rest.starts_with(':') || rest.starts_with("://"))
        return {};
    return KeyLine{key, trimmed(rest.substr(1))};
}

Result<void> KeyReader::take(const KeyLine& line)
{
    if (!m_taken.emplace(line.key).second)
        return Error{ErrorCode::InvalidInput, "the key " + inQuotes(line.key) + " is there twice; expected each key once"};
    if (const auto* text = find(kTextKeys, line.key)) {
        text->field(m_file) = line.value;
        return {};
    }
    if (const auto* value = find(kValueKeys, line.key))
        return line.value.empty() ? Result<void>() : value->take(m_file, line);
    m_file.otherKeys.emplace_back(line.key, line.value);
    return {};
}

std::string keyLinesOf(const SwingRecord& record)
{
    SwingFile file;
    file.aircraft = record.aircraft.registration;
    file.type = record.type.name;
    file.compass = record.compass.name;
    file.site = record.site ? record.site->name : std::string();
    file.operatorName = record.aircraft.operatorName;
    file.swing = record.swing;
    file.swing.readings.clear();

    std::string text;
    for (const auto& key : kTextKeys)
        if (key.key != "note")
            write(text, key.key, key.field(file));
    write(text, "date", file.swing.date);
    write(text, "kind", std::string(fileWord(file.swing.kind)));
    write(text, "stage", std::string(fileWord(file.swing.stage)));
    if (file.swing.configuration.radio != RadioState::NotStated)
        write(text, "radio", std::string(fileWord(file.swing.configuration.radio)));
    write(text, "datum_calibration_due", file.swing.datum.calibrationDue);
    if (file.swing.variation_deg)
        write(text, "variation_deg", shortestNumber(*file.swing.variation_deg));
    write(text, "note", file.swing.note);
    return text;
}

} // namespace lubberline::csv
