#include "ui/swing/readings/ReadingsTable.h"

#include <QAction>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLineEdit>

#include <algorithm>

#include "ui/kit/ClipboardRows.h"
#include "ui/kit/Words.h"
#include "ui/kit/fit/TableFit.h"
#include "ui/swing/readings/ReadingDelegate.h"
#include "ui/swing/readings/ReadingsModel.h"

namespace lubberline::ui {

ReadingsTable::ReadingsTable(ReadingsModel& model, QWidget* parent) : QTableView(parent), m_model(model)
{
    setObjectName(QStringLiteral("readingsTable"));
    setModel(&model);
    auto* delegate = new ReadingDelegate(this);
    setItemDelegate(delegate);
    connect(delegate, &ReadingDelegate::entered, this, &ReadingsTable::advance);
    connect(delegate, &ReadingDelegate::escaped, this, &ReadingsTable::restoreStored);
    setEditTriggers(AnyKeyPressed | DoubleClicked | EditKeyPressed);
    setSelectionMode(ExtendedSelection);
    setAlternatingRowColors(true);
    setTabKeyNavigation(false); // Tab leaves the table; inside an editor it goes to the next cell
    setCornerButtonEnabled(false);
    addCellActions();
    setWordWrap(false);
    verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
    verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    verticalHeader()->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("◉ 000")));
    wrapHeadings(*this);
    keepOwnColumns(*this);
    horizontalHeader()->setHighlightSections(false);
    horizontalHeader()->setResizeContentsPrecision(64); // about as many rows as are seen: a log has thousands
    horizontalHeader()->setSectionResizeMode(static_cast<int>(ReadingColumn::State), QHeaderView::ResizeToContents);
    horizontalHeader()->setMinimumSectionSize(fontMetrics().horizontalAdvance("Note00"));
    horizontalHeader()->setSectionResizeMode(static_cast<int>(ReadingColumn::Note), QHeaderView::Stretch);
    connect(&model, &QAbstractItemModel::modelReset, this, &ReadingsTable::fitColumns);
    connect(&model, &QAbstractItemModel::dataChanged, this, &ReadingsTable::fitColumns);
    connect(&model, &QAbstractItemModel::rowsInserted, this, &ReadingsTable::fitColumns);
    connect(&model, &QAbstractItemModel::rowsRemoved, this, &ReadingsTable::fitColumns);
}

/// What nobody planned and nobody can type any more is no column; on a small screen the figures stand close together, so that the state of a
/// reading is in sight.
void ReadingsTable::fitColumns()
{
    constexpr int kLookedAt = 500; // a log has thousands of rows, and plans none of them
    const auto cell = [this](int row, ReadingColumn column) { return m_model.index(row, static_cast<int>(column)); };
    bool empty = m_model.rowCount() > 0 && !(m_model.flags(cell(0, ReadingColumn::Magnetic)) & Qt::ItemIsEditable);
    for (int row = 0; empty && row < std::min(m_model.rowCount(), kLookedAt); ++row)
        empty = cell(row, ReadingColumn::Nominal).data().toString().isEmpty();
    setColumnHidden(static_cast<int>(ReadingColumn::Nominal), empty);

    const int wide = fontMetrics().horizontalAdvance("000°00'W0"), close = fontMetrics().horizontalAdvance("000°00'") + 8;
    const int figures = static_cast<int>(ReadingColumn::State) - (empty ? 1 : 0);
    const int others = horizontalHeader()->minimumSectionSize() + sizeHintForColumn(static_cast<int>(ReadingColumn::State));
    const int width = figures * wide + others > viewport()->width() ? close : wide;
    for (int column = 0; column < static_cast<int>(ReadingColumn::State); ++column)
        setColumnWidth(column, std::max(width, horizontalHeader()->sectionSizeHint(column)));
}

void ReadingsTable::resizeEvent(QResizeEvent* event)
{
    QTableView::resizeEvent(event);
    fitColumns();
}

/// The keys are those of the menu Edit, which acts on whatever has the keyboard: here they are only shown.
void ReadingsTable::addCellActions()
{
    const auto add = [this](const QString& text, const QKeySequence& keys, const char* name, void (ReadingsTable::*act)()) {
        const QString shown = keys.isEmpty() ? text : text + u'\t' + keys.toString(QKeySequence::NativeText);
        auto* action = new QAction(shown, this);
        action->setObjectName(QLatin1String(name));
        connect(action, &QAction::triggered, this, act);
        addAction(action);
    };
    add(tr("Cu&t"), QKeySequence::Cut, "cutReadings", &ReadingsTable::cut);
    add(tr("&Copy"), QKeySequence::Copy, "copyReadings", &ReadingsTable::copy);
    add(tr("Copy with &headings"), {}, "copyReadingsWithHeadings", &ReadingsTable::copyWithHeadings);
    add(tr("&Paste"), QKeySequence::Paste, "pasteReadings", &ReadingsTable::paste);
    add(tr("&Empty the cells"), Qt::Key_Delete, "clearReadings", &ReadingsTable::clearCells);
    add(tr("Select &all"), QKeySequence::SelectAll, "selectReadings", &ReadingsTable::selectAll);
    setContextMenuPolicy(Qt::ActionsContextMenu);
}

QModelIndexList ReadingsTable::chosenCells() const
{
    const QModelIndexList chosen = selectionModel()->selectedIndexes();
    return chosen.isEmpty() && currentIndex().isValid() ? QModelIndexList{currentIndex()} : chosen;
}

/// A cell closes under the hands of who types when another window closes the swing, or takes the reading away: it is said what was typed.
void ReadingsTable::tellLost()
{
    const auto* editor = findChild<QLineEdit*>(QStringLiteral("readingEditor"));
    if (editor && editor->isVisible() && editor->isModified() && !editor->text().isEmpty())
        emit refused(tr("“%1” was being typed when another window or program changed the swing: it is not stored.").arg(editor->text()));
}

void ReadingsTable::reset()
{
    tellLost();
    QTableView::reset();
}

void ReadingsTable::rowsAboutToBeRemoved(const QModelIndex& parent, int first, int last)
{
    if (currentIndex().row() >= first && currentIndex().row() <= last)
        tellLost();
    QTableView::rowsAboutToBeRemoved(parent, first, last);
}

void ReadingsTable::tell(const Result<void>& result)
{
    if (!result)
        emit refused(messageOf(result.error()));
}

void ReadingsTable::copy() { copyCells(false); }
void ReadingsTable::copyWithHeadings() { copyCells(true); }

void ReadingsTable::copyCells(bool headings)
{
    if (const QString text = m_model.copied(chosenCells(), headings); !text.isEmpty())
        putRowsOnClipboard(text);
}

void ReadingsTable::cut()
{
    copyCells(false);
    clearCells();
}

/// From the first of the chosen cells on.
void ReadingsTable::paste()
{
    QModelIndex at = currentIndex();
    for (const QModelIndex& cell : chosenCells())
        at = m_model.index(std::min(at.row(), cell.row()), std::min(at.column(), cell.column()));
    if (!at.isValid())
        return;
    const auto pasted = m_model.paste(at, clipboardRows());
    if (pasted)
        emit done(*pasted);
    else
        emit refused(tr("Nothing was pasted: %1").arg(messageOf(pasted.error())));
}

void ReadingsTable::clearCells()
{
    const auto cells = chosenCells();
    if (cells.size() == 1 && (m_model.flags(cells.front()) & Qt::ItemIsEditable))
        m_model.setData(cells.front(), QString()); // as if it had been typed
    else
        tell(m_model.clear(cells));
}

bool ReadingsTable::restoreStored()
{
    bool restored = false;
    for (const QModelIndex& cell : chosenCells())
        restored = m_model.restoreStored(cell) || restored;
    return restored;
}

void ReadingsTable::goTo(int row, ReadingColumn column)
{
    if (row >= 0 && row < m_model.rowCount())
        setCurrentIndex(m_model.index(row, static_cast<int>(column)));
}

std::vector<int> ReadingsTable::selectedReadings() const
{
    std::vector<int> rows;
    for (const QModelIndex& index : selectionModel()->selectedIndexes())
        if (!m_model.isNewRow(index.row()))
            rows.push_back(index.row());
    std::sort(rows.begin(), rows.end());
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    return rows;
}

void ReadingsTable::acceptNominal()
{
    leaveCell();
    const QModelIndex cell = m_model.index(currentIndex().row(), static_cast<int>(ReadingColumn::Magnetic));
    if (cell.isValid() && m_model.setData(cell, QStringLiteral("=")))
        goTo(cell.row(), ReadingColumn::Compass);
}

void ReadingsTable::leaveCell()
{
    if (state() == EditingState)
        setFocus();
}

void ReadingsTable::advance()
{
    const QModelIndex at = currentIndex();
    if (!at.isValid() || at.data(ReadingsModel::RejectedRole).toBool())
        return;
    switch (currentColumn()) {
    case ReadingColumn::Nominal: goTo(at.row(), ReadingColumn::Magnetic); return;
    case ReadingColumn::Magnetic: goTo(at.row(), ReadingColumn::Compass); return;
    case ReadingColumn::Note: goTo(at.row() + 1, ReadingColumn::Note); return;
    default: goTo(at.row() + 1, ReadingColumn::Magnetic);
    }
}

void ReadingsTable::enterCell()
{
    if (currentIndex().data(ReadingsModel::PlaceholderRole).toBool())
        m_model.setData(currentIndex(), QStringLiteral("="));
    advance();
}

/// They come as keys, and not as the shortcuts of a menu, as in a line that is typed into.
bool ReadingsTable::event(QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride) {
        auto* key = static_cast<QKeyEvent*>(event);
        for (const auto known : {QKeySequence::Cut, QKeySequence::Copy, QKeySequence::Paste, QKeySequence::SelectAll})
            if (key->matches(known)) {
                event->accept();
                return true;
            }
    }
    return QTableView::event(event);
}

void ReadingsTable::keyPressEvent(QKeyEvent* event)
{
    if (event->matches(QKeySequence::Cut)) {
        cut();
        return;
    }
    if (event->matches(QKeySequence::Copy)) {
        copy();
        return;
    }
    if (event->matches(QKeySequence::Paste)) {
        paste();
        return;
    }
    const bool plain = (event->modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier;
    if (plain && (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter))
        enterCell();
    else if (plain && event->key() == Qt::Key_Equal)
        acceptNominal();
    else if (plain && (event->key() == Qt::Key_Delete || event->key() == Qt::Key_Backspace))
        clearCells();
    else if (plain && event->key() == Qt::Key_Escape)
        event->setAccepted(restoreStored()); // else it closes a message
    else
        QTableView::keyPressEvent(event);
}

} // namespace lubberline::ui
