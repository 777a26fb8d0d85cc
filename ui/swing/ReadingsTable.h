#pragma once
/// The table of readings, for the keyboard: type, Enter, type, Enter. Delete clears a cell, "=" or Ctrl+D accepts the nominal
/// heading as read.

#include <QTableView>

#include "ui/swing/ReadingText.h"

namespace lubberline::ui {

class ReadingsModel;

class ReadingsTable : public QTableView {
    Q_OBJECT

public:
    explicit ReadingsTable(ReadingsModel& model, QWidget* parent = nullptr);

    void goTo(int row, ReadingColumn column);
    void acceptNominal();
    /// Ends an edit as if the cell had been left: what was typed is stored or refused.
    void leaveCell();
    [[nodiscard]] std::vector<int> selectedReadings() const;

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    /// Enter: on to the next cell that is read, unless the text of this one was refused.
    void advance();
    void enterCell();
    [[nodiscard]] ReadingColumn currentColumn() const { return static_cast<ReadingColumn>(currentIndex().column()); }

    ReadingsModel& m_model;
};

} // namespace lubberline::ui
