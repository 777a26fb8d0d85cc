#pragma once
/// Random numbers for simulated quantiles, whose seeds come from the contents that are asked about: the same records give the same
/// figures to the last digit, whatever their order, ids or threads.

#include <bit>
#include <cmath>
#include <cstdint>
#include <random>

#include "core/angle/Angle.h"

namespace lubberline {

/// Gathers contents into a seed (FNV-1a over the bits).
class ContentSeed {
public:
    ContentSeed& add(std::uint64_t bits)
    {
        for (int byte = 0; byte < 8; ++byte, bits >>= 8)
            m_hash = (m_hash ^ (bits & 0xff)) * 0x100000001b3ULL;
        return *this;
    }
    ContentSeed& add(double value) { return add(std::bit_cast<std::uint64_t>(value + 0.0)); } // −0 is 0
    ContentSeed& add(int value) { return add(static_cast<std::uint64_t>(static_cast<std::int64_t>(value))); }
    [[nodiscard]] std::uint64_t value() const { return m_hash; }

private:
    std::uint64_t m_hash = 0xcbf29ce484222325ULL;
};

class FleetRandom {
public:
    explicit FleetRandom(std::uint64_t seed) : m_engine(seed) {}
    std::uint64_t bits() { return m_engine(); }
    /// (0, 1)
    double unit() { return (static_cast<double>(m_engine() >> 12) + 0.5) * 0x1p-52; }
    /// Mean 0, standard deviation 1 (Box and Muller).
    double normal()
    {
        if (m_kept) {
            m_kept = false;
            return m_other;
        }
        const double radius = std::sqrt(-2.0 * std::log(unit())), turn = 2.0 * kPi * unit();
        m_other = radius * std::sin(turn);
        m_kept = true;
        return radius * std::cos(turn);
    }
    /// Gamma of a shape ≥ ½ and scale 1 (Marsaglia and Tsang).
    double gamma(double shape)
    {
        if (shape < 1.0)
            return gamma(shape + 1.0) * std::pow(unit(), 1.0 / shape);
        const double d = shape - 1.0 / 3.0, c = 1.0 / std::sqrt(9.0 * d);
        for (;;) {
            const double x = normal(), v = std::pow(1.0 + c * x, 3);
            if (v > 0 && std::log(unit()) < 0.5 * x * x + d - d * v + d * std::log(v))
                return d * v;
        }
    }
    double chiSquare(int degrees) { return 2.0 * gamma(0.5 * degrees); }

private:
    std::mt19937_64 m_engine;
    double m_other = 0;
    bool m_kept = false;
};

} // namespace lubberline
