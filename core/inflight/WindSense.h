#pragma once
/// Whether winds are what their file says: knots or metres a second, where they blow from or where to, headings from true north or magnetic.
/// With airspeeds the wind triangle closes to the last digit under one reading of the figures only; without them the reported wind is near
/// the reference under one only.

#include <array>
#include <cstdint>

#include "core/base/Message.h"
#include "core/inflight/WindReport.h"

namespace lubberline {

class WindSense {
public:
    /// Of a report with its ground velocity (east, north) and both winds as the file has them, blowing to [kt].
    void take(const WindReport& report, const double ground[2], const double wind[2], const double reference[2]);
    /// What is wrong, in words; empty where the file is right or the figures do not tell.
    [[nodiscard]] Message fault() const;
    [[nodiscard]] bool full() const { return m_count >= kEnough; }

private:
    static constexpr std::int64_t kEnough = 4000; ///< more need not be looked at
    static constexpr int kHypotheses = 6;         ///< from or to, by three units
    std::int64_t m_count = 0, m_triangles = 0;
    std::array<double, kHypotheses> m_triangle{};            ///< Σ (TAS − |V_G − h(W)|)²
    std::array<double, kHypotheses> m_apart{};               ///< Σ (W_ref − h(W))² along the track
    std::array<double, 2> m_airspeed{}, m_airspeedSquares{}; ///< of |V_G ∓ W_ref|
    double m_reference = 0;                                  ///< Σ W_ref² along the track
};

} // namespace lubberline
