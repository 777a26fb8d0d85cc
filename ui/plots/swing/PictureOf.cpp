#include "ui/plots/swing/PictureOf.h"

#include <QStringList>

#include "core/base/Contract.h"
#include "core/swing/Observations.h"

namespace lubberline::ui {

namespace {

QString titleOf(const SwingRecord& record)
{
    QStringList parts;
    for (const std::string& part : {record.aircraft.registration, record.compass.name, record.swing.date.text()})
        if (!part.empty())
            parts += QString::fromStdString(part);
    return parts.join(QStringLiteral(" · "));
}

PlottedReading plotted(int row, const Swing& swing, const Reading& reading)
{
    const Observation seen = observationOf(swing, reading);
    PlottedReading plotted;
    plotted.row = row;
    plotted.magnetic = seen.magnetic;
    plotted.compass = seen.compass;
    plotted.deviation = deviationOf(seen.magnetic, seen.compass);
    plotted.excluded = reading.exclusion.has_value();
    return plotted;
}

std::vector<PlottedReading> plottedReadings(const Swing& swing, const Analysis* analysis)
{
    std::vector<PlottedReading> all;
    std::size_t used = 0;
    for (std::size_t row = 0; row < swing.readings.size(); ++row) {
        const Reading& reading = swing.readings[row];
        if (!reading.complete())
            continue;
        PlottedReading point = plotted(static_cast<int>(row), swing, reading);
        if (analysis && reading.used()) {
            LUBBERLINE_EXPECT(used < analysis->readings.size(), "the analysis is of this swing's used readings");
            point.suspect = analysis->readings[used].suspect;
            point.studentised = analysis->readings[used].studentised;
            ++used;
        }
        all.push_back(point);
    }
    LUBBERLINE_EXPECT(!analysis || used == analysis->readings.size(), "the analysis is of this swing's used readings");
    return all;
}

} // namespace

SwingPicture pictureOf(const SwingRecord& record, std::shared_ptr<const Analysis> analysis, const QString& whyNoAnalysis,
    std::shared_ptr<const Analysis> previous, const QString& previousLabel, AngleStyle style)
{
    SwingPicture picture;
    picture.title = titleOf(record);
    picture.readings = plottedReadings(record.swing, analysis.get());
    picture.analysis = std::move(analysis);
    picture.whyNoAnalysis = picture.analysis ? QString() : whyNoAnalysis;
    picture.resolution_deg = record.compass.resolution_deg;
    if (record.limits) {
        picture.limit_deg = record.limits->maxDeviation_deg;
        picture.limitDocument = QString::fromStdString(record.limits->document);
    }
    picture.previous = std::move(previous);
    picture.previousLabel = previousLabel;
    picture.angleStyle = style;
    return picture;
}

} // namespace lubberline::ui
