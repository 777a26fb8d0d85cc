#pragma once

#include <QFont>

#include <vector>

#include <qwt_plot_item.h>

#include "ui/plots/base/CartesianPlot.h"
#include "ui/plots/base/Chart.h"
#include "ui/plots/swing/ReadingMarks.h"

namespace lubberline::ui {

/// Readings in a plot of ours.
class CartesianReadings : public QwtPlotItem {
public:
    CartesianReadings();
    void setPoints(std::vector<ReadingPoint> points)
    {
        m_points = std::move(points);
        setZ(depthOf(m_points.size()));
    }
    void setSelectedRow(int row) { m_selectedRow = row; }
    void setLook(const PlotColours& colours, const QFont& font);
    [[nodiscard]] const std::vector<ReadingPoint>& points() const { return m_points; }
    [[nodiscard]] int selectedRow() const { return m_selectedRow; }

    void draw(QPainter* painter, const QwtScaleMap& xMap, const QwtScaleMap& yMap, const QRectF& canvasRect) const override;

private:
    std::vector<ReadingPoint> m_points;
    int m_selectedRow = -1;
    PlotColours m_colours;
    QFont m_font;
};

[[nodiscard]] std::vector<Chart::RowPlace> rowPlaces(const CartesianPlot& plot, const CartesianReadings& readings);

} // namespace lubberline::ui
