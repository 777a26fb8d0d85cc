#include "core/swing/Removal.h"

#include <algorithm>
#include <cmath>

#include "core/angle/Circle.h"

namespace lubberline {

Result<Removal> removeComponents(const Analysis& analysis, CoefficientSet removed)
{
    for (const Coefficient coefficient : kCoefficients)
        if (removed.test(indexOf(coefficient)) && !analysis.approximate.of(coefficient))
            return Error{ErrorCode::Numeric,
                {MARKED("core", "coefficient %1 cannot be removed: these headings do not tell it"), letterOf(coefficient)}};

    const ApproximateSmith taken = without(analysis.approximate.smith(), ~removed);
    Removal result;
    const double index_rad = removed.test(indexOf(Coefficient::A)) ? 0.0 : analysis.approximate.index_rad; // no jump from 180° to −180°
    std::vector<HarmonicSample> samples;
    double sumOfSquares = 0;
    for (const auto& reading : analysis.readings) {
        const double left_rad
            = Deviation::fromDegrees(reading.deviation.degrees() - deviationAt(taken, reading.compass).degrees()).radians();
        result.remaining_rad.push_back(left_rad);
        result.maxAbs_rad = std::max(result.maxAbs_rad, std::abs(left_rad));
        sumOfSquares += left_rad * left_rad;
        samples.push_back({reading.magnetic.radians(), nearTo_rad(left_rad, index_rad)});
    }
    result.rms_rad = std::sqrt(sumOfSquares / static_cast<double>(analysis.readings.size()));
    auto spectrum = harmonics(samples);
    if (!spectrum)
        return spectrum.error();
    result.harmonics = std::move(spectrum.value());
    return result;
}

} // namespace lubberline
