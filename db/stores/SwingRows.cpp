#include "db/stores/SwingRows.h"

#include <QLocale>
#include <QStringList>

#include "core/format/exchange/RowJson.h"
#include "core/record/Ranges.h"

namespace lubberline::db {

namespace {

constexpr int kStampColumns = 8;

/// Its own parts of a row; a text that does not read damages the row.
template <class Value>
Value partOf(const Statement& row, int column, Result<Value> (*read)(std::string_view))
{
    const std::size_t before = row.damages().size();
    auto value = read(row.longText(column));
    if (value)
        return std::move(value.value());
    if (row.damages().size() == before)
        row.damages(column, value.error());
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
    stamp.model = row.optionalText(first);
    if (stamp.model.empty())
        return {};
    stamp.place = {row.real(first + 1, kLatitudeRange), row.real(first + 2, kSignedAngleRange), row.real(first + 3, kHeightRange)};
    stamp.date = row.day(first + 4);
    if (stamp.date.empty())
        row.damages(first + 4, MARKED("db", "a day of the calendar as YYYY-MM-DD"));
    stamp.field = {row.real(first + 5, kFieldRange), row.real(first + 6, kFieldRange), row.real(first + 7, kFieldRange)};
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
        "stage_stated", "shared_error_deg"};
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
    swing.record = row.record(column++);
    swing.compass = row.id<CompassId>(column++);
    swing.site = row.optionalId<SiteId>(column++);
    swing.date = row.day(column++);
    swing.kind = row.as(column++, SwingKind::Air);
    swing.stage = row.as(column++, SwingStage::AsLeft);
    swing.state = row.as(column++, SwingState::Signed);
    swing.configuration.radio = row.as(column++, RadioState::Off);
    for (std::string* field : {&swing.configuration.engines, &swing.configuration.electrics, &swing.configuration.other,
             &swing.datum.instrument, &swing.datum.serialNumber})
        *field = row.text(column++);
    swing.datum.calibrationDue = row.day(column++);
    for (std::string* field : {&swing.people.datumReader, &swing.people.cockpitReader, &swing.people.adjuster, &swing.people.inspector})
        *field = row.text(column++);
    swing.variation_deg = row.optionalReal(column++, kSignedAngleRange);
    for (std::string* field : {&swing.procedure, &swing.workOrder, &swing.reason, &swing.note})
        *field = row.text(column++);
    swing.field = stampFrom(row, column);
    column += kStampColumns;
    swing.indexRemoved_deg = row.optionalReal(column++, kSignedAngleRange);
    swing.datum.readOut = row.text(column++);
    swing.startUtc = row.moment(column++);
    swing.endUtc = row.moment(column++);
    swing.siteOverride = row.text(column++);
    swing.weather = row.text(column++);
    swing.job = row.optionalRecord(column++);
    swing.supersedes = row.optionalRecord(column++);
    swing.amendment = row.text(column++);
    swing.revision = row.integer(column++, kRevisionRange);
    if (!row.flag(column++))
        swing.kind = SwingKind::NotStated;
    if (!row.flag(column++))
        swing.stage = SwingStage::NotStated;
    swing.sharedErrors = partOf(row, column, readSharedErrors);
    return swing;
}

QString swingRowColumns()
{
    return "id, compass_id, date, CASE kind_stated WHEN 1 THEN kind ELSE 4 END AS kind, CASE stage_stated WHEN 1 THEN stage ELSE 2 END"
           " AS stage, state, reading_count, max_abs_deviation_deg, a_deg, b_deg, c_deg, d_deg, e_deg, status, revision,"
           " EXISTS (SELECT 1 FROM swing n WHERE n.supersedes = swing.record), EXISTS (SELECT 1 FROM swing_job j WHERE j.swing_id = swing.id AND j.state = 0),"
           " EXISTS (SELECT 1 FROM swing_job j WHERE j.swing_id = swing.id AND j.state = 2)";
}

SwingRow swingRowFrom(const Statement& row)
{
    // Kept figures are what core made of readings; few of them can make very large coefficients.
    const auto coefficient_deg = [&row](int column) { return row.optionalReal(column, {-1e9, 1e9}); };
    return {row.id<SwingId>(0), row.id<CompassId>(1), row.day(2), row.as(3, SwingKind::NotStated), row.as(4, SwingStage::NotStated),
        row.as(5, SwingState::Signed), row.integer(6, {0, double{kMaxReadings}}), row.optionalReal(7, {0, 180}),
        {coefficient_deg(8), coefficient_deg(9), coefficient_deg(10), coefficient_deg(11), coefficient_deg(12)},
        row.as(13, Status::OutOfLimits), row.integer(14, kRevisionRange), row.flag(15), row.flag(16), row.flag(17)};
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
              << swing.job << swing.supersedes << swing.amendment << swing.revision << kindStated << stageStated
              << textOf(swing.sharedErrors);
}

Reading readingFrom(const Statement& row, int first)
{
    int column = first;
    Reading reading;
    reading.id = row.id<ReadingId>(column++);
    reading.nominal_deg = row.optionalReal(column++, kHeadingRange);
    reading.magnetic = headingFrom<MagneticHeading>(row.optionalReal(column++, kHeadingRange));
    reading.compass = headingFrom<CompassHeading>(row.optionalReal(column++, kHeadingRange));
    reading.trueHeading = headingFrom<TrueHeading>(row.optionalReal(column++, kHeadingRange));
    reading.pitch_deg = row.optionalReal(column++, kPitchRange);
    reading.roll_deg = row.optionalReal(column++, kRollRange);
    reading.note = row.text(column++);
    if (const std::string reason = row.optionalText(column++); !reason.empty())
        reading.exclusion = Exclusion{reason};
    reading.extra = partOf(row, column++, readExtraRow);
    reading.raw = partOf(row, column++, readRawRow);
    reading.timeUtc = row.moment(column++);
    return reading;
}

QString headingColumns() { return "r.magnetic_heading_deg, r.compass_heading_deg, COALESCE(r.exclusion_reason, '') <> ''"; }

Reading headingsOnlyFrom(const Statement& row, int first)
{
    Reading reading;
    reading.magnetic = headingFrom<MagneticHeading>(row.optionalReal(first, kHeadingRange));
    reading.compass = headingFrom<CompassHeading>(row.optionalReal(first + 1, kHeadingRange));
    if (row.flag(first + 2))
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
