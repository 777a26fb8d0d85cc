#include "ui/window/MainWindow.h"

#include "ui/kit/MessagePanel.h"
#include "ui/kit/Words.h"

namespace lubberline::ui {

/// What could not be stored when the drive failed is put in when the user says so.
void MainWindow::offerRecovery()
{
    for (const QString& refusal : m_recovery.refusals())
        fail(tr("What was kept for recovery is not used: %1").arg(refusal));
    const auto lost = m_recovery.entriesFor(m_stores);
    if (lost.empty() || m_stores.readOnly())
        return;
    QStringList subjects;
    for (const auto& entry : lost)
        if (!subjects.contains(toText(entry.subject)))
            subjects += toText(entry.subject);
    m_messages->add(MessagePanel::Kind::Failure,
        tr("%n figures or steps could not be stored last time and were kept: %1.", nullptr, static_cast<int>(lost.size()))
            .arg(subjects.join(QStringLiteral("; "))),
        {{tr("Put them in"), [this, lost] { putBack(lost); }}}, MessagePanel::Stay::UntilClosed);
}

void MainWindow::putBack(const std::vector<LostEntry>& entries)
{
    const auto restored = m_recovery.restore(m_stores, entries);
    if (restored.done > 0)
        m_messages->add(MessagePanel::Kind::Information, tr("%n were put in.", nullptr, restored.done));
    for (const QString& failure : restored.failures)
        fail(failure);
    if (!restored.clashes.isEmpty())
        m_messages->add(MessagePanel::Kind::Failure,
            tr("Something else has been stored since; it stays as it is:") + '\n' + restored.clashes.join('\n'),
            {{tr("Forget what was kept"), [this, entries] { m_recovery.forget(entries); }}}, MessagePanel::Stay::UntilClosed);
    if (restored.locked)
        fail(tr("Another program is writing to the database; what was kept is offered again at the next start."));
}

void MainWindow::keepElsewhere(const SwingRecord& record, std::variant<LostStep, LostReading> what, bool waits)
{
    const LostEntry entry{m_stores.location().toStdString(), record.swing.id, record.swing.record,
        record.aircraft.registration + ", " + record.compass.name + ", " + record.swing.date.text(), std::move(what)};
    const auto kept = m_recovery.keep(m_stores, entry);
    if (!kept) {
        fail(messageOf(kept.error()));
    } else if (waits) {
        m_waiting.push_back(*kept);
        m_tryAgain.start();
        m_messages->add(
            MessagePanel::Kind::Information, tr("What could not be stored is kept, and stored as soon as the database is free."));
    } else {
        m_messages->add(MessagePanel::Kind::Information, tr("What could not be stored is kept and offered at the next start."));
    }
}

void MainWindow::tryWaiting()
{
    const auto restored = m_recovery.restore(m_stores, m_waiting);
    if (restored.locked)
        return;
    m_tryAgain.stop();
    const auto waited = std::exchange(m_waiting, {});
    if (restored.done > 0)
        m_messages->add(MessagePanel::Kind::Information, tr("The database is free again: %n were put in.", nullptr, restored.done));
    if (!restored.failures.isEmpty() || !restored.clashes.isEmpty()) {
        putBack(waited);
    } else { // the words about the other program have come to their end
        m_messages->mended();
        showSaved(true);
    }
}

} // namespace lubberline::ui
