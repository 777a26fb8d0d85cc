#pragma once
/// Deviation against magnetic heading, with the residuals of the approximate fit in a strip beneath.

#include "ui/plots/base/CartesianLines.h"
#include "ui/plots/base/Chart.h"
#include "ui/plots/base/NiceScale.h"
#include "ui/plots/swing/SwingChart.h"
#include "ui/plots/swing/SwingPicture.h"

class QwtPlotCurve;
class QwtPlotIntervalCurve;

namespace lubberline::ui {

class CartesianPlot;
class CartesianReadings;

class CurveChart : public SwingChart {
    Q_OBJECT

public:
    explicit CurveChart(QWidget* parent = nullptr);

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
    void setCurves();
    void setStrip();
    void setEntries(const NiceScale& scale);
    void addEntries();
    /// The same room left of both canvases, so that a heading stands in one vertical line.
    void alignPlots();
    /// The upright titles in the longest words that the canvases' heights hold [96ths of an inch]: a title is cut where it is
    /// longer.
    void fitTitles(double mainHeight, double stripHeight);
    [[nodiscard]] bool isStrip(const QWidget* canvas) const;
    [[nodiscard]] double stripHeight(double height) const; ///< of a chart of this height [96ths of an inch]

    CartesianPlot* m_main;
    CartesianPlot* m_strip;
    LimitBand m_limit;
    QwtPlotIntervalCurve* m_band;
    QwtPlotCurve* m_previous;
    QwtPlotCurve* m_approximate;
    QwtPlotCurve* m_exact;
    CartesianReadings* m_readings;
    CartesianReadings* m_residuals;
    bool m_hasStrip = false;
    int m_readingsEntry, m_approximateEntry, m_bandEntry, m_exactEntry, m_previousEntry, m_limitEntry;
};

} // namespace lubberline::ui
