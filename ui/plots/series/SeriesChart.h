#pragma once

#include "ui/plots/base/Chart.h"
#include "ui/plots/series/SeriesPlot.h"

class QwtPlotCurve;

namespace lubberline::ui {

class CartesianPlot;

class SeriesChart : public Chart {
    Q_OBJECT

public:
    static constexpr int kMostSeries = 3;

    explicit SeriesChart(QWidget* parent = nullptr);

    void setPicture(const SeriesPicture& picture);
    [[nodiscard]] QRectF view() const;
    [[nodiscard]] bool zoomed() const;
    [[nodiscard]] std::size_t drawnPoints(int series) const; ///< of a curve, after thinning

    [[nodiscard]] std::vector<QWidget*> canvases() const override;
    [[nodiscard]] std::vector<RowPlace> rowsOn(const QWidget*) const override { return {}; }
    [[nodiscard]] QString readOutOfRow(int) const override { return {}; }
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
    void thin(); ///< what is drawn of each series in the view

    CartesianPlot* m_plot;
    std::vector<QwtPlotCurve*> m_curves;
    std::vector<int> m_entries;
    SeriesPicture m_picture;
};

} // namespace lubberline::ui
