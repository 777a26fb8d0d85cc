#include "ui/swing/readings/ReadingBlock.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/FileText.h"
#include "core/base/Number.h"
#include "core/format/csv/TextCell.h"
#include "ui/kit/Words.h"

namespace lubberline::ui {

namespace {

struct BlockWords {
    Q_DECLARE_TR_FUNCTIONS(lubberline::ui::ReadingBlock)
};

constexpr double kAgreement_deg = 0.05; ///< as in a Swing CSV
constexpr std::array kBlockColumns{ReadingColumn::Nominal, ReadingColumn::Magnetic, ReadingColumn::Compass, ReadingColumn::Deviation,
    ReadingColumn::Residual, ReadingColumn::State, ReadingColumn::Note};
constexpr std::array kEnglishTitles{"Nominal", "Magnetic", "Compass", "Deviation", "Residual", "State", "Note"};

Error wrongBlock(const QString& message) { return {ErrorCode::InvalidInput, said(message)}; }

/// "magnetic_heading_deg", "Magnetic heading (°)" and "MAGNETIC" are one name.
QString plainName(const QString& heading)
{
    QString name = heading.toLower().replace(u'_', u' ');
    if (const auto unit = name.indexOf(u'('); unit > 0)
        name.truncate(unit);
    name = name.simplified();
    for (const char* word : {" deg", " heading", " reading"})
        if (name.endsWith(QLatin1String(word)))
            name.chop(static_cast<int>(qstrlen(word)));
    return name;
}

std::optional<ReadingColumn> columnNamed(const QString& heading)
{
    const QString name = plainName(heading);
    for (const ReadingColumn column : kBlockColumns)
        if (name == plainName(columnTitle(column)) || name == plainName(QLatin1String(kEnglishTitles[static_cast<std::size_t>(column)])))
            return column;
    return {};
}

bool isAngle(const std::string& cell) { return parseWrittenHeading(cell).ok() || parseSignedAngle_deg(cell).ok(); }

/// A first row that names columns and has no figure. One column of notes has none: there, a word is a note.
bool hasHeadings(const std::vector<std::string>& first, ReadingColumn begin)
{
    const bool named
        = std::any_of(first.begin(), first.end(), [](const std::string& cell) { return columnNamed(toText(cell)).has_value(); });
    const bool figures = std::any_of(first.begin(), first.end(), isAngle);
    const bool notes = first.size() == 1 && begin == ReadingColumn::Note && columnNamed(toText(first.front())) != ReadingColumn::Note;
    return named && !figures && !notes;
}

Result<std::vector<ReadingColumn>> columnsByName(const std::vector<std::string>& headings)
{
    std::vector<ReadingColumn> columns;
    for (const auto& heading : headings) {
        const auto column = columnNamed(toText(heading));
        if (!column)
            return wrongBlock(
                BlockWords::tr("%1 is no column of this table; expected one of Nominal, Magnetic, Compass, Deviation and Note")
                    .arg(toText(inQuotes(heading))));
        if (std::find(columns.begin(), columns.end(), *column) != columns.end())
            return wrongBlock(BlockWords::tr("the column %1 is pasted twice; expected it once").arg(columnTitle(*column)));
        columns.push_back(*column);
    }
    return columns;
}

Result<std::vector<ReadingColumn>> columnsFrom(ReadingColumn begin, std::size_t count)
{
    const auto first = static_cast<std::size_t>(begin);
    if (first + count > kBlockColumns.size())
        return wrongBlock(
            BlockWords::tr("the block has %1 columns, and from %2 on the table has %3; expected a narrower one, or a first row of headings")
                .arg(count)
                .arg(columnTitle(begin))
                .arg(kBlockColumns.size() - first));
    return std::vector<ReadingColumn>(
        kBlockColumns.begin() + static_cast<std::ptrdiff_t>(first), kBlockColumns.begin() + static_cast<std::ptrdiff_t>(first + count));
}

/// One row of the block.
class RowPaste {
public:
    RowPaste(const std::vector<ReadingColumn>& columns, const std::vector<std::string>& cells) : m_columns(columns), m_cells(cells) {}

    /// Nominal and magnetic headings first: what is computed from them needs them.
    Result<void> into(Reading& reading, std::optional<double> variation_deg) const
    {
        for (const ReadingColumn column : {ReadingColumn::Nominal, ReadingColumn::Magnetic, ReadingColumn::Compass, ReadingColumn::Note})
            if (const std::string* cell = of(column)) {
                const std::string text = column == ReadingColumn::Note ? textOfCell(*cell) : *cell;
                if (const auto typed = applyTyped(reading, column, toText(text), variation_deg); !typed)
                    return at(column, typed.error());
            }
        if (const auto residual = of(ReadingColumn::Residual); residual && !trimmed(*residual).empty() && !parseSignedAngle_deg(*residual))
            return at(ReadingColumn::Residual,
                wrongBlock(BlockWords::tr(
                    "this column is computed, and %1 is no residual; expected a first row of headings that says which column is which")
                               .arg(toText(inQuotes(*residual)))));
        return deviationInto(reading);
    }

private:
    [[nodiscard]] const std::string* of(ReadingColumn column) const
    {
        const auto found = std::find(m_columns.begin(), m_columns.end(), column);
        return found == m_columns.end() ? nullptr : &m_cells[static_cast<std::size_t>(found - m_columns.begin())];
    }
    static Error at(ReadingColumn column, const Error& error)
    {
        return wrongBlock(QStringLiteral("%1: %2").arg(columnTitle(column), messageOf(error)));
    }
    Result<void> deviationInto(Reading& reading) const
    {
        const std::string* cell = of(ReadingColumn::Deviation);
        const std::string* compass = of(ReadingColumn::Compass);
        const bool empty = cell && trimmed(*cell).empty();
        if (!cell || (empty && compass))
            return {};
        if (!compass || trimmed(*compass).empty()) {
            const auto typed = applyTyped(reading, ReadingColumn::Deviation, toText(*cell));
            return typed ? typed : Result<void>(at(ReadingColumn::Deviation, typed.error()));
        }
        const auto stated_deg = parseSignedAngle_deg(*cell);
        if (!stated_deg)
            return at(ReadingColumn::Deviation, stated_deg.error());
        if (!reading.complete())
            return at(ReadingColumn::Deviation, wrongBlock(BlockWords::tr("there is no magnetic heading beside it")));
        const double deviation_deg = deviationOf(*reading.magnetic, *reading.compass).degrees();
        if (std::abs(wrap180(*stated_deg - deviation_deg)) > kAgreement_deg + 1e-9)
            return at(ReadingColumn::Deviation,
                wrongBlock(BlockWords::tr("%1 contradicts magnetic − compass, which is %2")
                               .arg(toText(std::string(trimmed(*cell))),
                                   toText(formatSignedAngle(deviation_deg, AngleStyle::DecimalDegrees, 2)))));
        return {};
    }

    const std::vector<ReadingColumn>& m_columns;
    const std::vector<std::string>& m_cells;
};

/// Whether the magnetic heading of the row is north, and then whether it is written as 360.
std::optional<bool> northIn(const std::vector<ReadingColumn>& columns, const std::vector<std::string>& cells)
{
    const auto magnetic = std::find(columns.begin(), columns.end(), ReadingColumn::Magnetic);
    if (magnetic == columns.end())
        return {};
    const auto heading = parseWrittenHeading(cells[static_cast<std::size_t>(magnetic - columns.begin())]);
    return heading && heading->heading_deg == 0.0 ? std::optional(heading->fullTurn) : std::nullopt;
}

} // namespace

std::string figureCell(double value)
{
    constexpr double kNoise = 1e-11; // of binary fractions: 359.1 − 0.3 is 358.8
    QString figures = QString::number(value, 'g', 10);
    if (std::abs(figures.toDouble() - value) > kNoise)
        figures = toText(shortestNumber(value));
    return figures.replace(u'.', QLocale().decimalPoint()).toStdString();
}

std::string copiedCell(const Reading& reading, ReadingColumn column)
{
    if (column == ReadingColumn::Note)
        return withTextMark(reading.note);
    const auto value_deg = cellValue_deg(reading, column);
    return value_deg ? figureCell(*value_deg) : std::string();
}

QString columnTitle(ReadingColumn column)
{
    switch (column) {
    case ReadingColumn::Nominal: return BlockWords::tr("Nominal");
    case ReadingColumn::Magnetic: return BlockWords::tr("Magnetic");
    case ReadingColumn::Compass: return BlockWords::tr("Compass");
    case ReadingColumn::Deviation: return BlockWords::tr("Deviation");
    case ReadingColumn::Residual: return BlockWords::tr("Residual");
    case ReadingColumn::State: return BlockWords::tr("State");
    case ReadingColumn::Note: return BlockWords::tr("Note");
    }
    return {};
}

Result<PastedBlock> pasteBlock(
    std::vector<Reading> readings, int row, ReadingColumn column, CellRows rows, std::optional<double> variation_deg)
{
    if (rows.empty())
        return wrongBlock(BlockWords::tr("there is no text to paste; expected cells of a spreadsheet"));
    const bool named = hasHeadings(rows.front(), column);
    const auto columns = named ? columnsByName(rows.front()) : columnsFrom(column, rows.front().size());
    if (!columns)
        return columns.error();
    if (named)
        rows.erase(rows.begin());
    PastedBlock pasted;
    pasted.rows = static_cast<int>(rows.size());
    for (const ReadingColumn one : *columns)
        pasted.passedOver |= one == ReadingColumn::Residual || one == ReadingColumn::State;
    std::optional<std::size_t> zero, fullTurn;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const std::size_t place = static_cast<std::size_t>(row) + i;
        Reading reading = place < readings.size() ? readings[place] : Reading();
        if (const auto put = RowPaste(*columns, rows[i]).into(reading, variation_deg); !put)
            return wrongBlock(BlockWords::tr("row %1, %2").arg(place + 1).arg(messageOf(put.error())));
        if (place < readings.size())
            readings[place] = std::move(reading);
        else if (reading == Reading()) // an empty row between others is none
            continue;
        else
            readings.push_back(std::move(reading));
        if (const auto turn = northIn(*columns, rows[i]); turn && !(*turn ? fullTurn : zero))
            (*turn ? fullTurn : zero) = std::min(place, readings.size() - 1);
    }
    if (zero && fullTurn)
        pasted.north = settleNorthTwice(readings[std::min(*zero, *fullTurn)], readings[std::max(*zero, *fullTurn)], false);
    pasted.readings = std::move(readings);
    return pasted;
}

} // namespace lubberline::ui
