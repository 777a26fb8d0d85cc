#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainter>
#include <QPolygonF>

#include <algorithm>
#include <cmath>

#include "ui/plots/base/NiceScale.h"
#include "ui/plots/fleet/FleetAxes.h"
#include "ui/text/AngleWords.h"

namespace lubberline::ui {

namespace {

struct DistributionTexts {
    Q_DECLARE_TR_FUNCTIONS(lubberline::ui::DistributionDrawing)
};

constexpr std::size_t kNamedOutliers = 3;
constexpr int kMostBins = 40;

struct Bins {
    double from = 0, step = 1;
    std::vector<int> count;
    [[nodiscard]] double to() const { return from + step * static_cast<double>(count.size()); }
    [[nodiscard]] int largest() const { return count.empty() ? 0 : *std::ranges::max_element(count); }
};

/// As wide as Freedman and Diaconis (1981) have them, 2 IQR n^(−1/3), to a round figure.
Bins binsOf(const std::vector<double>& sorted)
{
    Bins bins;
    if (sorted.empty())
        return bins;
    const auto at = [&](double share) { return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))]; };
    const double range = sorted.back() - sorted.front();
    const double wanted = 2 * (at(0.75) - at(0.25)) / std::cbrt(static_cast<double>(sorted.size()));
    bins.step = niceStep(std::max({wanted, range / kMostBins, 0.02}));
    bins.from = std::floor(sorted.front() / bins.step) * bins.step;
    bins.count.resize(static_cast<std::size_t>(std::floor((sorted.back() - bins.from) / bins.step)) + 1);
    for (const double value : sorted)
        ++bins.count[std::min(bins.count.size() - 1, static_cast<std::size_t>((value - bins.from) / bins.step))];
    return bins;
}

/// Figures below the frame, so many that they do not touch.
void paintXTicks(QPainter& painter, const FleetAxes& axes, const FleetLook& look)
{
    const double line = lineHeight(look);
    double step = niceStep((axes.xTo - axes.xFrom) / 4);
    const double wide = QFontMetricsF(look.font).horizontalAdvance(QStringLiteral("+88.8°"));
    while ((axes.xTo - axes.xFrom) / step * 1.3 * wide > axes.room.width() && step < axes.xTo - axes.xFrom)
        step = niceStep(1.5 * step);
    painter.setPen(look.colours.text);
    for (double x = std::ceil(axes.xFrom / step) * step; x <= axes.xTo + 1e-9; x += step)
        painter.drawText(QRectF(axes.at(x, 0).x() - 4 * line, axes.room.bottom() + 0.2 * line, 8 * line, 1.2 * line),
            Qt::AlignHCenter | Qt::AlignTop, degreeTick(x, step));
}

void paintFrame(QPainter& painter, const FleetAxes& axes, const FleetLook& look)
{
    painter.setBrush(Qt::NoBrush);
    painter.setPen(penOf(look.colours.axis, look));
    painter.drawRect(axes.room);
}

void paintCounts(QPainter& painter, const FleetAxes& axes, const FleetLook& look)
{
    const double line = lineHeight(look);
    for (int i = 0; i * axes.yStep <= axes.yTo + 1e-9; ++i) {
        const double y = axes.at(axes.xFrom, i * axes.yStep).y();
        painter.setPen(penOf(look.colours.grid, look, 0.8));
        painter.drawLine(QPointF(axes.room.left(), y), QPointF(axes.room.right(), y));
        painter.setPen(look.colours.text);
        painter.drawText(QRectF(axes.room.left() - 10 * line, y - line, 9.7 * line, 2 * line), Qt::AlignRight | Qt::AlignVCenter,
            QString::number(qRound(i * axes.yStep)));
    }
}

void paintHistogram(
    QPainter& painter, const QRectF& rect, std::size_t c, const DistributionDrawing::Coefficient& one, const FleetLook& look)
{
    const double line = lineHeight(look);
    const QFontMetricsF metrics(look.font);
    painter.setFont(look.font);
    const QString letter = QString(QLatin1Char(letterOf(kCoefficients[c])));
    if (one.values_deg.empty())
        return paintNothing(painter, rect, DistributionTexts::tr("No swing tells %1.").arg(letter), look);
    const Bins bins = binsOf(one.values_deg);
    FleetAxes axes;
    axes.room = rect.adjusted(metrics.horizontalAdvance(QStringLiteral("88888")), 1.4 * line, -line, -1.6 * line);
    axes.xFrom = bins.from;
    axes.xTo = bins.to();
    axes.yStep = std::max(1.0, niceStep(1.15 * bins.largest() / 4));
    axes.yFrom = 0;
    axes.yTo = axes.yStep * std::ceil(1.15 * bins.largest() / axes.yStep);
    paintCounts(painter, axes, look);
    painter.setPen(penOf(look.colours.ground, look, 0.8));
    painter.setBrush(look.colours.approximate);
    for (std::size_t i = 0; i < bins.count.size(); ++i)
        if (bins.count[i] > 0) {
            const double from = bins.from + bins.step * static_cast<double>(i);
            painter.drawRect(QRectF(axes.at(from, bins.count[i]), axes.at(from + bins.step, 0)));
        }
    if (one.mean_deg) {
        painter.setPen(penOf(look.colours.exact, look, 1.8));
        painter.drawLine(axes.at(*one.mean_deg, 0), axes.at(*one.mean_deg, axes.yTo));
    }
    painter.setPen(look.colours.suspect);
    for (std::size_t i = 0; i < std::min(one.outliers.size(), kNamedOutliers); ++i) { // by name, each on a line of its own
        const QPointF foot = axes.at(one.outliers[i].value_deg, 0);
        const double width = metrics.horizontalAdvance(one.outliers[i].aircraft),
                     y = axes.room.top() + (1.1 + 1.1 * static_cast<double>(i)) * line;
        const double x = std::clamp(foot.x() - width / 2, axes.room.left(), std::max(axes.room.left(), axes.room.right() - width));
        painter.drawText(QPointF(x, y), one.outliers[i].aircraft);
        painter.drawLine(QPointF(foot.x(), y + 0.2 * line), foot);
    }
    paintXTicks(painter, axes, look);
    paintFrame(painter, axes, look);
    QString title = DistributionTexts::tr("%1, %n vote(s)", nullptr, static_cast<int>(one.values_deg.size())).arg(letter);
    if (one.outliers.size() > kNamedOutliers)
        title += DistributionTexts::tr("; %n more far off", nullptr, static_cast<int>(one.outliers.size() - kNamedOutliers));
    painter.setPen(look.colours.text);
    painter.drawText(QPointF(axes.room.left(), rect.top() + line), title);
}

} // namespace

DistributionDrawing distributionDrawing(const FleetReport& report, const FleetSwings& fleet)
{
    DistributionDrawing drawing;
    for (std::size_t c = 0; c < kCoefficientCount; ++c) {
        const auto& spread = report.pattern.coefficients[c];
        auto& one = drawing.coefficients[c];
        one.values_deg = spread.values_deg;
        one.mean_deg = spread.mean_deg;
        for (const auto& outlier : spread.outliers) {
            const auto& compass = fleet.compasses[static_cast<std::size_t>(fleet.swings[outlier.row].compass)];
            one.outliers.push_back({outlier.value_deg, QString::fromStdString(compass.aircraft)});
        }
    }
    drawing.found = report.found;
    drawing.left = report.left;
    return drawing;
}

void paintDistributions(QPainter& painter, const QRectF& rect, const DistributionDrawing& drawing, const FleetLook& look)
{
    const double width = rect.width() / 3, height = rect.height() / 2;
    for (std::size_t c = 0; c <= kCoefficientCount; ++c) {
        const QRectF room(
            rect.left() + width * static_cast<double>(c % 3), rect.top() + height * static_cast<double>(c / 3), width, height);
        if (c < kCoefficientCount)
            paintHistogram(painter, room, c, drawing.coefficients[c], look);
        else
            paintFleetSpectrum(painter, room.adjusted(0, 0.6 * lineHeight(look), 0, 0), drawing.found, drawing.left, look);
    }
}

void paintLimitDates(QPainter& painter, const QRectF& rect, const RankedCompass& ranked, const FleetLook& look)
{
    const double line = lineHeight(look), first = 1970.0 + ranked.lastSwing_day / kDaysPerYear;
    painter.setFont(look.font);
    FleetAxes axes;
    axes.room
        = rect.adjusted(QFontMetricsF(look.font).horizontalAdvance(QStringLiteral("100 %")) + 0.4 * line, 1.4 * line, -line, -1.6 * line);
    axes.xFrom = first;
    const auto whole
        = std::ranges::find_if(ranked.reachedShare, [](double share) { return share > 0.98; }); // what is certain needs no room
    axes.xTo = first + std::max<double>(2.0, static_cast<double>(whole - ranked.reachedShare.begin()) / 4);
    axes.yFrom = 0;
    axes.yTo = 100;
    for (int share = 0; share <= 100; share += 25) {
        painter.setPen(penOf(look.colours.grid, look, share == 50 ? 1.4 : 0.8));
        painter.drawLine(axes.at(axes.xFrom, share), axes.at(axes.xTo, share));
        painter.setPen(look.colours.text);
        const double y = axes.at(0, share).y();
        painter.drawText(QRectF(axes.room.left() - 10 * line, y - line, 9.7 * line, 2 * line), Qt::AlignRight | Qt::AlignVCenter,
            QStringLiteral("%1 %").arg(share));
    }
    const int step = std::max(1, static_cast<int>(std::ceil((axes.xTo - axes.xFrom) * 3.4 * line / std::max(1.0, axes.room.width()))));
    for (int year = static_cast<int>(std::ceil(axes.xFrom)); year <= axes.xTo; year += step) {
        const double x = axes.at(year, 0).x();
        painter.setPen(penOf(look.colours.grid, look, 0.8));
        painter.drawLine(QPointF(x, axes.room.top()), QPointF(x, axes.room.bottom()));
        painter.setPen(look.colours.text);
        painter.drawText(QRectF(x - 3 * line, axes.room.bottom() + 0.2 * line, 6 * line, 1.2 * line), Qt::AlignHCenter | Qt::AlignTop,
            QString::number(year));
    }
    QPolygonF curve;
    for (std::size_t i = 0; i < ranked.reachedShare.size() && first + static_cast<double>(i) / 4 <= axes.xTo + 1e-9; ++i)
        curve << axes.at(first + static_cast<double>(i) / 4, 100 * ranked.reachedShare[i]);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(penOf(look.colours.exact, look, 2.2));
    painter.drawPolyline(curve);
    if (const double by = 1970.0 + ranked.by_day / kDaysPerYear; by <= axes.xTo) {
        painter.setPen(penOf(look.colours.suspect, look, 1.2, Qt::DashLine));
        painter.drawLine(axes.at(by, 0), axes.at(by, 100));
        painter.drawText(axes.at(by, 100) + QPointF(0.3 * line, 1.1 * line), DistributionTexts::tr("next date"));
    }
    paintFrame(painter, axes, look);
    painter.setPen(look.colours.text);
    painter.drawText(QPointF(axes.room.left(), rect.top() + line), DistributionTexts::tr("Share of futures beyond the limit by then"));
}

} // namespace lubberline::ui
