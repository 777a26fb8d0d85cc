#include "ui/swing/ReadingEdits.h"

#include <utility>

namespace lubberline::ui {

namespace {

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

Result<void> ChangeReading::store(Reading from, Reading to) const
{
    from.id = to.id = context().readings.current(to.id);
    return stores().swings.changeReading(swing(), from, to);
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
