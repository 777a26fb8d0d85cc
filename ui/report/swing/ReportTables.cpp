/// The tables of a report: every reading, the coefficients by every method, and how well the fits hold.

#include <cmath>

#include "core/base/Contract.h"
#include "ui/report/page/Figures.h"
#include "ui/report/page/Words.h"
#include "ui/report/swing/ReportContent.h"

namespace lubberline::ui {

namespace {

using Align = TableColumn::Align;
using Look = TableRow::Look;

constexpr int kResidualDecimals = 2;
constexpr int kExactDecimals = 4;
constexpr int kLongestRemark = 300; ///< a row must fit a page; the whole text is in the attached record

std::vector<TableColumn> readingColumns(const QString& angleUnit)
{
    return {{Words::tr("No."), {}, {}, 9, Align::Point}, {Words::tr("Nominal"), Words::tr("heading"), angleUnit, 17},
        {Words::tr("Magnetic"), Words::tr("heading"), angleUnit, 18},
        {Words::tr("Compass", "heading"), Words::tr("heading"), angleUnit, 18},
        {Words::tr("Deviation"), Words::tr("east +"), angleUnit, 19},
        {Words::tr("Residual"), Words::tr("approximate"), QStringLiteral("°"), 20},
        {Words::tr("Residual"), Words::tr("exact"), QStringLiteral("°"), 18},
        {Words::tr("t"), Words::tr("studentised"), Words::tr("no unit"), 20}, {Words::tr("Remark"), {}, {}, 41, Align::Left}};
}

QString studentisedFigure(std::optional<double> t)
{
    if (t && std::isfinite(*t) && std::abs(*t) >= 1000)
        return *t > 0 ? QStringLiteral(">999") : QStringLiteral("<−999");
    return signedFigure(t, 1);
}

QString remarkOn(const Reading& reading, const AnalysedReading* analysed)
{
    QStringList remarks;
    if (reading.exclusion)
        remarks += Words::tr("EXCLUDED: %1").arg(printable(reading.exclusion->reason));
    else if (!reading.complete())
        remarks += Words::tr("not complete, not used");
    if (analysed && analysed->suspect)
        remarks += Words::tr("SUSPECT, used");
    remarks += printable(reading.note);
    const QString remark = joined(remarks);
    return remark.size() <= kLongestRemark ? remark : remark.left(kLongestRemark - 1) + QChar(0x2026);
}

TableRow readingRow(std::size_t index, const Reading& reading, const AnalysedReading* analysed, const AngleFigures& figures)
{
    std::optional<double> deviation_deg;
    if (reading.complete())
        deviation_deg = deviationOf(*reading.magnetic, *reading.compass).degrees();
    const auto magnetic_deg = reading.magnetic ? std::optional(reading.magnetic->degrees()) : std::nullopt;
    const auto compass_deg = reading.compass ? std::optional(reading.compass->degrees()) : std::nullopt;
    const auto approximate_deg = analysed ? inDegrees(analysed->residualApproximate_rad) : std::nullopt;
    const auto exact_deg = analysed ? inDegrees(analysed->residualExact_rad) : std::nullopt;
    TableRow row;
    row.cells
        = {QString::number(index + 1), figures.heading(reading.nominal_deg), figures.heading(magnetic_deg), figures.heading(compass_deg),
            figures.angle(deviation_deg), signedFigure(approximate_deg, kResidualDecimals), signedFigure(exact_deg, kResidualDecimals),
            studentisedFigure(analysed ? analysed->studentised : std::nullopt), remarkOn(reading, analysed)};
    row.look = !reading.used() ? Look::Faint : analysed && analysed->suspect ? Look::Marked : Look::Plain;
    return row;
}

QString coefficientName(Coefficient which)
{
    switch (which) {
    case Coefficient::A: return Words::tr("A  constant");
    case Coefficient::B: return Words::tr("B  sin");
    case Coefficient::C: return Words::tr("C  cos");
    case Coefficient::D: return Words::tr("D  sin 2×");
    case Coefficient::E: return Words::tr("E  cos 2×");
    }
    return {};
}

std::array<std::optional<double>, kCoefficientCount> valuesOf(const PointRules& rules)
{
    return {rules.A_rad, rules.B_rad, rules.C_rad, rules.D_rad, rules.E_rad};
}

/// The exact coefficients as angles by [P 5], so that they can be held against the approximate ones.
std::array<std::optional<double>, kCoefficientCount> exactAsAngles(const ExactFit& fit)
{
    std::array<std::optional<double>, kCoefficientCount> angles;
    if (!fit.fitted())
        return angles;
    const auto approximate = toApproximate(fit.smith());
    if (!approximate)
        return angles;
    const std::array values{approximate->A_rad, approximate->B_rad, approximate->C_rad, approximate->D_rad, approximate->E_rad};
    for (std::size_t i = 0; i < kCoefficientCount; ++i)
        if (fit.value[i])
            angles[i] = values[i];
    return angles;
}

std::vector<TableColumn> coefficientColumns(const Analysis& analysis)
{
    const QString degrees = QStringLiteral("°");
    const auto& rules = analysis.pointRules;
    const QString points = rules
        ? Words::tr("%1 points, %2")
              .arg(rules->points)
              .arg(rules->argument == HeadingArgument::Magnetic ? Words::tr("magnetic") : Words::tr("compass", "heading"))
        : Words::tr("none");
    return {{Words::tr("Coefficient"), {}, {}, 22, Align::Left}, {Words::tr("Approximate"), Words::tr("compass heading"), degrees, 26},
        {Words::tr("std. error"), {}, degrees, 18}, {Words::tr("95 % ±"), {}, degrees, 16},
        {Words::tr("Exact"), Words::tr("magnetic heading"), Words::tr("no unit"), 26}, {Words::tr("95 % ±"), {}, Words::tr("no unit"), 18},
        {Words::tr("Exact"), Words::tr("as an angle"), degrees, 24}, {Words::tr("Point rules"), points, degrees, 28}};
}

/// What cannot be solved has a condition number that says no more than that it is huge.
QString conditionFigure(double conditionNumber)
{
    constexpr double kHuge = 1e6;
    return conditionNumber < kHuge ? figure(conditionNumber, 2) : QStringLiteral("> 10⁶");
}

TableRow fitRow(const QString& name, const QString& argument, const SmithFitReport& fit, std::size_t readings)
{
    const auto known = [&fit](double value) { return fit.fitted() ? std::optional(value) : std::nullopt; };
    TableRow row;
    row.cells = {name, argument, QString::number(readings), QString::number(fit.parameters), QString::number(fit.degreesOfFreedom),
        figure(inDegrees(known(fit.rms_rad)), 3), figure(inDegrees(known(fit.maxAbsResidual_rad)), 2), figure(inDegrees(fit.sigma_rad), 3),
        conditionFigure(fit.conditionNumber)};
    return row;
}

} // namespace

Table readingsTable(const ReportInput& input)
{
    const AngleFigures figures(input.angleStyle, input.record.swing);
    Table table{Words::tr("Readings"), readingColumns(figures.unit()), {}};
    std::size_t used = 0;
    for (std::size_t i = 0; i < input.record.swing.readings.size(); ++i) {
        const Reading& reading = input.record.swing.readings[i];
        const AnalysedReading* analysed = nullptr;
        if (reading.used()) {
            LUBBERLINE_EXPECT(used < input.analysis.readings.size(), "the analysis is of this swing's used readings");
            analysed = &input.analysis.readings[used++];
        }
        table.rows.push_back(readingRow(i, reading, analysed, figures));
    }
    return table;
}

Table coefficientsTable(const Analysis& analysis)
{
    Table table{Words::tr("Coefficients"), coefficientColumns(analysis), {}};
    std::array<std::optional<double>, kCoefficientCount> rules;
    if (analysis.pointRules)
        rules = valuesOf(*analysis.pointRules);
    const auto angles = exactAsAngles(analysis.exact);
    for (const Coefficient c : kCoefficients) {
        const std::size_t i = indexOf(c);
        TableRow row;
        row.cells = {coefficientName(c), signedFigure(inDegrees(analysis.approximate.value[i]), 2),
            figure(inDegrees(analysis.approximate.standardError[i]), 2), figure(inDegrees(analysis.approximate.interval95(c)), 2),
            signedFigure(analysis.exact.value[i], kExactDecimals), figure(analysis.exact.interval95(c), kExactDecimals),
            signedFigure(inDegrees(angles[i]), 2), signedFigure(inDegrees(rules[i]), 2)};
        table.rows.push_back(row);
    }
    return table;
}

Table fitsTable(const Analysis& analysis)
{
    const QString degrees = QStringLiteral("°");
    const std::size_t readings = analysis.readings.size();
    Table table{Words::tr("Quality of the fits"), {}, {}};
    table.columns = {{Words::tr("Fit"), {}, {}, 28, Align::Left}, {Words::tr("Argument"), {}, {}, 30, Align::Left},
        {Words::tr("Readings"), {}, {}, 16}, {Words::tr("Fitted"), Words::tr("coefficients"), {}, 20},
        {Words::tr("Degrees of"), Words::tr("freedom"), {}, 19}, {Words::tr("rms"), Words::tr("residual"), degrees, 16},
        {Words::tr("Largest"), Words::tr("residual"), degrees, 16}, {Words::tr("Sigma of a"), Words::tr("reading"), degrees, 17},
        {Words::tr("Condition"), Words::tr("number"), {}, 18}};
    table.rows = {fitRow(Words::tr("Approximate"), Words::tr("compass heading"), analysis.approximate, readings),
        fitRow(Words::tr("Exact"), Words::tr("magnetic heading"), analysis.exact, readings)};
    return table;
}

} // namespace lubberline::ui
