#pragma once
/// Work on each of many, in order of nobody: who takes which changes nothing of what comes out. Progress is asked where it was begun.

#include <algorithm>

#include "core/base/Alongside.h"
#include "core/base/Progress.h"

namespace lubberline {

/// @param each takes a place below `count`, and touches nothing that it touches for another one. @param together  places that one hand
/// takes at a time: few where each is long. @return false: cancelled
template <class Each>
bool byTwoHands(std::size_t count, std::size_t together, const Progress& progress, const Each& each)
{
    constexpr std::size_t turns = 64; // between two looks at the progress
    for (std::size_t first = 0; first < count; first += turns * together) {
        if (progress && !progress(static_cast<double>(first) / static_cast<double>(count)))
            return false;
        const std::size_t last = std::min(count, first + turns * together);
        alongside((last - first + together - 1) / together, [&](std::size_t turn) {
            const std::size_t from = first + turn * together;
            for (std::size_t place = from; place < std::min(last, from + together); ++place)
                each(place);
        });
    }
    return true;
}

} // namespace lubberline
