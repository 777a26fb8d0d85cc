#include "ui/swing/readings/ReadingsModel.h"

#include <algorithm>
#include <cmath>

#include "core/format/csv/TextCell.h"
#include "ui/kit/Words.h"
#include "ui/swing/SwingEditor.h"
#include "ui/swing/readings/ReadingBlock.h"

namespace lubberline::ui {

std::string ReadingsModel::cellForSpreadsheet(int row, ReadingColumn column) const
{
    if (column == ReadingColumn::State)
        return withTextMark(stateText(row).toStdString());
    if (column != ReadingColumn::Residual)
        return copiedCell(m_rows[static_cast<std::size_t>(row)], column);
    const AnalysedReading* analysed = m_editor.analysed(row);
    if (!analysed || !analysed->residualApproximate_rad)
        return {};
    constexpr double kShort = 1e4;
    return figureCell(std::round(toDegrees(*analysed->residualApproximate_rad) * kShort) / kShort);
}

QString ReadingsModel::copied(const QModelIndexList& cells, bool headings) const
{
    std::map<std::pair<int, int>, std::string> content;
    int firstColumn = kReadingColumns, lastColumn = 0, firstRow = rowCount(), lastRow = -1;
    for (const QModelIndex& cell : cells) {
        if (isNewRow(cell.row()))
            continue;
        firstColumn = std::min(firstColumn, cell.column());
        lastColumn = std::max(lastColumn, cell.column());
        firstRow = std::min(firstRow, cell.row());
        lastRow = std::max(lastRow, cell.row());
        content[{cell.row(), cell.column()}] = cellForSpreadsheet(cell.row(), static_cast<ReadingColumn>(cell.column()));
    }
    CellRows rows;
    if (headings && lastRow >= 0) {
        rows.emplace_back();
        for (int column = firstColumn; column <= lastColumn; ++column)
            rows.back().push_back(columnTitle(static_cast<ReadingColumn>(column)).toStdString());
    }
    for (int row = firstRow; row <= lastRow; ++row) {
        rows.emplace_back();
        for (int column = firstColumn; column <= lastColumn; ++column)
            rows.back().push_back(content[{row, column}]);
    }
    return clipboardText(rows);
}

Result<void> ReadingsModel::put(const std::vector<Reading>& after, const QString& what)
{
    if (!m_editable)
        return Error{ErrorCode::InvalidInput, said(m_editor.whyReadOnly())};
    if (m_editor.putReadings(after, what))
        return {};
    return Error{ErrorCode::Io, said(m_editor.failureMessage())};
}

Result<QString> ReadingsModel::paste(const QModelIndex& at, const QString& text)
{
    auto rows = rowsOfClipboard(text);
    if (!rows)
        return rows.error();
    auto pasted = pasteBlock(m_rows, std::max(0, at.row()), static_cast<ReadingColumn>(std::max(0, at.column())), std::move(rows.value()),
        m_editor.record().swing.variation_deg);
    if (!pasted)
        return pasted.error();
    if (const auto stored = put(pasted->readings, pasted->rows == 1 ? tr("pasting of a row") : tr("pasting of %1 rows").arg(pasted->rows));
        !stored)
        return stored.error();
    // What was refused in the rows before is not there any more.
    for (int row = at.row(); row < std::min(at.row() + pasted->rows, rowCount()); ++row)
        for (int column = 0; column < kReadingColumns; ++column)
            m_rejected.erase(cellAt(index(row, column)));
    std::erase_if(m_rejected, [](const auto& rejected) { return !rejected.first.first.valid(); });
    emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
    QString done = pasted->rows == 1 ? tr("One row pasted.") : tr("%1 rows pasted.").arg(pasted->rows);
    if (pasted->passedOver)
        done += ' ' + tr("Residual and State are computed: they were passed over.");
    if (pasted->north == NorthTwice::CountsOnce)
        done += ' ' + tr("000 and 360 are one heading: the second is left out.");
    if (pasted->north == NorthTwice::Differs)
        done += ' ' + tr("000 and 360 are one heading, with different readings: look which is right.");
    return done;
}

Result<void> ReadingsModel::clear(const QModelIndexList& cells)
{
    std::vector<Reading> after = m_rows;
    for (const QModelIndex& cell : cells) {
        m_rejected.erase(cellAt(cell));
        const auto column = static_cast<ReadingColumn>(cell.column());
        if (!isNewRow(cell.row()) && (flags(cell) & Qt::ItemIsEditable))
            if (const auto cleared = applyTyped(after[static_cast<std::size_t>(cell.row())], column, {}); !cleared)
                return cleared;
    }
    if (rowCount() > 0)
        emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
    return put(after, tr("emptying of cells"));
}

} // namespace lubberline::ui
