#pragma once
/// The table of readings, for the keyboard: type, Enter, type, Enter. Delete clears a cell, "=" or Ctrl+D accepts the nominal
/// heading as read. Cells and blocks are copied, cut and pasted as spreadsheets do, by key and in the menu of the right button.

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

    void copy(bool headings);
    void cut();
    void paste();

signals:
    void done(const QString& what);
    void refused(const QString& why);

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    /// Enter: on to the next cell that is read, unless the text of this one was refused.
    void advance();
    void enterCell();
    void addClipboardActions();
    void clearCells();
    [[nodiscard]] QModelIndexList chosenCells() const;
    void tell(const Result<void>& result);
    [[nodiscard]] ReadingColumn currentColumn() const { return static_cast<ReadingColumn>(currentIndex().column()); }

    ReadingsModel& m_model;
};

} // namespace lubberline::ui
