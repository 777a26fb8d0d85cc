#include "core/coil/CoilHistory.h"

#include <algorithm>
#include <cmath>

#include "core/base/FileText.h"
#include "core/base/Normal.h"
#include "core/base/Number.h"

namespace lubberline {

namespace {

constexpr int kLeastDays = 30; // within a month no drift is told from a bench set up anew
constexpr double kDaysOfYear = 365.25;
constexpr double kOtherTemperature_c = 5;
constexpr double kOtherRange = 1.25;

struct Bias {
    Eigen::Vector3d value_nT, error_nT;
};

/// What the bias is at another temperature, by what a degree does to that sensor; where its bench did not tell, by what the other one told.
Bias biasAt(double temperature_c, const CoilResult& bench, const CoilResult& other)
{
    const CoilResult& told = bench.temperature_nT_per_c ? bench : other;
    const double warmer_c = temperature_c - *bench.biasAt_c;
    return {bench.bias_nT + warmer_c * *told.temperature_nT_per_c,
        (bench.biasError_nT.array().square() + (warmer_c * told.temperatureError_nT_per_c).array().square()).sqrt().matrix()};
}

std::vector<Message> doubtsOf(const CoilBench& earlier, const CoilBench& later, const CoilResult& first, const CoilResult& second)
{
    std::vector<Message> doubts;
    if (earlier.serialNumber.empty() || later.serialNumber.empty())
        doubts.push_back({MARKED("core", "not both benches state the sensor's serial number: whether it is the same sensor is not known")});
    if (std::max(first.range_nT, second.range_nT) > kOtherRange * std::min(first.range_nT, second.range_nT))
        doubts.push_back(
            {MARKED("core",
                 "the field went to %1 nT before and to %2 nT now: a sensor that is not straight has another scale over another range"),
                figureText(first.range_nT, 0), figureText(second.range_nT, 0)});
    if (!first.biasAt_c || !second.biasAt_c)
        doubts.push_back({MARKED("core", "not both benches have a temperature: a difference may be its")});
    else if (!first.temperature_nT_per_c && !second.temperature_nT_per_c
        && std::abs(*second.biasAt_c - *first.biasAt_c) > kOtherTemperature_c)
        doubts.push_back({MARKED("core", "it was %1 °C before and %2 °C now: a difference may be the temperature's"),
            figureText(*first.biasAt_c, 0), figureText(*second.biasAt_c, 0)});
    return doubts;
}

} // namespace

Result<CoilBench> coilRecordOf(const SensorLog& log)
{
    const auto result = coilBench(log);
    if (!result)
        return result.error();
    if (result->used > kMostCoilReadings)
        return Error{ErrorCode::InvalidInput,
            {MARKED(
                 "core", "has %1 whole rows; a bench that is kept has at most %2, for its readings are kept whole: keep a part of the log"),
                result->used, kMostCoilReadings}};
    CoilBench bench;
    bench.inCounts = log.unit == FieldUnit::Counts;
    std::array<const std::vector<double>*, 3> applied{};
    for (std::size_t axis = 0; axis < 3; ++axis)
        applied[axis] = columnOf(log, kAppliedColumns[axis]);
    const auto* temperature = columnOf(log, "temperature_c");
    for (const std::size_t row : result->rows) {
        std::array<double, 6> reading{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            reading[axis] = (*applied[axis])[row];
            reading[axis + 3] = log.field[axis][row];
        }
        bench.readings.push_back(reading);
        if (temperature)
            bench.temperature_c.push_back((*temperature)[row]);
    }
    return bench;
}

SensorLog logOf(const CoilBench& bench)
{
    SensorLog log;
    log.unit = bench.inCounts ? FieldUnit::Counts : FieldUnit::Nanotesla;
    for (const char* name : kAppliedColumns)
        log.others.push_back({name, {}});
    for (const auto& reading : bench.readings)
        for (std::size_t axis = 0; axis < 3; ++axis) {
            log.others[axis].values.push_back(reading[axis]);
            log.field[axis].push_back(reading[axis + 3]);
        }
    if (!bench.temperature_c.empty())
        log.others.push_back({"temperature_c", bench.temperature_c});
    return log;
}

Result<CoilDrift> driftBetween(const CoilBench& earlier, const CoilBench& later)
{
    if (!earlier.serialNumber.empty() && !later.serialNumber.empty() && earlier.serialNumber != later.serialNumber)
        return Error{ErrorCode::InvalidInput,
            {MARKED("core", "are of two sensors (serial numbers %1 and %2) and cannot be compared"), earlier.serialNumber,
                later.serialNumber}};
    if (earlier.inCounts != later.inCounts)
        return Error{ErrorCode::InvalidInput, MARKED("core", "are one in counts and one in nT and cannot be compared")};
    const int days = daysBetween(earlier.date, later.date);
    if (days < kLeastDays)
        return Error{ErrorCode::InvalidInput,
            {MARKED("core", "are %1 days apart: no drift is told from benches less than %2 days apart"), days, kLeastDays}};
    const auto first = coilBench(logOf(earlier)), second = coilBench(logOf(later));
    if (!first || !second)
        return first ? second.error() : first.error();
    CoilDrift drift;
    drift.years = days / kDaysOfYear;
    Bias was{first->bias_nT, first->biasError_nT}, is{second->bias_nT, second->biasError_nT};
    if (first->biasAt_c && second->biasAt_c && (first->temperature_nT_per_c || second->temperature_nT_per_c)) {
        drift.at_c = (*first->biasAt_c + *second->biasAt_c) / 2;
        was = biasAt(*drift.at_c, *first, *second);
        is = biasAt(*drift.at_c, *second, *first);
    }
    drift.bias_nT_per_year = (is.value_nT - was.value_nT) / drift.years;
    drift.scale_per_year = (second->scale - first->scale).cwiseQuotient(first->scale) / drift.years;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        drift.biasInterval_nT_per_year[axis] = kNormal95 * std::hypot(was.error_nT[axis], is.error_nT[axis]) / drift.years;
        drift.scaleInterval_per_year[axis]
            = kNormal95 * std::hypot(first->scaleError[axis], second->scaleError[axis]) / first->scale[axis] / drift.years;
        drift.noiseRatio[axis] = second->noise_nT[axis] / std::max(first->noise_nT[axis], 1e-12);
    }
    drift.doubts = doubtsOf(earlier, later, *first, *second);
    return drift;
}

} // namespace lubberline
