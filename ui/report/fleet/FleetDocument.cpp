#include "ui/report/fleet/FleetDocument.h"

#include <QPainter>

#include "core/base/OutputFile.h"
#include "core/format/results/FleetJson.h"
#include "ui/plots/fleet/FleetDrawing.h"
#include "ui/report/fleet/FleetTables.h"
#include "ui/report/page/DataHash.h"
#include "ui/report/page/DocumentFont.h"
#include "ui/report/page/Html.h"
#include "ui/report/page/Ink.h"
#include "ui/report/page/SheetDocument.h"
#include "ui/report/page/TableBlocks.h"
#include "ui/report/page/Words.h"
#include "ui/report/swing/FieldBlocks.h"

namespace lubberline::ui {

namespace {

constexpr std::size_t kRankedOnPaper = 100; ///< a headquarters reads the head of the list; CSV and JSON have all

PageFrame fleetFrame(const FleetDocument& document)
{
    PageFrame frame;
    frame.title = Words::tr("Fleet report");
    frame.subject = wordsFor(document.selection, document.report.options);
    frame.convention = Words::tr("Deviation = magnetic heading − compass heading; easterly is positive.");
    frame.hash = hashOfText(toJson(document.report, document.fleet));
    frame.made = madeWords(document.madeAtUtc);
    return frame;
}

/// Those that have rows, in the order of the questions.
std::vector<Table> tablesOf(const FleetDocument& document)
{
    const auto& [report, fleet, selection, made] = document;
    std::vector<Table> tables{rankingTable(report, fleet, kRankedOnPaper), binTable(report), patternTable(report),
        fleetCoefficientTable(report, fleet), softIronTable(report), fleetHarmonicTable(report), exceedanceTable(report),
        varianceTable(report), plantTable(report), alarmTable(report), jumpTable(report, fleet), driftTable(report, fleet)};
    std::erase_if(tables, [](const Table& table) { return table.rows.empty(); });
    return tables;
}

QString distributionTitle()
{
    return Words::tr("Distribution of the coefficients (line: mean; named: far from the others); amplitudes by order");
}

PopulationDrawing drawingOf(const FleetDocument& document) { return {&document.report.pattern, document.report.exceedance.limit_deg, {}}; }

using Paint = std::function<void(QPainter&, const QRectF&, const FleetLook&)>;

Block plotBlock(const QString& title, double height, const QString& family, const Paint& paint)
{
    const FleetLook look{documentFont(family, 7), paperColours()};
    const QFont bold = documentFont(family, 8.5, true);
    return {height, [=](QPainter& painter, const QRectF& rect) {
                painter.setPen(Ink::text());
                paintLine(painter, bold, {rect.left(), rect.top() + mm(4)}, Qt::AlignLeft, title);
                paint(painter, rect.adjusted(0, mm(6), 0, -mm(2)), look);
            }};
}

std::vector<Block> documentBlocks(const FleetDocument& document, const QString& family, QSizeF room)
{
    std::vector<Block> blocks = listBlocks(fleetSummary(document.report, document.fleet), family, 9, room.width());
    const auto& report = document.report;
    blocks.push_back(plotBlock(Words::tr("Mean deviation and spread against magnetic heading"), mm(78), family,
        [drawing = drawingOf(document)](
            QPainter& painter, const QRectF& rect, const FleetLook& look) { paintPopulationCurve(painter, rect, drawing, look); }));
    blocks.push_back(plotBlock(Words::tr("The same, polar"), mm(84), family,
        [drawing = drawingOf(document)](
            QPainter& painter, const QRectF& rect, const FleetLook& look) { paintPopulationPolar(painter, rect, drawing, look); }));
    blocks.push_back(plotBlock(distributionTitle(), mm(92), family,
        [drawing = distributionDrawing(report, document.fleet)](
            QPainter& painter, const QRectF& rect, const FleetLook& look) { paintDistributions(painter, rect, drawing, look); }));
    for (const auto& table : tablesOf(document))
        append(blocks, tableBlocks(table, room.width(), family, kDenseTableRow));
    blocks.push_back(titleBlock(Words::tr("How the figures were made"), family));
    append(blocks, listBlocks(fleetMethods(report), family, 8, room.width()));
    return blocks;
}

QByteArray fleetHtml(const FleetDocument& document, const PageFrame& frame, const QString& family)
{
    QFont font(family);
    font.setPixelSize(13);
    const FleetLook look{font, paperColours()};
    const auto drawing = drawingOf(document);
    const auto& report = document.report;
    const auto figureHtml = [&](const QString& title, QSize size_px, const char* prefix, const Paint& paint) {
        return element("div",
            element("h2", escaped(title))
                + svgOf([&](QPainter& painter, const QRectF& rect) { paint(painter, rect, look); }, size_px, QString::fromLatin1(prefix)),
            "plots");
    };
    QString body = element("h1", escaped(frame.title)) + element("p", escaped(frame.subject))
        + listHtml(Words::tr("In short"), fleetSummary(report, document.fleet));
    body += figureHtml(Words::tr("Mean deviation and spread against magnetic heading"), {980, 420}, "curve",
        [&](QPainter& painter, const QRectF& rect, const FleetLook& how) { paintPopulationCurve(painter, rect, drawing, how); });
    body += figureHtml(Words::tr("The same, polar"), {980, 560}, "polar",
        [&](QPainter& painter, const QRectF& rect, const FleetLook& how) { paintPopulationPolar(painter, rect, drawing, how); });
    body += figureHtml(distributionTitle(), {980, 560}, "spread",
        [&, spread = distributionDrawing(report, document.fleet)](
            QPainter& painter, const QRectF& rect, const FleetLook& how) { paintDistributions(painter, rect, spread, how); });
    for (const auto& table : tablesOf(document))
        body += tableHtml(table);
    body += listHtml(Words::tr("How the figures were made"), fleetMethods(report));
    QString foot;
    for (const QString& line : {frame.convention, Words::tr("Data SHA-256 %1").arg(frame.hash), frame.made})
        foot += element("div", escaped(line));
    return htmlPage(frame.title + QStringLiteral(" · ") + frame.subject, body + element("footer", foot));
}

} // namespace

Result<void> writeFleetDocument(const FleetDocument& document, const QString& path, DocumentKind kind, const Progress& progress)
{
    const PageFrame frame = fleetFrame(document);
    if (kind == DocumentKind::Pdf)
        return writeSheet(
            frame, [&](const QString& family, QSizeF room) { return documentBlocks(document, family, room); }, path, progress);
    const auto family = documentFamily();
    if (!family)
        return family.error();
    return writeWholeFile(path.toStdString(), fleetHtml(document, frame, *family).toStdString());
}

} // namespace lubberline::ui
