#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/angle/Angle.h"
#include "core/sensor/map/Contours.h"

namespace lubberline {
namespace {

struct Field {
    int columns, rows;
    std::vector<double> values;
    template <class F>
    Field(int width, int height, F f) : columns(width)
                                      , rows(height)
    {
        for (int y = 0; y < rows; ++y)
            for (int x = 0; x < columns; ++x)
                values.push_back(f(x, y));
    }
    std::vector<ContourLine> lines(std::vector<double> levels, std::span<const std::uint8_t> defined = {}, double jump = 0) const
    {
        return contoursOf({values, defined, columns, rows, jump}, levels);
    }
};

TEST(Contours, aCircleIsOneClosedLineOfItsRadius)
{
    const Field field(41, 41, [](int x, int y) { return std::hypot(x - 20, y - 20); });
    const auto lines = field.lines({10.5});
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_TRUE(lines[0].closed);
    for (const auto& point : lines[0].points)
        EXPECT_NEAR(std::hypot(point.x - 20, point.y - 20), 10.5, 0.02);
    double length = 0;
    for (std::size_t i = 0; i < lines[0].points.size(); ++i) {
        const auto &a = lines[0].points[i], &b = lines[0].points[(i + 1) % lines[0].points.size()];
        length += std::hypot(a.x - b.x, a.y - b.y);
    }
    EXPECT_NEAR(length, 2 * kPi * 10.5, 0.2);
}

TEST(Contours, straightLinesEndAtTheEdges)
{
    const Field field(11, 6, [](int x, int) { return x; });
    const auto lines = field.lines({2.5, 7.0});
    ASSERT_EQ(lines.size(), 2u);
    for (const auto& line : lines) {
        EXPECT_FALSE(line.closed);
        EXPECT_EQ(line.points.size(), 6u);
        EXPECT_EQ(std::abs(line.points.front().y - line.points.back().y), 5.0);
        for (const auto& point : line.points)
            EXPECT_DOUBLE_EQ(point.x, line.level);
    }
}

TEST(Contours, aSaddleIsCutAsItsMiddleSays)
{
    const Field high(2, 2, [](int x, int y) { return x == y ? 1.0 : -0.5; }); // mean +0.25
    const Field low(2, 2, [](int x, int y) { return x == y ? 0.5 : -1.0; });  // mean −0.25
    const auto highLines = high.lines({0.0}), lowLines = low.lines({0.0});
    ASSERT_EQ(highLines.size(), 2u);
    ASSERT_EQ(lowLines.size(), 2u);
    // Where the middle is above, the corners that are above are joined: each line cuts off a corner that is below.
    const auto cutsOff = [](const ContourLine& line, double x, double y) {
        const auto &a = line.points.front(), &b = line.points.back();
        return std::hypot(a.x - x, a.y - y) < 1 && std::hypot(b.x - x, b.y - y) < 1;
    };
    for (const auto& line : highLines)
        EXPECT_TRUE(cutsOff(line, 1, 0) || cutsOff(line, 0, 1));
    for (const auto& line : lowLines)
        EXPECT_TRUE(cutsOff(line, 0, 0) || cutsOff(line, 1, 1));
}

TEST(Contours, undefinedCellsAndJumpsAreLeftOut)
{
    const Field field(21, 5, [](int x, int) { return x <= 10 ? 0.3 * x : 0.3 * x - 2 * kPi; }); // an angle that jumps at column 10
    EXPECT_EQ(field.lines({0.0}).size(), 1u + 1u); // at column 0 the level is met from above only: see below; and at the jump
    EXPECT_EQ(field.lines({-1.0}, {}, kPi).size(), 1u);
    std::vector<std::uint8_t> defined(field.values.size(), 1);
    for (int x = 0; x < 21; ++x)
        defined[static_cast<std::size_t>(2 * 21 + x)] = 0; // the middle row
    const auto lines = Field(21, 5, [](int x, int) { return x; }).lines({4.5}, defined);
    EXPECT_EQ(lines.size(), 2u); // above and below it
}

TEST(Contours, levelsOnNodesGiveWholeLines)
{
    const Field field(9, 9, [](int x, int y) { return x + y; });
    const auto lines = field.lines({8.0});
    ASSERT_EQ(lines.size(), 1u);
    for (const auto& point : lines[0].points)
        EXPECT_NEAR(point.x + point.y, 8.0, 1e-12);
    EXPECT_TRUE(Field(5, 5, [](int, int) { return 3.0; }).lines({3.0}).empty());
}

/// Hills and hollows: along each line the value is the level (linear on the edges of cells), and only edges of the map end
/// lines.
TEST(Contours, ofHillsAreOnTheirLevelAndEndAtEdgesOnly)
{
    const Field field(61, 47, [](int x, int y) { return 5 * std::sin(0.21 * x) * std::cos(0.17 * y) + 2 * std::sin(0.11 * (x + 2 * y)); });
    const auto at = [&](double x, double y) {
        const int column = std::min(static_cast<int>(x), 59), row = std::min(static_cast<int>(y), 45);
        const double u = x - column, v = y - row;
        const auto value = [&](int dx, int dy) { return field.values[static_cast<std::size_t>((row + dy) * 61 + column + dx)]; };
        return (1 - v) * ((1 - u) * value(0, 0) + u * value(1, 0)) + v * ((1 - u) * value(0, 1) + u * value(1, 1));
    };
    const auto atEdge = [](const ContourPoint& point) { return point.x == 0 || point.x == 60 || point.y == 0 || point.y == 46; };
    const auto lines = field.lines(niceLevels(7, 20));
    int closed = 0;
    for (const auto& line : lines) {
        ASSERT_GE(line.points.size(), 2u);
        closed += line.closed;
        for (const auto& point : line.points)
            EXPECT_NEAR(at(point.x, point.y), line.level, 1e-12);
        for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
            const auto &a = line.points[i], &b = line.points[i + 1];
            EXPECT_LT(std::hypot(a.x - b.x, a.y - b.y), 1.42) << "no step leaves its cell";
        }
        EXPECT_EQ(atEdge(line.points.front()) && atEdge(line.points.back()), !line.closed);
    }
    EXPECT_GT(closed, 5);
    EXPECT_GT(static_cast<int>(lines.size()), closed);
}

TEST(NiceLevels, stepsOfOneTwoFive)
{
    EXPECT_EQ(niceLevels(10, 10), (std::vector<double>{-10, -8, -6, -4, -2, 0, 2, 4, 6, 8, 10}));
    const auto small = niceLevels(0.3, 12);
    EXPECT_EQ(small.size(), 13u);
    EXPECT_NEAR(small.back(), 0.3, 1e-12);
    EXPECT_EQ(niceLevels(0, 10), std::vector<double>{0.0});
    EXPECT_EQ(niceLevels(std::nan(""), 10), std::vector<double>{0.0});
}

} // namespace
} // namespace lubberline
