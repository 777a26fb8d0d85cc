#pragma once
/// The world in a plot of longitude and latitude: coasts, isolines of an element of the field, a place.

#include <QFont>
#include <QString>

#include <memory>
#include <optional>
#include <vector>

#include <qwt_plot_item.h>

#include "core/earth/FieldGrid.h"
#include "core/sensor/map/Contours.h"
#include "ui/plots/base/PlotColours.h"
#include "ui/plots/map/ContourPainting.h"

namespace lubberline::ui {

/// Declination jumps from +180° to −180°; other elements do not. [deg, or 0: none]
[[nodiscard]] double jumpOf(FieldElement element);

class WorldFieldItem : public QwtPlotItem {
public:
    WorldFieldItem();
    void setGrid(std::shared_ptr<const FieldGrid> grid);
    void setPlace(const std::optional<Place>& place, const QString& label);
    void setLook(const PlotColours& colours, const QFont& font);

    [[nodiscard]] const std::vector<ContourLine>& isolines() const { return m_isolines; } ///< points in degrees
    [[nodiscard]] const std::vector<ContourLabel>& labels() const { return m_labels; }    ///< of the last painting

    void draw(QPainter* painter, const QwtScaleMap& xMap, const QwtScaleMap& yMap, const QRectF& canvasRect) const override;

private:
    [[nodiscard]] QPen penOf(double level) const;

    std::shared_ptr<const FieldGrid> m_grid;
    std::vector<ContourLine> m_isolines;
    std::optional<Place> m_place;
    QString m_label;
    PlotColours m_colours;
    QFont m_font;
    mutable std::vector<ContourLabel> m_labels;
};

} // namespace lubberline::ui
