#pragma once
/// Lines of equal value on a grid of nodes, by marching squares: chains of points, ready to be drawn and labelled.

#include <cstdint>
#include <span>
#include <vector>

namespace lubberline {

struct ContourPoint {
    double x = 0, y = 0; ///< in nodes: 0 … nodes − 1, linear between them
};
struct ContourLine {
    double level = 0;
    bool closed = false;
    std::vector<ContourPoint> points;
};

struct ContourGrid {
    std::span<const double> values;        ///< rows follow y
    std::span<const std::uint8_t> defined; ///< empty: all are
    int columns = 0, rows = 0;
    /// Cells whose corners differ by more than this are left out: there an angle jumps from +180° to −180°. 0: none is.
    double jump = 0;
};

/// A level equal to a node's value is taken as just below it, so that no line ends there.
[[nodiscard]] std::vector<ContourLine> contoursOf(const ContourGrid& grid, std::span<const double> levels);

/// Levels at steps of 1-2-5 × 10ⁿ within [−largest, largest], zero among them, about `wanted` of them.
[[nodiscard]] std::vector<double> niceLevels(double largest, int wanted);

} // namespace lubberline
