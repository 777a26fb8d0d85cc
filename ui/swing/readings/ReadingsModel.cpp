#include "ui/swing/readings/ReadingsModel.h"

#include <QFont>
#include <QGuiApplication>
#include <QPalette>

#include <algorithm>
#include <cmath>

#include "ui/kit/Words.h"
#include "ui/swing/SlipWords.h"
#include "ui/swing/SwingEditor.h"
#include "ui/swing/readings/ReadingBlock.h"

namespace lubberline::ui {

namespace {

constexpr int kMostTyped = 64; ///< rows by hand: each is held against the others as it is made

} // namespace

ReadingsModel::ReadingsModel(SwingEditor& editor, QObject* parent) : QAbstractTableModel(parent), m_editor(editor)
{
    connect(&editor, &SwingEditor::opened, this, &ReadingsModel::reset);
    connect(&editor, &SwingEditor::closed, this, &ReadingsModel::reset);
    connect(&editor, &SwingEditor::changed, this, &ReadingsModel::sync);
    connect(&editor, &SwingEditor::readingChanged, this, &ReadingsModel::syncRow);
    connect(&editor, &SwingEditor::computed, this, &ReadingsModel::showResults);
    reset();
}

void ReadingsModel::reset()
{
    beginResetModel();
    m_rows = m_editor.readings();
    m_rejected.clear();
    m_decimals = decimalsFor(m_rows);
    m_editable = m_editor.editable();
    m_count = static_cast<int>(m_rows.size()) + (m_editable ? 1 : 0);
    endResetModel();
}

void ReadingsModel::sync()
{
    if (m_editable != m_editor.editable()) {
        reset();
        return;
    }
    syncRows();
    m_rows = m_editor.readings();
    m_decimals = decimalsFor(m_rows);
    std::erase_if(m_rejected, [this](const auto& rejected) {
        const ReadingId id = rejected.first.first;
        return id.valid() && std::none_of(m_rows.begin(), m_rows.end(), [id](const Reading& row) { return row.id == id; });
    });
    forgetStored();
    if (rowCount() > 0)
        emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
}

void ReadingsModel::syncRow(int row)
{
    m_rows[static_cast<std::size_t>(row)] = m_editor.readings()[static_cast<std::size_t>(row)];
    forgetStored();
    const bool same = m_decimals == std::exchange(m_decimals, decimalsFor(m_rows));
    emit dataChanged(index(same ? row : 0, 0), index(same ? row : rowCount() - 1, columnCount() - 1));
}

void ReadingsModel::showResults()
{
    if (rowCount() == 0)
        return;
    emit dataChanged(index(0, static_cast<int>(ReadingColumn::Residual)), index(rowCount() - 1, static_cast<int>(ReadingColumn::State)));
    emit headerDataChanged(Qt::Vertical, 0, rowCount() - 1);
}

void ReadingsModel::forgetStored()
{
    std::erase_if(m_rejected, [this](const auto& rejected) { return isStoredNow(rejected.first, rejected.second.text); });
}

/// What was refused for a while (another program was writing) and has been put in since.
bool ReadingsModel::isStoredNow(const Cell& cell, const QString& text) const
{
    const auto found = cell.first.valid()
        ? std::find_if(m_rows.begin(), m_rows.end(), [&](const Reading& row) { return row.id == cell.first; })
        : m_rows.empty() ? m_rows.end()
                         : m_rows.end() - 1;
    if (found == m_rows.end())
        return false;
    Reading typed = *found;
    return applyTyped(typed, cell.second, text, m_editor.record().swing.variation_deg) && typed == *found;
}

void ReadingsModel::syncRows()
{
    const auto& after = m_editor.readings();
    const auto sameId = [](const Reading& a, const Reading& b) { return a.id == b.id; };
    const auto first = std::mismatch(m_rows.begin(), m_rows.end(), after.begin(), after.end(), sameId);
    const auto last = std::mismatch(
        m_rows.rbegin(), std::make_reverse_iterator(first.first), after.rbegin(), std::make_reverse_iterator(first.second), sameId);
    const int position = static_cast<int>(first.first - m_rows.begin());
    const int removed = static_cast<int>(last.first.base() - first.first);
    const int inserted = static_cast<int>(last.second.base() - first.second);
    const bool atEnd = position + removed == static_cast<int>(m_rows.size());
    if (removed > 0) {
        beginRemoveRows({}, position, position + removed - 1);
        m_rows.erase(m_rows.begin() + position, m_rows.begin() + position + removed);
        m_count -= removed;
        endRemoveRows();
    }
    if (inserted > 0 && atEnd && m_editable) {
        // What was typed into the empty row becomes a reading there, and views are told of an empty row after it: the cell that
        // is being left stays the current one.
        m_rows.push_back(after[static_cast<std::size_t>(position)]);
        emit dataChanged(index(position, 0), index(position, kReadingColumns - 1));
        insertRowsAt(position + 1, {after.begin() + position + 1, after.begin() + position + inserted}, inserted);
    } else if (inserted > 0) {
        insertRowsAt(position, {after.begin() + position, after.begin() + position + inserted}, inserted);
    }
}

void ReadingsModel::insertRowsAt(int position, const std::vector<Reading>& rows, int told)
{
    beginInsertRows({}, position, position + told - 1);
    m_rows.insert(m_rows.begin() + position, rows.begin(), rows.end());
    m_count += told;
    endInsertRows();
}

/// What was refused in the empty row goes with it when it becomes a reading.
void ReadingsModel::adoptRejected(ReadingId id)
{
    for (int column = 0; column < kReadingColumns; ++column)
        if (auto node = m_rejected.extract(Cell(ReadingId(), static_cast<ReadingColumn>(column)))) {
            node.key().first = id;
            m_rejected.insert(std::move(node));
        }
}

int ReadingsModel::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : m_count; }

int ReadingsModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kReadingColumns; }

/// As the page's message marks it: State says why, and may be out of sight.
bool ReadingsModel::lookedAtAgain(int row) const
{
    const Reading& reading = m_rows[static_cast<std::size_t>(row)];
    if (reading.exclusion || !reading.complete())
        return false;
    const AnalysedReading* analysed = m_editor.analysed(row);
    if (analysed && analysed->suspect)
        return true;
    return m_count <= kMostTyped && !slipOfRow(m_editor, row, m_style, SlipFigures::Beside).isEmpty();
}

QVariant ReadingsModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation == Qt::Vertical) {
        if (role == Qt::DisplayRole)
            return isNewRow(section)     ? QStringLiteral("+")
                : lookedAtAgain(section) ? QStringLiteral("◉ %1").arg(section + 1)
                                         : QString::number(section + 1);
        return {};
    }
    static const char* const meanings[] = {QT_TR_NOOP("The heading that the aircraft was turned to, magnetic"),
        QT_TR_NOOP("The magnetic heading that the datum gave"), QT_TR_NOOP("What the compass read"),
        QT_TR_NOOP("Magnetic − compass, east positive. Type it, and the compass heading follows"),
        QT_TR_NOOP("Deviation read − deviation of the approximate fit"), QT_TR_NOOP("Whether the reading counts"), QT_TR_NOOP("Remarks")};
    if (role == Qt::DisplayRole)
        return columnTitle(static_cast<ReadingColumn>(section));
    if (role == Qt::ToolTipRole)
        return tr(meanings[section]);
    return {};
}

ReadingsModel::Cell ReadingsModel::cellAt(const QModelIndex& index) const
{
    const auto row = static_cast<std::size_t>(index.row());
    return {row < m_rows.size() ? m_rows[row].id : ReadingId(), static_cast<ReadingColumn>(index.column())};
}

const ReadingsModel::Rejected* ReadingsModel::rejectedAt(const QModelIndex& index) const
{
    const auto found = m_rejected.find(cellAt(index));
    return found == m_rejected.end() ? nullptr : &found->second;
}

bool ReadingsModel::isPlaceholder(int row, ReadingColumn column) const
{
    return column == ReadingColumn::Magnetic && !isNewRow(row) && !m_rows[static_cast<std::size_t>(row)].magnetic
        && m_rows[static_cast<std::size_t>(row)].nominal_deg;
}

QString ReadingsModel::studentisedText(int row) const
{
    const AnalysedReading* analysed = m_editor.analysed(row);
    if (!analysed || !analysed->studentised || !std::isfinite(*analysed->studentised))
        return {};
    QString number = QString::number(*analysed->studentised, 'f', std::abs(*analysed->studentised) < 10 ? 1 : 0);
    return tr("t = %1").arg(number.replace('-', QChar(0x2212)));
}

namespace {

QString incompleteWords(const Reading& reading)
{
    if (!reading.magnetic && !reading.compass)
        return reading.nominal_deg ? ReadingsModel::tr("incomplete: not read yet")
                                   : ReadingsModel::tr("incomplete: both headings are missing");
    return reading.magnetic ? ReadingsModel::tr("incomplete: the compass heading is missing")
                            : ReadingsModel::tr("incomplete: the magnetic heading is missing");
}

} // namespace

QString ReadingsModel::stateText(int row) const
{
    const Reading& reading = m_rows[static_cast<std::size_t>(row)];
    if (reading.exclusion)
        return tr("excluded: %1").arg(toText(reading.exclusion->reason));
    if (!reading.complete())
        return incompleteWords(reading);
    QStringList words;
    const AnalysedReading* analysed = m_editor.analysed(row);
    if (analysed && analysed->suspect)
        words += tr("suspect, %1").arg(studentisedText(row));
    if (const QString slip = slipOfRow(m_editor, row, m_style, SlipFigures::Beside); !slip.isEmpty())
        words += slip;
    if (const QString far = farFromNominal(reading, m_style); !far.isEmpty())
        words += far;
    return words.join(QStringLiteral("; "));
}

QString ReadingsModel::displayText(int row, ReadingColumn column) const
{
    if (isNewRow(row))
        return {};
    const Reading& reading = m_rows[static_cast<std::size_t>(row)];
    if (column == ReadingColumn::State)
        return stateText(row);
    if (column == ReadingColumn::Residual) {
        const AnalysedReading* analysed = m_editor.analysed(row);
        if (!analysed || !analysed->residualApproximate_rad)
            return {};
        return toText(formatSignedAngle(toDegrees(*analysed->residualApproximate_rad), m_style, m_decimals));
    }
    if (isPlaceholder(row, column))
        return cellText(reading, ReadingColumn::Nominal, m_style, m_decimals);
    return cellText(reading, column, m_style, m_decimals);
}

QString ReadingsModel::toolTip(const QModelIndex& index) const
{
    if (const Rejected* rejected = rejectedAt(index))
        return tr("Not stored: %1\nStored: %2\nEscape puts the stored value back.").arg(rejected->message, storedWords(index));
    const auto column = static_cast<ReadingColumn>(index.column());
    if (isPlaceholder(index.row(), column))
        return tr("The nominal heading: nobody has read it yet. Enter or = accepts it, typing replaces it");
    return column == ReadingColumn::State && !isNewRow(index.row()) ? stateText(index.row()) : QString();
}

QVariant ReadingsModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    const int row = index.row();
    const auto column = static_cast<ReadingColumn>(index.column());
    const Rejected* rejected = rejectedAt(index);
    switch (role) {
    case Qt::DisplayRole: return rejected ? rejected->text : displayText(row, column);
    case Qt::EditRole:
        if (rejected)
            return rejected->text;
        return isNewRow(row) ? QString() : editText(m_rows[static_cast<std::size_t>(row)], column, m_style);
    case Qt::TextAlignmentRole:
        return column < ReadingColumn::State ? int(Qt::AlignRight | Qt::AlignVCenter) : int(Qt::AlignLeft | Qt::AlignVCenter);
    case Qt::ForegroundRole:
        if (isPlaceholder(row, column) || (!isNewRow(row) && m_rows[static_cast<std::size_t>(row)].exclusion))
            return QGuiApplication::palette().brush(QPalette::PlaceholderText);
        return {};
    case Qt::ToolTipRole: return toolTip(index);
    case RejectedRole: return rejected != nullptr;
    case StoredRole: return displayText(row, column);
    case Qt::AccessibleTextRole:
        return rejected ? tr("%1, not stored; stored: %2").arg(rejected->text, displayText(row, column)) : displayText(row, column);
    case PlaceholderRole: return !rejected && isPlaceholder(row, column);
    default: return {};
    }
}

bool ReadingsModel::reject(const QModelIndex& index, const QString& text, const QString& message)
{
    m_rejected[cellAt(index)] = {text, message};
    emit dataChanged(index, index);
    return false;
}

bool ReadingsModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
    if (role != Qt::EditRole || !(flags(index) & Qt::ItemIsEditable))
        return false;
    const int row = index.row();
    const auto column = static_cast<ReadingColumn>(index.column());
    const QString text = value.toString();
    if (!rejectedAt(index) && text == data(index, Qt::EditRole).toString())
        return true; // left as it was: an angle shown in minutes must not lose its seconds; what was refused is tried again
    Reading after = isNewRow(row) ? Reading() : m_rows[static_cast<std::size_t>(row)];
    if (const auto typed = applyTyped(after, column, text, m_editor.record().swing.variation_deg); !typed)
        return reject(index, text, toText(typed.error().message));
    m_rejected.erase(cellAt(index));
    emit dataChanged(index, index);
    if (isNewRow(row) && after == Reading())
        return true;
    const bool isNew = isNewRow(row);
    const bool stored = isNew ? m_editor.insertReadings(row, {after}, tr("%1 in a new row").arg(editName(column)))
                              : m_editor.changeReading(row, after, editName(column));
    if (stored && isNew && row < static_cast<int>(m_rows.size()))
        adoptRejected(m_rows[static_cast<std::size_t>(row)].id);
    return stored || reject(this->index(row, index.column()), text, m_editor.failureMessage());
}

Qt::ItemFlags ReadingsModel::flags(const QModelIndex& index) const
{
    Qt::ItemFlags flags = QAbstractTableModel::flags(index);
    const auto column = static_cast<ReadingColumn>(index.column());
    if (index.isValid() && m_editable && column != ReadingColumn::Residual && column != ReadingColumn::State)
        flags |= Qt::ItemIsEditable;
    return flags;
}

void ReadingsModel::setAngleStyle(AngleStyle style)
{
    m_style = style;
    if (rowCount() > 0)
        emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
}

QString ReadingsModel::rejection(const QModelIndex& index) const
{
    const Rejected* rejected = index.isValid() ? rejectedAt(index) : nullptr;
    return rejected ? rejected->message : QString();
}

QString ReadingsModel::storedWords(const QModelIndex& index) const
{
    const QString stored = displayText(index.row(), static_cast<ReadingColumn>(index.column()));
    return stored.isEmpty() || isPlaceholder(index.row(), static_cast<ReadingColumn>(index.column())) ? tr("nothing") : stored;
}

bool ReadingsModel::restoreStored(const QModelIndex& index)
{
    if (!index.isValid() || m_rejected.erase(cellAt(index)) == 0)
        return false;
    emit dataChanged(index, index);
    return true;
}

QStringList ReadingsModel::rejectedTexts() const
{
    QStringList texts;
    for (const auto& [cell, rejected] : m_rejected)
        texts += rejected.text;
    return texts;
}

QModelIndex ReadingsModel::firstRejected() const
{
    if (m_rejected.empty()) // nearly always, and a log has many rows
        return {};
    for (int row = 0; row < rowCount(); ++row)
        for (int column = 0; column < kReadingColumns; ++column)
            if (rejectedAt(index(row, column)))
                return index(row, column);
    return {};
}

} // namespace lubberline::ui
