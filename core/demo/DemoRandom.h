#pragma once
/// Random numbers that are the same everywhere: the standard's engines are exact, its distributions are not.

#include <cstdint>
#include <random>

namespace lubberline {

class DemoRandom {
public:
    explicit DemoRandom(std::uint64_t seed) : m_engine(seed) {}

    /// [0, 1)
    double unit() { return static_cast<double>(m_engine() >> 11) * 0x1p-53; }
    double between(double least, double most) { return least + (most - least) * unit(); }
    /// 0 … count − 1
    int below(int count) { return static_cast<int>(unit() * count); }
    /// Mean 0; twelve uniform numbers summed (Irwin and Hall) instead of a logarithm that differs in its last digit between
    /// libraries.
    double normal(double standardDeviation)
    {
        double sum = -6.0;
        for (int i = 0; i < 12; ++i)
            sum += unit();
        return sum * standardDeviation;
    }

private:
    std::mt19937_64 m_engine;
};

} // namespace lubberline
