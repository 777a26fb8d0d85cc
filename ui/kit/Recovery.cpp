#include "ui/kit/Recovery.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <map>
#include <tuple>

#include "core/base/OutputFile.h"
#include "ui/kit/Words.h"
#include "ui/recovery/LostMerge.h"
#include "ui/recovery/PrivateFile.h"

namespace lubberline::ui {

namespace {

struct RecoveryWords {
    Q_DECLARE_TR_FUNCTIONS(lubberline::ui::Recovery)
};

QList<QByteArray> linesOf(const QString& path)
{
    const auto text = readPrivateFile(path);
    QList<QByteArray> lines = text ? text->split('\n') : QList<QByteArray>();
    lines.removeAll(QByteArray());
    return lines;
}

std::string identityOf(db::Stores& stores)
{
    const auto head = stores.signing.trailHead();
    return head ? head->file : std::string();
}

/// One file, whichever way it is named; a file that is not there has its name alone.
bool samePlace(const QString& one, const QString& other)
{
    const QFileInfo a(one), b(other);
    return a.exists() && b.exists() ? a.canonicalFilePath() == b.canonicalFilePath() : a.absoluteFilePath() == b.absoluteFilePath();
}

/// How one entry came out.
struct Outcome {
    Result<void> done;
    QString clash; ///< what stands against it; empty: nothing
};

QString when(const LostEntry& entry) { return entry.timeUtc.empty() ? RecoveryWords::tr("earlier") : toText(entry.timeUtc); }

QString sideBySide(const LostEntry& entry, const std::vector<SwingDifference>& clashes)
{
    QStringList parts;
    for (const SwingDifference& one : clashes)
        parts += RecoveryWords::tr("%1: kept %2, stored since %3")
                     .arg(toText(one.what), one.before.empty() ? QStringLiteral("–") : toText(one.before),
                         one.after.empty() ? QStringLiteral("–") : toText(one.after));
    return RecoveryWords::tr("%1, kept %2. %3").arg(toText(entry.subject), when(entry), parts.join(QStringLiteral("; ")));
}

Outcome putStep(db::Stores& stores, const LostEntry& entry, const LostStep& step)
{
    const auto job = stores.jobs.jobOf(entry.swing);
    if (!job)
        return {job.error(), {}};
    if (*job && step.place < (*job)->job.events.size()) {
        if ((*job)->job.events[step.place] == step.event)
            return {};
        return {{},
            RecoveryWords::tr("%1, kept %2: step %3 of the guided swing; another has been stored in its place since")
                .arg(toText(entry.subject), when(entry))
                .arg(step.place + 1)};
    }
    return {stores.jobs.append(entry.swing, step.place, step.event), {}};
}

/// By its identity, however it is named; but a copy of a database that is still there has the same, and what was kept is of the one.
bool belongsTo(const LostEntry& entry, const std::string& identity, const QString& location)
{
    const QString database = toText(entry.database);
    return entry.file == identity && (samePlace(database, location) || !QFileInfo::exists(database));
}

/// The row that an entry speaks of: by its identity, or one that was made of an entry before.
const Reading* rowOf(const std::vector<Reading>& rows, ReadingId id)
{
    const auto found = std::find_if(rows.begin(), rows.end(), [&](const Reading& one) { return one.id == id; });
    return found == rows.end() ? nullptr : &*found;
}

/// Typed again, and stored: nothing is left to be put in.
bool isStored(db::Stores& stores, const LostEntry& entry)
{
    const auto* lost = std::get_if<LostReading>(&entry.what);
    const auto swing = lost ? stores.swings.swing(entry.swing) : Result<Swing>(Error{});
    if (!swing || swing->record != entry.record)
        return false;
    const auto row = static_cast<std::size_t>(lost->row);
    const Reading* now = lost->id.valid() ? rowOf(swing->readings, lost->id)
        : row < swing->readings.size()    ? &swing->readings[row]
                                          : nullptr;
    return now && says(*now, lost->before.value_or(Reading()), lost->reading);
}

class Restoring {
public:
    Restoring(db::Stores& stores) : m_stores(stores) {}

    Outcome put(const LostEntry& entry)
    {
        const auto record = m_stores.swings.record(entry.swing);
        if (!record)
            return {record.error(), {}};
        if (record->swing.record != entry.record)
            return {Error{ErrorCode::NotFound, MARKED("ui", "the swing is no longer there")}, {}};
        if (const auto* step = std::get_if<LostStep>(&entry.what))
            return putStep(m_stores, entry, *step);
        return putReading(entry, std::get<LostReading>(entry.what), record->swing);
    }

private:
    Outcome putReading(const LostEntry& entry, const LostReading& lost, const Swing& swing)
    {
        const auto row = static_cast<std::size_t>(lost.row);
        const auto ours = m_ours.find({entry.swing, lost.id, lost.id.valid() ? 0 : lost.row});
        const ReadingId wanted = lost.id.valid() ? lost.id : ours == m_ours.end() ? ReadingId() : ours->second.id;
        const Reading* now = wanted.valid() ? rowOf(swing.readings, wanted) : row < swing.readings.size() ? &swing.readings[row] : nullptr;
        const Reading before = lost.before.value_or(Reading());
        if (now && says(*now, before, lost.reading))
            return {};
        // A new row has found another there, or a row is gone.
        const bool isNew = !wanted.valid();
        if (isNew ? now != nullptr : now == nullptr)
            return {{}, sideBySide(entry, differences(lost.reading, now ? *now : Reading(), row))};
        const MergedReading merged = now ? mergedReading(before, lost.reading, *now, ours == m_ours.end() ? nullptr : &ours->second)
                                         : MergedReading{lost.reading, false};
        if (merged.clashes)
            return {{}, sideBySide(entry, differences(lost.reading, *now, row))};
        if (const auto open = isOpen(swing); !open)
            return {open, {}};
        Reading put = merged.reading;
        if (now) {
            if (const auto changed = m_stores.swings.changeReading(entry.swing, *now, put); !changed)
                return {changed, {}};
        } else {
            const auto added = m_stores.swings.insertReading(entry.swing, static_cast<int>(swing.readings.size()), put);
            if (!added)
                return {added.error(), {}};
            put.id = *added;
        }
        m_ours[{entry.swing, lost.id, lost.id.valid() ? 0 : lost.row}] = put;
        return {};
    }

    static std::vector<SwingDifference> differences(const Reading& kept, const Reading& now, std::size_t row)
    {
        Swing was, is;
        was.readings.resize(row + 1);
        is.readings.resize(row + 1);
        was.readings[row] = kept;
        is.readings[row] = now;
        return differencesBetween(was, is);
    }

    /// What was completed since is not changed by what was kept.
    static Result<void> isOpen(const Swing& swing)
    {
        if (swing.state == SwingState::Draft)
            return {};
        return Error{ErrorCode::Frozen, MARKED("ui", "the swing was completed since; expected it to be opened again first")};
    }

    db::Stores& m_stores;
    /// What was put in of entries before: by the reading, or by the place of a new row. What is typed twice does not stand against itself.
    std::map<std::tuple<SwingId, ReadingId, int>, Reading> m_ours;
};

} // namespace

Result<LostEntry> Recovery::keep(db::Stores& stores, LostEntry entry) const
{
    entry.file = identityOf(stores);
    entry.database = stores.location().toStdString();
    entry.timeUtc = stores.clock().nowUtc();
    const QByteArray line = QByteArray::fromStdString(writeLostEntry(entry));
    for (const QString& path : m_paths)
        if (appendPrivately(path, line))
            return entry;
    return Error{ErrorCode::Io, MARKED("ui", "no place was found to keep it until the database can be written again")};
}

std::vector<LostEntry> Recovery::entriesFor(db::Stores& stores) const
{
    const std::string identity = identityOf(stores);
    std::vector<LostEntry> entries, settled;
    for (const QString& path : m_paths)
        for (const QByteArray& line : linesOf(path))
            if (auto entry = readLostEntry(line.toStdString()); entry
                && (entry->file.empty() ? samePlace(toText(entry->database), stores.location())
                                        : belongsTo(*entry, identity, stores.location())))
                (isStored(stores, *entry) ? settled : entries).push_back(std::move(entry.value()));
    if (!settled.empty())
        forget(settled);
    return entries;
}

QStringList Recovery::refusals() const
{
    QStringList all;
    for (const QString& path : m_paths)
        if (const auto text = readPrivateFile(path); !text)
            all += messageOf(text.error());
    return all;
}

Recovery::Restored Recovery::restore(db::Stores& stores, const std::vector<LostEntry>& entries) const
{
    Restored restored;
    std::vector<LostEntry> gone;
    Restoring restoring(stores);
    for (const auto& entry : entries) {
        const Outcome outcome = restoring.put(entry);
        if (!outcome.done && outcome.done.error().code == ErrorCode::Locked) {
            restored.locked = true;
            break;
        }
        if (!outcome.done) {
            restored.failures += QStringLiteral("%1: %2").arg(toText(entry.subject), messageOf(outcome.done.error()));
        } else if (!outcome.clash.isEmpty()) {
            restored.clashes += outcome.clash;
        } else {
            ++restored.done;
            gone.push_back(entry);
        }
    }
    forget(gone);
    return restored;
}

void Recovery::forget(const std::vector<LostEntry>& gone) const
{
    for (const QString& path : m_paths) {
        const auto lines = linesOf(path);
        QByteArray left;
        for (const QByteArray& line : lines) {
            const auto entry = readLostEntry(line.toStdString());
            if (!entry || std::find(gone.begin(), gone.end(), *entry) == gone.end())
                left += line + '\n';
        }
        if (lines.isEmpty()) // none, or not ours to touch
            continue;
        if (left.isEmpty())
            QFile::remove(path);
        else
            (void)writeWholeFile(path.toStdString(), left.toStdString()); // what stays is offered again: putting it twice changes nothing
    }
}

} // namespace lubberline::ui
