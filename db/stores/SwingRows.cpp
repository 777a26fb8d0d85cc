#include "db/stores/SwingRows.h"

#include <QLocale>
#include <QStringList>

#include "core/format/exchange/RowJson.h"

namespace lubberline::db {

namespace {

constexpr int kStampColumns = 8;

/// Its own parts of a row; a text that does not read damages the row.
template <class Value>
Value partOf(const Statement& row, int column, Result<Value> (*read)(std::string_view))
{
    auto value = read(row.text(column));
    if (value)
        return std::move(value.value());
    row.damages(described(value.error()));
    return {};
}

template <class HeadingType>
std::optional<double> degreesOf(const std::optional<HeadingType>& heading)
{
    return heading ? std::optional(heading->degrees()) : std::nullopt;
}

template <class HeadingType>
std::optional<HeadingType> headingFrom(std::optional<double> heading_deg)
{
    return heading_deg ? std::optional(HeadingType::fromDegrees(*heading_deg)) : std::nullopt;
}

/// Eight columns from `first`; none where they are NULL.
std::optional<FieldStamp> stampFrom(const Statement& row, int first)
{
    FieldStamp stamp;
    stamp.model = row.text(first);
    if (stamp.model.empty())
        return {};
    stamp.place = {row.real(first + 1), row.real(first + 2), row.real(first + 3)};
    stamp.date = row.day(first + 4);
    stamp.field = {row.real(first + 5), row.real(first + 6), row.real(first + 7)};
    return stamp;
}

void bindStamp(Statement& statement, const std::optional<FieldStamp>& stamp)
{
    if (!stamp) {
        for (int column = 0; column < kStampColumns; ++column)
            statement.null();
        return;
    }
    statement << stamp->model << stamp->place.latitude_deg << stamp->place.longitude_deg << stamp->place.height_m << stamp->date
              << stamp->field.north_nT << stamp->field.east_nT << stamp->field.down_nT;
}

} // namespace

QStringList swingFields()
{
    return {"compass_id", "site_id", "date", "kind", "stage", "state", "radio", "engines", "electrics", "other_configuration",
        "datum_instrument", "datum_serial_number", "datum_calibration_due", "datum_reader", "cockpit_reader", "adjuster", "inspector",
        "variation_deg", "procedure_name", "work_order", "reason", "note", "field_model", "field_latitude_deg", "field_longitude_deg",
        "field_height_m", "field_date", "field_north_nT", "field_east_nT", "field_down_nT", "index_removed_deg", "datum_read_out",
        "start_utc", "end_utc", "site_override", "weather", "job_record", "supersedes", "amendment", "revision", "kind_stated",
        "stage_stated"};
}

QString swingColumns() { return "s.id, s.record, s." + swingFields().join(", s."); }

QStringList readingFields()
{
    return {"nominal_deg", "magnetic_heading_deg", "compass_heading_deg", "true_heading_deg", "pitch_deg", "roll_deg", "note",
        "exclusion_reason", "extra_json", "raw_json", "time_utc"};
}

QString readingColumns() { return "r.id, r." + readingFields().join(", r."); }

Swing swingFrom(const Statement& row, int first)
{
    int column = first;
    Swing swing;
    swing.id = row.id<SwingId>(column++);
    swing.record = row.text(column++);
    swing.compass = row.id<CompassId>(column++);
    swing.site = row.id<SiteId>(column++);
    swing.date = row.day(column++);
    swing.kind = row.as<SwingKind>(column++);
    swing.stage = row.as<SwingStage>(column++);
    swing.state = row.as<SwingState>(column++);
    swing.configuration.radio = row.as<RadioState>(column++);
    for (std::string* field : {&swing.configuration.engines, &swing.configuration.electrics, &swing.configuration.other,
             &swing.datum.instrument, &swing.datum.serialNumber})
        *field = row.text(column++);
    swing.datum.calibrationDue = row.day(column++);
    for (std::string* field : {&swing.people.datumReader, &swing.people.cockpitReader, &swing.people.adjuster, &swing.people.inspector})
        *field = row.text(column++);
    swing.variation_deg = row.optionalReal(column++);
    for (std::string* field : {&swing.procedure, &swing.workOrder, &swing.reason, &swing.note})
        *field = row.text(column++);
    swing.field = stampFrom(row, column);
    column += kStampColumns;
    swing.indexRemoved_deg = row.optionalReal(column++);
    for (std::string* field : {&swing.datum.readOut, &swing.startUtc, &swing.endUtc, &swing.siteOverride, &swing.weather, &swing.job,
             &swing.supersedes, &swing.amendment})
        *field = row.text(column++);
    swing.revision = static_cast<int>(row.integer(column++));
    if (row.integer(column++) == 0)
        swing.kind = SwingKind::NotStated;
    if (row.integer(column) == 0)
        swing.stage = SwingStage::NotStated;
    return swing;
}

QString swingRowColumns()
{
    return "id, compass_id, date, CASE kind_stated WHEN 1 THEN kind ELSE 4 END, CASE stage_stated WHEN 1 THEN stage ELSE 2 END, state,"
           " reading_count, max_abs_deviation_deg, a_deg, b_deg, c_deg, d_deg, e_deg, status, revision,"
           " EXISTS (SELECT 1 FROM swing n WHERE n.supersedes = swing.record), EXISTS (SELECT 1 FROM swing_job j WHERE j.swing_id = swing.id AND j.state = 0),"
           " EXISTS (SELECT 1 FROM swing_job j WHERE j.swing_id = swing.id AND j.state = 2)";
}

SwingRow swingRowFrom(const Statement& row)
{
    return {row.id<SwingId>(0), row.id<CompassId>(1), row.day(2), row.as<SwingKind>(3), row.as<SwingStage>(4), row.as<SwingState>(5),
        static_cast<int>(row.integer(6)), row.optionalReal(7),
        {row.optionalReal(8), row.optionalReal(9), row.optionalReal(10), row.optionalReal(11), row.optionalReal(12)}, row.as<Status>(13),
        static_cast<int>(row.integer(14)), row.integer(15) != 0, row.integer(16) != 0, row.integer(17) != 0};
}

void bindParticulars(Statement& statement, const Swing& swing)
{
    const bool kindStated = swing.kind != SwingKind::NotStated, stageStated = swing.stage != SwingStage::NotStated;
    statement << swing.compass << swing.site << swing.date << (kindStated ? static_cast<int>(swing.kind) : 0)
              << (stageStated ? static_cast<int>(swing.stage) : 0) << static_cast<int>(swing.state)
              << static_cast<int>(swing.configuration.radio) << swing.configuration.engines << swing.configuration.electrics
              << swing.configuration.other << swing.datum.instrument << swing.datum.serialNumber << swing.datum.calibrationDue
              << swing.people.datumReader << swing.people.cockpitReader << swing.people.adjuster << swing.people.inspector
              << swing.variation_deg << swing.procedure << swing.workOrder << swing.reason << swing.note;
    bindStamp(statement, swing.field);
    statement << swing.indexRemoved_deg << swing.datum.readOut << swing.startUtc << swing.endUtc << swing.siteOverride << swing.weather
              << swing.job << swing.supersedes << swing.amendment << swing.revision << kindStated << stageStated;
}

Reading readingFrom(const Statement& row, int first)
{
    int column = first;
    Reading reading;
    reading.id = row.id<ReadingId>(column++);
    reading.nominal_deg = row.optionalReal(column++);
    reading.magnetic = headingFrom<MagneticHeading>(row.optionalReal(column++));
    reading.compass = headingFrom<CompassHeading>(row.optionalReal(column++));
    reading.trueHeading = headingFrom<TrueHeading>(row.optionalReal(column++));
    reading.pitch_deg = row.optionalReal(column++);
    reading.roll_deg = row.optionalReal(column++);
    reading.note = row.text(column++);
    if (const std::string reason = row.text(column++); !reason.empty())
        reading.exclusion = Exclusion{reason};
    reading.extra = partOf(row, column++, readExtraRow);
    reading.raw = partOf(row, column++, readRawRow);
    reading.timeUtc = row.text(column++);
    return reading;
}

QString headingColumns() { return "r.magnetic_heading_deg, r.compass_heading_deg, COALESCE(r.exclusion_reason, '') <> ''"; }

Reading headingsOnlyFrom(const Statement& row, int first)
{
    Reading reading;
    reading.magnetic = headingFrom<MagneticHeading>(row.optionalReal(first));
    reading.compass = headingFrom<CompassHeading>(row.optionalReal(first + 1));
    if (row.integer(first + 2) != 0)
        reading.exclusion.emplace();
    return reading;
}

void bindReading(Statement& statement, const Reading& reading)
{
    statement << reading.nominal_deg << degreesOf(reading.magnetic) << degreesOf(reading.compass) << degreesOf(reading.trueHeading)
              << reading.pitch_deg << reading.roll_deg << reading.note;
    if (reading.exclusion)
        statement << reading.exclusion->reason;
    else
        statement.null();
    statement << writeExtraRow(reading.extra) << writeRawRow(reading.raw) << reading.timeUtc;
}

std::string auditText(const Reading& reading)
{
    std::string text;
    const auto add
        = [&](const char* name, const std::string& value) { text += (text.empty() ? "" : ", ") + std::string(name) + " " + value; };
    const auto figure = [&](const char* name, std::optional<double> value) {
        if (value)
            add(name, QString::number(*value, 'g', QLocale::FloatingPointShortest).toStdString());
    };
    figure("nominal", reading.nominal_deg);
    figure("magnetic", degreesOf(reading.magnetic));
    figure("compass", degreesOf(reading.compass));
    figure("true", degreesOf(reading.trueHeading));
    figure("pitch", reading.pitch_deg);
    figure("roll", reading.roll_deg);
    if (reading.exclusion)
        add("excluded:", reading.exclusion->reason);
    if (!reading.note.empty())
        add("note:", reading.note);
    if (!reading.extra.empty())
        add("extra", writeExtraRow(reading.extra));
    if (!reading.raw.empty())
        add("figures", writeRawRow(reading.raw));
    return text.empty() ? "empty" : text;
}

} // namespace lubberline::db
