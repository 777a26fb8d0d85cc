#pragma once
/// The flat map: colours with labelled contours over two axes of attitude.

#include "ui/plots/map/MapViewChart.h"

namespace lubberline::ui {

class CartesianPlot;
class MapItem;

class MapChart : public MapViewChart {
    Q_OBJECT

public:
    explicit MapChart(QWidget* parent = nullptr);

    [[nodiscard]] CartesianPlot& plot() const { return *m_plot; }
    [[nodiscard]] const MapItem& item() const { return *m_item; }

    [[nodiscard]] std::vector<QWidget*> canvases() const override;
    [[nodiscard]] QString readOutAt(const CanvasPlace& place) const override;
    void zoomInto(const QWidget* canvas, const QRectF& rect) override;
    void zoomAt(const CanvasPlace& place, double factor) override;
    void panBy(const QWidget* canvas, const QPointF& by) override;
    void resetZoom() override;
    void takeView(const Chart& other) override;

protected:
    void takePicture() override;
    void layoutBody(const QRect& rect) override;
    void paintBody(QPainter& painter, const QRectF& device, double scale) override;
    [[nodiscard]] double footHeight() const override;
    void styleItems() override;
    void replotAll() override;

private:
    void updateEntries();

    CartesianPlot* m_plot;
    MapItem* m_item;                    ///< the plot owns it
    std::optional<MapRequest> m_viewed; ///< what the view belongs to
    int m_contoursEntry, m_limitEntry, m_extremesEntry;
};

} // namespace lubberline::ui
