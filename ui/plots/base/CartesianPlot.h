#pragma once
/// A QwtPlot in our looks with a view that zooms and pans within its base, and the items that Qwt lacks.

#include <QFont>

#include <vector>

#include <qwt_plot.h>
#include <qwt_plot_item.h>

#include "ui/plots/base/NiceScale.h"
#include "ui/plots/base/PlotColours.h"

class QwtPlotGrid;
class QwtPlotMarker;

namespace lubberline::ui {

class PlotNotice;

class CartesianPlot : public QwtPlot {
    Q_OBJECT

public:
    explicit CartesianPlot(QWidget* parent = nullptr);

    void setLook(const PlotColours& colours, const QFont& font);
    void setTitles(const QString& x, const QString& y);
    void setNotice(const QString& text);
    [[nodiscard]] QString notice() const;

    /// The values seen when nothing is zoomed; the steps of y. A zoomed view stays where it is.
    void setBase(double xFrom, double xTo, double yFrom, double yTo, double yStep);
    void setView(const QRectF& view); ///< values, kept within the base
    [[nodiscard]] QRectF view() const { return m_view; }
    [[nodiscard]] bool zoomed() const { return m_view != m_base; }
    void resetZoom();
    void takeView(const CartesianPlot& other); ///< its zoom, if it is zoomed
    void zoomInto(const QRectF& rect_px);
    void zoomAt(const QPointF& at_px, double factor);
    void panBy(const QPointF& by_px);

    [[nodiscard]] QPointF valueAt(const QPointF& at_px) const;
    [[nodiscard]] QPointF pixelOf(const QPointF& value) const;
    /// In vector form into a rectangle of the painter's device.
    void paintInto(QPainter& painter, const QRectF& device);

signals:
    void viewChanged();

private:
    void applyView();

    QRectF m_base{0, -1, 1, 2}, m_view = m_base; ///< top(): lowest y
    double m_yStep = 1;
    QwtPlotGrid* m_grid;
    QwtPlotMarker* m_zero;
    PlotNotice* m_notice;
    PlotColours m_colours;
    QFont m_font;
};

/// What to do, or why there is no curve: in the middle of the plot.
class PlotNotice : public QwtPlotItem {
public:
    PlotNotice();
    void setText(const QString& text) { m_text = text; }
    void setLook(const PlotColours& colours, const QFont& font);
    [[nodiscard]] const QString& text() const { return m_text; }

    void draw(QPainter* painter, const QwtScaleMap& xMap, const QwtScaleMap& yMap, const QRectF& canvasRect) const override;

private:
    QString m_text;
    PlotColours m_colours;
    QFont m_font;
};

} // namespace lubberline::ui
