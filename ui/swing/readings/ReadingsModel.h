#pragma once
/// The readings of the shown swing as a table that can be typed into. After the last reading comes an empty row: typing there
/// makes a new reading. What cannot be understood stays in its cell, is marked, and is not stored.

#include <QAbstractTableModel>

#include <map>
#include <utility>
#include <vector>

#include "ui/swing/readings/ReadingText.h"
#include "ui/text/AngleWords.h"

namespace lubberline::ui {

class SwingEditor;

class ReadingsModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Role {
        RejectedRole = Qt::UserRole, ///< bool: the cell holds typed text that was not stored
        StoredRole,                  ///< text: what is stored beside such a text
        PlaceholderRole,             ///< bool: the grey nominal heading where no magnetic heading was read
    };

    explicit ReadingsModel(SwingEditor& editor, QObject* parent = nullptr);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role = Qt::EditRole) override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;

    /// The cells for a spreadsheet, as the rectangle about them; with their headings where that is wanted. The empty row is none.
    [[nodiscard]] QString copied(const QModelIndexList& cells, bool headings) const;
    /// Puts what a spreadsheet copied from `at` on: all of it or nothing, one step of undo. @return what was done.
    /// Errors: InvalidInput, naming row and column; what storing says.
    Result<QString> paste(const QModelIndex& at, const QString& text);
    /// Empties the cells that can be typed into: all or nothing, one step.
    Result<void> clear(const QModelIndexList& cells);

    void setAngleStyle(AngleStyle style);
    [[nodiscard]] bool isNewRow(int row) const { return row >= static_cast<int>(m_rows.size()); }
    /// Why the text of a cell was not stored; empty when it was.
    [[nodiscard]] QString rejection(const QModelIndex& index) const;
    /// What was refused in a cell goes; the stored value is seen again. @return false: nothing was refused there
    bool restoreStored(const QModelIndex& index);
    [[nodiscard]] QStringList rejectedTexts() const;
    /// The first cell with text that was not stored, or an invalid index.
    [[nodiscard]] QModelIndex firstRejected() const;
    /// The row's studentised residual in words: "t = 15.0"; empty if there is none.
    [[nodiscard]] QString studentisedText(int row) const;

private:
    struct Rejected {
        QString text, message;
    };
    using Cell = std::pair<ReadingId, ReadingColumn>; ///< id 0: the empty row

    void reset();
    Result<void> put(const std::vector<Reading>& after, const QString& what);
    [[nodiscard]] std::string cellForSpreadsheet(int row, ReadingColumn column) const;
    void sync();
    void syncRow(int row);
    void showResults();
    void syncRows();
    void insertRowsAt(int position, const std::vector<Reading>& rows, int told);
    void adoptRejected(ReadingId id);
    [[nodiscard]] Cell cellAt(const QModelIndex& index) const;
    void forgetStored();
    [[nodiscard]] bool isStoredNow(const Cell& cell, const QString& text) const;
    [[nodiscard]] const Rejected* rejectedAt(const QModelIndex& index) const;
    [[nodiscard]] QString displayText(int row, ReadingColumn column) const;
    [[nodiscard]] QString stateText(int row) const;
    [[nodiscard]] bool lookedAtAgain(int row) const;
    [[nodiscard]] QString storedWords(const QModelIndex& index) const;
    [[nodiscard]] QString toolTip(const QModelIndex& index) const;
    bool reject(const QModelIndex& index, const QString& text, const QString& message);
    bool isPlaceholder(int row, ReadingColumn column) const;

    SwingEditor& m_editor;
    std::vector<Reading> m_rows; ///< as the views know them: behind the editor only while sync() tells the views
    int m_count = 0;             ///< rows that views know of, the empty one included
    std::map<Cell, Rejected> m_rejected;
    AngleStyle m_style = shownAngles();
    int m_decimals = 1;
    bool m_editable = false;
};

} // namespace lubberline::ui
