#pragma once
/// The surface in space with its camera.

#include <memory>
#include <optional>

#include "ui/plots/map/MapViewChart.h"
#include "ui/plots/map/SurfacePainting.h"

namespace lubberline::ui {

class SurfaceChart : public MapViewChart {
    Q_OBJECT

public:
    explicit SurfaceChart(QWidget* parent = nullptr);

    void setView(const SurfaceView& view); ///< held within what can be drawn
    [[nodiscard]] const SurfaceView& view() const { return m_view; }
    /// While it turns it is drawn without smooth edges and mesh.
    void setTurning(bool turning);
    [[nodiscard]] double zoom() const { return m_zoom; }
    [[nodiscard]] const SurfaceMesh* mesh() const { return m_mesh.get(); } ///< null without a map
    /// Where a place of the map with a value is on the canvas.
    [[nodiscard]] QPointF pixelOf(const BoxPoint& point) const;

    [[nodiscard]] std::vector<QWidget*> canvases() const override { return {m_canvas}; }
    [[nodiscard]] QString readOutAt(const CanvasPlace& place) const override;
    void zoomInto(const QWidget* canvas, const QRectF& rect) override;
    void zoomAt(const CanvasPlace& place, double factor) override;
    void panBy(const QWidget* canvas, const QPointF& by) override;
    void resetZoom() override; ///< the view too
    void takeView(const Chart& other) override;

protected:
    void takePicture() override;
    void layoutBody(const QRect& rect) override;
    void paintBody(QPainter& painter, const QRectF& device, double scale) override;
    void styleItems() override;
    void replotAll() override;

private:
    [[nodiscard]] SurfaceProjection projectionIn(const QRectF& rect, const QFont& font) const;
    void paintIn(QPainter& painter, const QRectF& rect, const QFont& font, const SurfaceMesh* mesh, bool turning) const;

    QWidget* m_canvas;
    std::unique_ptr<const SurfaceMesh> m_mesh;
    SurfaceView m_view;
    double m_zoom = 1;
    QPointF m_moved;
    bool m_turning = false;
};

/// Drag turns (left) or pans (middle), the wheel zooms, a double click resets; hovering reads out.
class SurfaceMouse : public QObject {
    Q_OBJECT

public:
    explicit SurfaceMouse(SurfaceChart* chart);

signals:
    void pressed();
    void readOut(const QString& text);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void drag(QPointF to);

    SurfaceChart* m_chart;
    QPointF m_from;
    Qt::MouseButton m_button = Qt::NoButton;
};

} // namespace lubberline::ui
