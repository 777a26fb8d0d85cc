#pragma once

#include "ui/plots/base/CartesianLines.h"
#include "ui/plots/base/Chart.h"
#include "ui/plots/swing/PredictionPlot.h"

class QwtPlotCurve;
class QwtPlotIntervalCurve;

namespace lubberline::ui {

class CartesianPlot;

class PredictionChart : public Chart {
    Q_OBJECT

public:
    explicit PredictionChart(QWidget* parent = nullptr);

    void setPicture(const PredictionPicture& picture);

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
    CartesianPlot* m_plot;
    LimitBand m_limit;
    QwtPlotIntervalCurve* m_band;
    QwtPlotCurve* m_there;
    QwtPlotCurve* m_here;
    int m_bandEntry, m_thereEntry, m_hereEntry, m_limitEntry;
    PredictionPicture m_picture;
};

} // namespace lubberline::ui
