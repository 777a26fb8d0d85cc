// The deviation map: a map of 361 × 181 points against as many bare arc tangents of the same build, and against the plain
// formula.

#include <random>
#include <string>

#include "core/sensor/map/DeviationMap.h"
#include "core/sensor/map/VectorAtan2.h"
#include "tests/bench/Ratio.h"

using namespace lubberline;

namespace {

constexpr int kColumns = 361, kRows = 181;
constexpr std::size_t kPoints = std::size_t{kColumns} * kRows; // 65,341

SensorModel usualIron()
{
    SensorModel model;
    model.softIron << 0.03, 0.01, -0.02, -0.015, 0.05, 0.01, 0.02, -0.01, 0.04;
    model.hardIron_nT = {2000, -1500, 800};
    return model;
}

bool measure(const char* name, AttitudeAxis x, AttitudeAxis y)
{
    const SensorResponse sensor = responseOf(usualIron());
    const MeridianField field = MeridianField::fromDip(18500, toRadians(67));
    const MapRequest request{{x, fullRange(x), kColumns}, {y, fullRange(y), kRows}, 10};
    DeviationMap fast, plain;
    std::mt19937_64 random(1);
    std::normal_distribution<double> normal;
    std::vector<double> sines(kPoints), cosines(kPoints), angles(kPoints);
    for (auto& value : sines)
        value = normal(random);
    for (auto& value : cosines)
        value = normal(random);
    const auto map = [&] { computeMap(sensor, field, request, fast); };
    const auto bare = bench::compare(
        map, [&] { vectorAtan2(sines.data(), cosines.data(), angles.data(), kPoints); }, 201);
    const auto plainly = bench::compare(
        map, [&] { computeMapPlainly(sensor, field, request, plain); }, 11);
    const bool quick = bench::report((std::string(name) + ", 361 x 181").c_str(), bare, "65,341 bare vector arc tangents", 1.5);
    return bench::report((std::string(name) + ", 361 x 181").c_str(), plainly, "the plain formula a point", 1.0 / 20) && quick;
}

} // namespace

int main()
{
    bool kept = measure("heading x pitch", AttitudeAxis::Heading, AttitudeAxis::Pitch);
    kept = measure("heading x roll", AttitudeAxis::Heading, AttitudeAxis::Roll) && kept;
    return measure("pitch x roll", AttitudeAxis::Pitch, AttitudeAxis::Roll) && kept ? 0 : 1;
}
