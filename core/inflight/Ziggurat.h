#pragma once
/// Standard normal numbers by the million, for simulations whose figures nobody has seen yet: FleetRandom::normal() takes a logarithm and a
/// sine, and what was drawn with it has to be drawn again to the last digit.

#include <array>
#include <cmath>

#include "core/fleet/FleetRandom.h"

namespace lubberline {

/// The normal density in 128 layers of equal area: 97 of 100 numbers are one multiplication [Marsaglia & Tsang 2000, in Doornik's form 2005].
class Ziggurat {
public:
    Ziggurat()
    {
        m_edge[0] = kArea / density(kTail);
        m_edge[1] = kTail;
        for (std::size_t i = 2; i < kLayers; ++i)
            m_edge[i] = std::sqrt(-2.0 * std::log(kArea / m_edge[i - 1] + density(m_edge[i - 1])));
        for (std::size_t i = 0; i < kLayers; ++i)
            m_within[i] = m_edge[i + 1] / m_edge[i];
    }

    double operator()(FleetRandom& random) const
    {
        for (;;) {
            const std::uint64_t bits = random.bits();
            const std::size_t layer = bits % kLayers;
            const double across = static_cast<double>(static_cast<std::int64_t>(bits) >> 11) * 0x1p-52; // [−1, 1)
            if (std::abs(across) < m_within[layer])
                return across * m_edge[layer];
            if (layer == 0)
                return std::copysign(beyondTail(random), across);
            const double x = across * m_edge[layer];
            const double outer = std::exp(-0.5 * (m_edge[layer] * m_edge[layer] - x * x));
            const double inner = std::exp(-0.5 * (m_edge[layer + 1] * m_edge[layer + 1] - x * x));
            if (inner + random.unit() * (outer - inner) < 1.0)
                return x;
        }
    }

private:
    static constexpr std::size_t kLayers = 128;
    static constexpr double kTail = 3.442619855899, kArea = 9.91256303526217e-3; ///< where the lowest layer's tail begins; of each layer
    static double density(double x) { return std::exp(-0.5 * x * x); }

    static double beyondTail(FleetRandom& random)
    {
        double x = 0, y = 0;
        do {
            x = std::log(random.unit()) / kTail;
            y = std::log(random.unit());
        } while (-2.0 * y < x * x);
        return kTail - x;
    }

    std::array<double, kLayers + 1> m_edge{}; ///< of the layers, from the lowest; the last is 0
    std::array<double, kLayers> m_within{};   ///< share of a layer that lies below the density
};

} // namespace lubberline
