#pragma once
/// Heading error against time with the share of each source stacked, and a loop's gain against frequency: drawn for window and paper.

#include <QString>

#include <memory>
#include <vector>

#include "core/reference/ReferenceRun.h"
#include "ui/plots/drawn/DrawnPicture.h"

class QPainter;
class QRectF;

namespace lubberline::ui {

[[nodiscard]] QString nameOfSource(ErrorSource source);

/// The bands of the stack: every source but slaving; slaving and what the sources do together are one band, since slaving mostly takes away
/// what the others bring.
struct TimePicture {
    std::vector<double> time_s;
    std::vector<double> error_deg, vertical_deg;
    struct Band {
        QString name;
        std::vector<double> share_deg;
    };
    std::vector<Band> bands;
    double at_s = 0; ///< where the film stands
};
/// At most `most` points of the run.
[[nodiscard]] TimePicture pictureOf(const ReferenceRun& run, std::size_t most = 2000);

/// The film moves `at_s` of the picture that it draws.
[[nodiscard]] DrawnPicture timeDrawing(std::shared_ptr<const TimePicture> picture);
/// Gains of levelling and of slaving against frequency, both logarithmic.
[[nodiscard]] DrawnPicture gainDrawing(const Scenario& scenario);
/// Two dials: what is true, and what is read; the tilt of the vertical between them.
void paintDials(
    QPainter& painter, const QRectF& rect, double heading_deg, double error_deg, const AxisTilt& tilt, const PlotColours& colours);

} // namespace lubberline::ui
