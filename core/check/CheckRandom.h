#pragma once

#include <cmath>
#include <cstdint>
#include <random>

#include "core/angle/Angle.h"

namespace lubberline {

/// Random numbers that are the same on every machine.
class CheckRandom {
public:
    explicit CheckRandom(std::uint64_t seed) : m_engine(seed) {}
    [[nodiscard]] double uniform() { return (static_cast<double>(m_engine() >> 11) + 0.5) * 0x1p-53; } ///< within (0, 1)
    [[nodiscard]] double normal()
    {
        const double size = std::sqrt(-2 * std::log(uniform()));
        return size * std::cos(2 * kPi * uniform());
    }

private:
    std::mt19937_64 m_engine;
};

} // namespace lubberline
