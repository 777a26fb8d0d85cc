#pragma once
/// Where a scenario takes the aircraft, step by step.

#include <algorithm>
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

} // namespace lubberline
