#include "ui/report/forms/StyleSheet1613.h"

#include <QPainter>

#include <array>
#include <cmath>

#include "core/swing/Observations.h"
#include "ui/report/card/CardPlacard.h"
#include "ui/report/forms/FormGrid.h"
#include "ui/report/page/DocumentFont.h"
#include "ui/report/page/Figures.h"
#include "ui/report/page/Ink.h"
#include "ui/report/page/SheetDocument.h"
#include "ui/report/page/TableBlocks.h"
#include "ui/report/page/Words.h"
#include "ui/report/swing/ReportContent.h"

namespace lubberline::ui {

namespace {

constexpr std::array kNames{"N", "NE", "E", "SE", "S", "SW", "W", "NW"};
constexpr double kStep_deg = 45, kNear_deg = kStep_deg / 2;

std::optional<Observation> nearest(const Swing& swing, double heading_deg)
{
    std::optional<Observation> best;
    double off = kNear_deg;
    for (const auto& reading : swing.readings) {
        if (!reading.used())
            continue;
        const Observation seen = observationOf(swing, reading);
        const double distance = std::abs(wrap180(seen.magnetic.degrees() - heading_deg));
        if (distance < off) {
            off = distance;
            best = seen;
        }
    }
    return best;
}

double indicatedLess(const Observation& seen)
{
    return -deviationOf(seen.magnetic, seen.compass).degrees(); // compass − magnetic
}

QStringList rowOf(const StyleSheet1613& sheet, std::size_t eighth)
{
    const double heading = kStep_deg * static_cast<double>(eighth);
    QStringList cells{QStringLiteral("%1 %2").arg(QString::fromLatin1(kNames[eighth])).arg(heading, 3, 'f', 0, QChar('0'))};
    const auto before = sheet.asFound ? nearest(*sheet.asFound, heading) : std::nullopt;
    const auto after = nearest(sheet.record.swing, heading);
    const auto degrees = [](const auto& angle) { return figure(angle.degrees(), 1); };
    cells << (before ? degrees(before->magnetic) : dash()) << (before ? degrees(before->compass) : dash())
          << (before ? signedFigure(indicatedLess(*before), 1) : dash());
    cells << (after ? degrees(after->magnetic) : dash()) << (after ? degrees(after->compass) : dash())
          << (after ? signedFigure(-indicatedLess(*after), 1) : dash());
    cells << (after ? signedFigure(indicatedLess(*after), 1) : dash());
    return cells;
}

/// TO FLY and STEER for the pilot, to be cut off.
std::vector<QStringList> tearOff(const StyleSheet1613& sheet)
{
    QStringList fly, steer;
    for (std::size_t eighth = 0; eighth < kNames.size(); ++eighth) {
        const double heading = kStep_deg * static_cast<double>(eighth);
        const auto after = nearest(sheet.record.swing, heading);
        fly += QStringLiteral("%1").arg(heading, 3, 'f', 0, QChar('0'));
        steer += after
            ? QStringLiteral("%1").arg(std::fmod(std::round(wrap360(heading + indicatedLess(*after))), 360.0), 3, 'f', 0, QChar('0'))
            : dash();
    }
    fly.prepend(Words::tr("TO FLY (M)"));
    steer.prepend(Words::tr("STEER (C)"));
    return {fly, steer};
}

Block cutLine(const QString& family)
{
    return {mm(8), [family](QPainter& painter, const QRectF& rect) {
                QPen pen(Ink::strong(), mm(0.2), Qt::DashLine);
                painter.setPen(pen);
                painter.drawLine(QPointF(rect.left(), rect.center().y()), QPointF(rect.right(), rect.center().y()));
                painter.setPen(Ink::text());
                paintLine(painter, documentFont(family, 6.5), {rect.left(), rect.center().y() - mm(1)}, Qt::AlignLeft,
                    Words::tr("cut here: the lower part stays with the compass, the upper part goes to the logbook"));
            }};
}

std::vector<Block> blocksOf(const StyleSheet1613& sheet, const QString& family, double width)
{
    const auto append = [](std::vector<Block>& blocks, std::vector<Block> more) { blocks.insert(blocks.end(), more.begin(), more.end()); };
    std::vector<Fact> facts = factsOf(sheet.record);
    facts.push_back({Words::tr("Signs"),
        Words::tr(
            "on this sheet, as on the form: DEV = compass − magnetic, positive where the compass reads more. The deviation of all other "
            "documents is magnetic − compass, easterly positive.")});
    std::vector<Block> blocks = factBlocks(facts, {family, 8, mm(28)}, width);
    append(blocks, tableBlocks(table1613(sheet), width, family));
    blocks.push_back(cutLine(family));
    std::vector<FormColumn> columns{{printable(sheet.record.aircraft.registration), 26}};
    for (const char* name : kNames)
        columns.push_back({QString::fromLatin1(name), 16});
    append(blocks,
        formGrid(
            Words::tr("%1 · swung %2 · signed ____________").arg(printable(sheet.record.compass.name), printable(sheet.record.swing.date)),
            columns, tearOff(sheet), width, family, mm(7)));
    return blocks;
}

PageFrame frameOf(const StyleSheet1613& sheet)
{
    PageFrame frame = frameFor(sheet.record, Words::tr("Pilot's compass correction card (DD 1613 style)"), sheet.madeAtUtc);
    frame.convention = Words::tr("On this sheet DEV = compass heading − magnetic heading; positive where the compass reads more.");
    return frame;
}

} // namespace

Table table1613(const StyleSheet1613& sheet)
{
    const auto column = [](const QString& head, const QString& argument, double width = 20) {
        return TableColumn{head, argument, QStringLiteral("°"), width, TableColumn::Align::Point};
    };
    Table table{Words::tr("Compensating swing, residual swing, computation"),
        {{Words::tr("Rose"), Words::tr("heading"), QStringLiteral("°"), 18, TableColumn::Align::Left},
            column(Words::tr("Compensating"), Words::tr("(1) actual M")), column(Words::tr("swing"), Words::tr("(2) comp C")),
            column(Words::tr("DEV"), Words::tr("(2) − (1)")), column(Words::tr("Residual"), Words::tr("(3) actual M")),
            column(Words::tr("swing"), Words::tr("(4) comp C")), column(Words::tr("C to M"), Words::tr("(3) − (4)")),
            column(Words::tr("M to C"), Words::tr("(4) − (3)"))},
        {}};
    for (std::size_t eighth = 0; eighth < kNames.size(); ++eighth)
        table.rows.push_back({rowOf(sheet, eighth)});
    return table;
}

Result<void> write1613(const StyleSheet1613& sheet, const QString& path)
{
    return writeSheet(
        frameOf(sheet), [&](const QString& family, QSizeF room) { return blocksOf(sheet, family, room.width()); }, path);
}

Result<void> print1613(const StyleSheet1613& sheet, QPagedPaintDevice& device)
{
    return printSheet(
        frameOf(sheet), [&](const QString& family, QSizeF room) { return blocksOf(sheet, family, room.width()); }, device);
}

} // namespace lubberline::ui
