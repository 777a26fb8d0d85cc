#include "ui/report/card/CardDocument.h"

#include <QPagedPaintDevice>
#include <QPainter>

#include <algorithm>

#include "core/swing/CardRemarks.h"
#include "ui/report/card/CardPlacard.h"
#include "ui/report/card/CardWords.h"
#include "ui/report/page/DataHash.h"
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

bool sameCompass(const SwingRecord& a, const SwingRecord& b)
{
    const auto same = [](const std::string& one, const std::string& other) { return printable(one) == printable(other); };
    return same(a.aircraft.registration, b.aircraft.registration) && same(a.compass.name, b.compass.name)
        && (a.compass.serialNumber.empty() || b.compass.serialNumber.empty() || same(a.compass.serialNumber, b.compass.serialNumber));
}

Result<void> checkColumns(const std::vector<CardColumn>& columns)
{
    if (columns.empty() || columns.size() > 2)
        return inputError(Words::tr("a card has %1 STEER columns here; expected one or two").arg(columns.size()));
    const CardColumn &first = columns.front(), &last = columns.back();
    if (first.card.rows.empty())
        return inputError(Words::tr("the card has no headings; expected one every 10°, 15°, 30° or 45°"));
    if (!(first.card.options == last.card.options) || first.card.rows.size() != last.card.rows.size())
        return inputError(Words::tr("the two STEER columns are made in different ways; expected the same headings and the same method"));
    if (!sameCompass(first.record, last.record))
        return inputError(
            Words::tr("the two STEER columns are of different compasses; expected two swings of one compass of one aircraft"));
    if (columns.size() > 1 && first.heading == last.heading)
        return inputError(Words::tr("the two STEER columns are both “%1”; expected columns that can be told apart").arg(first.heading));
    return {};
}

QString useWords(const CardInput& input)
{
    const bool level = std::ranges::all_of(input.columns, [](const CardColumn& column) { return attitudeOf(column.record.swing).level; });
    const bool tilted = std::ranges::any_of(input.columns, [](const CardColumn& column) { return attitudeOf(column.record.swing).tilted; });
    const QString holds = tilted
        ? Words::tr("It holds in the attitude in which it was swung, which was not level, and in the configuration that it names.")
        : level ? Words::tr("It holds for level flight in the configuration that it names.")
                : Words::tr("It holds in the configuration that it names; the attitude in which it was swung is not stated.");
    return Words::tr(
        "Print at 100 %, check the line of 50 mm, cut along the marks, fix it on or near the compass and take the old card away. %1 "
        "Between two headings, interpolate.")
        .arg(holds);
}

/// What the records of all columns say once, and what they say differently once for each.
std::vector<Fact> factsOfColumns(const std::vector<CardColumn>& columns)
{
    std::vector<Fact> facts;
    for (const Fact& fact : factsOf(columns.front().record, columns.front().holds)) {
        QStringList each;
        bool same = true;
        for (const CardColumn& column : columns) {
            const auto theirs = factsOf(column.record, column.holds);
            const auto found = std::ranges::find_if(theirs, [&](const Fact& one) { return one.name == fact.name; });
            const QString value = found == theirs.end() ? notStated() : found->value;
            same = same && value == fact.value;
            each += QStringLiteral("%1: %2").arg(column.heading, value);
        }
        facts.push_back(same ? fact : Fact{fact.name, each.join(QStringLiteral("; "))});
    }
    // What only the second record states.
    for (const Fact& fact : factsOf(columns.back().record, columns.back().holds))
        if (std::ranges::none_of(facts, [&](const Fact& one) { return one.name == fact.name; }))
            facts.push_back({fact.name, QStringLiteral("%1: %2").arg(columns.back().heading, fact.value)});
    return facts;
}

void addColumnFacts(std::vector<Fact>& facts, const CardColumn& column, bool several)
{
    const QString record = column.record.swing.record.empty() ? dash() : printable(column.record.swing.record);
    QStringList words;
    if (several)
        words += Words::tr("record %1, data SHA-256 %2").arg(record, dataHash(column.record));
    words += joined(signatureLinesOf(column));
    words += qualityLine(column);
    words += largestLine(column);
    facts.push_back({several ? column.heading : Words::tr("Quality"), words.join(QStringLiteral(". ")) + QStringLiteral(".")});
    QStringList remarks;
    for (const auto& remark : remarksOn(column.card, column.record))
        remarks += printable(remark);
    if (!remarks.isEmpty())
        facts.push_back({several ? QString() : Words::tr("Remarks"), remarks.join(QStringLiteral(". ")) + QStringLiteral(".")});
}

QString stageWords(SwingStage stage)
{
    return stage == SwingStage::AsLeft ? Words::tr("adjustment: the figures are what remains")
                                       : Words::tr("nothing: as found, before any adjustment");
}

std::vector<Fact> cardFacts(const CardInput& input)
{
    std::vector<Fact> facts = factsOfColumns(input.columns);
    facts.push_back({Words::tr("Figures"), methodWords(input.columns.front().card.options)});
    for (const CardColumn& column : input.columns)
        addColumnFacts(facts, column, input.columns.size() > 1);
    if (const SwingStage stage = input.record().swing.stage; stage != SwingStage::NotStated)
        facts.push_back({Words::tr("After"), stageWords(stage)});
    if (!input.loadsToName.isEmpty())
        facts.push_back({Words::tr("Loads"),
            Words::tr("push the deviation past 10° while they are on: %1").arg(input.loadsToName.join(QStringLiteral(", ")))});
    if (!input.nextDue.isEmpty())
        facts.push_back({Words::tr("Next swing"),
            Words::tr("due on %1 by the calendar; earlier after an event that makes one due").arg(input.nextDue)});
    if (!input.reprintOf.isEmpty())
        facts.push_back({Words::tr("Reprint"), Words::tr("of the card of %1, from the record").arg(input.reprintOf)});
    facts.push_back({Words::tr("Use"), useWords(input)});
    return facts;
}

/// The figures before they were rounded, how sure they are, and what is half-way to the next row.
Table exactFigures(const CardInput& input)
{
    const bool byCompass = input.columns.front().card.options.by == CardBy::Compass;
    const QString degrees = QStringLiteral("°");
    Table table{Words::tr("The figures before rounding, and half-way to the next row"),
        {{byCompass ? Words::tr("COMPASS") : Words::tr("FOR"), byCompass ? Words::tr("compass", "heading") : Words::tr("magnetic"), degrees,
            18}},
        {}};
    for (const CardColumn& column : input.columns) {
        table.columns.push_back({byCompass && input.columns.size() == 1 ? Words::tr("MAGNETIC") : column.heading,
            byCompass ? Words::tr("magnetic") : Words::tr("compass", "heading"), degrees, 22});
        table.columns.push_back({Words::tr("Deviation"), Words::tr("corrected for"), degrees, 22});
        table.columns.push_back({Words::tr("95 % band"), Words::tr("±"), degrees, 18});
        table.columns.push_back({Words::tr("Half-way"), Words::tr("by the curve"), degrees, 20});
        table.columns.push_back({Words::tr("Interpolated"), Words::tr("is off by"), degrees, 20});
    }
    for (std::size_t i = 0; i < input.columns.front().card.rows.size(); ++i) {
        const CardRow& first = input.columns.front().card.rows[i];
        TableRow row;
        row.cells += threeDigits(byCompass ? first.steerRounded_deg() : first.magneticRounded_deg());
        for (const CardColumn& column : input.columns) {
            const CardRow& here = column.card.rows[i];
            const auto& curve_deg = here.halfway.curve_deg;
            row.cells << headingFigure(byCompass ? here.magnetic.degrees() : here.steer.degrees(), 2) + markOf(here, column)
                      << signedFigure(here.residual.degrees(), 2) << figure(inDegrees(here.band_rad), 2) << headingFigure(curve_deg, 2)
                      << (curve_deg ? signedFigure(wrap180(here.halfway.interpolated_deg - *curve_deg), 2) : dash());
            if (!markOf(here, column).isEmpty())
                row.look = TableRow::Look::Marked;
        }
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
    const QSizeF size = placardSize(input, family);
    return {size.height() + 2 * kMarks + mm(6), [&input, family, size](QPainter& painter, const QRectF& rect) {
                const QRectF card(QPointF(rect.center().x() - size.width() / 2, rect.top() + kMarks), size);
                paintPlacard(painter, card, input, family);
                paintCropMarks(painter, card);
                paintScaleBar(painter, {card.center().x(), card.bottom() + kMarks + mm(1)}, family);
            }};
}

/// How close the page is set.
struct Setting {
    double row = kTableRow, facts_pt = 8;
};

std::vector<Block> cardBlocks(
    const CardInput& input, const QString& family, double width, const Setting& setting, bool figuresApart = false)
{
    std::vector<Block> blocks{placardBlock(input, family)};
    append(blocks, factBlocks(cardFacts(input), {family, setting.facts_pt, mm(28)}, width));
    auto figures = tableBlocks(exactFigures(input), width, family, setting.row);
    figures.front().newPage = figuresApart;
    append(blocks, std::move(figures));
    return blocks;
}

/// Rows and facts stand closer where that keeps the card on one page; where it does not, the figures have a page of their own.
std::vector<Block> cardBlocks(const CardInput& input, const QString& family, QSizeF room)
{
    for (const Setting& setting : {Setting(), Setting{kDenseTableRow}, Setting{kDenseTableRow, 7}, Setting{0.9 * kDenseTableRow, 7}})
        if (auto blocks = cardBlocks(input, family, room.width(), setting); paginate(blocks, room.height()).size() == 1)
            return blocks;
    return cardBlocks(input, family, room.width(), Setting(), true);
}

/// Named for every column, by their beginnings: a hash stands for its own record alone.
PageFrame frameOf(const CardInput& input)
{
    PageFrame frame = frameFor(input.record(), Words::tr("Compass correction card"), input.madeAtUtc);
    frame.banner = cardBanner(input);
    if (input.columns.size() > 1) {
        QStringList records, hashes;
        for (const CardColumn& column : input.columns) {
            records += QStringLiteral("%1 %2").arg(column.heading, printable(column.record.swing.record).left(8));
            hashes += QStringLiteral("%1 %2").arg(column.heading, dataHash(column.record).left(16));
        }
        frame.recordId = records.join(QStringLiteral(" · "));
        frame.hash = hashes.join(QStringLiteral(" · "));
    }
    return frame;
}

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
