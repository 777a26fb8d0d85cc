#include "core/record/NorthTwice.h"

#include <cmath>

namespace lubberline {

NorthTwice settleNorthTwice(const Reading& earlier, Reading& later, bool byCompass)
{
    constexpr double kSame_deg = 1e-9;
    if (!earlier.used() || !later.used())
        return NorthTwice::Settled;
    const auto read_deg
        = [byCompass](const Reading& reading) { return byCompass ? reading.magnetic->degrees() : reading.compass->degrees(); };
    if (std::abs(wrap180(read_deg(earlier) - read_deg(later))) > kSame_deg)
        return NorthTwice::Differs;
    later.exclusion = Exclusion{"listed twice: 000 and 360 are one heading"};
    return NorthTwice::CountsOnce;
}

} // namespace lubberline
