#pragma once
/// 000 and 360 are one heading. Tables that close the circle list it twice.

#include "core/record/Swing.h"

namespace lubberline {

enum class NorthTwice {
    Settled,    ///< one of them does not count, or is not complete: nothing to tell
    CountsOnce, ///< the same reading: the later one was left out, with its reason
    Differs,    ///< both count; somebody should look which is right
};

/// @param byCompass  whether the rows are listed by compass headings, not by magnetic ones.
NorthTwice settleNorthTwice(const Reading& earlier, Reading& later, bool byCompass);

} // namespace lubberline
