#include "core/swing/SensorBench.h"

#include <cmath>

#include "core/angle/Angle.h"
#include "core/base/FileText.h"
#include "core/base/Number.h"
#include "core/coil/CoilHistory.h"

namespace lubberline {

double SensorBench::whole_nT() const { return std::hypot(noise_nT, hysteresis_nT, nonlinearity_nT); }

Result<SensorBench> sensorBenchOf(const CoilBench& bench)
{
    const auto result = coilBench(logOf(bench));
    if (!result)
        return result.error();
    const auto across = [&result](const Eigen::Vector3d& of) { // counts are made nT again, and what the sensor shows what it stands for
        return std::hypot(of.x() / result->scale.x(), of.y() / result->scale.y()) / std::sqrt(2.0);
    };
    return SensorBench{bench.date, across(result->noise_nT),
        across(result->hysteresis_nT.value_or(Eigen::Vector3d::Zero())) / std::sqrt(12.0),
        across(result->nonlinearity_nT) / std::sqrt(3.0)};
}

std::optional<double> errorIn(const SensorBench& bench, double H_nT)
{
    return H_nT >= 2000 ? std::optional(std::atan(bench.whole_nT() / H_nT)) : std::nullopt;
}

Message wordsOf(const SensorBench& bench, const std::optional<double>& error_rad, double H_nT)
{
    const Message when = bench.date.empty() ? Message() : Message{MARKED("core", " of %1"), bench.date.text()};
    if (!error_rad)
        return {
            MARKED("core",
                "by its coil bench%1 the sensor itself leaves %2 nT on each reading, which is not in the errors: the field of the swing is not known"),
            when, figureText(bench.whole_nT(), 0)};
    return {
        MARKED("core",
            "the sensor itself leaves %1° on each reading, in the errors: by its coil bench%2, noise %3, hysteresis %4 and nonlinearity %5 nT (standard uncertainties) in a field of %6 nT"),
        figureText(toDegrees(*error_rad), 2), when, figureText(bench.noise_nT, 0), figureText(bench.hysteresis_nT, 0),
        figureText(bench.nonlinearity_nT, 0), figureText(H_nT, 0)};
}

} // namespace lubberline
