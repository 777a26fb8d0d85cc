#pragma once
/// A sensor on a coil bench as it was recorded: what was applied and what it measured. What that tells is recomputed
/// (core/coil/CoilBench.h).

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "core/base/Date.h"
#include "core/record/Id.h"

namespace lubberline {

struct CoilBench {
    RecordId record;
    Date date;                                   ///< stated: benches are compared by it
    std::string serialNumber;                    ///< of the sensor; empty: not stated
    std::string log;                             ///< name of the file
    std::string note;                            ///< the bench, its coil, who did it
    bool inCounts = false;                       ///< what was measured; else in nT
    std::vector<std::array<double, 6>> readings; ///< applied x, y, z [nT], measured x, y, z; whole ones alone, in order
    std::vector<double> temperature_c;           ///< of each; empty: not read
    friend bool operator==(const CoilBench&, const CoilBench&) = default;
};

/// Readings are kept whole, and read again with each result of the compass: a bench takes hundreds.
inline constexpr std::size_t kMostCoilReadings = 10'000;

} // namespace lubberline
