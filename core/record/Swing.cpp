#include "core/record/Swing.h"

namespace lubberline {

std::vector<std::size_t> usedReadings(const Swing& swing)
{
    std::vector<std::size_t> used;
    used.reserve(swing.readings.size());
    for (std::size_t i = 0; i < swing.readings.size(); ++i)
        if (swing.readings[i].used())
            used.push_back(i);
    return used;
}

} // namespace lubberline
