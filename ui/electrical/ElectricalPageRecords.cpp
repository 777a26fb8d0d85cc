#include "ui/electrical/ElectricalPage.h"

#include <QComboBox>
#include <QUndoStack>

#include "core/procedure/ElectricalChecks.h"
#include "ui/electrical/ElectricalSteps.h"
#include "ui/kit/StoredEdit.h"
#include "ui/kit/Words.h"

namespace lubberline::ui {

/// On disk when the cell is left.
void ElectricalPage::store(ElectricalSwing after)
{
    const StoredBy<ElectricalSwing> by{
        [id = m_compass.id](db::Stores& stores, const ElectricalSwing& one) { return noValue(stores.electrical.add(id, one)); },
        [id = m_compass.id](db::Stores& stores, const ElectricalSwing& known, const ElectricalSwing& one) {
            return stores.electrical.change(id, known, one);
        },
        [id = m_compass.id](db::Stores& stores, const ElectricalSwing& one) { return stores.electrical.remove(id, one.record); }};
    const bool known = m_current >= 0 && current().record == after.record;
    const QString text = known ? tr("electrical swing of %1").arg(toText(after.date)) : tr("new electrical swing");
    m_undo.push(new StoredEdit(m_context, by, known ? std::optional(current()) : std::nullopt, std::optional(std::move(after)), text,
        Destination{QStringLiteral("electrical"), m_compass.id}));
    reload();
}

void ElectricalPage::add()
{
    ElectricalSwing swing;
    swing.record = newRecordId();
    swing.date = m_today();
    swing.headings = everyFifteenDegrees();
    m_current = -1;
    store(swing);
    for (std::size_t i = 0; i < m_swings.size(); ++i)
        if (m_swings[i].record == swing.record)
            m_current = static_cast<int>(i);
    m_chooser->setCurrentIndex(m_current);
    showSwing();
}

void ElectricalPage::write()
{
    if (m_current < 0)
        emit failed(tr("There is no electrical swing of this compass yet: begin one first."));
    else
        emit writeRecord(current(), m_compass);
}

void ElectricalPage::make()
{
    Swing swing = swingFrom(current());
    swing.compass = m_compass.id;
    emit makeSwing(swing);
}

} // namespace lubberline::ui
