#include "ui/report/page/TableBlocks.h"

#include <QFontMetricsF>
#include <QHash>
#include <QPainter>

#include <algorithm>
#include <numeric>

#include "ui/report/page/DocumentFont.h"
#include "ui/report/page/Ink.h"
#include "ui/text/AngleWords.h"

namespace lubberline::ui {

namespace {

constexpr double kCellSize_pt = 8;
constexpr double kHeadSize_pt = 7;
constexpr double kHeadLine = mm(3.1);
constexpr double kPadding = mm(0.8);
constexpr double kNameGap = mm(1.5); ///< between the name of a fact and what it is

/// Where the columns stand, and where in each the decimal points stand. Shared by the blocks of one table.
struct Setting {
    Table table;
    std::vector<double> left, width, point;
    QFont cell, bold, head;
    double row = kTableRow; ///< height of a row of one line

    /// Measured once: the same figures come again and again in a column, and a log has tens of thousands.
    double advance(const QFont& font, const QString& text) const
    {
        auto& known = font.bold() ? boldAdvances : advances;
        auto found = known.constFind(text);
        if (found == known.constEnd())
            found = known.insert(text, QFontMetricsF(font).horizontalAdvance(text));
        return *found;
    }

private:
    mutable QHash<QString, double> advances, boldAdvances;
};

int pointOf(const QString& cell)
{
    const auto at = cell.indexOf('.');
    return static_cast<int>(at < 0 ? cell.size() : at);
}

bool isFigure(const QString& cell)
{
    return std::any_of(cell.begin(), cell.end(), [](QChar c) { return c.isDigit(); });
}

/// The place of the decimal point that centres the widest figures in the column.
double pointPlace(const Setting& setting, std::size_t column)
{
    double before = 0, after = 0;
    for (const TableRow& row : setting.table.rows) {
        const QString cell = row.cells.value(static_cast<qsizetype>(column));
        if (!isFigure(cell))
            continue;
        before = std::max(before, setting.advance(setting.cell, cell.left(pointOf(cell))));
        after = std::max(after, setting.advance(setting.cell, cell.mid(pointOf(cell))));
    }
    return setting.left[column] + (setting.width[column] - before - after) / 2 + before;
}

std::shared_ptr<const Setting> settingOf(const Table& table, double width, const QString& family, double row)
{
    auto setting = std::make_shared<Setting>();
    setting->table = inAngleStyle(table);
    setting->row = row;
    setting->cell = documentFont(family, kCellSize_pt);
    setting->bold = documentFont(family, kCellSize_pt, true);
    setting->head = documentFont(family, kHeadSize_pt);
    const double total = std::accumulate(
        table.columns.begin(), table.columns.end(), 0.0, [](double sum, const TableColumn& column) { return sum + column.width_mm; });
    double left = 0;
    for (const TableColumn& column : table.columns) {
        setting->left.push_back(left);
        setting->width.push_back(column.width_mm / total * width);
        left += setting->width.back();
    }
    for (std::size_t i = 0; i < table.columns.size(); ++i)
        setting->point.push_back(pointPlace(*setting, i));
    return setting;
}

QFont smaller(QFont font, double factor)
{
    font.setPixelSize(std::max(1, static_cast<int>(font.pixelSize() * factor)));
    return font;
}

void paintCell(QPainter& painter, const Setting& setting, std::size_t column, const QRectF& row, const QFont& font, const QString& text)
{
    const double left = row.left() + setting.left[column];
    const double baseline = row.top() + setting.row / 2 + QFontMetricsF(setting.cell).capHeight() / 2;
    if (setting.table.columns[column].align == TableColumn::Align::Left) {
        const double ascent = QFontMetricsF(setting.cell).ascent();
        paintWrapped(painter, font, QRectF(left + kPadding, baseline - ascent, setting.width[column] - 2 * kPadding, row.height()), text);
    } else if (const double room = setting.width[column] - kPadding, needed = setting.advance(font, text); needed > room) {
        // what is too long for its column is set smaller, and never into the next
        paintLine(painter, smaller(font, room / needed), {left + setting.width[column] / 2, baseline}, Qt::AlignHCenter, text);
    } else if (isFigure(text)) {
        // The points stand one beneath the other, unless "2e-42" and "0.0011" would need more than the column for that.
        const double whole = setting.advance(font, text.left(pointOf(text)));
        const double most = left + setting.width[column] - kPadding / 2 - needed;
        const double x = std::max(left + kPadding / 2, std::min(row.left() + setting.point[column] - whole, most));
        paintLine(painter, font, {x, baseline}, Qt::AlignLeft, text);
    } else {
        paintLine(painter, font, {left + (setting.width[column] - needed) / 2, baseline}, Qt::AlignLeft, text);
    }
}

void paintRow(QPainter& painter, const Setting& setting, const TableRow& row, const QRectF& rect)
{
    if (row.look == TableRow::Look::Marked)
        painter.fillRect(rect, Ink::marked());
    painter.setPen(row.look == TableRow::Look::Faint ? Ink::faint() : Ink::text());
    const QFont& font = row.look == TableRow::Look::Marked ? setting.bold : setting.cell;
    for (std::size_t i = 0; i < setting.table.columns.size(); ++i)
        paintCell(painter, setting, i, rect, font, row.cells.value(static_cast<qsizetype>(i)));
    painter.setPen(QPen(Ink::rule(), mm(0.1)));
    painter.drawLine(rect.bottomLeft(), rect.bottomRight());
}

double rowHeight(const Setting& setting, const TableRow& row)
{
    const QFont& font = row.look == TableRow::Look::Marked ? setting.bold : setting.cell;
    const double oneLine = QFontMetricsF(font).lineSpacing();
    double height = setting.row;
    for (std::size_t i = 0; i < setting.table.columns.size(); ++i) {
        if (setting.table.columns[i].align != TableColumn::Align::Left)
            continue;
        const double wrapped = wrappedHeight(font, setting.width[i] - 2 * kPadding, row.cells.value(static_cast<qsizetype>(i)));
        height = std::max(height, setting.row + std::max(0.0, wrapped - oneLine));
    }
    return height;
}

/// The lines of a head stand on a common base, so that units stand beside units.
QStringList headLines(const TableColumn& column)
{
    QStringList lines{column.head, column.argument, column.unit};
    lines.removeAll(QString());
    return lines;
}

int mostHeadLines(const Table& table)
{
    qsizetype lines = 1;
    for (const TableColumn& column : table.columns)
        lines = std::max(lines, headLines(column).size());
    return static_cast<int>(lines);
}

void paintHead(QPainter& painter, const Setting& setting, const QRectF& rect)
{
    painter.setPen(Ink::text());
    const QFontMetricsF metrics(setting.head);
    for (std::size_t i = 0; i < setting.table.columns.size(); ++i) {
        const TableColumn& column = setting.table.columns[i];
        const bool left = column.align == TableColumn::Align::Left;
        const double x = rect.left() + setting.left[i] + (left ? kPadding : setting.width[i] / 2);
        const QStringList lines = headLines(column);
        double baseline = rect.bottom() - mm(0.6) - metrics.descent() - kHeadLine * static_cast<double>(lines.size() - 1);
        for (const QString& line : lines) {
            const double room = setting.width[i] - (left ? kPadding : 0), needed = metrics.horizontalAdvance(line);
            const QFont font = needed <= room ? setting.head : smaller(setting.head, room / needed);
            paintLine(painter, font, {x, baseline}, left ? Qt::AlignLeft : Qt::AlignHCenter, line);
            baseline += kHeadLine;
        }
    }
    painter.setPen(QPen(Ink::strong(), mm(0.3)));
    painter.drawLine(rect.bottomLeft(), rect.bottomRight());
}

} // namespace

Table inAngleStyle(Table table)
{
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        if (table.columns[i].unit != QStringLiteral("°"))
            continue;
        table.columns[i].unit = angleUnit();
        for (TableRow& row : table.rows)
            if (static_cast<qsizetype>(i) < row.cells.size())
                row.cells[static_cast<qsizetype>(i)] = inAngleColumn(row.cells[static_cast<qsizetype>(i)]);
    }
    return table;
}

Block titleBlock(const QString& title, const QString& family)
{
    const QFont font = documentFont(family, 9.5, true);
    return {mm(6.2),
        [font, title](QPainter& painter, const QRectF& rect) {
            painter.setPen(Ink::text());
            paintLine(painter, font, {rect.left(), rect.bottom() - mm(1.4)}, Qt::AlignLeft, title);
        },
        true};
}

std::vector<Block> tableBlocks(const Table& table, double width, const QString& family, double lineHeight)
{
    const auto setting = settingOf(table, width, family, lineHeight);
    const auto head = std::make_shared<const Block>(Block{mm(1.4) + kHeadLine * mostHeadLines(table),
        [setting](QPainter& painter, const QRectF& rect) { paintHead(painter, *setting, rect); }, true});
    std::vector<Block> blocks{titleBlock(table.title, family), *head};
    for (const TableRow& row : setting->table.rows) {
        blocks.push_back({rowHeight(*setting, row),
            [setting, row](QPainter& painter, const QRectF& rect) { paintRow(painter, *setting, row, rect); }, false, false, head});
    }
    return blocks;
}

std::vector<Block> factBlocks(const std::vector<Fact>& facts, const FactStyle& style, double width)
{
    const QFont name = documentFont(style.family, style.size_pt, true);
    const QFont value = documentFont(style.family, style.size_pt);
    const double lineHeight = QFontMetricsF(value).lineSpacing(), ascent = QFontMetricsF(value).ascent();
    std::vector<Block> blocks;
    for (const Fact& fact : facts) {
        const QStringList heads = wrappedLines(name, style.nameWidth - kNameGap, fact.name);
        const QStringList lines = wrappedLines(value, width - style.nameWidth, fact.value);
        // A block for each line: a note of any length goes on on the next page.
        const qsizetype count = std::max(heads.size(), lines.size());
        for (qsizetype i = 0; i < count; ++i) {
            blocks.push_back({lineHeight + (i + 1 == count ? mm(0.5) : 0),
                [head = heads.value(i), line = lines.value(i), name, value, ascent, left = style.nameWidth](
                    QPainter& painter, const QRectF& rect) {
                    painter.setPen(Ink::text());
                    paintLine(painter, name, {rect.left(), rect.top() + ascent}, Qt::AlignLeft, head);
                    paintLine(painter, value, {rect.left() + left, rect.top() + ascent}, Qt::AlignLeft, line);
                }});
        }
    }
    return blocks;
}

} // namespace lubberline::ui
