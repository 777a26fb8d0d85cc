#pragma once
/// Deviation over two axes of attitude, from above: colours and labelled contours.

#include "ui/plots/base/Plot.h"
#include "ui/plots/map/MapPicture.h"

namespace lubberline::ui {

class MapChart;

/// The manners are those of every plot (Plot.h).
class MapPlot : public Plot {
    Q_OBJECT

public:
    explicit MapPlot(QWidget* parent = nullptr);

    /// Repaints at the next turn of the event loop; a zoomed view stays while the axes remain the same.
    void setPicture(const MapPicture& picture);
    void render(QPainter& painter, const QRectF& target) const override;
    [[nodiscard]] MapChart* chart() const { return m_chart; }

protected:
    void refresh() override;

private:
    MapChart* m_chart;
    MapPicture m_picture;
    bool m_stale = false;
};

} // namespace lubberline::ui
