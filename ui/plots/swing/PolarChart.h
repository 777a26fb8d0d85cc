#pragma once
/// Deviation against heading round the compass: outward is east (+), the heavy circle half-way out is zero.

#include "ui/plots/base/Chart.h"
#include "ui/plots/base/NiceScale.h"
#include "ui/plots/swing/SwingChart.h"
#include "ui/plots/swing/SwingPicture.h"

class QwtPolarCurve;
class QwtPolarPlot;

namespace lubberline::ui {

class PolarGround;
class PolarNotice;
class PolarReadings;

class PolarChart : public SwingChart {
    Q_OBJECT

public:
    explicit PolarChart(QWidget* parent = nullptr);

    void setPicture(const SwingPicture& picture) override;
    void setSelectedRow(int row) override;
    [[nodiscard]] std::vector<QWidget*> canvases() const override;
    [[nodiscard]] std::vector<RowPlace> rowsOn(const QWidget* canvas) const override;
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
    /// What is seen: `centre` is at the middle of the canvas, in radii of the whole plot from the pole, y upwards;
    /// `factor` is the part of the radius that half the canvas shows.
    struct View {
        QPointF centre;
        double factor = 1;
    };
    void setView(View view);
    [[nodiscard]] QPointF inRadii(const QPointF& at) const;

    NiceScale m_scale;
    View m_view;
    QwtPolarPlot* m_plot;
    PolarGround* m_ground;
    QwtPolarCurve* m_previous;
    QwtPolarCurve* m_approximate;
    QwtPolarCurve* m_exact;
    PolarReadings* m_readings;
    PolarNotice* m_notice;
    int m_readingsEntry, m_approximateEntry, m_exactEntry, m_previousEntry, m_limitEntry;
};

} // namespace lubberline::ui
