#include "core/format/SwingCsv.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <set>

#include "core/format/CsvRow.h"
#include "core/format/LineReader.h"
#include "core/format/Names.h"

namespace lubberline {

namespace {

enum class Column { Magnetic, Compass, True, Deviation, IndicationError, Nominal, Pitch, Roll, Note, Excluded, Unknown };

const std::map<std::string, Column>& knownColumns()
{
    static const std::map<std::string, Column> columns{{"magnetic_heading_deg", Column::Magnetic}, {"compass_heading_deg", Column::Compass},
        {"true_heading_deg", Column::True}, {"deviation_deg", Column::Deviation}, {"indication_error_deg", Column::IndicationError},
        {"nominal_deg", Column::Nominal}, {"pitch_deg", Column::Pitch}, {"roll_deg", Column::Roll}, {"note", Column::Note}, {"excluded", Column::Excluded}};
    return columns;
}

/// Figures that state the same thing twice may differ by this: the rounding of a sheet to tenths.
constexpr double kAgreement_deg = 0.05 + 1e-9;

struct Header {
    char separator = ',';
    std::vector<std::string> names;
    std::vector<Column> columns;
    [[nodiscard]] bool has(Column column) const { return std::find(columns.begin(), columns.end(), column) != columns.end(); }
};

class Reader {
public:
    Reader(std::istream& input, const std::string& name, const Progress& progress) : m_lines(input, name), m_name(name), m_progress(progress) {}
    Result<SwingFile> read();

private:
    Error wrong(const std::string& message, ErrorCode code = ErrorCode::InvalidInput) const { return {code, message, m_name, m_lines.line()}; }
    Result<void> readKey(const std::string& line);
    Result<void> setKey(const std::string& key, const std::string& value);
    template <class Enum>
    Result<void> setWord(Enum& target, const std::string& key, const std::string& value);
    Result<void> readHeader(const std::string& line);
    Result<void> readRow(const std::string& line);
    Result<std::optional<double>> number(const std::vector<std::string>& cells, std::size_t i, double least, double most) const;
    Result<void> complete(Reading& reading, std::optional<double> deviation_deg);

    LineReader m_lines;
    std::string m_name;
    const Progress& m_progress;
    SwingFile m_file;
    std::optional<Header> m_header;
    std::set<std::string> m_keys;
};

template <class Enum>
Result<void> Reader::setWord(Enum& target, const std::string& key, const std::string& value)
{
    const auto word = fromWord<Enum>(value);
    if (!word)
        return wrong(key + " is '" + value + "'; expected " + allWords<Enum>());
    target = *word;
    return {};
}

Result<void> Reader::setKey(const std::string& key, const std::string& value)
{
    Swing& swing = m_file.swing;
    const std::map<std::string, std::string*> texts{{"aircraft", &m_file.aircraft}, {"type", &m_file.type}, {"compass", &m_file.compass},
        {"site", &m_file.site}, {"operator", &m_file.operatorName}, {"engines", &swing.configuration.engines},
        {"electrics", &swing.configuration.electrics}, {"configuration", &swing.configuration.other}, {"datum", &swing.datum.instrument},
        {"datum_serial", &swing.datum.serialNumber}, {"datum_reader", &swing.people.datumReader}, {"cockpit_reader", &swing.people.cockpitReader},
        {"adjuster", &swing.people.adjuster}, {"inspector", &swing.people.inspector}, {"procedure", &swing.procedure},
        {"work_order", &swing.workOrder}, {"reason", &swing.reason}, {"note", &swing.note}};
    if (const auto found = texts.find(key); found != texts.end()) {
        *found->second = value;
        return {};
    }
    if (key == "kind")
        return setWord(swing.kind, key, value);
    if (key == "stage")
        return setWord(swing.stage, key, value);
    if (key == "radio")
        return setWord(swing.configuration.radio, key, value);
    if (key == "date" || key == "datum_calibration_due") {
        if (!isDateOrEmpty(value))
            return wrong(key + " is '" + value + "'; expected a date like 2026-11-20");
        (key == "date" ? swing.date : swing.datum.calibrationDue) = value;
        return {};
    }
    if (key == "variation_deg") {
        const auto variation = parseNumber(value, true);
        if (!variation || std::abs(*variation) > 180.0)
            return wrong("variation_deg is '" + value + "'; expected degrees within -180 to 180, east positive");
        swing.variation_deg = *variation;
        return {};
    }
    m_file.otherKeys.emplace_back(key, value);
    return {};
}

Result<void> Reader::readKey(const std::string& line)
{
    const auto colon = line.find(':');
    if (colon == std::string::npos)
        return {}; // a remark
    const std::string key = trimmed(std::string_view(line).substr(1, colon - 1));
    if (key.empty() || key.find(' ') != std::string::npos)
        return {}; // a sentence with a colon in it
    if (!m_keys.insert(key).second)
        return wrong("the key '" + key + "' stands twice; expected it once");
    return setKey(key, trimmed(std::string_view(line).substr(colon + 1)));
}

Result<void> Reader::readHeader(const std::string& line)
{
    Header header;
    header.separator = separatorOf(line);
    const auto names = splitCells(line, header.separator);
    if (!names)
        return wrong("a quote is not closed", ErrorCode::Format);
    header.names = *names;
    for (const auto& name : header.names) {
        const auto known = knownColumns().find(name);
        header.columns.push_back(known == knownColumns().end() ? Column::Unknown : known->second);
        if (name.empty())
            return wrong("a column has no name; expected a header like magnetic_heading_deg,compass_heading_deg", ErrorCode::Format);
        if (std::count(header.names.begin(), header.names.end(), name) > 1)
            return wrong("the column " + name + " stands twice; expected it once", ErrorCode::Format);
        if (known == knownColumns().end())
            m_file.warnings.push_back(m_name + ": the column '" + name + "' is not known; its figures are kept with the readings, unused");
    }
    const bool reference = header.has(Column::Magnetic) || header.has(Column::True);
    const bool difference = header.has(Column::Deviation) || header.has(Column::IndicationError);
    if (header.has(Column::Deviation) && header.has(Column::IndicationError))
        return wrong("deviation_deg and indication_error_deg are the same with opposite signs; expected one of them", ErrorCode::Format);
    if (!(reference && header.has(Column::Compass)) && !(difference && (reference || header.has(Column::Compass))))
        return wrong("columns are missing; expected two of magnetic_heading_deg (or true_heading_deg), compass_heading_deg and deviation_deg", ErrorCode::Format);
    if (header.has(Column::True) && !header.has(Column::Magnetic) && !m_file.swing.variation_deg)
        return wrong("true_heading_deg needs the variation of the place; expected a line '# variation_deg: …' before the header");
    m_header = std::move(header);
    return {};
}

Result<std::optional<double>> Reader::number(const std::vector<std::string>& cells, std::size_t i, double least, double most) const
{
    const std::string& cell = cells[i];
    if (cell.empty())
        return std::optional<double>{};
    const auto value = parseNumber(cell, m_header->separator != ',');
    if (!value)
        return wrong(m_header->names[i] + " is '" + cell + "'; expected a number of degrees");
    if (*value < least || *value > most)
        return wrong(m_header->names[i] + " is " + cell + "; expected " + shortestText(least) + " to " + shortestText(most));
    return std::optional(*value);
}

/// Makes both headings of what the row states, and holds what it states twice against itself.
Result<void> Reader::complete(Reading& reading, std::optional<double> deviation_deg)
{
    if (!reading.magnetic && reading.trueHeading && m_file.swing.variation_deg)
        reading.magnetic = toMagnetic(*reading.trueHeading, Variation::fromDegrees(*m_file.swing.variation_deg));
    if (deviation_deg) {
        const auto deviation = Deviation::fromDegrees(*deviation_deg);
        if (reading.magnetic && reading.compass) {
            const double apart_deg = wrap180(deviationOf(*reading.magnetic, *reading.compass).degrees() - deviation.degrees());
            if (std::abs(apart_deg) > kAgreement_deg)
                return wrong("the deviation " + shortestText(deviation.degrees()) + " is not magnetic - compass, which is "
                    + shortestText(deviationOf(*reading.magnetic, *reading.compass).degrees()) + "; expected them to agree to 0.05 degrees");
        } else if (reading.magnetic) {
            reading.compass = toCompass(*reading.magnetic, deviation);
        } else if (reading.compass) {
            reading.magnetic = toMagnetic(*reading.compass, deviation);
        }
    }
    if (!reading.complete())
        return wrong("a cell is empty; expected two of magnetic (or true) heading, compass heading and deviation");
    return {};
}

Result<void> Reader::readRow(const std::string& line)
{
    const auto cells = splitCells(line, m_header->separator);
    if (!cells)
        return wrong("a quote is not closed", ErrorCode::Format);
    if (cells->size() != m_header->columns.size())
        return wrong("the row has " + std::to_string(cells->size()) + (cells->size() == 1 ? " cell" : " cells") + "; expected "
            + std::to_string(m_header->columns.size()) + " cells, as in the header", ErrorCode::Format);
    if (m_file.swing.readings.size() == kMaxReadings)
        return wrong("more than " + std::to_string(kMaxReadings) + " readings; expected one swing in a file");

    Reading reading;
    std::optional<double> deviation_deg;
    for (std::size_t i = 0; i < cells->size(); ++i) {
        const Column column = m_header->columns[i];
        if (column == Column::Note) {
            reading.note = (*cells)[i];
        } else if (column == Column::Excluded) {
            if (!(*cells)[i].empty())
                reading.exclusion = Exclusion{(*cells)[i]};
        } else if (column == Column::Unknown) {
            reading.extra.emplace_back(m_header->names[i], (*cells)[i]);
        } else {
            const bool difference = column == Column::Deviation || column == Column::IndicationError || column == Column::Roll;
            const double most = difference ? 180.0 : column == Column::Pitch ? 90.0 : 360.0;
            const double least = difference || column == Column::Pitch ? -most : 0.0;
            const auto value = number(*cells, i, least, most);
            if (!value)
                return value.error();
            if (!*value)
                continue;
            switch (column) {
            case Column::Magnetic: reading.magnetic = MagneticHeading::fromDegrees(**value); break;
            case Column::Compass: reading.compass = CompassHeading::fromDegrees(**value); break;
            case Column::True: reading.trueHeading = TrueHeading::fromDegrees(**value); break;
            case Column::Deviation: deviation_deg = **value; break;
            case Column::IndicationError: deviation_deg = -**value; break; // indicated - actual is the opposite of deviation
            case Column::Nominal: reading.nominal_deg = wrap360(**value); break;
            case Column::Pitch: reading.pitch_deg = **value; break;
            case Column::Roll: reading.roll_deg = **value; break;
            default: break;
            }
        }
    }
    if (const auto done = complete(reading, deviation_deg); !done)
        return done;
    m_file.swing.readings.push_back(std::move(reading));
    return {};
}

Result<SwingFile> Reader::read()
{
    for (;;) {
        const auto line = m_lines.next();
        if (!line)
            return line.error();
        if (!*line)
            break;
        if (m_progress && m_lines.line() % 4096 == 0 && !m_progress(m_lines.fraction()))
            return Error{ErrorCode::Cancelled, "cancelled", m_name};
        const std::string text = trimmed(**line);
        if (text.empty())
            continue;
        const auto done = text.starts_with('#') ? readKey(text) : m_header ? readRow(**line) : readHeader(text);
        if (!done)
            return done.error();
    }
    if (m_lines.line() == 0)
        return Error{ErrorCode::Format, "the file is empty; expected a header of columns and a reading a row", m_name};
    if (!m_header)
        return Error{ErrorCode::Format, "the file has no header; expected a line of columns like magnetic_heading_deg,compass_heading_deg", m_name};
    if (m_file.swing.readings.empty())
        return Error{ErrorCode::Format, "the file has a header but no readings; expected a reading a row", m_name};
    if (m_progress)
        m_progress(1.0);
    for (const auto& [key, value] : m_file.otherKeys)
        m_file.swing.note += (m_file.swing.note.empty() ? "" : "\n") + key + ": " + value;
    return std::move(m_file);
}

/// What makes two files the same swing: what was read, when, on what.
std::string canonicalText(const SwingFile& file)
{
    std::string text = file.aircraft + "|" + file.compass + "|" + file.swing.date + "|" + wordFor(file.swing.kind) + "|" + wordFor(file.swing.stage) + "|"
        + wordFor(file.swing.configuration.radio);
    for (const auto& reading : file.swing.readings)
        text += "|" + shortestText(reading.magnetic->degrees()) + " " + shortestText(reading.compass->degrees());
    return text;
}

} // namespace

Result<SwingFile> readSwingCsv(std::istream& input, const std::string& name, const Progress& progress)
{
    auto file = Reader(input, name, progress).read();
    if (file)
        file->swing.record = recordIdFor(canonicalText(*file));
    return file;
}

Result<SwingFile> readSwingCsvFile(const std::string& path, const Progress& progress)
{
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored))
        return Error{ErrorCode::Io, "this is a folder; expected a swing CSV file", path};
    std::ifstream input(path, std::ios::binary);
    if (!input)
        return Error{ErrorCode::Io, "the file cannot be opened; expected a swing CSV file that is there and may be read", path};
    return readSwingCsv(input, path, progress);
}

std::vector<Observation> observationsOf(const Swing& swing)
{
    std::vector<Observation> observations;
    for (const auto& reading : swing.readings)
        if (reading.used())
            observations.push_back({*reading.magnetic, *reading.compass});
    return observations;
}

Result<Fleet> toFleet(const SwingFile& file)
{
    if (file.aircraft.empty())
        return Error{ErrorCode::InvalidInput, "the file does not name the aircraft; expected a line '# aircraft: REGISTRATION' (or --aircraft)"};
    SwingRecord record;
    record.swing = file.swing;
    record.swing.record = recordIdFor(canonicalText(file)); // the aircraft may have been named only now
    record.aircraft.registration = file.aircraft;
    record.aircraft.operatorName = file.operatorName;
    record.type.name = file.type;
    record.compass.name = file.compass;
    if (!file.site.empty()) {
        Site site;
        site.name = file.site;
        site.variation_deg = file.swing.variation_deg;
        record.site = site;
    }
    return toFleet(record);
}

std::string writeSwingCsv(const SwingRecord& record)
{
    const Swing& swing = record.swing;
    std::string out;
    const auto key = [&](const char* name, std::string value) {
        std::replace(value.begin(), value.end(), '\n', ' ');
        if (!value.empty())
            out += std::string("# ") + name + ": " + value + "\n";
    };
    key("aircraft", record.aircraft.registration);
    key("type", record.type.name);
    key("compass", record.compass.name);
    key("site", record.site ? record.site->name : "");
    key("operator", record.aircraft.operatorName);
    key("date", swing.date);
    key("kind", wordFor(swing.kind));
    key("stage", wordFor(swing.stage));
    key("radio", wordFor(swing.configuration.radio));
    key("engines", swing.configuration.engines);
    key("electrics", swing.configuration.electrics);
    key("configuration", swing.configuration.other);
    key("datum", swing.datum.instrument);
    key("datum_serial", swing.datum.serialNumber);
    key("datum_calibration_due", swing.datum.calibrationDue);
    key("datum_reader", swing.people.datumReader);
    key("cockpit_reader", swing.people.cockpitReader);
    key("adjuster", swing.people.adjuster);
    key("inspector", swing.people.inspector);
    key("variation_deg", swing.variation_deg ? shortestText(*swing.variation_deg) : "");
    key("procedure", swing.procedure);
    key("work_order", swing.workOrder);
    key("reason", swing.reason);
    key("note", swing.note);

    out += "magnetic_heading_deg,compass_heading_deg,deviation_deg,nominal_deg,true_heading_deg,pitch_deg,roll_deg,note,excluded\n";
    const auto figure = [](std::optional<double> value) { return value ? shortestText(*value) : std::string(); };
    for (const auto& reading : swing.readings) {
        if (!reading.complete())
            continue;
        const double deviation_deg = deviationOf(*reading.magnetic, *reading.compass).degrees();
        out += shortestText(reading.magnetic->degrees()) + "," + shortestText(reading.compass->degrees()) + "," + shortestText(deviation_deg) + ","
            + figure(reading.nominal_deg) + "," + (reading.trueHeading ? shortestText(reading.trueHeading->degrees()) : "") + ","
            + figure(reading.pitch_deg) + "," + figure(reading.roll_deg) + "," + quoteCell(reading.note) + ","
            + quoteCell(reading.exclusion ? reading.exclusion->reason : "") + "\n";
    }
    return out;
}

} // namespace lubberline
