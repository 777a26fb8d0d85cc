#include "ui/swing/ReadingEdits.h"

#include <utility>

namespace lubberline::ui {

namespace {

Result<void> changeRow(EditContext& context, SwingId swing, Reading from, Reading to)
{
    from.id = to.id = context.readings.current(to.id);
    return context.stores.swings.changeReading(swing, from, to);
}

Result<void> removeRows(EditContext& context, SwingId swing, const std::vector<PlacedReading>& rows, std::size_t count)
{
    for (std::size_t i = count; i-- > 0;)
        if (auto removed = context.stores.swings.removeReading(swing, context.readings.current(rows[i].reading.id)); !removed)
            return removed;
    return {};
}

Result<void> insertRows(EditContext& context, SwingId swing, std::vector<PlacedReading>& rows)
{
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const ReadingId before = context.readings.current(rows[i].reading.id);
        const auto stored = context.stores.swings.insertReading(swing, rows[i].position, rows[i].reading);
        if (!stored)
            return stored.error();
        if (before.valid())
            context.readings.replace(before, *stored);
        rows[i].reading.id = *stored;
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

Result<void> ChangeReading::store(Reading from, Reading to) const { return changeRow(context(), swing(), std::move(from), std::move(to)); }

PutReadings::PutReadings(
    EditContext& context, SwingId swing, std::vector<Change> changed, std::vector<PlacedReading> added, const QString& text)
    : ReadingEdit(context, swing, text)
    , m_changed(std::move(changed))
    , m_added(std::move(added))
{
}

Result<void> PutReadings::apply()
{
    for (const auto& [before, after] : m_changed)
        if (auto changed = changeRow(context(), swing(), before, after); !changed)
            return changed;
    return insertRows(context(), swing(), m_added);
}

Result<void> PutReadings::revert()
{
    if (auto removed = removeRows(context(), swing(), m_added, m_added.size()); !removed)
        return removed;
    for (const auto& [before, after] : m_changed)
        if (auto changed = changeRow(context(), swing(), after, before); !changed)
            return changed;
    return {};
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
