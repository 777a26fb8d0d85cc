#pragma once
/// The manners of every plot of a swing: mouse, keys, context menu, palette, and repainting only while it is seen.

#include <functional>
#include <memory>

#include "ui/plots/Chart.h"
#include "ui/plots/SwingPlot.h"

namespace lubberline::ui {

class ChartPlot : public SwingPlot {
    Q_OBJECT

public:
    using MakeChart = std::function<std::unique_ptr<SwingChart>()>;
    ChartPlot(const QString& name, MakeChart makeChart, QWidget* parent);

    [[nodiscard]] QString name() const override { return m_name; }
    void setPicture(const SwingPicture& picture) override;
    void setSelectedRow(int row) override;
    void resetZoom() override;
    void render(QPainter& painter, const QRectF& target) const override;
    [[nodiscard]] QSize sizeHint() const override { return {560, 480}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {220, 200}; }
    [[nodiscard]] SwingChart* chart() const { return m_chart; }

protected:
    bool event(QEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

private:
    void select(int row);
    /// The next reading round the compass, or the one before.
    void selectNeighbour(int direction);
    /// Hands over what was set while the plot was hidden.
    void refresh();
    void followPalette();

    QString m_name;
    MakeChart m_makeChart;
    SwingChart* m_chart = nullptr;
    SwingPicture m_picture;
    int m_selectedRow = -1;
    bool m_stale = false;
};

/// A fresh chart painted once, for paper.
void renderChart(SwingChart& chart, QPainter& painter, const QRectF& target, const SwingPicture& picture);

} // namespace lubberline::ui
