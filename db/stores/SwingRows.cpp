#include "db/stores/SwingRows.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QLocale>
#include <QStringList>

namespace lubberline::db {

namespace {

constexpr int kStampColumns = 8;

std::string extraText(const Reading& reading)
{
    QJsonArray pairs;
    for (const auto& [name, value] : reading.extra)
        pairs.append(QJsonArray{QString::fromStdString(name), QString::fromStdString(value)});
    return QJsonDocument(pairs).toJson(QJsonDocument::Compact).toStdString();
}

std::vector<std::pair<std::string, std::string>> extraFrom(const std::string& text)
{
    std::vector<std::pair<std::string, std::string>> extra;
    if (text == "[]") // nearly always
        return extra;
    for (const auto& pair : QJsonDocument::fromJson(QByteArray::fromStdString(text)).array())
        extra.emplace_back(pair.toArray().at(0).toString().toStdString(), pair.toArray().at(1).toString().toStdString());
    return extra;
}

/// Three arrays: datum, astern, compass; nothing where no figures were kept apart.
std::string rawText(const RawFigures& raw)
{
    if (raw.empty())
        return {};
    QJsonArray all;
    for (const auto* figures : {&raw.datum_deg, &raw.astern_deg, &raw.compass_deg}) {
        QJsonArray one;
        for (const double figure : *figures)
            one.append(figure);
        all.append(one);
    }
    return QJsonDocument(all).toJson(QJsonDocument::Compact).toStdString();
}

RawFigures rawFrom(const std::string& text)
{
    RawFigures raw;
    if (text.empty()) // nearly always
        return raw;
    const QJsonArray all = QJsonDocument::fromJson(QByteArray::fromStdString(text)).array();
    qsizetype place = 0;
    for (auto* figures : {&raw.datum_deg, &raw.astern_deg, &raw.compass_deg})
        for (const auto& figure : all.at(place++).toArray())
            figures->push_back(figure.toDouble());
    return raw;
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
    stamp.date = row.text(first + 4);
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
        "start_utc", "end_utc", "site_override", "weather", "job_record", "supersedes", "amendment", "revision"};
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
    swing.date = row.text(column++);
    swing.kind = row.as<SwingKind>(column++);
    swing.stage = row.as<SwingStage>(column++);
    swing.state = row.as<SwingState>(column++);
    swing.configuration.radio = row.as<RadioState>(column++);
    for (std::string* field : {&swing.configuration.engines, &swing.configuration.electrics, &swing.configuration.other,
             &swing.datum.instrument, &swing.datum.serialNumber, &swing.datum.calibrationDue, &swing.people.datumReader,
             &swing.people.cockpitReader, &swing.people.adjuster, &swing.people.inspector})
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
    swing.revision = static_cast<int>(row.integer(column));
    return swing;
}

QString swingRowColumns()
{
    return "id, compass_id, date, kind, stage, state, reading_count, max_abs_deviation_deg, a_deg, b_deg, c_deg, d_deg, e_deg, status, revision,"
           " EXISTS (SELECT 1 FROM swing n WHERE n.supersedes = swing.record), EXISTS (SELECT 1 FROM swing_job j WHERE j.swing_id = swing.id AND j.state = 0)";
}

SwingRow swingRowFrom(const Statement& row)
{
    return {row.id<SwingId>(0), row.id<CompassId>(1), row.text(2), row.as<SwingKind>(3), row.as<SwingStage>(4), row.as<SwingState>(5),
        static_cast<int>(row.integer(6)), row.optionalReal(7),
        {row.optionalReal(8), row.optionalReal(9), row.optionalReal(10), row.optionalReal(11), row.optionalReal(12)}, row.as<Status>(13),
        static_cast<int>(row.integer(14)), row.integer(15) != 0, row.integer(16) != 0};
}

void bindParticulars(Statement& statement, const Swing& swing)
{
    statement << swing.compass << swing.site << swing.date << static_cast<int>(swing.kind) << static_cast<int>(swing.stage)
              << static_cast<int>(swing.state) << static_cast<int>(swing.configuration.radio) << swing.configuration.engines
              << swing.configuration.electrics << swing.configuration.other << swing.datum.instrument << swing.datum.serialNumber
              << swing.datum.calibrationDue << swing.people.datumReader << swing.people.cockpitReader << swing.people.adjuster
              << swing.people.inspector << swing.variation_deg << swing.procedure << swing.workOrder << swing.reason << swing.note;
    bindStamp(statement, swing.field);
    statement << swing.indexRemoved_deg << swing.datum.readOut << swing.startUtc << swing.endUtc << swing.siteOverride << swing.weather
              << swing.job << swing.supersedes << swing.amendment << swing.revision;
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
    reading.extra = extraFrom(row.text(column++));
    reading.raw = rawFrom(row.text(column++));
    reading.timeUtc = row.text(column++);
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
    statement << extraText(reading) << rawText(reading.raw) << reading.timeUtc;
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
        add("extra", extraText(reading));
    if (!reading.raw.empty())
        add("figures", rawText(reading.raw));
    return text.empty() ? "empty" : text;
}

} // namespace lubberline::db
