#include "ui/swing/ReadingEdits.h"

#include <utility>

namespace lubberline::ui {

namespace {

db::ReadingChange change(const EditContext& context, Reading from, Reading to)
{
    from.id = to.id = context.readings.current(to.id);
    return {std::move(from), std::move(to)};
}

Result<void> removeRows(EditContext& context, SwingId swing, const std::vector<PlacedReading>& rows, std::size_t count)
{
    std::vector<ReadingId> ids;
    for (std::size_t i = 0; i < count; ++i)
        ids.push_back(context.readings.current(rows[i].reading.id));
    return ids.empty() ? Result<void>() : context.stores.swings.removeReadings(swing, ids);
}

/// Rows that stand one after the other are one change: thousands of them are pasted at once.
Result<void> insertRows(EditContext& context, SwingId swing, std::vector<PlacedReading>& rows)
{
    for (std::size_t first = 0, end = 0; first < rows.size(); first = end) {
        std::vector<Reading> together;
        for (end = first; end < rows.size() && rows[end].position == rows[first].position + static_cast<int>(end - first); ++end)
            together.push_back(rows[end].reading);
        const auto stored = context.stores.swings.insertReadings(swing, rows[first].position, together);
        if (!stored)
            return stored.error();
        for (std::size_t i = first; i < end; ++i) {
            const ReadingId before = context.readings.current(rows[i].reading.id);
            if (before.valid())
                context.readings.replace(before, (*stored)[i - first]);
            rows[i].reading.id = (*stored)[i - first];
        }
    }
    return {};
}

} // namespace

ChangeReading::ChangeReading(EditContext& context, SwingId swing, Reading before, Reading after, const QString& text)
    : ReadingEdit(context, swing, text)
    , m_before(std::move(before))
    , m_after(std::move(after))
{
}

Result<void> ChangeReading::store(Reading from, Reading to) const
{
    const auto one = change(context(), std::move(from), std::move(to));
    return stores().swings.changeReading(swing(), one.known, one.reading);
}

PutReadings::PutReadings(
    EditContext& context, SwingId swing, std::vector<Change> changed, std::vector<PlacedReading> added, const QString& text)
    : ReadingEdit(context, swing, text)
    , m_changed(std::move(changed))
    , m_added(std::move(added))
{
}

Result<void> PutReadings::apply()
{
    std::vector<db::ReadingChange> changes;
    for (const auto& [before, after] : m_changed)
        changes.push_back(change(context(), before, after));
    if (auto changed = stores().swings.changeReadings(swing(), changes); !changed)
        return changed;
    return insertRows(context(), swing(), m_added);
}

Result<void> PutReadings::revert()
{
    if (auto removed = removeRows(context(), swing(), m_added, m_added.size()); !removed)
        return removed;
    std::vector<db::ReadingChange> changes;
    for (const auto& [before, after] : m_changed)
        changes.push_back(change(context(), after, before));
    return stores().swings.changeReadings(swing(), changes);
}

InsertReadings::InsertReadings(EditContext& context, SwingId swing, std::vector<PlacedReading> rows, const QString& text)
    : ReadingEdit(context, swing, text)
    , m_rows(std::move(rows))
{
}

Result<void> InsertReadings::apply() { return insertRows(context(), swing(), m_rows); }
Result<void> InsertReadings::revert() { return removeRows(context(), swing(), m_rows, m_rows.size()); }

RemoveReadings::RemoveReadings(EditContext& context, SwingId swing, std::vector<PlacedReading> rows, const QString& text)
    : ReadingEdit(context, swing, text)
    , m_rows(std::move(rows))
{
}

Result<void> RemoveReadings::apply() { return removeRows(context(), swing(), m_rows, m_rows.size()); }
Result<void> RemoveReadings::revert() { return insertRows(context(), swing(), m_rows); }

} // namespace lubberline::ui
