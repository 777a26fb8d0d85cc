#include "core/format/csv/WindCsv.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/base/Date.h"
#include "core/base/FileText.h"
#include "core/base/WholeFile.h"
#include "core/format/csv/FigureCsv.h"
#include "core/format/csv/WindHands.h"

namespace lubberline {

namespace {

constexpr double kKnotsOfMetres = 3600.0 / 1852.0, kKnotsOfKilometres = 1000.0 / 1852.0;
constexpr std::array kSpeeds{UnitSuffix{"_kt", 1}, UnitSuffix{"_m_s", kKnotsOfMetres}, UnitSuffix{"_km_h", kKnotsOfKilometres}};
constexpr std::array kHeights{UnitSuffix{"_m", 1}, UnitSuffix{"_ft", 0.3048}};
constexpr std::array kDegrees{UnitSuffix{"_deg", 1}};
constexpr std::array kFromOrToward{UnitSuffix{"_from_deg", 1}, UnitSuffix{"_toward_deg", -1}};
constexpr std::array<std::string_view, 10> kWindColumnNames{
    "ground_speed", "track", "tas", "wind_", "ref_wind", "aircraft", "flight", "time_utc", "latitude", "heading"};

enum class Bounds { Any, Speed, Direction, Latitude, Longitude };

/// A figure of the report and where it goes.
struct WindField {
    double WindReport::*field;
    std::string_view name;
    std::span<const UnitSuffix> units;
    Bounds bounds;
    bool required;
};

const std::array kWindFields{
    WindField{&WindReport::groundSpeed_kt, "ground_speed", kSpeeds, Bounds::Speed, true},
    WindField{&WindReport::track_deg, "track", kDegrees, Bounds::Direction, true},
    WindField{&WindReport::tas_kt, "tas", kSpeeds, Bounds::Speed, false},
    WindField{&WindReport::wind_kt, "wind_speed", kSpeeds, Bounds::Speed, false},
    WindField{&WindReport::windFrom_deg, "wind", kFromOrToward, Bounds::Direction, false},
    WindField{&WindReport::reference_kt, "ref_wind_speed", kSpeeds, Bounds::Speed, true},
    WindField{&WindReport::referenceFrom_deg, "ref_wind", kFromOrToward, Bounds::Direction, true},
    WindField{&WindReport::heading_deg, "heading", kDegrees, Bounds::Direction, false},
    WindField{&WindReport::roll_deg, "roll", kDegrees, Bounds::Any, false},
    WindField{&WindReport::latitude_deg, "latitude", kDegrees, Bounds::Latitude, false},
    WindField{&WindReport::longitude_deg, "longitude", kDegrees, Bounds::Longitude, false},
    WindField{&WindReport::altitude_m, "altitude", kHeights, Bounds::Any, false},
};

struct TakenField {
    WindField field;
    FigureColumn column;
};

Message boundsText(Bounds bounds)
{
    switch (bounds) {
    case Bounds::Any: break;
    case Bounds::Speed: return MARKED("core", "0 to 3000 knots");
    case Bounds::Direction: return MARKED("core", "0 to 360");
    case Bounds::Latitude: return MARKED("core", "-90 to 90");
    case Bounds::Longitude: return MARKED("core", "-180 to 360");
    }
    return MARKED("core", "a number");
}

bool within(Bounds bounds, double value)
{
    switch (bounds) {
    case Bounds::Any: return true;
    case Bounds::Speed: return !(value < 0) && !(value > 3000);
    case Bounds::Direction: return !(value < -180) && !(value > 360);
    case Bounds::Latitude: return !(std::abs(value) > 90);
    case Bounds::Longitude: return !(value < -180) && !(value > 360);
    }
    return true;
}

/// "T10:00:00Z", what stands behind the day; NaN: it is no time.
double secondsOfDay(std::string_view text)
{
    const auto digits = [&](std::size_t at, int most) {
        if (at + 2 > text.size() || text[at] < '0' || text[at] > '9' || text[at + 1] < '0' || text[at + 1] > '9')
            return -1;
        const int value = 10 * (text[at] - '0') + text[at + 1] - '0';
        return value <= most ? value : -1;
    };
    if (text.size() < 6 || (text[0] != 'T' && text[0] != ' ') || text[3] != ':')
        return kMissing;
    const int hour = digits(1, 23), minute = digits(4, 59);
    double second = 0;
    std::string_view rest = text.substr(6);
    if (rest.starts_with(':')) {
        const int whole = digits(7, 60);
        if (whole < 0)
            return kMissing;
        rest.remove_prefix(3);
        second = whole;
        if (rest.starts_with('.') || rest.starts_with(',')) {
            double unit = 0.1;
            rest.remove_prefix(1);
            while (!rest.empty() && rest.front() >= '0' && rest.front() <= '9') {
                second += unit * (rest.front() - '0');
                unit *= 0.1;
                rest.remove_prefix(1);
            }
        }
    }
    if (hour < 0 || minute < 0 || !(rest.empty() || rest == "Z" || rest == "z" || rest == "+00:00"))
        return kMissing;
    return hour * 3600.0 + minute * 60.0 + second;
}

/// Seconds since 1970 to the beginning of a day "2014-01-05"; NaN: it is none.
double secondsToDay(std::string_view text)
{
    const auto day = Date::read(text);
    return day ? static_cast<double>(std::chrono::sys_days(day->day()).time_since_epoch().count()) * 86400.0 : kMissing;
}

class WindReader {
public:
    WindReader(
        std::istream& input, const std::string& name, const WindOptions& options, const WindReading& reading, const Progress& progress)
        : m_csv(input, name, MARKED("core", "a Wind CSV: named columns, a report a row"), progress)
        , m_name(name)
        , m_study(options)
        , m_reading(reading)
    {
    }

    Result<WindFile> read()
    {
        if (const auto header = takeHeader(); !header)
            return header.error();
        WindHands hands(m_study);
        const auto rows = takeRows(hands);
        const auto stopped = hands.done(); // which is above the row that cannot be read, if both are there
        switch (stopped.excess) {
        case WindHands::Excess::None: break;
        case WindHands::Excess::Aircraft:
            return Error{ErrorCode::InvalidInput,
                {MARKED("core", "there are more than %1 aircraft; expected reports of fewer at a time"), WindHands::kMostAircraft}, m_name,
                stopped.line};
        case WindHands::Excess::Flights:
            return Error{ErrorCode::InvalidInput,
                {MARKED("core", "there are more than %1 flights; expected reports of fewer at a time, and those of a flight together"),
                    WindHands::kMostFlights},
                m_name, stopped.line};
        }
        if (!rows)
            return rows.error();
        if (m_study.observations() == 0)
            return m_csv.wholeFile(MARKED("core", "has a header but no reports; expected one a row below it"));
        WindFile file;
        file.result = m_study.finish();
        file.warnings = std::move(m_warnings);
        file.warnings.insert(file.warnings.end(), file.result.warnings.begin(), file.result.warnings.end());
        return file;
    }

private:
    [[nodiscard]] static bool isGround(const WindField& field)
    {
        return field.field == &WindReport::groundSpeed_kt || field.field == &WindReport::track_deg;
    }

    Result<void> takeHeader()
    {
        if (const auto header = m_csv.readHeader(kWindColumnNames); !header)
            return header;
        std::vector<bool> known(m_csv.columns().size());
        const bool fromPositions = m_csv.column("latitude_deg") && m_csv.column("longitude_deg") && m_csv.column("time_utc");
        for (const auto& field : kWindFields) {
            const auto column = m_csv.column(field.name, field.units);
            if (!column)
                return column.error();
            if (*column) {
                m_fields.push_back({field, **column});
                known[(*column)->place] = true;
            } else if (field.required && !(fromPositions && isGround(field))) {
                return m_csv.here(
                    {MARKED("core",
                         "there is no column %1; expected ground_speed_kt, track_deg, wind_speed_kt, wind_from_deg, ref_wind_speed_kt and ref_wind_from_deg; or, in place of both first, latitude_deg, longitude_deg and time_utc"),
                        inQuotes(std::string(field.name) + std::string(field.units.front().suffix))});
            }
        }
        const auto text = [&](std::string_view name) {
            const auto place = m_csv.column(name);
            if (place)
                known[*place] = true;
            return place;
        };
        m_aircraft = text("aircraft");
        m_flight = text("flight");
        m_time = text("time_utc");
        m_source = text("source");
        m_group = text("group");
        m_latitude = fromPositions ? m_csv.column("latitude_deg") : std::nullopt;
        const bool hasWind = m_csv.column("wind_speed", kSpeeds)->has_value() && m_csv.column("wind", kFromOrToward)->has_value();
        const bool hasHeading = m_csv.column("heading_deg") && m_csv.column("tas", kSpeeds)->has_value();
        if (!hasWind && !hasHeading)
            return m_csv.here(
                MARKED("core", "there is no reported wind; expected wind_speed_kt and wind_from_deg, or heading_deg and tas_kt"));
        for (std::size_t i = 0; i < known.size(); ++i)
            if (!known[i] && !m_csv.columns()[i].empty())
                m_warnings.push_back({MARKED("core", "the column %1 means nothing here"), inQuotes(m_csv.columns()[i])});
        if (!m_csv.column("latitude_deg") || !m_csv.column("longitude_deg") || !m_time)
            m_warnings.push_back(MARKED("core",
                "there is no position with a time: the declination is not taken out, and the argument of the fit is the true heading"));
        return {};
    }

    Result<void> takeRows(WindHands& hands)
    {
        while (!hands.stopped()) {
            const auto more = m_csv.next();
            if (!more)
                return more.error();
            if (!*more)
                break;
            if (const auto fault = takeRow(hands))
                return *fault;
        }
        return {};
    }

    std::optional<Error> takeRow(WindHands& hands)
    {
        WindReport report;
        for (const auto& [field, column] : m_fields) {
            double& value = report.*field.field;
            if (!m_csv.figure(column.place, value))
                return m_csv.noFigure(column.place);
            if (column.factor > 0)
                value *= column.factor;
            else
                value = value < 180.0 ? value + 180.0 : value - 180.0; // toward
            if (!within(field.bounds, value))
                return m_csv.here({MARKED("core", "%1 is %2; expected %3"), m_csv.columns()[column.place],
                    inQuotes(m_csv.cell(column.place)), boundsText(field.bounds)});
        }
        report.wind_kt *= m_reading.windFactor;
        report.reference_kt *= m_reading.referenceFactor;
        if (m_reading.toward)
            report.windFrom_deg += 180.0;
        if (m_reading.referenceToward)
            report.referenceFrom_deg += 180.0;
        if (m_time)
            if (const std::string_view cell = m_csv.cell(*m_time); !cell.empty()) {
                report.time_s = timeOf(cell);
                if (!std::isfinite(report.time_s))
                    return m_csv.here({MARKED("core", "time_utc %1 is no time; expected YYYY-MM-DDTHH:MM:SSZ"), inQuotes(cell)});
            }
        for (const auto& place : {m_aircraft, m_flight, m_source, m_group})
            if (place && !m_csv.isName(*place))
                return m_csv.noName(*place);
        const auto text = [&](const std::optional<std::size_t>& place) { return place ? m_csv.cell(*place) : std::string_view(); };
        report.aircraft = text(m_aircraft);
        report.flight = text(m_flight);
        report.source = text(m_source);
        report.group = text(m_group);
        if (m_latitude) {
            const std::string_view latitude = m_csv.cell(*m_latitude);
            const auto point = latitude.find_first_of(".,");
            if (point != std::string_view::npos)
                m_decimals = std::clamp(latitude.size() - point - 1, m_decimals, std::size_t{9});
            report.positionStep_deg = kSteps_deg[m_decimals];
        }
        hands.add(report, m_csv.line());
        return {};
    }

    /// Reports of one day follow one another.
    double timeOf(std::string_view cell)
    {
        if (cell.substr(0, 10) != m_day) {
            m_day = cell.substr(0, 10);
            m_dayFrom_s = secondsToDay(m_day);
        }
        return cell.size() > 10 ? m_dayFrom_s + secondsOfDay(cell.substr(10)) : kMissing;
    }

    FigureCsv m_csv;
    std::string m_name;
    WindStudy m_study;
    std::string m_day;
    double m_dayFrom_s = kMissing;
    WindReading m_reading;
    std::vector<TakenField> m_fields;
    std::optional<std::size_t> m_aircraft, m_flight, m_time, m_source, m_group, m_latitude;
    std::size_t m_decimals = 0; ///< of latitudes, the most so far: a program may leave zeros away
    static constexpr std::array<double, 10> kSteps_deg{1, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9};
    std::vector<Message> m_warnings;
};

} // namespace

double secondsOfUtc(std::string_view text)
{
    return text.size() > 10 ? secondsToDay(text.substr(0, 10)) + secondsOfDay(text.substr(10)) : kMissing;
}

Result<WindFile> readWindCsv(
    std::istream& input, const std::string& name, const WindOptions& options, const WindReading& reading, const Progress& progress)
{
    return WindReader(input, name, options, reading, progress).read();
}

Result<WindFile> readWindCsvFile(const std::string& path, const WindOptions& options, const WindReading& reading, const Progress& progress)
{
    const auto file = openInput(path, MARKED("core", "a Wind CSV"));
    return file ? readWindCsv(**file, nameOfInput(path), options, reading, progress) : Result<WindFile>(file.error());
}

} // namespace lubberline
