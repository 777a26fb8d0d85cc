#include "ui/plots/map/SurfacePainting.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>

#include "ui/plots/map/DivergingMap.h"
#include "ui/plots/map/MapMarks.h"
#include "ui/plots/map/MapText.h"
#include "ui/plots/map/SurfaceAxes.h"

namespace lubberline::ui {

namespace {

constexpr int kMeshLines = 24; ///< along the longer side, about

/// The node of the map for one of `count` that are drawn; both ends are among them.
int nodeFor(int drawn, int count, int nodes) { return static_cast<int>(std::lround(drawn * (nodes - 1.0) / (count - 1))); }

/// Indices of cells from the far side to the near one.
struct Walk {
    int first, step, count;
    [[nodiscard]] int at(int i) const { return first + i * step; }
};
Walk walkFrom(int farSide, int cells) { return farSide > 0 ? Walk{cells - 1, -1, cells} : Walk{0, 1, cells}; }

QColor meshColour(const QColor& fill) { return fill.darker(135); }

class SurfacePainter {
public:
    SurfacePainter(QPainter& painter, const SurfaceMesh& mesh, const SurfaceProjection& project, const SurfaceLook& look)
        : m_painter(painter)
        , m_mesh(mesh)
        , m_look(look)
        , m_every(std::max(1, (std::max(mesh.columns(), mesh.rows()) - 1) / kMeshLines))
    {
        m_points.reserve(static_cast<std::size_t>(mesh.columns()) * mesh.rows());
        for (int y = 0; y < mesh.rows(); ++y) {
            for (int x = 0; x < mesh.columns(); ++x)
                m_points.push_back(project(mesh.node(x, y).at));
        }
    }

    void paint(const SurfaceProjection& project)
    {
        m_painter.setRenderHint(QPainter::Antialiasing, !m_look.turning);
        if (m_look.turning)
            m_painter.setPen(Qt::NoPen);
        const Walk down = walkFrom(project.farY(), m_mesh.rows() - 1), across = walkFrom(project.farX(), m_mesh.columns() - 1);
        for (int j = 0; j < down.count; ++j) {
            for (int i = 0; i < across.count; ++i)
                paintCell(across.at(i), down.at(j));
        }
    }

private:
    void paintCell(int x, int y)
    {
        const auto middle_deg = m_mesh.middle_deg(x, y);
        if (!middle_deg)
            return;
        const QColor fill = divergingColour(divergingStep(*middle_deg / m_look.scale.end));
        const std::array<QPointF, 4> corners{point(x, y), point(x + 1, y), point(x + 1, y + 1), point(x, y + 1)};
        if (!m_look.turning)
            m_painter.setPen(QPen(fill, 0.8)); // or the ground would shine through the seams
        m_painter.setBrush(fill);
        m_painter.drawConvexPolygon(corners.data(), 4);
        if (m_look.turning)
            return;
        m_painter.setPen(QPen(meshColour(fill), 0.8));
        const auto edge = [&](bool wanted, std::size_t from, std::size_t to) {
            if (wanted)
                m_painter.drawLine(corners[from], corners[to]);
        };
        edge(y % m_every == 0, 0, 1);
        edge((y + 1) % m_every == 0, 3, 2);
        edge(x % m_every == 0, 0, 3);
        edge((x + 1) % m_every == 0, 1, 2);
    }

    /// The steps of the table: neighbouring cells then often share a colour, and files stay small.
    static double divergingStep(double fraction) { return std::round(fraction * 64) / 64; }
    [[nodiscard]] QPointF point(int x, int y) const { return m_points[static_cast<std::size_t>(y) * m_mesh.columns() + x]; }

    QPainter& m_painter;
    const SurfaceMesh& m_mesh;
    const SurfaceLook& m_look;
    int m_every;
    std::vector<QPointF> m_points;
};

BoxPoint boxPoint(const MapRequest& request, double x_deg, double y_deg, double part)
{
    const auto along = [](const MapAxis& axis, double value_deg) {
        return 2 * (value_deg - axis.range.from_deg) / (axis.range.to_deg - axis.range.from_deg) - 1;
    };
    return {along(request.x, x_deg), along(request.y, y_deg), std::clamp(part, -1.0, 1.0)};
}

void paintMarks(QPainter& painter, const QRectF& room, const MapPicture& picture, const SurfaceProjection& project, const SurfaceLook& look)
{
    painter.setRenderHint(QPainter::Antialiasing);
    std::vector<QRectF> taken;
    const MapRequest& request = picture.map->request;
    for (const MapExtreme& extreme : picture.extremes) {
        const double value_deg = toDegrees(extreme.deviation_rad);
        paintExtreme(painter, project(boxPoint(request, extreme.x_deg, extreme.y_deg, value_deg / look.scale.end)), extreme.maximum,
            mapValueText(value_deg), {room, taken}, look.font);
    }
    for (const VanishingPlace& place : picture.vanishing)
        paintCross(painter, project(boxPoint(request, place.x_deg, place.y_deg, 0)), vanishingText(), {room, taken}, look.font);
}

bool contains(const std::array<QPointF, 4>& corners, QPointF at)
{
    bool inside = false;
    for (std::size_t i = 0, j = 3; i < 4; j = i++) {
        const QPointF a = corners[i], b = corners[j];
        if ((a.y() > at.y()) != (b.y() > at.y()) && at.x() < (b.x() - a.x()) * (at.y() - a.y()) / (b.y() - a.y()) + a.x())
            inside = !inside;
    }
    return inside;
}

} // namespace

SurfaceMesh::SurfaceMesh(const MapCells& cells, double scale_deg, int mostColumns, int mostRows)
{
    m_columns = std::min(cells.columns(), mostColumns);
    m_rows = std::min(cells.rows(), mostRows);
    m_nodes.reserve(static_cast<std::size_t>(m_columns) * m_rows);
    const MapRequest& request = cells.request();
    for (int row = 0; row < m_rows; ++row) {
        const int y = nodeFor(row, m_rows, cells.rows());
        for (int column = 0; column < m_columns; ++column) {
            const int x = nodeFor(column, m_columns, cells.columns());
            const double value_deg = cells.node_deg(x, y);
            m_nodes.push_back(
                {boxPoint(request, request.x.at_deg(x), request.y.at_deg(y), value_deg / scale_deg), value_deg, cells.defined(x, y)});
        }
    }
}

std::optional<double> SurfaceMesh::middle_deg(int x, int y) const
{
    const std::array<const Node*, 4> corners{&node(x, y), &node(x + 1, y), &node(x, y + 1), &node(x + 1, y + 1)};
    double sum = 0, least = corners[0]->value_deg, most = least;
    for (const Node* corner : corners) {
        if (!corner->defined)
            return std::nullopt;
        sum += corner->value_deg;
        least = std::min(least, corner->value_deg);
        most = std::max(most, corner->value_deg);
    }
    return most - least > kJump_deg ? std::nullopt : std::optional(sum / 4);
}

void paintSurface(QPainter& painter, const QRectF& room, const MapPicture& picture, const SurfaceMesh& mesh,
    const SurfaceProjection& project, const SurfaceLook& look)
{
    painter.save();
    painter.setFont(look.font);
    const SurfaceAxes axes(picture, project, look);
    axes.paintBehind(painter);
    SurfacePainter(painter, mesh, project, look).paint(project);
    painter.setRenderHint(QPainter::Antialiasing);
    axes.paintBefore(painter);
    paintMarks(painter, room, picture, project, look);
    painter.restore();
}

QRectF boxRoom(const QRectF& rect, const QFont& font)
{
    const QFontMetricsF metrics(font);
    const double aside = metrics.horizontalAdvance(QStringLiteral("000 N")) + 10, below = 2.4 * metrics.height();
    const QRectF room = rect.adjusted(aside + metrics.height(), metrics.height(), -aside, -below);
    return room.isValid() ? room : QRectF(rect.center() - QPointF(1, 1), QSizeF(2, 2));
}

std::optional<QPoint> nodeAt(const SurfaceMesh& mesh, const SurfaceProjection& project, QPointF at)
{
    const Walk down = walkFrom(-project.farY(), mesh.rows() - 1), across = walkFrom(-project.farX(), mesh.columns() - 1);
    for (int j = 0; j < down.count; ++j) {
        for (int i = 0; i < across.count; ++i) {
            const int x = across.at(i), y = down.at(j);
            if (mesh.middle_deg(x, y)
                && contains({project(mesh.node(x, y).at), project(mesh.node(x + 1, y).at), project(mesh.node(x + 1, y + 1).at),
                                project(mesh.node(x, y + 1).at)},
                    at))
                return QPoint(x, y);
        }
    }
    return std::nullopt;
}

} // namespace lubberline::ui
