#pragma once
/// The mouse on a chart: read-out, picking, zoom by frame and wheel, pan, reset.

#include <QObject>

#include "ui/plots/base/Chart.h"

class QLabel;

namespace lubberline::ui {

class ChartMouse : public QObject {
    Q_OBJECT

public:
    /// Watches all canvases of the chart and is owned by it.
    explicit ChartMouse(Chart* chart);

signals:
    void picked(int row);
    void pressed();
    void clicked(const QWidget* canvas, const QPointF& at);
    void readOut(const QString& text); ///< empty when the pointer leaves

private:
    void watch(QWidget* canvas);
    void tell(const QString& text, QPoint at); ///< beside the pointer, and to whoever listens

    Chart* m_chart;
    QLabel* m_beside;
};

inline constexpr double kZoomStep = 0.8; ///< of a wheel's notch or a key
void zoomMiddle(Chart& chart, double factor);

} // namespace lubberline::ui
