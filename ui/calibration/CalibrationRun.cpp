#include "ui/calibration/CalibrationRun.h"

#include <QCoreApplication>
#include <QStringList>

#include "core/angle/Angle.h"
#include "ui/kit/Words.h"

namespace lubberline::ui {

namespace {

/// Whose words they are, for translators.
struct CalibrationWords {
    Q_DECLARE_TR_FUNCTIONS(CalibrationWords)
};

EllipsoidShape shapeOf(CalibrationMethod method)
{
    return method == CalibrationMethod::Sphere ? EllipsoidShape::Sphere
        : method == CalibrationMethod::Axes    ? EllipsoidShape::Axes
                                               : EllipsoidShape::General;
}

void addList(QString& html, const QString& title, const std::vector<Message>& messages)
{
    if (messages.empty())
        return;
    html += QStringLiteral("<p style='margin-bottom:2px'><b>%1</b></p><ul style='margin-top:0'>").arg(title);
    for (const auto& message : messages)
        html += QStringLiteral("<li>%1</li>").arg(toText(message).toHtmlEscaped());
    html += QStringLiteral("</ul>");
}

void addParameters(QString& html, const std::vector<FittedParameter>& parameters)
{
    html += QStringLiteral("<table cellspacing='4'>");
    for (const auto& parameter : parameters) {
        const bool ratio = parameter.unit == "1";
        const int decimals = ratio ? 5 : 1;
        html += QStringLiteral("<tr><td>%1</td><td align='right'>%2</td><td>± %3</td><td>%4</td></tr>")
                    .arg(toText(parameter.name).toHtmlEscaped(),
                        parameter.value ? signedNumber(*parameter.value, decimals) : CalibrationWords::tr("not told"),
                        parameter.standard_error ? plainNumber(*parameter.standard_error, decimals) : QStringLiteral("–"),
                        ratio ? QString() : toText(parameter.unit));
    }
    html += QStringLiteral("</table>");
}

/// In files it is uT, which any keyboard types.
QString unitShown(FieldUnit unit)
{
    return unit == FieldUnit::Microtesla ? QStringLiteral("µT") : QString::fromStdString(std::string(nameOf(unit)));
}

QString verdictLine(CalibrationVerdict verdict)
{
    switch (verdict) {
    case CalibrationVerdict::Good: return CalibrationWords::tr("● Good: the calibration can be used.");
    case CalibrationVerdict::Doubtful: return CalibrationWords::tr("▲ Doubtful: see why, and what to do for better.");
    case CalibrationVerdict::NotDetermined: break;
    }
    return CalibrationWords::tr("■ Not determined: this log does not tell the calibration.");
}

} // namespace

Result<CalibrationRun> runCalibration(const CalibrationWish& wish, const Progress& progress)
{
    CalibrationRun run;
    run.log = wish.read;
    if (!run.log) {
        auto log = readSensorLogFile(wish.path, wish.reading, progress);
        if (!log)
            return log.error();
        run.log = std::make_shared<const SensorLog>(std::move(log.value()));
    }
    run.part = wish.part ? std::make_shared<const SensorLog>(partOf(*run.log, wish.part->first, wish.part->second)) : run.log;
    std::optional<MeridianField> meridian;
    if (wish.field_nT && wish.dip_deg)
        meridian = MeridianField{*wish.field_nT * std::cos(toRadians(*wish.dip_deg)), *wish.field_nT * std::sin(toRadians(*wish.dip_deg))};
    if (wish.method == CalibrationMethod::Attitude) {
        if (!meridian)
            return Error{ErrorCode::InvalidInput, MARKED("ui", "against attitude the Earth's field and its dip must be known: enter both")};
        auto fit = fitAttitude(*run.part, {*meridian, wish.attitudeError_deg, {}});
        if (!fit)
            return Error{fit.error().code, fit.error().message, wish.path};
        run.attitude = std::move(fit.value());
        if (run.attitude->verdict != CalibrationVerdict::NotDetermined)
            run.model = run.attitude->model;
        run.uncertainty = run.attitude->uncertainty;
        run.field_nT = *wish.field_nT;
    } else {
        run.ellipsoid = fitEllipsoid(*run.part, shapeOf(wish.method), wish.field_nT);
        if (run.ellipsoid->fit && run.ellipsoid->verdict != CalibrationVerdict::NotDetermined) {
            run.model = SensorModel();
            run.model->softIron = run.ellipsoid->fit->softIron;
            run.model->hardIron_nT = run.ellipsoid->fit->hardIron;
            run.field_nT = run.ellipsoid->fit->field;
            run.uncertainty = run.ellipsoid->fit->uncertainty;
        }
    }
    if (run.model) {
        CompensationOptions options;
        options.field = meridian;
        options.uncertainty = run.uncertainty;
        if (auto compensated = compensate(*run.part, *run.model, options))
            run.compensated = std::move(compensated.value());
    }
    return run;
}

QString wordsOf(const CalibrationRun& run)
{
    QString html = QStringLiteral("<p style='font-size:large'><b>%1</b></p>").arg(verdictLine(run.verdict()));
    const auto& reasons = run.ellipsoid ? run.ellipsoid->reasons : run.attitude->reasons;
    const auto& next = run.ellipsoid ? run.ellipsoid->nextSteps : run.attitude->nextSteps;
    addList(html, CalibrationWords::tr("Why"), reasons);
    if (next.empty() && run.verdict() == CalibrationVerdict::Good)
        addList(html, CalibrationWords::tr("What to do next"),
            {MARKED("ui", "save the model, or store it with the compass: it takes these errors out of what the sensor measures")});
    else
        addList(html, CalibrationWords::tr("What to do next"), next);
    const std::size_t samples = run.part->size(), used = run.ellipsoid ? run.ellipsoid->used : run.attitude->used;
    html += CalibrationWords::tr("<p>%1 samples, %2 used; unit %3 (%4).</p>")
                .arg(samples)
                .arg(used)
                .arg(unitShown(run.part->unit), toText(run.part->unitReason).toHtmlEscaped());
    if (run.compensated && run.compensated->before && run.compensated->after)
        html += CalibrationWords::tr("<p>Heading error (rms, largest): before %1°, %2°; after <b>%3°, %4°</b>.</p>")
                    .arg(plainNumber(run.compensated->before->rms_deg, 2), plainNumber(run.compensated->before->max_deg, 2),
                        plainNumber(run.compensated->after->rms_deg, 2), plainNumber(run.compensated->after->max_deg, 2));
    if (run.compensated)
        html += CalibrationWords::tr("<p>The field's size spreads by %1 before and <b>%2</b> after (%3).</p>")
                    .arg(plainNumber(run.compensated->spreadBefore, 0), plainNumber(run.compensated->spreadAfter, 0),
                        QString::fromStdString(std::string(run.part->figureUnit())));
    if (run.model) {
        html += CalibrationWords::tr(
            "<p>P, Q, R: the field of what is magnetic near the sensor (hard iron). a to k: how much the iron and the "
            "sensor's axes bend the Earth's field, 0.01 is 1 % (soft iron). F: the Earth's field.</p>");
        addParameters(html, run.ellipsoid ? run.ellipsoid->fit->parameters : run.attitude->parameters);
    }
    if (run.attitude)
        addList(html, CalibrationWords::tr("What this log cannot tell"), run.attitude->notSeparable);
    std::vector<Message> warnings = run.part->warnings;
    const auto& more = run.ellipsoid ? run.ellipsoid->warnings : run.attitude->warnings;
    warnings.insert(warnings.end(), more.begin(), more.end());
    addList(html, CalibrationWords::tr("To note"), warnings);
    return html;
}

} // namespace lubberline::ui
