#pragma once

#include <mutex>

namespace lubberline {

/// FFTW runs plans from any thread, but makes plans without any lock: whoever makes one holds this one.
inline std::mutex& fourierPlannerMutex()
{
    static std::mutex mutex;
    return mutex;
}

} // namespace lubberline
