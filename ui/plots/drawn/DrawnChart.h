#pragma once

#include "ui/plots/base/Chart.h"
#include "ui/plots/drawn/DrawnPicture.h"

namespace lubberline::ui {

class PaintedStrip;

class DrawnChart : public Chart {
    Q_OBJECT

public:
    explicit DrawnChart(QWidget* parent = nullptr);
    void setPicture(const DrawnPicture& picture);

    [[nodiscard]] std::vector<QWidget*> canvases() const override;
    [[nodiscard]] std::vector<RowPlace> rowsOn(const QWidget*) const override { return {}; }
    [[nodiscard]] QString readOutOfRow(int) const override { return {}; }
    [[nodiscard]] QString readOutAt(const CanvasPlace& place) const override;
    void zoomInto(const QWidget*, const QRectF&) override {}
    void zoomAt(const CanvasPlace&, double) override {}
    void panBy(const QWidget*, const QPointF&) override {}
    void resetZoom() override {}

protected:
    void styleItems() override;
    void layoutPlots(const QRect& rect) override;
    void paintPlots(QPainter& painter, const QRectF& device) override;
    void replotAll() override;

private:
    void draw(QPainter& painter, const QRectF& rect) const;

    DrawnPicture m_picture;
    PaintedStrip* m_canvas;
};

} // namespace lubberline::ui
