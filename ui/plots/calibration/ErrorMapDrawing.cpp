#include "ui/plots/calibration/ErrorMapDrawing.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "core/base/Normal.h"
#include "ui/plots/drawn/DrawnAxes.h"
#include "ui/plots/map/DivergingMap.h"
#include "ui/text/NumberText.h"

namespace lubberline::ui {

namespace {

struct ErrorMapWords {
    Q_DECLARE_TR_FUNCTIONS(lubberline::ui::ErrorMapWords)
};

constexpr double kHatchSpacing = 8;

struct ShownErrors {
    std::vector<ErrorCell> cells;
    double most_deg = 0, mostAfter_deg = 0, lowest_deg = 0, highest_deg = 0;
    bool after = false;
};

/// The upper or the lower of two halves, with room for a title above each.
QRectF halfOf(const QRectF& rect, const QFont& font, bool second, bool both)
{
    const double title = QFontMetricsF(font).height() * 1.3, height = both ? rect.height() / 2 : rect.height();
    return {rect.left(), rect.top() + (second ? height : 0) + title, rect.width(), height - title};
}

DrawnAxes errorAxes(const ShownErrors& shown, const QRectF& rect, const QFont& font)
{
    return {rect, font, {-kCellHeading_deg / 2, 360 - kCellHeading_deg / 2, ErrorMapWords::tr("magnetic heading (°)"), false, false, true},
        {shown.lowest_deg, shown.highest_deg, ErrorMapWords::tr("pitch (°)"), false, true}};
}

/// No samples are no deviation of 0°: hatched, by lines of our own as in the other maps (a brush pattern would be an image on paper).
void paintHatch(QPainter& painter, const QRectF& area, const QColor& colour)
{
    painter.setPen(QPen(colour, 0));
    for (double x = area.left() - area.height(); x < area.right(); x += kHatchSpacing)
        painter.drawLine(QPointF(x, area.bottom()), QPointF(x + area.height(), area.top()));
}

void paintHalf(QPainter& painter, const QRectF& rect, const ShownErrors& shown, const DrawnLook& look, bool after)
{
    const DrawnAxes axes = errorAxes(shown, rect, painter.font());
    axes.paint(painter, look.colours);
    painter.save();
    painter.setClipRect(axes.inside());
    paintHatch(painter, axes.inside(), look.colours.hatch);
    painter.setPen(Qt::NoPen);
    for (const ErrorCell& cell : shown.cells) {
        const std::optional<double> value = after ? cell.after_deg : cell.before_deg;
        if (!value)
            continue;
        painter.setBrush(divergingColour(*value / std::max(shown.most_deg, 1e-9)));
        painter.drawRect(QRectF(axes.at(cell.heading_deg - kCellHeading_deg / 2, cell.pitch_deg + kCellPitch_deg / 2),
            axes.at(cell.heading_deg + kCellHeading_deg / 2, cell.pitch_deg - kCellPitch_deg / 2)));
    }
    painter.restore();
    painter.setPen(look.colours.text);
    const double line = QFontMetricsF(painter.font()).height();
    painter.drawText(QPointF(axes.inside().left(), rect.top() - 0.3 * line),
        after ? ErrorMapWords::tr("after: up to %1°").arg(plainNumber(shown.mostAfter_deg, 2))
              : ErrorMapWords::tr("before: up to %1° (west blue, east red, to this size in both; hatched: no samples)")
                    .arg(plainNumber(shown.most_deg, 2)));
}

QString errorReadOut(const ShownErrors& shown, const QRectF& rect, const QFont& font, const QPointF& at)
{
    for (const bool after : {false, true}) {
        const DrawnAxes axes = errorAxes(shown, halfOf(rect, font, after, shown.after), font);
        if ((after && !shown.after) || !axes.contains(at))
            continue;
        const QPointF value = axes.valueAt(at);
        for (const ErrorCell& cell : shown.cells)
            if (std::abs(cell.heading_deg - value.x()) <= kCellHeading_deg / 2
                && std::abs(cell.pitch_deg - value.y()) <= kCellPitch_deg / 2) {
                QString text
                    = ErrorMapWords::tr("heading %1°, pitch %2°: deviation %3° before")
                          .arg(plainNumber(cell.heading_deg, 0), signedNumber(cell.pitch_deg, 0), signedNumber(cell.before_deg, 2));
                if (cell.after_deg)
                    text += ErrorMapWords::tr(", %1° after").arg(signedNumber(*cell.after_deg, 2));
                if (cell.sigma_deg)
                    text += ErrorMapWords::tr(", sure to %1° (95 %)").arg(plainNumber(kNormal95 * *cell.sigma_deg, 2));
                return text + ErrorMapWords::tr("; %1 samples").arg(cell.samples);
            }
        return ErrorMapWords::tr("heading %1°, pitch %2°: no samples")
            .arg(plainNumber(std::max(std::round(value.x() / kCellHeading_deg), 0.0) * kCellHeading_deg, 0),
                signedNumber(std::round(value.y() / kCellPitch_deg) * kCellPitch_deg, 0)); // of the cell, as the heading
    }
    return {};
}

} // namespace

DrawnPicture errorMapDrawing(std::vector<ErrorCell> map)
{
    DrawnPicture picture;
    if (map.empty()) {
        picture.notice = ErrorMapWords::tr("No headings: nothing is compensated yet.");
        return picture;
    }
    auto shown = std::make_shared<ShownErrors>();
    shown->lowest_deg = shown->highest_deg = map.front().pitch_deg;
    for (const ErrorCell& cell : map) {
        shown->most_deg = std::max(shown->most_deg, std::abs(cell.before_deg));
        shown->after = shown->after || cell.after_deg;
        shown->mostAfter_deg = std::max(shown->mostAfter_deg, std::abs(cell.after_deg.value_or(0.0)));
        shown->lowest_deg = std::min(shown->lowest_deg, cell.pitch_deg);
        shown->highest_deg = std::max(shown->highest_deg, cell.pitch_deg);
    }
    shown->lowest_deg -= kCellPitch_deg / 2;
    shown->highest_deg += kCellPitch_deg / 2;
    shown->cells = std::move(map);
    picture.paint = [shown](QPainter& painter, const QRectF& rect, const DrawnLook& look) {
        paintHalf(painter, halfOf(rect, painter.font(), false, shown->after), *shown, look, false);
        if (shown->after)
            paintHalf(painter, halfOf(rect, painter.font(), true, true), *shown, look, true);
    };
    picture.readOut = [shown](const QRectF& rect, const QFont& font, const QPointF& at) { return errorReadOut(*shown, rect, font, at); };
    picture.legend = [](const PlotColours&) { return std::vector<LegendEntry>(); };
    return picture;
}

} // namespace lubberline::ui
