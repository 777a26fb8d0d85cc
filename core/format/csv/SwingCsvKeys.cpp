#include "core/format/csv/SwingCsvKeys.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/angle/AngleText.h"
#include "core/base/DateText.h"
#include "core/base/FileText.h"
#include "core/base/Number.h"
#include "core/earth/FieldModel.h"
#include "core/format/csv/RowSplitter.h"
#include "core/format/csv/TextCell.h"
#include "core/record/Ranges.h"
#include "core/record/RecordWords.h"

namespace lubberline::csv {

namespace {

constexpr std::size_t kMostKeys = 1000;

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

Error wrongValue(const KeyLine& line, const Message& expected)
{
    return {ErrorCode::InvalidInput,
        {MARKED("core", "%1: %2 is not allowed; expected %3"), std::string(line.key), inQuotes(line.value), expected}};
}

/// What the cells of the window say of the same text, with the key before it.
Error wrongAngle(const KeyLine& line, const Error& error)
{
    return {error.code, {MARKED("core", "%1: %2"), std::string(line.key), error.message}};
}

template <class Choice>
Result<void> takeChoice(const KeyLine& line, Choice& into)
{
    const auto choice = choiceOf<Choice>(line.value);
    if (!choice)
        return wrongValue(line, Message::verbatim(allowedWords<Choice>()));
    into = *choice;
    return {};
}

Result<void> takeDate(const KeyLine& line, Date& into)
{
    const auto day = plainDate(line.value);
    if (!day)
        return wrongValue(line, MARKED("core", "a date of the calendar as YYYY-MM-DD or DD.MM.YYYY"));
    into = *day;
    return {};
}

Result<void> takeVariation(const KeyLine& line, std::optional<double>& into)
{
    const auto variation_deg = parseSignedAngle_deg(line.value);
    if (!variation_deg)
        return wrongAngle(line, variation_deg.error());
    into = *variation_deg;
    return {};
}

Result<void> takeSharedErrors(const KeyLine& line, SharedErrors& into)
{
    const auto errors = readSharedErrors(line.value);
    if (!errors)
        return wrongAngle(line, errors.error());
    into = *errors;
    return {};
}

Result<void> takeLatitude(const KeyLine& line, std::optional<double>& into)
{
    const auto latitude_deg = parseLatitude_deg(line.value);
    if (!latitude_deg)
        return wrongAngle(line, latitude_deg.error());
    into = *latitude_deg;
    return {};
}

Result<void> takeNumber(const KeyLine& line, double least, double most, Pattern expected, std::optional<double>& into)
{
    const auto number = readNumber(line.value, true);
    if (number.fault != NumberFault::None || number.value < least || number.value > most)
        return wrongValue(line, expected);
    into = number.value;
    return {};
}

/// More than half a turn as a number, as some programs count; in letters as the window takes it.
Result<void> takeLongitude(const KeyLine& line, std::optional<double>& into)
{
    constexpr double kMost_deg = 540.0;
    if (const auto number = readNumber(line.value, true); number.fault == NumberFault::None && std::abs(number.value) <= kMost_deg) {
        into = number.value;
        return {};
    }
    const auto longitude_deg = parseSignedAngle_deg(line.value);
    if (!longitude_deg)
        return wrongAngle(line, longitude_deg.error());
    into = *longitude_deg;
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
    ValueKey{"shared_error_deg", [](SwingFile& file, const KeyLine& line) { return takeSharedErrors(line, file.swing.sharedErrors); }},
    ValueKey{"latitude_deg", [](SwingFile& file, const KeyLine& line) { return takeLatitude(line, file.latitude_deg); }},
    ValueKey{"longitude_deg", [](SwingFile& file, const KeyLine& line) { return takeLongitude(line, file.longitude_deg); }},
    ValueKey{"height_m",
        [](SwingFile& file, const KeyLine& line) {
            return takeNumber(line, -10'000, 600'000, MARKED("core", "metres from -10000 to 600000"), file.height_m);
        }},
};

template <std::size_t N, class Key>
const Key* find(const std::array<Key, N>& keys, std::string_view key)
{
    const auto found = std::find_if(keys.begin(), keys.end(), [&](const Key& one) { return one.key == key; });
    return found == keys.end() ? nullptr : &*found;
}

bool isKeyCharacter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_'; }

/// Whether a spreadsheet would part the value so that a cell of it began a formula, or our reader would take its end for empty cells.
bool isPartedBySpreadsheets(std::string_view value)
{
    constexpr std::string_view kSeparators = ",;|";
    for (std::size_t at = value.find_first_of(kSeparators); at != std::string_view::npos; at = value.find_first_of(kSeparators, at + 1)) {
        const auto cell = value.substr(at + 1);
        if (at == 0 || cell.empty() || withTextMark(trimmed(cell)) != trimmed(cell) || trimmed(cell).starts_with('"'))
            return true;
    }
    return false;
}

void write(std::string& text, std::string_view key, std::string value)
{
    // A key line is one line: breaks in a note become spaces.
    std::replace_if(
        value.begin(), value.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }, ' ');
    const auto shown = trimmed(value);
    if (shown.empty())
        return;
    const std::string line = "# " + std::string(key) + ": " + std::string(shown);
    text += (isPartedBySpreadsheets(shown) ? csvQuoted(line) : line) + "\n";
}

void writePlace(std::string& text, const Place& place)
{
    write(text, "latitude_deg", shortestNumber(place.latitude_deg));
    write(text, "longitude_deg", shortestNumber(place.longitude_deg));
    write(text, "height_m", shortestNumber(place.height_m));
}

} // namespace

std::string keyTextOf(std::string_view line, char separator)
{
    if (line.starts_with('"')) {
        RowSplitter splitter(separator);
        splitter.begin(line);
        std::string text = splitter.cells().front();
        for (std::size_t i = 1; i < splitter.cells().size(); ++i) // the value in a cell of its own
            if (const auto cell = trimmed(splitter.cells()[i]); !cell.empty())
                text += (text.ends_with(':') ? std::string(" ") : std::string(1, separator)) + std::string(cell);
        return text;
    }
    auto text = trimmed(line);
    while (text.ends_with(separator))
        text = trimmed(text.substr(0, text.size() - 1));
    std::string key(text);
    // "# aircraft:,SP-XYZ": likewise; and without the colon, where a cell holds the name of a key and nothing else.
    const auto colon = key.find(':'), cell = key.find(separator);
    if (colon != std::string::npos && cell == colon + 1)
        key[cell] = ' ';
    else if (cell < colon && cell + 1 < key.size() && key[cell + 1] != ' '
        && isKey(inSmallLetters(trimmed(std::string_view(key).substr(0, cell).substr(std::min(key.find_first_not_of('#'), cell))))))
        key.replace(cell, 1, ": ");
    return key;
}

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

std::vector<std::string_view> keyNames()
{
    std::vector<std::string_view> names;
    for (const auto& key : kTextKeys)
        names.push_back(key.key);
    for (const auto& key : kValueKeys)
        names.push_back(key.key);
    return names;
}

bool isKey(std::string_view name) { return find(kTextKeys, name) || find(kValueKeys, name); }

Result<void> KeyReader::take(const KeyLine& line)
{
    const std::string known = inSmallLetters(line.key);
    if (line.value.size() > kLongestText)
        return Error{ErrorCode::InvalidInput,
            {MARKED("core", "%1 is a text of %2 bytes; expected at most %3"), inQuotes(line.key), line.value.size(), kLongestText}};
    if (m_taken.size() == kMostKeys)
        return Error{
            ErrorCode::InvalidInput, {MARKED("core", "there are more than %1 keys; expected the particulars of a swing"), kMostKeys}};
    if (!m_taken.insert(known).second)
        return Error{ErrorCode::InvalidInput, {MARKED("core", "the key %1 is there twice; expected each key once"), inQuotes(line.key)}};
    if (const auto* text = find(kTextKeys, known)) {
        text->field(m_file) = line.value;
        return {};
    }
    if (const auto* value = find(kValueKeys, known))
        return line.value.empty() ? Result<void>() : value->take(m_file, line);
    m_file.otherKeys.emplace_back(line.key, line.value);
    return {};
}

Result<void> stampFromKeys(SwingFile& file)
{
    if (file.latitude_deg.has_value() != file.longitude_deg.has_value())
        return Error{ErrorCode::InvalidInput,
            {MARKED("core", "%1 is stated without %2; expected both or neither"),
                std::string(file.latitude_deg ? "latitude_deg" : "longitude_deg"),
                std::string(file.latitude_deg ? "longitude_deg" : "latitude_deg")}};
    if (!file.latitude_deg)
        return {};
    const auto place = makePlace(*file.latitude_deg, *file.longitude_deg, file.height_m.value_or(0.0));
    if (!place)
        return place.error();
    if (file.swing.date.empty()) {
        file.warnings.push_back(MARKED("core",
            "the place of the swing is stated, but no date, so the field there is not known; expected a line \"# date: YYYY-MM-DD\""));
        return {};
    }
    if (const auto stamp = stampField(*place, file.swing.date))
        file.swing.field = *stamp;
    else
        file.warnings.push_back({MARKED("core", "the Earth's field at the swing's place is not known: %1"), stamp.error().message});
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
    write(text, "date", file.swing.date.text());
    write(text, "kind", std::string(fileWord(file.swing.kind)));
    write(text, "stage", std::string(fileWord(file.swing.stage)));
    if (file.swing.configuration.radio != RadioState::NotStated)
        write(text, "radio", std::string(fileWord(file.swing.configuration.radio)));
    write(text, "datum_calibration_due", file.swing.datum.calibrationDue.text());
    if (file.swing.variation_deg)
        write(text, "variation_deg", shortestNumber(*file.swing.variation_deg));
    write(text, "shared_error_deg", textOf(file.swing.sharedErrors));
    if (file.swing.field)
        writePlace(text, file.swing.field->place);
    write(text, "note", file.swing.note);
    return text;
}

} // namespace lubberline::csv
