#include "ui/swing/SwingEditor.h"

#include <QUndoStack>

#include <algorithm>
#include <utility>

#include "core/angle/AngleText.h"
#include "ui/fleet/RecordEdits.h"
#include "ui/kit/Words.h"
#include "ui/swing/NominalLayout.h"
#include "ui/swing/ReadingEdits.h"

namespace lubberline::ui {

namespace {

/// "045°" for undo texts: where the reading is.
QString placeOf(const Reading& reading)
{
    const auto heading_deg = reading.magnetic ? std::optional(reading.magnetic->degrees()) : reading.nominal_deg;
    return heading_deg ? toText(formatHeading(*heading_deg, AngleStyle::DecimalDegrees, 0)) : SwingEditor::tr("a new row");
}

/// Nothing is wrong with what was typed: the place where it is kept has failed.
bool isOfTheDrive(ErrorCode code)
{
    return code == ErrorCode::Io || code == ErrorCode::Full || code == ErrorCode::Corrupt || code == ErrorCode::Locked;
}

} // namespace

bool SwingEditor::run(QUndoCommand* edit)
{
    const auto previouslyFailed = m_context.failed;
    std::optional<Error> failure;
    m_context.failed = [&failure](const Error& error) { failure = error; };
    m_stack.push(edit);
    m_context.failed = previouslyFailed;
    m_failure = failure ? messageOf(*failure) : QString();
    m_lost = failure && isOfTheDrive(failure->code);
    m_waits = failure && failure->code == ErrorCode::Locked;
    if (failure)
        m_context.failed(*failure);
    if (failure && failure->code == ErrorCode::Conflict)
        onSwingChanged(id()); // what somebody else has written is shown
    return !failure;
}

bool SwingEditor::changeReading(int row, const Reading& after, const QString& what)
{
    const Reading before = readings().at(static_cast<std::size_t>(row));
    if (before == after)
        return true;
    const QString place = placeOf(after.magnetic || after.nominal_deg ? after : before);
    const bool stored = run(new ChangeReading(m_context, id(), before, after, tr("%1 on %2").arg(what, place)));
    if (!stored && m_lost)
        emit notStored(row, before, after);
    return stored;
}

bool SwingEditor::putReadings(const std::vector<Reading>& after, const QString& what)
{
    std::vector<PutReadings::Change> changed;
    std::vector<PlacedReading> added;
    std::vector<PlacedReading> lost;
    const std::vector<Reading> known = readings();
    for (std::size_t row = 0; row < after.size(); ++row) {
        const int position = static_cast<int>(row);
        if (row >= readings().size())
            added.push_back({position, after[row]});
        else if (!(readings()[row] == after[row]))
            changed.emplace_back(readings()[row], after[row]);
        else
            continue;
        lost.push_back({position, after[row]});
    }
    if (lost.empty())
        return true;
    const bool stored = run(new PutReadings(m_context, id(), std::move(changed), std::move(added), what));
    if (!stored && m_lost)
        for (const auto& row : lost)
            emit notStored(row.position,
                static_cast<std::size_t>(row.position) < known.size() ? known[static_cast<std::size_t>(row.position)] : Reading(),
                row.reading);
    return stored;
}

bool SwingEditor::insertReadings(int position, std::vector<Reading> inserted, const QString& what)
{
    std::vector<PlacedReading> rows;
    for (Reading& reading : inserted) {
        reading.id = {};
        rows.push_back({position++, std::move(reading)});
    }
    if (rows.empty())
        return true;
    const auto lost = rows;
    const bool stored = run(new InsertReadings(m_context, id(), std::move(rows), what));
    if (!stored && m_lost)
        for (const auto& row : lost)
            emit notStored(row.position, Reading(), row.reading);
    return stored;
}

bool SwingEditor::removeReadings(std::vector<int> rows)
{
    std::sort(rows.begin(), rows.end());
    std::vector<PlacedReading> placed;
    for (const int row : rows)
        placed.push_back({row, readings().at(static_cast<std::size_t>(row))});
    if (placed.empty())
        return true;
    const QString text = placed.size() == 1 ? tr("removal of the row on %1").arg(placeOf(placed.front().reading))
                                            : tr("removal of %1 rows").arg(placed.size());
    return run(new RemoveReadings(m_context, id(), std::move(placed), text));
}

bool SwingEditor::layOutNominals(int points)
{
    auto rows = nominalRows(readings(), points);
    return rows.empty() || run(new InsertReadings(m_context, id(), std::move(rows), tr("layout of %1 headings").arg(points)));
}

bool SwingEditor::changeParticulars(const Swing& after, const QString& what)
{
    Swing consistent = after;
    if (after.variation_deg && after.variation_deg != m_record.swing.variation_deg)
        for (Reading& reading : consistent.readings)
            if (reading.trueHeading)
                reading.magnetic = toMagnetic(*reading.trueHeading, Variation::fromDegrees(*after.variation_deg));
    return consistent == m_record.swing || run(new ChangeSwing(m_context, m_record.swing, consistent, what));
}

bool SwingEditor::complete() { return run(new CompleteSwing(m_context, id(), tr("completion"))); }

bool SwingEditor::exclude(int row, const QString& reason)
{
    Reading after = readings().at(static_cast<std::size_t>(row));
    after.exclusion.reset();
    if (!reason.trimmed().isEmpty())
        after.exclusion = Exclusion{reason.trimmed().toStdString()};
    return changeReading(row, after, after.exclusion ? tr("exclusion") : tr("inclusion"));
}

} // namespace lubberline::ui
