#include "ui/report/forms/StyleSheet1613.h"

#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/swing/Card.h"
#include "core/swing/CardRemarks.h"
#include "core/swing/Observations.h"
#include "ui/report/card/CardWords.h"
#include "ui/report/forms/FormGrid.h"
#include "ui/report/page/DataHash.h"
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
    const auto degrees = [](const auto& angle) { return headingFigure(angle.degrees(), 1); };
    cells << (before ? degrees(before->magnetic) : dash()) << (before ? degrees(before->compass) : dash())
          << (before ? signedFigure(indicatedLess(*before), 1) : dash());
    cells << (after ? degrees(after->magnetic) : dash()) << (after ? degrees(after->compass) : dash())
          << (after ? signedFigure(-indicatedLess(*after), 1) : dash());
    cells << (after ? signedFigure(indicatedLess(*after), 1) : dash());
    return cells;
}

/// What the pilot is to steer on an eighth; none where nothing was read near it.
std::optional<CardRow> steerRow(const StyleSheet1613& sheet, std::size_t eighth)
{
    const auto magnetic = MagneticHeading::fromDegrees(kStep_deg * static_cast<double>(eighth));
    const auto after = nearest(sheet.record.swing, magnetic.degrees());
    if (!after)
        return {};
    const Deviation deviation = deviationOf(after->magnetic, after->compass);
    CardRow row;
    row.magnetic = magnetic;
    row.residual = deviation;
    row.steer = toCompass(magnetic, deviation);
    row.unread = std::any_of(sheet.gaps.begin(), sheet.gaps.end(), [magnetic](const ReadingGap& gap) { return gap.holds(magnetic); });
    return row;
}

bool hasUnread(const StyleSheet1613& sheet)
{
    for (std::size_t eighth = 0; eighth < kNames.size(); ++eighth)
        if (const auto row = steerRow(sheet, eighth); row && row->unread)
            return true;
    return false;
}

/// TO FLY and STEER for the pilot, to be cut off.
std::vector<QStringList> tearOff(const StyleSheet1613& sheet)
{
    QStringList fly, steer;
    for (std::size_t eighth = 0; eighth < kNames.size(); ++eighth) {
        const auto row = steerRow(sheet, eighth);
        fly += threeDigits(static_cast<int>(kStep_deg) * static_cast<int>(eighth));
        const auto mark = [&](bool holds, const char* sign) { return row && holds ? QString::fromLatin1(sign) : QString(); };
        steer += row ? threeDigits(row->steerRounded_deg()) + mark(overLimit(*row, sheet.record.limits), "!") + mark(row->unread, "*")
                     : dash();
    }
    fly.prepend(Words::tr("TO FLY (M)"));
    steer.prepend(Words::tr("STEER (C)"));
    return {fly, steer};
}

Result<void> checkSteer(const StyleSheet1613& sheet)
{
    std::vector<CardRow> rows;
    for (std::size_t eighth = 0; eighth < kNames.size(); ++eighth)
        if (const auto row = steerRow(sheet, eighth))
            rows.push_back(*row);
    return rows.size() < 3 ? Result<void>() : checkRising(rows, CardBy::Magnetic);
}

/// max − min of compass − magnetic over the eighths that were read.
QString spreadWords(const Swing& swing)
{
    std::optional<double> least, most;
    int read = 0;
    for (std::size_t eighth = 0; eighth < kNames.size(); ++eighth)
        if (const auto seen = nearest(swing, kStep_deg * static_cast<double>(eighth))) {
            least = std::min(least.value_or(360.0), indicatedLess(*seen));
            most = std::max(most.value_or(-360.0), indicatedLess(*seen));
            ++read;
        }
    if (!least)
        return {};
    const double spread_deg = *most - *least;
    QString words = Words::tr("%1° (from %2° to %3°)").arg(figure(spread_deg, 1), signedFigure(least, 1), signedFigure(most, 1));
    if (read < static_cast<int>(kNames.size()))
        words += Words::tr(", over %1 of 8 headings only").arg(read);
    return words;
}

QString spreadFact(const StyleSheet1613& sheet)
{
    const QString after = spreadWords(sheet.record.swing), before = sheet.asFound ? spreadWords(*sheet.asFound) : QString();
    QStringList parts;
    if (!before.isEmpty())
        parts += Words::tr("before compensation %1").arg(before);
    if (!after.isEmpty()) {
        double least = 360, most = -360;
        for (std::size_t eighth = 0; eighth < kNames.size(); ++eighth)
            if (const auto seen = nearest(sheet.record.swing, kStep_deg * static_cast<double>(eighth))) {
                least = std::min(least, indicatedLess(*seen));
                most = std::max(most, indicatedLess(*seen));
            }
        constexpr double kRounding_deg = 1e-9;
        const QString verdict = most - least <= kSpread1613_deg + kRounding_deg ? Words::tr("within") : Words::tr("BEYOND");
        parts += Words::tr("residual swing %1: %2 the %3° that are allowed (TM 1-1500-204-23-4)").arg(after, verdict).arg(kSpread1613_deg);
    }
    return parts.isEmpty() ? notStated() : parts.join(QStringLiteral("; "));
}

QString stateWords(bool isSigned, bool verified, const Swing& swing)
{
    if (!isSigned)
        return Words::tr("DRAFT — NOT SIGNED");
    QStringList names;
    for (const auto& one : swing.signatures)
        names += joined({printable(one.name), printable(one.licence)});
    names.removeDuplicates();
    if (names.isEmpty())
        return Words::tr("signed before signatures were kept");
    const QString who = names.join(QStringLiteral(", "));
    return verified ? Words::tr("signed %1").arg(who) : Words::tr("signed %1 (names not verified)").arg(who);
}

QString compensatingFact(const StyleSheet1613& sheet)
{
    if (!sheet.asFound)
        return Words::tr("none is known: columns (1) and (2) are empty");
    if (!sheet.compensating)
        return Words::tr("as the guided swing of this record read it, before any control was turned");
    const SwingRecord& other = *sheet.compensating;
    return joined({printable(other.swing.date), statedWord(other.swing.kind), statedWord(other.swing.stage),
        Words::tr("record %1").arg(printable(other.swing.record)), Words::tr("data %1").arg(dataHash(other).left(8)),
        stateWords(other.swing.state == SwingState::Signed && sheet.compensatingHolds, false, other.swing)});
}

std::vector<Fact> factsOf1613(const StyleSheet1613& sheet)
{
    std::vector<Fact> facts = factsOf(sheet.record, sheet.holds);
    facts.push_back({Words::tr("Compensating"), compensatingFact(sheet)});
    facts.push_back({Words::tr("Spread"), spreadFact(sheet)});
    facts.push_back({Words::tr("Signed"), stateWords(sheet.isSigned(), sheet.verified, sheet.record.swing)});
    facts.push_back({Words::tr("Method"),
        Words::tr("every figure is of the reading nearest to its heading, within 22.5°; a placard by the fit may differ by how far that "
                  "reading lies off the curve")});
    QStringList remarks;
    for (const auto& remark : sheet.remarks)
        remarks += printable(remark);
    if (!remarks.isEmpty())
        facts.push_back({Words::tr("Remarks"), remarks.join(QStringLiteral(". ")) + QStringLiteral(".")});
    facts.push_back({Words::tr("Signs"),
        Words::tr(
            "on this sheet, as on the form: DEV = compass − magnetic, positive where the compass reads more. The deviation of all other "
            "documents, and of the remarks, is magnetic − compass, easterly positive.")});
    return facts;
}

/// What the pilot must know of the strip that stays with the compass.
std::vector<Fact> factsOfTearOff(const StyleSheet1613& sheet)
{
    QStringList remarks;
    for (const auto& remark : sheet.remarks)
        remarks += printable(remark);
    const QString configuration = configurationWords(sheet.record.swing.configuration);
    std::vector<Fact> facts{{Words::tr("Configuration"), configuration.isEmpty() ? notStated() : configuration},
        {Words::tr("Method"),
            joined({Words::tr("by the nearest reading"), hasUnread(sheet) ? Words::tr("* nobody read near") : QString()})},
        {Words::tr("Signed"),
            joined({stateWords(sheet.isSigned(), sheet.verified, sheet.record.swing),
                sheet.outOfLimits ? Words::tr("OUT OF LIMITS") : QString()})}};
    if (!remarks.isEmpty())
        facts.push_back({Words::tr("Remarks"), remarks.join(QStringLiteral(". ")) + QStringLiteral(".")});
    return facts;
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
    std::vector<Block> blocks = factBlocks(factsOf1613(sheet), {family, 8, mm(28)}, width);
    append(blocks, tableBlocks(table1613(sheet), width, family));
    blocks.push_back(cutLine(family));
    std::vector<FormColumn> columns{{printable(sheet.record.aircraft.registration), 26}};
    for (const char* name : kNames)
        columns.push_back({QString::fromLatin1(name), 16});
    append(blocks,
        formGrid(joined({printable(sheet.record.compass.name), labelled(Words::tr("S/N"), printable(sheet.record.compass.serialNumber)),
                     Words::tr("swung %1").arg(printable(sheet.record.swing.date))}),
            columns, tearOff(sheet), width, family, mm(7)));
    append(blocks, factBlocks(factsOfTearOff(sheet), {family, 7, mm(28)}, width));
    return blocks;
}

PageFrame frameOf(const StyleSheet1613& sheet)
{
    QStringList marks;
    if (sheet.record.aircraft.demonstration)
        marks += Words::tr("DEMONSTRATION DATA");
    PageFrame frame = frameFor(sheet.record, Words::tr("Pilot's compass correction card (DD 1613 style)"), sheet.madeAtUtc);
    if (!sheet.isSigned())
        marks += Words::tr("DRAFT — NOT SIGNED");
    if (sheet.outOfLimits)
        marks += Words::tr("OUT OF LIMITS");
    if (sheet.superseded)
        marks += Words::tr("AMENDED SINCE: NOT VALID");
    frame.banner = joined(marks);
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
    if (auto checked = checkSteer(sheet); !checked)
        return checked;
    return writeSheet(
        frameOf(sheet), [&](const QString& family, QSizeF room) { return blocksOf(sheet, family, room.width()); }, path);
}

Result<void> print1613(const StyleSheet1613& sheet, QPagedPaintDevice& device)
{
    if (auto checked = checkSteer(sheet); !checked)
        return checked;
    return printSheet(
        frameOf(sheet), [&](const QString& family, QSizeF room) { return blocksOf(sheet, family, room.width()); }, device);
}

} // namespace lubberline::ui
