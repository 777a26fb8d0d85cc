#include "ui/report/forms/InflightSheets.h"

#include <QFileInfo>

#include "ui/plots/inflight/InflightDrawing.h"
#include "ui/report/page/Figures.h"
#include "ui/report/page/Words.h"

namespace lubberline::ui {

namespace {

ReferenceSheet::Picture pictureOfHeight(double height_mm, const DrawnPicture& drawn)
{
    return {height_mm, [drawn](QPainter& painter, const QRectF& rect) { renderDrawn(painter, rect, drawn); }};
}

} // namespace

QString sourceName(const std::string& path) { return QFileInfo(QString::fromStdString(path)).fileName(); }

QStringList printableAll(const std::vector<Message>& messages)
{
    QStringList lines;
    for (const Message& message : messages)
        lines += printable(message);
    return lines;
}

ReferenceSheet legsSheet(const LegsSolution& solution, const QString& source, const QStringList& warnings)
{
    const QString degrees = QStringLiteral("°");
    ReferenceSheet sheet;
    sheet.title = Words::tr("Swing in flight: legs by GPS");
    sheet.subject = source;
    sheet.text
        << Words::tr("Wind from %1° at %2 kt ± %3 kt, airspeed %4 kt ± %5 kt (one standard error).")
               .arg(headingFigure(solution.air.from_deg(), 0), figure(solution.air.speed_kt(), 1),
                   figure(solution.air.standardError_kt(), 1), figure(solution.air.airspeed_kt, 1),
                   figure(solution.air.airspeedError_kt, 1))
        << Words::tr(
               "Ground velocity = air velocity + wind: at one airspeed in one air mass the ground velocities of three headings or more lie on a "
               "circle about the wind whose radius is the airspeed; the heading of each leg is that of ground velocity − wind.")
        << warnings;
    sheet.pictures.push_back(pictureOfHeight(95, legCircle(solution)));
    sheet.table = {Words::tr("Legs"),
        {{Words::tr("Leg"), {}, {}, 26, TableColumn::Align::Left}, {Words::tr("Track"), Words::tr("true"), degrees, 20},
            {Words::tr("Speed"), Words::tr("ground"), QStringLiteral("kt"), 20}, {Words::tr("Heading"), Words::tr("true"), degrees, 20},
            {Words::tr("±"), Words::tr("1 se"), degrees, 14}, {Words::tr("Heading"), Words::tr("magnetic"), degrees, 20},
            {Words::tr("Compass", "heading"), Words::tr("heading"), degrees, 20}, {Words::tr("Deviation"), {}, degrees, 20}},
        {}};
    for (const SolvedLeg& leg : solution.legs)
        sheet.table.rows.push_back({{printable(leg.leg.name), headingFigure(leg.leg.track_deg, 1), figure(leg.leg.groundSpeed_kt, 1),
            headingFigure(leg.trueHeading_deg, 1), figure(leg.standardError_deg, 2), headingFigure(leg.magneticHeading_deg, 1),
            headingFigure(leg.leg.compassHeading_deg, 1), signedFigure(leg.deviation_deg, 2)}});
    return sheet;
}

ReferenceSheet continuousSheet(const ContinuousResult& result, const QString& source, const QStringList& warnings)
{
    ReferenceSheet sheet;
    sheet.title = Words::tr("Continuous swing in flight");
    sheet.subject = source;
    sheet.text
        << Words::tr("%1 updates; innovations %2 times what the stated errors allow (1: as stated).")
               .arg(result.updates)
               .arg(figure(result.nisMean, 2))
        << Words::tr(
               "δ = A + B sin ψ′ + C cos ψ′ + D sin 2ψ′ + E cos 2ψ′, followed by a Kalman filter; an alarm is raised by χ² of the last 10, 20, 40 "
               "and 80 innovations, falsely in one of ten logs of 1400 updates.");
    if (result.whole)
        sheet.text << Words::tr("sin δ = Σ g (S b + p/H): the sensor's soft and hard iron followed by a Kalman filter at every attitude; "
                                "a scale that all axes share turns no heading, so k is 0. Figures are degrees: soft iron times 57.3, P, "
                                "Q and R over H. A to E are level where the last update was.");
    for (const Message& direction : result.nullDirections)
        sheet.text << printable(direction);
    sheet.text << warnings;
    sheet.pictures.push_back(pictureOfHeight(105, convergence(result)));
    sheet.table = {Words::tr("Coefficients"),
        {{Words::tr("Coefficient"), {}, {}, 50, TableColumn::Align::Left},
            {Words::tr("Value"), Words::tr("east +"), QStringLiteral("°"), 30}, {Words::tr("Standard error"), {}, QStringLiteral("°"), 30}},
        {}};
    for (std::size_t i = 0; i < result.names.size(); ++i)
        sheet.table.rows.push_back(
            {{printable(result.names[i]), signedFigure(result.state_deg[i], 2), figure(result.standardError_deg[i], 2)}});
    if (result.whole)
        for (std::size_t c = 0; c < result.whole->level_deg.size(); ++c)
            sheet.table.rows.push_back({{QString(QLatin1Char("ABCDE"[c])), signedFigure(result.whole->level_deg[c], 2),
                figure(result.whole->levelError_deg[c], 2)}});
    return sheet;
}

} // namespace lubberline::ui
