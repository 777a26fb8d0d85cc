#pragma once
/// Where a scenario takes the aircraft, step by step.

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

#include "core/base/Message.h"
#include "core/reference/Scenario.h"

namespace lubberline {

/// At the beginning of a step; rates and accelerations are those over the step.
struct MotionPoint {
    double heading_rad = 0; ///< magnetic, not wrapped
    double sinHeading = 0, cosHeading = 1;
    double turnRate_rad_s = 0;
    double speed_m_s = 0;
    double forward_m_s2 = 0;   ///< dV/dt
    double starboard_m_s2 = 0; ///< V ψ̇
    double up_m_s2 = 0;
    double climb_m_s = 0;
    double gustForward_m_s2 = 0, gustStarboard_m_s2 = 0;
    double earthStarboard_m_s2 = 0; ///< Coriolis, and the parallel that is flown along [K 9.8]
    [[nodiscard]] double sensedForward_m_s2() const { return forward_m_s2 + gustForward_m_s2; }
    [[nodiscard]] double sensedStarboard_m_s2() const { return starboard_m_s2 + gustStarboard_m_s2 + earthStarboard_m_s2; }
    [[nodiscard]] double gravity_m_s2() const { return std::max(kGravity_m_s2 + up_m_s2, 0.1); } ///< weightless: no vertical at all
};

struct Motion {
    std::vector<MotionPoint> points; ///< one a step, and the end
    std::vector<Message> warnings;
};

/// Within this latitude terms in tan Φ are flown; nearer to a pole they are left out, and it is told.
inline constexpr double kPoleward_deg = 89;

[[nodiscard]] Motion motionOf(const Scenario& scenario);

/// The same, some points after others: a long flight is carried through its instruments in parts that stay near the processor.
class MotionParts {
public:
    explicit MotionParts(const Scenario& scenario);
    ~MotionParts();
    /// All points, whether they were made or not.
    [[nodiscard]] std::size_t size() const { return m_size; }
    /// The next ones, at most so many; none: the flight is over.
    void next(std::vector<MotionPoint>& points, std::size_t most);
    /// Of what was flown so far.
    [[nodiscard]] std::vector<Message> warnings() const;

private:
    void takeManoeuvres(std::vector<MotionPoint>& points) const;
    void takeGusts(std::vector<MotionPoint>& points);
    void fly(std::vector<MotionPoint>& points);

    const Scenario& m_scenario;
    std::size_t m_size, m_from = 0;
    struct Random; ///< gusts that are not regular
    std::unique_ptr<Random> m_gusts;
    double m_heading_rad, m_speed_m_s;
    bool m_stood = false; ///< it came to a stand and was told to go slower still
    double m_fastest_m_s = 0, m_turning_rad_s = 0, m_pulled2_m2_s4 = 0;
};

} // namespace lubberline
