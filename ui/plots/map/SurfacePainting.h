#pragma once
/// The surface, its box and its axes.

#include <QFont>

#include <optional>
#include <vector>

#include "ui/plots/base/NiceScale.h"
#include "ui/plots/base/PlotColours.h"
#include "ui/plots/map/MapCells.h"
#include "ui/plots/map/MapPicture.h"
#include "ui/plots/map/SurfaceProjection.h"

namespace lubberline::ui {

/// The nodes that are drawn: at most so many columns and rows, both ends among them.
class SurfaceMesh {
public:
    SurfaceMesh(const MapCells& cells, double scale_deg, int mostColumns, int mostRows);

    struct Node {
        BoxPoint at;
        double value_deg = 0;
        bool defined = true;
    };
    [[nodiscard]] int columns() const { return m_columns; }
    [[nodiscard]] int rows() const { return m_rows; }
    [[nodiscard]] const Node& node(int x, int y) const { return m_nodes[static_cast<std::size_t>(y) * m_columns + x]; }
    /// None where a corner is undefined or the angle jumps: there is no surface.
    [[nodiscard]] std::optional<double> middle_deg(int x, int y) const;

private:
    int m_columns = 0, m_rows = 0;
    std::vector<Node> m_nodes;
};

struct SurfaceLook {
    NiceScale scale;
    PlotColours colours;
    QFont font;
    bool turning = false; ///< no smooth edges and no mesh
    QRectF within = {};   ///< labels stay in it, however the box is turned
};

void paintSurface(QPainter& painter, const QRectF& room, const MapPicture& picture, const SurfaceMesh& mesh,
    const SurfaceProjection& project, const SurfaceLook& look);

/// The room that the box leaves to its labels.
[[nodiscard]] QRectF boxRoom(const QRectF& rect, const QFont& font);

/// The node drawn in front of all others at a place, as (x, y).
[[nodiscard]] std::optional<QPoint> nodeAt(const SurfaceMesh& mesh, const SurfaceProjection& project, QPointF at);

} // namespace lubberline::ui
