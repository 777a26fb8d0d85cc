#pragma once
/// A chart of a swing that is one rectangular plot.

#include "ui/plots/base/Chart.h"
#include "ui/plots/swing/SwingChart.h"

namespace lubberline::ui {

class CartesianPlot;

class CartesianChart : public SwingChart {
    Q_OBJECT

public:
    explicit CartesianChart(QWidget* parent = nullptr);

    [[nodiscard]] std::vector<QWidget*> canvases() const override;
    void zoomInto(const QWidget* canvas, const QRectF& rect) override;
    void zoomAt(const CanvasPlace& place, double factor) override;
    void panBy(const QWidget* canvas, const QPointF& by) override;
    void resetZoom() override;
    void takeView(const Chart& other) override;

protected:
    [[nodiscard]] CartesianPlot& plot() const { return *m_plot; }
    void styleItems() override;
    void layoutPlots(const QRect& rect) override;
    void paintPlots(QPainter& painter, const QRectF& device) override;
    void replotAll() override;

private:
    CartesianPlot* m_plot;
};

} // namespace lubberline::ui
