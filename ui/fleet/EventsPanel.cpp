#include "ui/fleet/EventsPanel.h"

#include <QComboBox>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>
#include <QUndoStack>
#include <QVBoxLayout>
#include <QWheelEvent>

#include "core/due/DueList.h"
#include "ui/earth/FieldText.h"
#include "ui/fleet/RecordEdits.h"
#include "ui/kit/DueBadge.h"
#include "ui/kit/OpenCell.h"
#include "ui/kit/Words.h"

namespace lubberline::ui {

namespace {

enum EventColumn { EventDate, EventKind, EventCause, EventNote, kEventColumns };

/// In a row of the table: the wheel scrolls the table, and must not change what is on record.
class CauseBox final : public QComboBox {
protected:
    void wheelEvent(QWheelEvent* event) override { event->ignore(); }
};

} // namespace

EventsPanel::EventsPanel(EditContext& context, QUndoStack& stack, QWidget* parent)
    : QWidget(parent)
    , m_context(context)
    , m_stack(stack)
    , m_table(new QTableWidget(0, kEventColumns))
    , m_date(new QLineEdit)
    , m_kind(new QLineEdit)
    , m_cause(new QComboBox)
    , m_note(new QLineEdit)
    , m_add(new QPushButton(tr("Add event")))
    , m_message(new QLabel)
{
    m_table->setObjectName(QStringLiteral("events"));
    m_table->setAccessibleName(tr("Events"));
    m_table->setHorizontalHeaderLabels({tr("Date"), tr("Event"), tr("Makes a swing due"), tr("Note")});
    m_table->horizontalHeader()->setStretchLastSection(true);
    m_table->verticalHeader()->hide();
    m_table->setTabKeyNavigation(false);
    m_date->setObjectName(QStringLiteral("eventDate"));
    m_date->setPlaceholderText(tr("year-month-day"));
    m_kind->setObjectName(QStringLiteral("eventKind"));
    m_kind->setPlaceholderText(tr("lightning strike, engine change, hard landing …"));
    m_cause->setObjectName(QStringLiteral("eventCause"));
    m_cause->addItems(choiceWords<DueCause>());
    m_cause->setItemText(0, tr("no"));
    m_note->setObjectName(QStringLiteral("eventNote"));
    m_add->setObjectName(QStringLiteral("addEvent"));
    m_message->setWordWrap(true);
    auto* form = new QFormLayout;
    form->addRow(tr("Date:"), m_date);
    form->addRow(tr("Event:"), m_kind);
    form->addRow(tr("Makes due:"), m_cause);
    form->addRow(tr("Note:"), m_note);
    form->addRow(QString(), m_add);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(m_table, 1);
    layout->addWidget(m_message);
    layout->addLayout(form);
    connect(m_kind, &QLineEdit::textEdited, this,
        [this](const QString& words) { m_cause->setCurrentIndex(static_cast<int>(causeInWords(words.toStdString()))); });
    connect(m_add, &QPushButton::clicked, this, &EventsPanel::add);
    // Queued: storing shows the events anew, which would delete the item that is just being changed.
    connect(m_table, &QTableWidget::cellChanged, this, &EventsPanel::changeCell, Qt::QueuedConnection);
}

void EventsPanel::showAircraft(AircraftId aircraft)
{
    const bool editable = aircraft.valid() && !m_context.stores.readOnly();
    for (QWidget* widget : {static_cast<QWidget*>(m_date), static_cast<QWidget*>(m_kind), static_cast<QWidget*>(m_cause),
             static_cast<QWidget*>(m_note), static_cast<QWidget*>(m_add)})
        widget->setEnabled(editable);
    if (const auto stored = m_context.stores.fleet.eventsOf(aircraft); aircraft == m_aircraft && stored && *stored == m_events)
        return; // something else has changed: what is said and open here stays
    m_aircraft = aircraft;
    m_table->setEditTriggers(
        editable ? QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed : QAbstractItemView::NoEditTriggers);
    m_message->clear();
    showEvents();
}

void EventsPanel::showEvents()
{
    if (waitsForCell(*m_table, this, &EventsPanel::showEvents))
        return;
    auto events = m_context.stores.fleet.eventsOf(m_aircraft);
    if (!events)
        m_message->setText(messageOf(events.error()));
    m_events = events ? std::move(events.value()) : std::vector<Event>();
    const QSignalBlocker quiet(m_table); // filling is not editing
    m_table->setRowCount(static_cast<int>(m_events.size()));
    for (int row = 0; row < m_table->rowCount(); ++row) {
        const Event& event = m_events[static_cast<std::size_t>(row)];
        m_table->setItem(row, EventDate, new QTableWidgetItem(toText(event.date)));
        m_table->setItem(row, EventKind, new QTableWidgetItem(toText(event.kind)));
        auto* cause = new CauseBox;
        cause->addItems(choiceWords<DueCause>());
        cause->setItemText(0, tr("no"));
        cause->setCurrentIndex(static_cast<int>(event.cause));
        cause->setEnabled(!m_context.stores.readOnly());
        cause->setToolTip(cause->currentText());
        connect(
            cause, &QComboBox::activated, this, [this, row](int choice) { changeCause(row, choice); }, Qt::QueuedConnection);
        m_table->setCellWidget(row, EventCause, cause);
        m_table->setItem(row, EventNote, new QTableWidgetItem(toText(event.note)));
    }
}

bool EventsPanel::apply(Event& event, int column, const QString& text)
{
    m_message->clear();
    if (column == EventDate) {
        auto date = parseDate(text, false);
        if (!date) {
            m_message->setText(toText(date.error().message));
            return false;
        }
        event.date = std::move(date.value());
    } else if (column == EventKind && text.trimmed().isEmpty()) {
        m_message->setText(tr("Say what happened, as “lightning strike”."));
        return false;
    } else {
        (column == EventKind ? event.kind : event.note) = text.trimmed().toStdString();
    }
    return true;
}

void EventsPanel::add()
{
    Event event;
    event.aircraft = m_aircraft;
    event.cause = static_cast<DueCause>(m_cause->currentIndex());
    if (!apply(event, EventDate, m_date->text()) || !apply(event, EventKind, m_kind->text()) || !apply(event, EventNote, m_note->text()))
        return;
    if (const auto stored = m_context.stores.fleet.add(event); !stored) {
        m_message->setText(messageOf(stored.error()));
        return;
    }
    for (QLineEdit* line : {m_date, m_kind, m_note})
        line->clear();
    m_cause->setCurrentIndex(0);
    showEvents();
}

void EventsPanel::changeCause(int row, int cause)
{
    if (row >= static_cast<int>(m_events.size()))
        return;
    const Event before = m_events.at(static_cast<std::size_t>(row));
    Event after = before;
    after.cause = static_cast<DueCause>(cause);
    if (!(after == before))
        m_stack.push(new ChangeRecord<Event>(m_context, m_aircraft, before, after, tr("event of %1").arg(toText(before.date))));
}

void EventsPanel::changeCell(int row, int column)
{
    if (row >= static_cast<int>(m_events.size()) || column == EventCause)
        return;
    const Event before = m_events.at(static_cast<std::size_t>(row));
    Event after = before;
    if (apply(after, column, m_table->item(row, column)->text()) && !(after == before))
        m_stack.push(new ChangeRecord<Event>(m_context, m_aircraft, before, after, tr("event of %1").arg(toText(before.date))));
    else
        showEvents(); // the table shows what is stored
}

} // namespace lubberline::ui
