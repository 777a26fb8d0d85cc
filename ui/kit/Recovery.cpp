#include "ui/kit/Recovery.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>

#include "core/base/OutputFile.h"
#include "core/format/exchange/JobJson.h"
#include "ui/kit/Words.h"

namespace lubberline::ui {

namespace {

template <class Heading>
void put(QJsonObject& object, const char* key, const std::optional<Heading>& heading)
{
    if (heading)
        object[QLatin1String(key)] = heading->degrees();
}

void put(QJsonObject& object, const char* key, const std::optional<double>& value)
{
    if (value)
        object[QLatin1String(key)] = *value;
}

std::optional<double> number(const QJsonObject& object, const char* key)
{
    const auto value = object[QLatin1String(key)];
    return value.isDouble() ? std::optional(value.toDouble()) : std::nullopt;
}

template <class Heading>
std::optional<Heading> heading(const QJsonObject& object, const char* key)
{
    const auto value = number(object, key);
    return value ? std::optional(Heading::fromDegrees(*value)) : std::nullopt;
}

QByteArray lineOf(const LostEntry& entry)
{
    QJsonObject object{{"database", toText(entry.database)}, {"swing", static_cast<qint64>(entry.swing.value)},
        {"record", toText(entry.record)}, {"subject", toText(entry.subject)}};
    if (const auto* step = std::get_if<LostStep>(&entry.what)) {
        object["place"] = static_cast<qint64>(step->place);
        object["event"] = toText(writeJobEvent(step->event));
    } else {
        const auto& lost = std::get<LostReading>(entry.what);
        QJsonObject reading{{"note", toText(lost.reading.note)}};
        put(reading, "nominal_deg", lost.reading.nominal_deg);
        put(reading, "magnetic_heading_deg", lost.reading.magnetic);
        put(reading, "compass_heading_deg", lost.reading.compass);
        put(reading, "true_heading_deg", lost.reading.trueHeading);
        put(reading, "pitch_deg", lost.reading.pitch_deg);
        put(reading, "roll_deg", lost.reading.roll_deg);
        if (lost.reading.exclusion)
            reading["excluded"] = toText(lost.reading.exclusion->reason);
        object["row"] = lost.row;
        object["reading"] = reading;
    }
    return QJsonDocument(object).toJson(QJsonDocument::Compact) + '\n';
}

std::optional<LostEntry> entryOf(const QByteArray& line)
{
    const QJsonObject object = QJsonDocument::fromJson(line).object();
    LostEntry entry;
    entry.database = object["database"].toString().toStdString();
    entry.swing = SwingId{object["swing"].toInteger()};
    entry.record = object["record"].toString().toStdString();
    entry.subject = object["subject"].toString().toStdString();
    if (entry.database.empty() || !entry.swing.valid())
        return {};
    if (object.contains("event")) {
        auto event = readJobEvent(object["event"].toString().toStdString(), "recovery file");
        if (!event)
            return {};
        entry.what = LostStep{static_cast<std::size_t>(object["place"].toInteger()), std::move(event.value())};
        return entry;
    }
    const QJsonObject stored = object["reading"].toObject();
    LostReading lost;
    lost.row = object["row"].toInt();
    lost.reading.nominal_deg = number(stored, "nominal_deg");
    lost.reading.magnetic = heading<MagneticHeading>(stored, "magnetic_heading_deg");
    lost.reading.compass = heading<CompassHeading>(stored, "compass_heading_deg");
    lost.reading.trueHeading = heading<TrueHeading>(stored, "true_heading_deg");
    lost.reading.pitch_deg = number(stored, "pitch_deg");
    lost.reading.roll_deg = number(stored, "roll_deg");
    lost.reading.note = stored["note"].toString().toStdString();
    if (stored.contains("excluded"))
        lost.reading.exclusion = Exclusion{stored["excluded"].toString().toStdString()};
    entry.what = lost;
    return entry;
}

QList<QByteArray> linesOf(const QString& path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return {};
    QList<QByteArray> lines = file.readAll().split('\n');
    lines.removeAll(QByteArray());
    return lines;
}

Result<void> putStep(db::Stores& stores, SwingId swing, const LostStep& step)
{
    const auto job = stores.jobs.jobOf(swing);
    if (!job)
        return job.error();
    if (*job && step.place < (*job)->job.events.size() && (*job)->job.events[step.place] == step.event)
        return {};
    return stores.jobs.append(swing, step.place, step.event);
}

Result<void> putReading(db::Stores& stores, const SwingRecord& record, const LostReading& lost)
{
    const auto& rows = record.swing.readings;
    if (lost.row < static_cast<int>(rows.size())) {
        const Reading& before = rows[static_cast<std::size_t>(lost.row)];
        Reading after = lost.reading;
        after.id = before.id;
        after.raw = before.raw;
        after.timeUtc = before.timeUtc;
        after.extra = before.extra;
        return stores.swings.changeReading(record.swing.id, before, after);
    }
    const auto added = stores.swings.insertReading(record.swing.id, static_cast<int>(rows.size()), lost.reading);
    return added ? Result<void>() : added.error();
}

} // namespace

Result<void> Recovery::keep(const LostEntry& entry) const
{
    const QByteArray line = lineOf(entry);
    for (const QString& path : m_paths) {
        QDir().mkpath(QFileInfo(path).absolutePath());
        QFile file(path);
        if (file.open(QIODevice::WriteOnly | QIODevice::Append) && file.write(line) == line.size() && file.flush())
            return {};
    }
    return Error{ErrorCode::Io, MARKED("ui", "no place was found to keep it until the database can be written again")};
}

std::vector<LostEntry> Recovery::entriesFor(const QString& database) const
{
    std::vector<LostEntry> entries;
    for (const QString& path : m_paths)
        for (const QByteArray& line : linesOf(path))
            if (auto entry = entryOf(line); entry && toText(entry->database) == database)
                entries.push_back(std::move(*entry));
    return entries;
}

Recovery::Restored Recovery::restore(db::Stores& stores) const
{
    Restored restored;
    std::vector<LostEntry> gone;
    for (const auto& entry : entriesFor(stores.location())) {
        const auto record = stores.swings.record(entry.swing);
        Result<void> done = !record                ? Result<void>(record.error())
            : record->swing.record != entry.record ? Result<void>(Error{ErrorCode::NotFound, MARKED("ui", "the swing is no longer there")})
            : std::holds_alternative<LostStep>(entry.what) ? putStep(stores, entry.swing, std::get<LostStep>(entry.what))
                                                           : putReading(stores, *record, std::get<LostReading>(entry.what));
        if (done) {
            ++restored.done;
            gone.push_back(entry);
        } else {
            restored.failures += QStringLiteral("%1: %2").arg(toText(entry.subject), messageOf(done.error()));
        }
    }
    rewrite(gone);
    return restored;
}

void Recovery::forget(const QString& database) const { rewrite(entriesFor(database)); }

/// The lines of other databases, and those that do not read, stay.
void Recovery::rewrite(const std::vector<LostEntry>& gone) const
{
    for (const QString& path : m_paths) {
        QByteArray left;
        for (const QByteArray& line : linesOf(path)) {
            const auto entry = entryOf(line);
            if (!entry || std::find(gone.begin(), gone.end(), *entry) == gone.end())
                left += line + '\n';
        }
        if (left.isEmpty()) {
            QFile::remove(path);
            continue;
        }
        (void)writeWholeFile(path.toStdString(), left.toStdString()); // what stays is offered again: putting it twice changes nothing
    }
}

} // namespace lubberline::ui
