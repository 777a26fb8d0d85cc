#include "core/sensor/map/Contours.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/Contract.h"

namespace lubberline {

namespace {

/// An edge between two nodes: horizontal ones are even, vertical ones odd.
using Edge = int;
constexpr Edge kNone = -1;

/// Lines of one level after the other; the memory for chaining is kept between them.
class March {
public:
    explicit March(const ContourGrid& grid)
        : m_grid(grid)
        , m_links(static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows) * 2, {kNone, kNone})
    {
    }

    void run(double level, std::vector<ContourLine>& lines)
    {
        m_level = level;
        m_touched.clear();
        for (int y = 0; y + 1 < m_grid.rows; ++y)
            for (int x = 0; x + 1 < m_grid.columns; ++x)
                cutCell(x, y);
        chain(lines);
    }

private:
    int node(int x, int y) const { return y * m_grid.columns + x; }
    double value(int node) const { return m_grid.values[static_cast<std::size_t>(node)]; }
    Edge horizontal(int x, int y) const { return 2 * node(x, y); }
    Edge vertical(int x, int y) const { return 2 * node(x, y) + 1; }

    void cutCell(int x, int y)
    {
        const std::array<int, 4> corners{node(x, y), node(x + 1, y), node(x + 1, y + 1), node(x, y + 1)};
        int above = 0;
        double least = value(corners[0]), most = least, sum = 0;
        for (int i = 0; i < 4; ++i) {
            const double v = value(corners[static_cast<std::size_t>(i)]);
            above |= v > m_level ? 1 << i : 0;
            least = std::min(least, v), most = std::max(most, v);
            sum += v;
        }
        if (above == 0 || above == 15 || (m_grid.jump > 0 && most - least > m_grid.jump) || !cellDefined(corners))
            return;
        const std::array<Edge, 4> edges{horizontal(x, y), vertical(x + 1, y), horizontal(x, y + 1), vertical(x, y)};
        if (above == 5 || above == 10) { // a saddle: the middle tells which corners belong together
            const bool middleAbove = sum / 4 > m_level;
            const bool cutsOffFirst = (above == 5) != middleAbove; // the lines cut off the corners 0 and 2, else 1 and 3
            join(edges[0], edges[cutsOffFirst ? 3 : 1]);
            join(edges[2], edges[cutsOffFirst ? 1 : 3]);
            return;
        }
        std::array<Edge, 2> crossed{};
        std::size_t count = 0;
        for (int i = 0; i < 4; ++i)
            if ((above >> i & 1) != (above >> ((i + 1) % 4) & 1))
                crossed[count++] = edges[static_cast<std::size_t>(i)];
        join(crossed[0], crossed[1]);
    }

    bool cellDefined(const std::array<int, 4>& corners) const
    {
        return m_grid.defined.empty() || std::all_of(corners.begin(), corners.end(), [this](int corner) {
            return m_grid.defined[static_cast<std::size_t>(corner)] != 0;
        });
    }

    void join(Edge a, Edge b)
    {
        link(a, b);
        link(b, a);
    }

    void link(Edge from, Edge to)
    {
        auto& links = m_links[static_cast<std::size_t>(from)];
        if (links[0] == kNone && links[1] == kNone)
            m_touched.push_back(from);
        links[links[0] == kNone ? 0 : 1] = to;
    }

    /// Where the level crosses an edge.
    ContourPoint pointOn(Edge edge) const
    {
        const int from = edge / 2, to = edge % 2 == 0 ? from + 1 : from + m_grid.columns;
        const double part = (m_level - value(from)) / (value(to) - value(from));
        const double x = from % m_grid.columns, y = from / m_grid.columns;
        return edge % 2 == 0 ? ContourPoint{x + part, y} : ContourPoint{x, y + part};
    }

    void unlink(Edge from, Edge to)
    {
        for (auto& link : m_links[static_cast<std::size_t>(from)])
            if (link == to) {
                link = kNone;
                return;
            }
    }

    /// Takes the chain that begins at an edge apart, link by link.
    ContourLine follow(Edge first)
    {
        ContourLine line{m_level, false, {pointOn(first)}};
        for (Edge here = first;;) {
            const auto& links = m_links[static_cast<std::size_t>(here)];
            const Edge next = links[0] != kNone ? links[0] : links[1];
            if (next == kNone)
                return line;
            unlink(here, next);
            unlink(next, here);
            if (next == first) {
                line.closed = true;
                return line;
            }
            line.points.push_back(pointOn(next));
            here = next;
        }
    }

    void chain(std::vector<ContourLine>& lines)
    {
        const auto ends = [this](Edge edge) {
            const auto& links = m_links[static_cast<std::size_t>(edge)];
            return (links[0] != kNone ? 1 : 0) + (links[1] != kNone ? 1 : 0);
        };
        for (const int wanted : {1, 2}) // open lines from their ends first; what is left is closed
            for (const Edge edge : m_touched)
                if (ends(edge) == wanted)
                    lines.push_back(follow(edge));
    }

    const ContourGrid& m_grid;
    std::vector<std::array<Edge, 2>> m_links;
    std::vector<Edge> m_touched;
    double m_level = 0;
};

} // namespace

std::vector<ContourLine> contoursOf(const ContourGrid& grid, std::span<const double> levels)
{
    const auto nodes = static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows);
    LUBBERLINE_EXPECT(
        grid.values.size() == nodes && (grid.defined.empty() || grid.defined.size() == nodes), "a grid has a value for each node");
    std::vector<ContourLine> lines;
    March march(grid);
    for (const double level : levels)
        march.run(level, lines);
    return lines;
}

std::vector<double> niceLevels(double largest, int wanted)
{
    if (!(largest > 0) || !std::isfinite(largest) || wanted < 1)
        return {0.0};
    const double least = 2 * largest / wanted, power = std::pow(10.0, std::floor(std::log10(least)));
    double step = 10 * power;
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= least * (1 - 1e-9)) {
            step = factor * power;
            break;
        }
    std::vector<double> levels;
    const int count = static_cast<int>(std::floor(largest / step * (1 + 1e-9)));
    for (int k = -count; k <= count; ++k)
        levels.push_back(k * step);
    return levels;
}

} // namespace lubberline
