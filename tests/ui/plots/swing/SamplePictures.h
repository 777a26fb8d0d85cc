#pragma once
/// Pictures of swings for the tests of the plots, made by the core like any other.

#include <QtTest>

#include <cmath>
#include <memory>
#include <vector>

#include "ui/plots/swing/SwingPicture.h"

namespace lubberline::ui {

inline ApproximateSmith sampleSmith() { return {toRadians(0.6), toRadians(2.9), toRadians(-1.8), toRadians(0.8), toRadians(-0.3)}; }

/// N readings on equally spaced magnetic headings, exactly on the approximate formula but for `errors_deg` (repeated).
inline SwingPicture samplePicture(
    int readings, const ApproximateSmith& smith = sampleSmith(), const std::vector<double>& errors_deg = {0.2, -0.1, -0.2, 0.15, -0.05})
{
    SwingPicture picture;
    std::vector<Observation> observations;
    for (int row = 0; row < readings; ++row) {
        PlottedReading reading;
        reading.row = row;
        reading.magnetic = MagneticHeading::fromDegrees(row * 360.0 / readings);
        const double error_deg = errors_deg[static_cast<std::size_t>(row) % errors_deg.size()];
        const CompassHeading withoutError = compassHeadingFor(smith, reading.magnetic).value();
        reading.compass = CompassHeading::fromDegrees(withoutError.degrees() - error_deg);
        reading.deviation = deviationOf(reading.magnetic, reading.compass);
        observations.push_back({reading.magnetic, reading.compass});
        picture.readings.push_back(reading);
    }
    const auto analysis = analyse(observations);
    if (analysis)
        picture.analysis = std::make_shared<Analysis>(*analysis);
    else
        picture.whyNoAnalysis = QString::fromStdString(analysis.error().message.english());
    return picture;
}

/// The pixels that are not the colour of the corner.
inline int inkOf(const QImage& image)
{
    int ink = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x)
            ink += image.pixel(x, y) != image.pixel(0, 0);
    }
    return ink;
}

inline QPalette darkPalette()
{
    QPalette dark;
    dark.setColor(QPalette::Base, QColor(0x23, 0x26, 0x29));
    dark.setColor(QPalette::Window, QColor(0x2b, 0x2e, 0x32));
    dark.setColor(QPalette::Text, QColor(0xee, 0xee, 0xee));
    dark.setColor(QPalette::WindowText, QColor(0xee, 0xee, 0xee));
    return dark;
}

} // namespace lubberline::ui
