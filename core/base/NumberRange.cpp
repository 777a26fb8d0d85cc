#include "core/base/NumberRange.h"

#include "core/base/Number.h"

namespace lubberline {

Message inWords(const NumberRange& range)
{
    const bool above = range.least > std::numeric_limits<double>::lowest(), below = range.most < std::numeric_limits<double>::max();
    if (above && below)
        return Message{MARKED("core", "a number from %1 to %2"), shortestNumber(range.least), shortestNumber(range.most)};
    if (above)
        return Message{MARKED("core", "a number from %1 up"), shortestNumber(range.least)};
    return MARKED("core", "a number");
}

} // namespace lubberline
