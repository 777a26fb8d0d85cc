#pragma once
/// A population of swings drawn: on a page of the window in pixels, on paper in the units of the sheet; everything is sized by the font.
/// East is up and outward, as in every plot of ours.

#include <QFont>
#include <QPointF>
#include <QRectF>
#include <QString>

#include <array>
#include <optional>
#include <vector>

#include "core/fleet/FleetReport.h"
#include "ui/plots/base/PlotColours.h"

class QPainter;

namespace lubberline::ui {

struct FleetLook {
    QFont font;
    PlotColours colours;
};

struct PopulationDrawing {
    const PopulationPattern* pattern = nullptr;
    std::optional<double> limit_deg = {};
    std::optional<double> chosen_deg = {}; ///< a heading that is marked
    QString nothing = {};                  ///< what is said where there is no pattern; empty: that no swing tells one
};

/// Words in the middle, where there is nothing to draw.
void paintNothing(QPainter& painter, const QRectF& rect, const QString& words, const FleetLook& look);

/// Mean with its standard deviation between aircraft (tint) and 5 to 95 % (thin) against heading.
void paintPopulationCurve(QPainter& painter, const QRectF& rect, const PopulationDrawing& drawing, const FleetLook& look);
/// The same around a circle, north up.
void paintPopulationPolar(QPainter& painter, const QRectF& rect, const PopulationDrawing& drawing, const FleetLook& look);
/// The heading under a place of either, on the pattern's grid; none beside the plot.
[[nodiscard]] std::optional<double> curveHeadingAt(const QRectF& rect, const PopulationDrawing& drawing, const FleetLook& look, QPointF at);
[[nodiscard]] std::optional<double> polarHeadingAt(const QRectF& rect, const PopulationDrawing& drawing, const FleetLook& look, QPointF at);

/// Amplitudes by order, as found before as left.
void paintFleetSpectrum(QPainter& painter, const QRectF& rect, const std::vector<HarmonicOrder>& found,
    const std::vector<HarmonicOrder>& left, const FleetLook& look);

/// How the coefficients of the population are distributed, with those far from the others by name.
struct DistributionDrawing {
    struct Outlier {
        double value_deg = 0;
        QString aircraft;
    };
    struct Coefficient {
        std::vector<double> values_deg; ///< sorted
        std::optional<double> mean_deg;
        std::vector<Outlier> outliers; ///< the farthest first
    };
    std::array<Coefficient, kCoefficientCount> coefficients;
    std::vector<HarmonicOrder> found, left; ///< beside them: their orders (Figure 14 of the source paper)
};
[[nodiscard]] DistributionDrawing distributionDrawing(const FleetReport& report, const FleetSwings& fleet);
/// Five histograms and the spectrum as found over as left.
void paintDistributions(QPainter& painter, const QRectF& rect, const DistributionDrawing& drawing, const FleetLook& look);

/// By when a limit is reached: share of the futures against the years.
void paintLimitDates(QPainter& painter, const QRectF& rect, const RankedCompass& ranked, const FleetLook& look);

/// One compass through the years.
struct HistoryDrawing {
    struct Point {
        int day = 0;
        bool left = false;                   ///< as left, else as found
        FiveTerms value_deg{}, half95_deg{}; ///< NaN where the coefficient is not known
    };
    struct Jump {
        int after_day = 0, before_day = 0;
        std::size_t coefficient = 0;
    };
    std::vector<Point> points; ///< by day
    std::vector<Jump> jumps;
    std::vector<FleetEvent> events;
    std::optional<double> limit_deg = {};
    std::size_t shown = 0; ///< how many of the points, from the first: a film
};
[[nodiscard]] HistoryDrawing historyDrawing(
    const FleetSwings& fleet, const FleetCurves& curves, const CompassHistory& history, const FleetChanges& changes);

/// Coefficients with their 95 % bars over the years, five strips under one another; jumps as tints, events as lines with their words.
void paintCoefficientHistory(QPainter& painter, const QRectF& rect, const HistoryDrawing& drawing, const FleetLook& look);
/// The curves laid over each other, the oldest faint, the newest strong; as left dashed.
void paintCurveHistory(QPainter& painter, const QRectF& rect, const HistoryDrawing& drawing, const FleetLook& look);

} // namespace lubberline::ui
