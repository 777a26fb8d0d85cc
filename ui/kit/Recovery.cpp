#include "ui/kit/Recovery.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <algorithm>

#include "core/base/OutputFile.h"
#include "ui/kit/Words.h"

namespace lubberline::ui {

namespace {

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
    const QByteArray line = QByteArray::fromStdString(writeLostEntry(entry));
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
            if (auto entry = readLostEntry(line.toStdString()); entry && toText(entry->database) == database)
                entries.push_back(std::move(entry.value()));
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
            const auto entry = readLostEntry(line.toStdString());
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
