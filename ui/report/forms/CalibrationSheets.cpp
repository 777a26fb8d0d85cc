#include "ui/report/forms/CalibrationSheets.h"

#include <algorithm>

#include "core/base/Normal.h"
#include "ui/plots/calibration/ErrorMapDrawing.h"
#include "ui/report/page/Figures.h"
#include "ui/report/page/Words.h"

namespace lubberline::ui {

namespace {

QString unitWords(const SensorLog& log) { return QString::fromStdString(std::string(log.figureUnit())); }

void addAll(QStringList& text, const QString& before, const std::vector<Message>& messages)
{
    for (const Message& message : messages)
        text += before + printable(message);
}

QString verdictWords(CalibrationVerdict verdict)
{
    switch (verdict) {
    case CalibrationVerdict::Good: return Words::tr("Good: the calibration can be used.");
    case CalibrationVerdict::Doubtful: return Words::tr("Doubtful.");
    case CalibrationVerdict::NotDetermined: break;
    }
    return Words::tr("Not determined: this log does not tell the calibration.");
}

Table parameterTable(const std::vector<FittedParameter>& parameters)
{
    Table table{Words::tr("Parameters"),
        {{Words::tr("Parameter"), {}, {}, 60, TableColumn::Align::Left}, {Words::tr("Value"), {}, {}, 34},
            {Words::tr("Standard error"), {}, {}, 34}, {Words::tr("Unit"), {}, {}, 24, TableColumn::Align::Left}},
        {}};
    for (const FittedParameter& parameter : parameters) {
        const bool ratio = parameter.unit == "1";
        const int decimals = ratio ? 5 : 1;
        table.rows.push_back({{printable(parameter.name), signedFigure(parameter.value, decimals),
            figure(parameter.standard_error, decimals), ratio ? QString() : printable(parameter.unit)}});
    }
    return table;
}

Table errorTable(const CompensatedLog& compensated)
{
    const QString degrees = QStringLiteral("°");
    Table table{Words::tr("Heading error, read − magnetic"),
        {{QString(), {}, {}, 40, TableColumn::Align::Left}, {Words::tr("Mean"), {}, degrees, 28}, {Words::tr("rms"), {}, degrees, 28},
            {QStringLiteral("95 %"), {}, degrees, 28}, {Words::tr("Largest"), {}, degrees, 28}},
        {}};
    const auto add = [&table](const QString& when, const std::optional<HeadingErrors>& errors) {
        if (errors)
            table.rows.push_back({{when, signedFigure(errors->mean_deg, 2), figure(errors->rms_deg, 2), figure(errors->p95_deg, 2),
                figure(errors->max_deg, 2)}});
    };
    add(Words::tr("before"), compensated.before);
    add(Words::tr("after"), compensated.after);
    return table;
}

void addCompensation(ReferenceSheet& sheet, const CompensatedLog& compensated, const SensorLog& log)
{
    sheet.text << Words::tr("The field's size spreads by %1 before and %2 after compensation (%3).")
                      .arg(figure(compensated.spreadBefore, 0), figure(compensated.spreadAfter, 0), unitWords(log));
    if (compensated.before && compensated.after)
        sheet.text << Words::tr("Heading error, rms and largest: %1° and %2° before, %3° and %4° after.")
                          .arg(figure(compensated.before->rms_deg, 2), figure(compensated.before->max_deg, 2),
                              figure(compensated.after->rms_deg, 2), figure(compensated.after->max_deg, 2));
    std::optional<double> sigma_deg;
    for (const ErrorCell& cell : compensated.map)
        if (cell.sigma_deg)
            sigma_deg = std::max(sigma_deg.value_or(0.0), *cell.sigma_deg);
    if (sigma_deg)
        sheet.text << Words::tr(
            "By the uncertainty of the calibration a compensated heading is sure to %1° (95 %) or better in the cells below.")
                          .arg(figure(kNormal95 * *sigma_deg, 2));
    if (!compensated.map.empty())
        sheet.pictures.push_back({compensated.after ? 110.0 : 65.0,
            [picture = errorMapDrawing(compensated.map)](QPainter& painter, const QRectF& rect) { renderDrawn(painter, rect, picture); }});
}

} // namespace

CalibrationOutcome outcomeOf(const EllipsoidResult& result)
{
    const bool told = result.fit && result.verdict != CalibrationVerdict::NotDetermined;
    return {Words::tr("by the field's size"), result.verdict, result.samples, result.used, result.reasons, result.nextSteps, {},
        result.warnings, told ? result.fit->parameters : std::vector<FittedParameter>()};
}

CalibrationOutcome outcomeOf(const AttitudeResult& result)
{
    return {Words::tr("against heading, pitch and roll"), result.verdict, result.samples, result.used, result.reasons, result.nextSteps,
        result.notSeparable, result.warnings,
        result.verdict == CalibrationVerdict::NotDetermined ? std::vector<FittedParameter>() : result.parameters};
}

ReferenceSheet calibrationSheet(
    const CalibrationOutcome& outcome, const SensorLog& log, const CompensatedLog* compensated, const QString& source)
{
    ReferenceSheet sheet;
    sheet.title = Words::tr("Calibration of a magnetometer");
    sheet.subject = source;
    sheet.text << verdictWords(outcome.verdict);
    addAll(sheet.text, Words::tr("Because: "), outcome.reasons);
    addAll(sheet.text, Words::tr("Next: "), outcome.nextSteps);
    sheet.text << Words::tr("%1 samples, %2 used, %3; figures in %4 (%5).")
                      .arg(outcome.samples)
                      .arg(outcome.used)
                      .arg(outcome.method, unitWords(log), printable(log.unitReason));
    if (compensated)
        addCompensation(sheet, *compensated, log);
    addAll(sheet.text, Words::tr("Not told: "), outcome.notSeparable);
    addAll(sheet.text, {}, log.warnings);
    addAll(sheet.text, {}, outcome.warnings);
    sheet.table = parameterTable(outcome.parameters);
    sheet.signatures = true;
    return sheet;
}

ReferenceSheet compensationSheet(const CompensatedLog& compensated, const SensorLog& log, const QString& source)
{
    ReferenceSheet sheet;
    sheet.title = Words::tr("Log of a magnetometer, compensated");
    sheet.subject = source;
    addCompensation(sheet, compensated, log);
    for (const Demand& demand : compensated.demands)
        sheet.text << Words::tr("A helmet system asks: %1 %2 %3 %4: %5.")
                          .arg(printable(demand.name), demand.atLeast ? QStringLiteral("≥") : QStringLiteral("≤"), figure(demand.limit, 1),
                              printable(demand.unit),
                              !demand.value       ? Words::tr("not known")
                                  : *demand.met() ? Words::tr("%1, met").arg(figure(*demand.value, 2))
                                                  : Words::tr("%1, NOT MET").arg(figure(*demand.value, 2)));
    addAll(sheet.text, {}, log.warnings);
    addAll(sheet.text, {}, compensated.warnings);
    sheet.table = errorTable(compensated);
    return sheet;
}

} // namespace lubberline::ui
