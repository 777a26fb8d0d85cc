#pragma once
/// A…E and the largest deviation of each swing of one compass, against the date of the swing.

#include <array>
#include <optional>
#include <vector>

#include "ui/plots/base/CartesianLines.h"
#include "ui/plots/base/Chart.h"
#include "ui/plots/swing/HistoryPlot.h"

class QwtPlotCurve;

namespace lubberline::ui {

class CartesianPlot;

class HistoryChart : public Chart {
    Q_OBJECT

public:
    explicit HistoryChart(QWidget* parent = nullptr);

    void setHistory(const std::vector<HistoryPoint>& points, std::optional<double> limit_deg);

    [[nodiscard]] std::vector<QWidget*> canvases() const override;
    [[nodiscard]] std::vector<RowPlace> rowsOn(const QWidget* canvas) const override;
    [[nodiscard]] QString readOutOfRow(int swing) const override;
    [[nodiscard]] QString readOutAt(const CanvasPlace& place) const override;
    void zoomInto(const QWidget* canvas, const QRectF& rect) override;
    void zoomAt(const CanvasPlace& place, double factor) override;
    void panBy(const QWidget* canvas, const QPointF& by) override;
    void resetZoom() override;
    void takeView(const Chart& other) override;

protected:
    void styleItems() override;
    void layoutPlots(const QRect& rect) override;
    void paintPlots(QPainter& painter, const QRectF& device) override;
    void replotAll() override;

private:
    static constexpr std::size_t kLargest = 5; ///< the series after A…E

    CartesianPlot* m_plot;
    LimitBand m_limit;
    std::array<QwtPlotCurve*, 6> m_series; ///< A…E, largest |deviation|
    std::array<int, 6> m_entries;
    int m_limitEntry;
    std::vector<HistoryPoint> m_points; ///< by date
};

} // namespace lubberline::ui
