#include "ui/report/card/CardDocument.h"

#include <QPagedPaintDevice>
#include <QPainter>

#include <iterator>

#include "ui/report/card/CardPlacard.h"
#include "ui/report/page/DocumentFont.h"
#include "ui/report/page/Figures.h"
#include "ui/report/page/Ink.h"
#include "ui/report/page/PageFrame.h"
#include "ui/report/page/SheetDocument.h"
#include "ui/report/page/TableBlocks.h"
#include "ui/report/page/Words.h"
#include "ui/report/swing/ReportBlocks.h"
#include "ui/report/swing/ReportContent.h"

namespace lubberline::ui {

namespace {

constexpr double kMarks = mm(7); ///< room for the crop marks around the card
constexpr double kScaleBar = mm(50);

Error inputError(const QString& message) { return {ErrorCode::InvalidInput, said(message)}; }

Result<void> checkColumns(const std::vector<CardColumn>& columns)
{
    if (columns.empty() || columns.size() > 2)
        return inputError(Words::tr("a card has %1 STEER columns here; expected one or two").arg(columns.size()));
    const auto& rows = columns.front().card.rows;
    if (rows.empty())
        return inputError(Words::tr("the card has no headings; expected one every 30° or 45°"));
    const auto sameHeading = [](const CardRow& a, const CardRow& b) { return a.magnetic == b.magnetic; };
    const auto& others = columns.back().card.rows;
    if (!std::equal(rows.begin(), rows.end(), others.begin(), others.end(), sameHeading))
        return inputError(Words::tr("the two STEER columns are for different headings; expected the same step in both"));
    return {};
}

QString removedWords(CoefficientSet removed)
{
    QStringList letters;
    for (const Coefficient c : kCoefficients)
        if (removed.test(indexOf(c)))
            letters += QChar::fromLatin1(letterOf(c));
    return letters.isEmpty()
        ? QString()
        : Words::tr("; %1 taken out mechanically after the swing and not in these figures").arg(letters.join(QStringLiteral(", ")));
}

QString figuresWords(const CardOptions& options)
{
    const QString source = options.source == CardSource::Fit ? Words::tr("deviation by the exact fit at each heading")
                                                             : Words::tr("deviation of the reading nearest to each heading");
    return Words::tr("STEER = FOR − deviation, to whole degrees; %1%2").arg(source, removedWords(options.removed));
}

std::vector<Fact> cardFacts(const CardInput& input)
{
    std::vector<Fact> facts = factsOf(input.record);
    if (input.options)
        facts.push_back({Words::tr("Figures"), figuresWords(*input.options)});
    facts.push_back({Words::tr("After"),
        input.record.swing.stage == SwingStage::AsLeft ? Words::tr("adjustment: the figures are what remains")
                                                       : Words::tr("a check only: nothing was adjusted")});
    if (!input.loadsToName.isEmpty())
        facts.push_back({Words::tr("Loads"),
            Words::tr("push the deviation past 10° while they are on: %1").arg(input.loadsToName.join(QStringLiteral(", ")))});
    if (!input.nextDue.isEmpty())
        facts.push_back({Words::tr("Next swing"),
            Words::tr("due on %1 by the calendar; earlier after an event that makes one due").arg(input.nextDue)});
    if (!input.reprintOf.isEmpty())
        facts.push_back({Words::tr("Reprint"), Words::tr("of the card of %1, from the record").arg(input.reprintOf)});
    facts.push_back({Words::tr("Use"),
        Words::tr(
            "Print at 100 %, check the line of 50 mm, cut along the marks, fix it on or near the compass and take the old card away. It "
            "holds for level flight in the configuration that it names. Between two headings, interpolate.")});
    return facts;
}

/// The figures before they were rounded, for whoever signs the card.
Table exactFigures(const CardInput& input)
{
    Table table{Words::tr("The figures before rounding"), {{Words::tr("FOR"), Words::tr("magnetic"), QStringLiteral("°"), 20}}, {}};
    for (const CardColumn& column : input.columns) {
        table.columns.push_back({column.heading, Words::tr("compass"), QStringLiteral("°"), 30});
        table.columns.push_back({Words::tr("Deviation"), Words::tr("corrected for"), QStringLiteral("°"), 30});
    }
    for (std::size_t i = 0; i < input.columns.front().card.rows.size(); ++i) {
        TableRow row;
        row.cells += threeDigits(qRound(input.columns.front().card.rows[i].magnetic.degrees()));
        for (const CardColumn& column : input.columns)
            row.cells << figure(column.card.rows[i].steer.degrees(), 2) << signedFigure(column.card.rows[i].residual.degrees(), 2);
        table.rows.push_back(row);
    }
    return table;
}

void paintScaleBar(QPainter& painter, QPointF centre, const QString& family)
{
    const double left = centre.x() - kScaleBar / 2, right = centre.x() + kScaleBar / 2;
    painter.setPen(QPen(Ink::strong(), mm(0.2)));
    painter.drawLine(QPointF(left, centre.y()), QPointF(right, centre.y()));
    for (const double x : {left, right})
        painter.drawLine(QPointF(x, centre.y() - mm(1)), QPointF(x, centre.y() + mm(1)));
    painter.setPen(Ink::text());
    paintLine(
        painter, documentFont(family, 6), {centre.x(), centre.y() + mm(3)}, Qt::AlignHCenter, Words::tr("50 mm when printed at 100 %"));
}

Block placardBlock(const CardInput& input, const QString& family)
{
    const QSizeF size = placardSize(input);
    return {size.height() + 2 * kMarks + mm(6), [&input, family, size](QPainter& painter, const QRectF& rect) {
                const QRectF card(QPointF(rect.center().x() - size.width() / 2, rect.top() + kMarks), size);
                paintPlacard(painter, card, input, family);
                paintCropMarks(painter, card);
                paintScaleBar(painter, {card.center().x(), card.bottom() + kMarks + mm(1)}, family);
            }};
}

std::vector<Block> cardBlocks(const CardInput& input, const QString& family, double width, double row)
{
    std::vector<Block> blocks{placardBlock(input, family)};
    for (auto& more : {factBlocks(cardFacts(input), {family, 8, mm(28)}, width), tableBlocks(exactFigures(input), width, family, row)})
        blocks.insert(blocks.end(), more.begin(), more.end());
    return blocks;
}

/// The rows stand closer where that keeps the card on one page.
std::vector<Block> cardBlocks(const CardInput& input, const QString& family, QSizeF room)
{
    auto usual = cardBlocks(input, family, room.width(), kTableRow);
    return paginate(usual, room.height()).size() == 1 ? usual : cardBlocks(input, family, room.width(), kDenseTableRow);
}

PageFrame frameOf(const CardInput& input) { return frameFor(input.record, Words::tr("Compass correction card"), input.madeAtUtc); }

} // namespace

Result<void> printCard(const CardInput& input, QPagedPaintDevice& device)
{
    if (const auto checked = checkColumns(input.columns); !checked)
        return checked;
    return printSheet(
        frameOf(input), [&input](const QString& family, QSizeF room) { return cardBlocks(input, family, room); }, device);
}

Result<void> writeCard(const CardInput& input, const QString& path)
{
    if (const auto checked = checkColumns(input.columns); !checked) {
        Error error = checked.error();
        error.file = path.toStdString();
        return error;
    }
    return writeSheet(
        frameOf(input), [&input](const QString& family, QSizeF room) { return cardBlocks(input, family, room); }, path);
}

} // namespace lubberline::ui
