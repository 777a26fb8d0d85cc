#pragma once
/// What the coil bench of a compass's sensor says of the swings after it: noise, hysteresis and nonlinearity are no iron and no curve takes
/// them away. Its bias is hard iron, which a swing measures itself.

#include <optional>
#include <string>

#include "core/base/Message.h"
#include "core/base/Result.h"
#include "core/record/CoilBench.h"

namespace lubberline {

/// Standard uncertainties of one reading of a horizontal axis (x and y, rms) [nT].
struct SensorBench {
    Date date;
    double noise_nT = 0;        ///< rms
    double hysteresis_nT = 0;   ///< the way up − the way down is anything between: /√12
    double nonlinearity_nT = 0; ///< anything up to the largest, either way: /√3
    [[nodiscard]] double whole_nT() const;
};

/// Errors: those of coilBench().
Result<SensorBench> sensorBenchOf(const CoilBench& bench);

/// Standard uncertainty of one deviation in a horizontal field [rad]: across the needle, the mean over all headings. None where H is too
/// weak for a compass (under 2000 nT).
[[nodiscard]] std::optional<double> errorIn(const SensorBench& bench, double H_nT);

/// What a result says of it. @param error_rad none: it could not be taken in, for the field of the swing is not known.
[[nodiscard]] Message wordsOf(const SensorBench& bench, const std::optional<double>& error_rad, double H_nT);

} // namespace lubberline
