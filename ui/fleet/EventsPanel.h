#pragma once

#include <QWidget>

#include "ui/kit/EditContext.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;
class QUndoStack;

namespace lubberline::ui {

/// The events of an aircraft's life that may have changed its magnetism, and a line to add one. Cells are edited in place.
class EventsPanel : public QWidget {
    Q_OBJECT

public:
    EventsPanel(EditContext& context, QUndoStack& stack, QWidget* parent = nullptr);
    void showAircraft(AircraftId aircraft);

private:
    void showEvents();
    void add();
    void changeCell(int row, int column);
    void changeCause(int row, int cause);
    /// Takes one cell over; says what is wrong beneath the table.
    bool apply(Event& event, int column, const QString& text);

    EditContext& m_context;
    QUndoStack& m_stack;
    AircraftId m_aircraft;
    std::vector<Event> m_events;
    QTableWidget* m_table;
    QLineEdit* m_date;
    QLineEdit* m_kind;
    QComboBox* m_cause; ///< follows the words until it is chosen by hand
    QLineEdit* m_note;
    QPushButton* m_add;
    QLabel* m_message;
};

} // namespace lubberline::ui
