#pragma once
/// An element of the Earth's field over the world, in the equirectangular projection with equal scales (plate carrée): a degree is as long
/// eastward as northward.

#include <memory>
#include <optional>

#include "core/earth/FieldGrid.h"
#include "ui/plots/base/Chart.h"

namespace lubberline::ui {

class CartesianPlot;
class WorldFieldItem;

class WorldFieldChart : public Chart {
    Q_OBJECT

public:
    explicit WorldFieldChart(QWidget* parent = nullptr);

    void setGrid(std::shared_ptr<const FieldGrid> grid);
    void setPlace(const std::optional<Place>& place, const QString& label);
    /// Longitude and latitude [deg] under a place of the canvas; none beyond the world.
    [[nodiscard]] std::optional<QPointF> placeAt(const QPointF& at_px) const;
    [[nodiscard]] CartesianPlot& plot() const { return *m_plot; }
    [[nodiscard]] const WorldFieldItem& item() const { return *m_item; }

    [[nodiscard]] std::vector<QWidget*> canvases() const override;
    [[nodiscard]] std::vector<RowPlace> rowsOn(const QWidget*) const override { return {}; }
    [[nodiscard]] QString readOutOfRow(int) const override { return {}; }
    [[nodiscard]] QString readOutAt(const CanvasPlace& place) const override;
    void zoomInto(const QWidget* canvas, const QRectF& rect) override;
    void zoomAt(const CanvasPlace& place, double factor) override;
    void panBy(const QWidget* canvas, const QPointF& by) override;
    void resetZoom() override;
    void takeView(const Chart& other) override;

protected:
    void styleItems() override;
    void layoutPlots(const QRect& rect) override;
    void paintPlots(QPainter& painter, const QRectF& device) override;
    void replotAll() override;

private:
    /// The part of a place in which the canvas has the shape of the world; `unit`: of the place, in pixels of the plot.
    [[nodiscard]] QRectF inShape(const QRectF& rect, double unit) const;
    CartesianPlot* m_plot;
    WorldFieldItem* m_item; ///< the plot owns it
    std::shared_ptr<const FieldGrid> m_grid;
};

} // namespace lubberline::ui
