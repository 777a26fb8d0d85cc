#pragma once
/// The table of readings, for the keyboard: type, Enter, type, Enter. Delete clears a cell, "=" or Ctrl+D accepts the nominal
/// heading as read, Escape puts the stored value back where a text was refused. Cells and blocks are copied, cut and pasted as spreadsheets
/// do: by key, in the menu Edit and in that of the right button.

#include <QTableView>

#include "ui/swing/readings/ReadingText.h"

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

public slots:
    void reset() override;
    void copy();
    void copyWithHeadings();
    void cut();
    void paste();
    void clearCells();

signals:
    void done(const QString& what);
    void refused(const QString& why);

protected:
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void rowsAboutToBeRemoved(const QModelIndex& parent, int first, int last) override;

private:
    /// Enter: on to the next cell that is read, unless the text of this one was refused.
    void advance();
    void enterCell();
    void addCellActions();
    void fitColumns();
    void copyCells(bool headings);
    /// @return false: nothing of the chosen cells was refused
    bool restoreStored();
    [[nodiscard]] QModelIndexList chosenCells() const;
    void tellLost();
    void tell(const Result<void>& result);
    [[nodiscard]] ReadingColumn currentColumn() const { return static_cast<ReadingColumn>(currentIndex().column()); }

    ReadingsModel& m_model;
};

} // namespace lubberline::ui
