#include "ui/report/forms/SensorTestSheets.h"

#include "core/angle/Angle.h"
#include "ui/plots/calibration/SensorTestDrawing.h"
#include "ui/report/page/Figures.h"
#include "ui/report/page/Words.h"

namespace lubberline::ui {

namespace {

ReferenceSheet::Picture drawnPicture(double height_mm, const DrawnPicture& drawn)
{
    return {height_mm, [drawn](QPainter& painter, const QRectF& rect) { renderDrawn(painter, rect, drawn); }};
}

QString unitOf(const SensorLog& log) { return QString::fromStdString(std::string(log.figureUnit())); }

QStringList printableLines(const std::vector<Message>& messages)
{
    QStringList lines;
    for (const Message& message : messages)
        lines += printable(message);
    return lines;
}

} // namespace

Table linesTable(const LogSpectrum& spectrum, const QString& unit)
{
    Table table{Words::tr("Lines"),
        {{Words::tr("Frequency"), {}, QStringLiteral("Hz"), 28}, {Words::tr("Amplitude"), {}, unit, 28},
            {Words::tr("Source"), {}, {}, 70, TableColumn::Align::Left}, {Words::tr("Folded from"), {}, QStringLiteral("Hz"), 28}},
        {}};
    for (const SpectralLine& line : spectrum.lines)
        table.rows.push_back(
            {{figure(line.frequency_hz, 2), figure(line.amplitude, 1), printable(line.source), figure(line.aliasOf_hz, 0)}});
    return table;
}

QString filterWords(const LogSpectrum& spectrum, const QString& unit)
{
    if (!spectrum.filter)
        return {};
    QStringList notches;
    for (const double notch : spectrum.filter->notches_hz)
        notches += figure(notch, 1);
    return Words::tr("Filter of %1 ms: notches %2 Hz, low-pass %3 Hz; above %4 Hz it leaves %5 of %6 %7 rms.")
        .arg(figure(spectrum.filter->delay_ms, 2), notches.isEmpty() ? dash() : notches.join(QStringLiteral(", ")),
            figure(spectrum.filter->lowPass_hz, 1), figure(spectrum.filter->from_hz, 1), figure(spectrum.filter->left_rms, 2),
            figure(spectrum.filter->before_rms, 2), unit);
}

ReferenceSheet spectrumSheet(const LogSpectrum& spectrum, const SensorLog& log, const QString& source)
{
    const QString unit = unitOf(log);
    ReferenceSheet sheet;
    sheet.title = Words::tr("Spectrum of a sensor's log");
    sheet.subject = source;
    sheet.text << Words::tr(
        "Column %1 at %2 samples a second; Welch, %3 segments of %4 samples, periodic Hann window, half overlap, mean of each taken out; one-sided. "
        "A line stands above its neighbours' middle by more than chance does once in a thousand spectra.")
                      .arg(printable(spectrum.column), figure(spectrum.rate_hz, 2))
                      .arg(spectrum.segments)
                      .arg(spectrum.segment)
               << filterWords(spectrum, unit) << printableLines(spectrum.warnings);
    sheet.pictures.push_back(drawnPicture(85, spectrumDrawing(spectrum, unit)));
    if (const auto spectrogram = spectrogramOf(log, spectrum.column, spectrum.segment); spectrogram && spectrogram->density.size() > 1)
        sheet.pictures.push_back(drawnPicture(70, spectrogramDrawing(*spectrogram, unit)));
    sheet.table = linesTable(spectrum, unit);
    return sheet;
}

Table coilTable(const CoilResult& result)
{
    Table table{Words::tr("Measured against applied"),
        {{Words::tr("Quantity"), {}, {}, 76, TableColumn::Align::Left}, {QStringLiteral("x"), {}, {}, 30},
            {QStringLiteral("y"), {}, {}, 30}, {QStringLiteral("z"), {}, {}, 30}},
        {}};
    const auto add = [&table](const QString& what, const Eigen::Vector3d& values, int decimals) {
        table.rows.push_back({{what, figure(values.x(), decimals), figure(values.y(), decimals), figure(values.z(), decimals)}});
    };
    add(Words::tr("scale, measured per applied"), result.scale, 6);
    add(Words::tr("its standard error"), result.scaleError, 6);
    add(result.biasAt_c ? Words::tr("bias at %1 °C (nT)").arg(figure(*result.biasAt_c, 1)) : Words::tr("bias (nT)"), result.bias_nT, 1);
    add(Words::tr("its standard error (nT)"), result.biasError_nT, 1);
    if (result.temperature_nT_per_c)
        add(Words::tr("per degree of temperature (nT/°C)"), *result.temperature_nT_per_c, 2);
    if (result.hysteresis_nT)
        add(Words::tr("hysteresis, on the way up − down (nT)"), *result.hysteresis_nT, 1);
    add(Words::tr("nonlinearity, largest (nT)"), result.nonlinearity_nT, 1);
    add(Words::tr("noise, rms (nT)"), result.noise_nT, 1);
    return table;
}

QString coilAngles(const CoilResult& result)
{
    return Words::tr("Not at right angles: x and y by %1°, x and z by %2°, y and z by %3°. Mount: roll %4°, pitch %5°, yaw %6°.")
        .arg(signedFigure(result.nonOrthogonality_deg.x(), 3), signedFigure(result.nonOrthogonality_deg.y(), 3),
            signedFigure(result.nonOrthogonality_deg.z(), 3), signedFigure(toDegrees(result.misalignment.roll_rad), 3),
            signedFigure(toDegrees(result.misalignment.pitch_rad), 3), signedFigure(toDegrees(result.misalignment.yaw_rad), 3));
}

Table benchesTable(const std::vector<CoilBench>& benches)
{
    const QString bias = Words::tr("Bias"), unit = QStringLiteral("nT");
    Table table{Words::tr("Kept benches"),
        {{Words::tr("Date"), {}, {}, 24, TableColumn::Align::Left}, {Words::tr("Serial number"), {}, {}, 28, TableColumn::Align::Left},
            {Words::tr("Range"), {}, unit, 22}, {bias, QStringLiteral("x"), unit, 20}, {bias, QStringLiteral("y"), unit, 20},
            {bias, QStringLiteral("z"), unit, 20}, {Words::tr("Noise, largest"), {}, unit, 22},
            {Words::tr("Log"), {}, {}, 30, TableColumn::Align::Left}, {Words::tr("Note"), {}, {}, 30, TableColumn::Align::Left}},
        {}};
    for (const CoilBench& bench : benches) {
        const auto result = coilBench(logOf(bench));
        const auto shown = [&result](auto of, int decimals) { return result ? figure(of(*result), decimals) : dash(); };
        QStringList cells{
            printable(bench.date.text()), printable(bench.serialNumber), shown([](const CoilResult& one) { return one.range_nT; }, 0)};
        for (Eigen::Index axis = 0; axis < 3; ++axis)
            cells += shown([axis](const CoilResult& one) { return one.bias_nT[axis]; }, 1);
        cells << shown([](const CoilResult& one) { return one.noise_nT.maxCoeff(); }, 1) << printable(bench.log) << printable(bench.note);
        table.rows.push_back({cells});
    }
    return table;
}

QStringList driftWords(const CoilBench& earlier, const CoilBench& later)
{
    const QString from = printable(earlier.date.text()), to = printable(later.date.text());
    const auto drift = driftBetween(earlier, later);
    if (!drift)
        return {Words::tr("The benches of %1 and %2 %3.").arg(from, to, printable(drift.error().message))};
    const auto three = [](const Eigen::Vector3d& values, const Eigen::Vector3d& halves, double unit, int decimals) {
        QStringList parts;
        for (Eigen::Index axis = 0; axis < 3; ++axis)
            parts += QStringLiteral("%1 ± %2").arg(signedFigure(values[axis] * unit, decimals), figure(halves[axis] * unit, decimals));
        return parts.join(QStringLiteral(", "));
    };
    QStringList lines{
        Words::tr("From %1 to %2 on x, y, z (95 %): bias %3 nT a year; scale %4 millionths a year; noise %5 times what it was.")
            .arg(from, to, three(drift->bias_nT_per_year, drift->biasInterval_nT_per_year, 1, 1),
                three(drift->scale_per_year, drift->scaleInterval_per_year, 1e6, 0),
                QStringLiteral("%1, %2, %3")
                    .arg(figure(drift->noiseRatio.x(), 2), figure(drift->noiseRatio.y(), 2), figure(drift->noiseRatio.z(), 2)))};
    if (drift->at_c)
        lines += Words::tr("Both biases are taken at %1 °C.").arg(figure(*drift->at_c, 1));
    return lines + printableLines(drift->doubts);
}

ReferenceSheet coilSheet(const CoilResult& result, const QString& source, const QStringList& history)
{
    ReferenceSheet sheet;
    sheet.title = Words::tr("Sensor on the coil bench");
    sheet.subject = source;
    sheet.text << Words::tr(
        "%1 samples, %2 used. measured = scale (axes) applied + bias + temperature + hysteresis + nonlinearity; scale is measured per applied.")
                      .arg(result.samples)
                      .arg(result.used)
               << coilAngles(result) << history << printableLines(result.warnings);
    sheet.table = coilTable(result);
    sheet.signatures = true;
    return sheet;
}

Table actionsTable(const InterferenceResult& result)
{
    const QString unit = QStringLiteral("nT"), seconds = QStringLiteral("s");
    Table table{Words::tr("Actions"),
        {{Words::tr("Action"), {}, {}, 52, TableColumn::Align::Left}, {Words::tr("From"), {}, seconds, 16},
            {Words::tr("Worst"), QStringLiteral("x"), unit, 17}, {Words::tr("Worst"), QStringLiteral("y"), unit, 17},
            {Words::tr("Worst"), QStringLiteral("z"), unit, 17}, {Words::tr("at"), QStringLiteral("x"), seconds, 15},
            {Words::tr("at"), QStringLiteral("y"), seconds, 15}, {Words::tr("at"), QStringLiteral("z"), seconds, 15},
            {Words::tr("Passes"), {}, {}, 14, TableColumn::Align::Left}},
        {}};
    for (const ActionOutcome& action : result.actions)
        table.rows.push_back(
            {{printable(action.action), figure(action.from_s, 1), signedFigure(action.worst_nT.x(), 0),
                 signedFigure(action.worst_nT.y(), 0), signedFigure(action.worst_nT.z(), 0), figure(action.worstAt_s.x(), 1),
                 figure(action.worstAt_s.y(), 1), figure(action.worstAt_s.z(), 1), action.passes ? Words::tr("yes") : Words::tr("NO")},
                action.passes ? TableRow::Look::Plain : TableRow::Look::Marked});
    return table;
}

ReferenceSheet interferenceSheet(const InterferenceResult& result, const SensorLog& log, const QString& source)
{
    ReferenceSheet sheet;
    sheet.title = Words::tr("Interference test of a sensor");
    sheet.subject = source;
    sheet.text << (result.passes ? Words::tr("Passes: no action changes the field by more than the limits.")
                                 : Words::tr("Does not pass: an action changes the field by more than the limits."))
               << Words::tr("Limits %1, %2 and %3 nT on x, y and z; noise before the first action %4, %5, %6 nT.")
                      .arg(figure(result.limits_nT.x(), 0), figure(result.limits_nT.y(), 0), figure(result.limits_nT.z(), 0),
                          figure(result.noise_nT.x(), 1), figure(result.noise_nT.y(), 1), figure(result.noise_nT.z(), 1));
    for (const Circuit& circuit : result.circuits)
        sheet.text << Words::tr("%1: %2, %3, %4 nT per ampere.")
                          .arg(printable(circuit.name), signedFigure(circuit.field_nT_per_A.x(), 2),
                              signedFigure(circuit.field_nT_per_A.y(), 2), signedFigure(circuit.field_nT_per_A.z(), 2));
    sheet.text << printableLines(result.warnings);
    sheet.pictures.push_back(drawnPicture(80, interferenceDrawing(log, result)));
    sheet.table = actionsTable(result);
    sheet.signatures = true;
    return sheet;
}

} // namespace lubberline::ui
