#pragma once
/// What time it is. Everything that stores, signs or prints a time is given a Clock; nothing else asks the machine (tests/structure holds
/// the sources against that), so that a test can say what day it is.

#include <chrono>
#include <functional>
#include <string>

#include "core/base/Date.h"

namespace lubberline {

/// Always UTC: the day that is stored does not depend on where the laptop thinks it is. Near midnight it is not the crew's day.
struct Clock {
    using Time = std::chrono::sys_time<std::chrono::milliseconds>;
    std::function<Time()> now;

    [[nodiscard]] Date today() const;            ///< 2026-11-26
    [[nodiscard]] std::string nowUtc() const;    ///< "2026-11-26T11:05:09Z", cut to the second
    [[nodiscard]] std::string nowUtc_ms() const; ///< "2026-11-26T11:05:09.120Z"
};

/// That of the machine: for the composition root, and what is opened without another.
[[nodiscard]] Clock machineClock();

} // namespace lubberline
