#pragma once
/// The same mathematics once more, written without Eigen, FFTW or anything of core/deviation, in long double: what the program
/// is held against. Normal equations by Gauss elimination, plain sums for Fourier, bisection for the solve.

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

namespace lubberline::test {

using Real = long double;
inline constexpr Real kTurn = 2 * std::numbers::pi_v<Real>;

struct Pair {
    Real magnetic, compass; ///< rad
};

inline Real wrapped(Real angle) { return std::remainder(angle, kTurn); }

/// [P 3] by its definition.
inline Real exactDeviation(const std::array<Real, 5>& c, Real psi)
{
    const Real numerator = c[0] + c[1] * std::sin(psi) + c[2] * std::cos(psi) + c[3] * std::sin(2 * psi) + c[4] * std::cos(2 * psi);
    const Real denominator = 1 + c[1] * std::cos(psi) - c[2] * std::sin(psi) + c[3] * std::cos(2 * psi) - c[4] * std::sin(2 * psi);
    return std::atan2(numerator, denominator);
}

template <std::size_t N>
std::array<Real, N> solveNormal(const std::vector<std::array<Real, N>>& rows, const std::vector<Real>& right)
{
    std::array<std::array<Real, N + 1>, N> m{};
    for (std::size_t r = 0; r < rows.size(); ++r)
        for (std::size_t i = 0; i < N; ++i) {
            for (std::size_t j = 0; j < N; ++j)
                m[i][j] += rows[r][i] * rows[r][j];
            m[i][N] += rows[r][i] * right[r];
        }
    for (std::size_t column = 0; column < N; ++column) {
        std::size_t pivot = column;
        for (std::size_t i = column + 1; i < N; ++i)
            if (std::abs(m[i][column]) > std::abs(m[pivot][column]))
                pivot = i;
        std::swap(m[column], m[pivot]);
        for (std::size_t i = 0; i < N; ++i)
            if (i != column) {
                const Real factor = m[i][column] / m[column][column];
                for (std::size_t j = column; j <= N; ++j)
                    m[i][j] -= factor * m[column][j];
            }
    }
    std::array<Real, N> solution;
    for (std::size_t i = 0; i < N; ++i)
        solution[i] = m[i][N] / m[i][i];
    return solution;
}

inline std::array<Real, 5> independentApproximate(const std::vector<Pair>& readings)
{
    std::vector<std::array<Real, 5>> rows;
    std::vector<Real> right;
    for (const auto& [psi, z] : readings) {
        rows.push_back({1, std::sin(z), std::cos(z), std::sin(2 * z), std::cos(2 * z)});
        right.push_back(wrapped(psi - z));
    }
    return solveNormal<5>(rows, right);
}

inline std::array<Real, 5> independentExact(const std::vector<Pair>& readings)
{
    std::vector<std::array<Real, 5>> rows;
    std::vector<Real> right;
    for (const auto& [psi, z] : readings) {
        const Real delta = wrapped(psi - z);
        rows.push_back({std::cos(delta), std::sin(z), std::cos(z), std::sin(psi + z), std::cos(psi + z)});
        right.push_back(std::sin(delta));
    }
    return solveNormal<5>(rows, right);
}

/// A swing as a sensor with these exact coefficients would give it, with reading noise [rad].
inline std::vector<Pair> simulatedSwing(
    const std::array<Real, 5>& coefficients, int points, Real noise, std::mt19937& random, Real offset = 0)
{
    std::normal_distribution<double> normal;
    std::vector<Pair> readings;
    for (int i = 0; i < points; ++i) {
        const Real psi = std::fmod(offset + kTurn * i / points, kTurn);
        readings.push_back({psi, psi - exactDeviation(coefficients, psi) + noise * normal(random)});
    }
    return readings;
}

} // namespace lubberline::test
