#include "core/reference/Alignment.h"

#include <cmath>

#include "core/angle/Angle.h"

namespace lubberline {

ErrorBudget budgetOf(const TransferGyro& gyro)
{
    return {{{MARKED("core", "setting"), gyro.setting_deg}, {MARKED("core", "reading"), gyro.reading_deg},
        {MARKED("core", "drift"), std::abs(gyro.drift_deg_h) * gyro.minutes / 60}}};
}

ErrorBudget budgetOf(const RunwayAlignment& runway)
{
    const double off_rad = std::atan2(std::sqrt(2.0) * runway.offCentre_m, runway.wheelbase_m);
    return {{{MARKED("core", "published direction"), runway.published_deg}, {MARKED("core", "lining up"), toDegrees(off_rad)}}};
}

ErrorBudget budgetOf(const Place& place, UtcTime time, const SunSighting& sighting) { return sunBudget(place, time, sighting); }

ErrorBudget budgetOf(const SynchroTransmission& synchro)
{
    // Amplitudes at a heading that nobody chose: their root mean square.
    return {{{MARKED("core", "one-cycle error"), synchro.oneCycle_deg / std::sqrt(2.0)},
        {MARKED("core", "two-cycle error"), synchro.twoCycle_deg / std::sqrt(2.0)}}};
}

ErrorBudget withVariation(ErrorBudget budget, double variation_deg)
{
    budget.parts.push_back({MARKED("core", "variation"), variation_deg});
    return budget;
}

} // namespace lubberline
