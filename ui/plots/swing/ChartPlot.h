#pragma once
/// A plot of a swing with any chart of it: selection, and repainting only while it is seen.

#include <functional>
#include <memory>

#include "ui/plots/base/Chart.h"
#include "ui/plots/swing/SwingChart.h"
#include "ui/plots/swing/SwingPicture.h"
#include "ui/plots/swing/SwingPlot.h"

namespace lubberline::ui {

class ChartPlot : public SwingPlot {
    Q_OBJECT

public:
    using MakeChart = std::function<std::unique_ptr<SwingChart>()>;
    ChartPlot(const QString& name, MakeChart makeChart, QWidget* parent);

    void setPicture(const SwingPicture& picture) override;
    void setSelectedRow(int row) override;
    void render(QPainter& painter, const QRectF& target) const override;
    [[nodiscard]] SwingChart* chart() const { return m_chart; }

protected:
    bool step(int direction) override;
    void refresh() override;

private:
    void select(int row);

    MakeChart m_makeChart;
    SwingChart* m_chart;
    SwingPicture m_picture;
    int m_selectedRow = -1;
    bool m_stale = false;
};

/// A fresh chart painted once, for paper.
void renderChart(SwingChart& chart, QPainter& painter, const QRectF& target, const SwingPicture& picture);

} // namespace lubberline::ui
