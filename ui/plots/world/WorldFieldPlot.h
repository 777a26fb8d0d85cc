#pragma once
/// An element of the Earth's field over the world as isolines, with the coasts and a place.

#include <memory>
#include <optional>

#include "core/earth/EarthField.h"
#include "ui/plots/base/Plot.h"

namespace lubberline {
struct FieldGrid;
}

namespace lubberline::ui {

class WorldFieldChart;

/// The manners are those of every plot (Plot.h).
class WorldFieldPlot : public Plot {
    Q_OBJECT

public:
    explicit WorldFieldPlot(QWidget* parent = nullptr);

    /// Null: nothing but the coasts.
    void setGrid(std::shared_ptr<const FieldGrid> grid);
    void setPlace(const std::optional<Place>& place, const QString& label);
    void render(QPainter& painter, const QRectF& target) const override;
signals:
    void placeClicked(double latitude_deg, double longitude_deg);

public:
    [[nodiscard]] WorldFieldChart* chart() const { return m_chart; }

private:
    WorldFieldChart* m_chart;
    std::shared_ptr<const FieldGrid> m_grid;
    std::optional<Place> m_place;
    QString m_label;
};

} // namespace lubberline::ui
