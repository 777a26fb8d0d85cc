#pragma once
/// A map of deviation in a plot: colours, contours, limit, extremes, and where the horizontal field vanishes.

#include <QFont>

#include <memory>
#include <vector>

#include <qwt_plot_item.h>

#include "ui/plots/base/NiceScale.h"
#include "ui/plots/map/ContourPainting.h"
#include "ui/plots/map/MapCells.h"
#include "ui/plots/map/MapPicture.h"

namespace lubberline::ui {

class MapItem : public QwtPlotItem {
public:
    MapItem();

    /// `cells` of the picture's map.
    void setMap(const MapPicture& picture, std::shared_ptr<const MapCells> cells, const NiceScale& scale);
    void setLook(const QColor& ground, const QFont& font);

    bool contoursShown = true, limitShown = true, extremesShown = true;

    [[nodiscard]] const std::vector<double>& levels_deg() const { return m_levels_deg; }
    [[nodiscard]] const std::vector<ContourLine>& contours() const { return m_contours; }
    [[nodiscard]] const std::vector<ContourLine>& limitLines() const { return m_limitLines; }
    /// Of the last painting.
    [[nodiscard]] const std::vector<ContourLabel>& labels() const { return m_labels; }

    void draw(QPainter* painter, const QwtScaleMap& xMap, const QwtScaleMap& yMap, const QRectF& canvasRect) const override;

private:
    struct Maps;
    void drawColours(QPainter& painter, const Maps& maps) const;
    void drawHatch(QPainter& painter, const Maps& maps, std::vector<QRectF>& taken) const;
    void drawContours(QPainter& painter, const Maps& maps, std::vector<QRectF>& taken) const;
    void drawExtremes(QPainter& painter, const Maps& maps, std::vector<QRectF>& taken) const;
    void drawVanishing(QPainter& painter, const Maps& maps, std::vector<QRectF>& taken) const;
    void addStrokes(std::vector<ContourStroke>& strokes, const std::vector<ContourLine>& lines, const Maps& maps) const;

    MapPicture m_picture;
    std::shared_ptr<const MapCells> m_cells;
    NiceScale m_scale;
    std::vector<double> m_levels_deg;
    std::vector<ContourLine> m_contours, m_limitLines; ///< points in degrees
    QColor m_ground;
    QFont m_font;
    mutable std::vector<ContourLabel> m_labels;
};

} // namespace lubberline::ui
