#pragma once
/// Deviation over two axes of attitude as a surface in space that turns under the mouse, drawn without a GPU.

#include "ui/plots/base/Plot.h"
#include "ui/plots/map/MapPlotRendering.h"

namespace lubberline::ui {

class SurfaceChart;

/// Drag turns it, the wheel zooms, a double click or Home resets; the arrow keys turn it by 5°. Copy and export as every plot
/// (Plot.h).
class SurfacePlot : public Plot {
    Q_OBJECT

public:
    explicit SurfacePlot(QWidget* parent = nullptr);

    void setPicture(const MapPicture& picture);
    void setView(const SurfaceView& view); ///< the elevation is held within 5…75°
    [[nodiscard]] SurfaceView view() const;
    void render(QPainter& painter, const QRectF& target) const override;
    [[nodiscard]] SurfaceChart* chart() const { return m_chart; }

protected:
    bool step(int direction) override;
    void refresh() override;

private:
    SurfaceChart* m_chart;
    MapPicture m_picture;
    bool m_stale = false;
};

} // namespace lubberline::ui
