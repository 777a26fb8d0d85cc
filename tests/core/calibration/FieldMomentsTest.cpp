#include "core/calibration/FieldMoments.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace lubberline::test {
namespace {

/// Blocks, rests and left-out points give the sums of the plain loop.
TEST(FieldMoments, areThePlainSums)
{
    constexpr std::size_t kPoints = 1111; // four blocks and a rest
    std::array<std::vector<double>, 3> columns;
    std::vector<std::uint8_t> used;
    for (std::size_t i = 0; i < kPoints; ++i) {
        const auto x = static_cast<double>(i);
        columns[0].push_back(std::sin(x));
        columns[1].push_back(std::cos(0.7 * x) + 0.2);
        columns[2].push_back(std::sin(1.3 * x + 1));
        used.push_back(i < 300 || i % 7 != 0 ? 1 : 0);
        if (used.back() == 0)
            columns[i % 3].back() = std::nan("");
    }
    const Eigen::Vector3d centre(0.1, -0.2, 0.3);
    const auto moments = momentsOf({columns[0], columns[1], columns[2]}, used, centre, 2.0);
    for (int a = 0; a <= 4; ++a)
        for (int b = 0; a + b <= 4; ++b)
            for (int c = 0; a + b + c <= 4; ++c) {
                double sum = 0;
                for (std::size_t i = 0; i < kPoints; ++i)
                    if (used[i] != 0)
                        sum += std::pow((columns[0][i] - 0.1) / 2, a) * std::pow((columns[1][i] + 0.2) / 2, b)
                            * std::pow((columns[2][i] - 0.3) / 2, c);
                EXPECT_NEAR(moments.of(a, b, c), sum, 1e-9) << a << b << c;
            }
}

} // namespace
} // namespace lubberline::test
