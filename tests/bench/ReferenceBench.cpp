// A scenario of one hour at 50 Hz with every source of error, against three arctangents and a sine and cosine for each of its 180,000
// steps, which is what its sensor needs with, without tilt and without deviation. The choice of three headings for a compass with ten swings
// of history against the 2,324 inversions of five by five that trying all sets of one to three of its 24 headings would need.

#include <cmath>
#include <cstdio>

#include <Eigen/LU>

#include "core/angle/Angle.h"
#include "core/check/CheckHeadings.h"
#include "core/reference/ReferenceRun.h"
#include "tests/bench/Ratio.h"

using namespace lubberline;

namespace {

constexpr int kSteps = 180'000, kSets = 24 + 276 + 2024;

Scenario oneHour()
{
    Scenario scenario;
    scenario.latitude_deg = 52;
    scenario.dip_deg = 67;
    scenario.speed_m_s = 60;
    scenario.step_s = 0.02;
    scenario.duration_s = 3600;
    for (int i = 0; i < 20; ++i)
        scenario.manoeuvres.push_back({60.0 + 170 * i, 120.0 + 170 * i, i % 2 == 0 ? 3.0 : -3.0, 0, 0});
    scenario.gusts = Gusts{0.5, 12, 1, false};
    scenario.vertical = VerticalGyro{};
    scenario.vertical->loop = LoopKind::Third;
    scenario.gyro = HeadingGyro{};
    scenario.gyro->drift_deg_h = 1;
    scenario.gyro->apparentDrift = true;
    scenario.gyro->slavingTau_s = 120;
    scenario.compass.model = SensorModel{};
    scenario.compass.model->hardIron_nT = {700, -400, 200};
    scenario.compass.horizontal_nT = 18700;
    return scenario;
}

CompassBelief tenSwings()
{
    std::vector<PastSwing> history;
    for (int i = 0; i < 10; ++i)
        history.push_back({2015.0 + i, {0.5, 2.0 + 0.2 * (i % 3), -3, 0.5, 0}, {0.3, 0.4, 0.4, 0.4, 0.4}, false});
    return beliefOf(history, 2025, {});
}

} // namespace

int main()
{
    double sum = 0; // used, so that nothing is optimised away
    const Scenario scenario = oneHour();
    const auto flown = bench::compare([&] { sum += runScenario(scenario)->headingError_rad.back(); },
        [&] {
            for (int i = 0; i < kSteps; ++i) {
                const double x = i * 1e-3;
                sum += std::sin(x) + std::cos(x) + std::atan2(x - 90, x + 1) + std::atan2(x - 40, x + 2) + std::atan2(x + 3, x - 50);
            }
        },
        9);
    const CompassBelief belief = tenSwings();
    const auto chosen = bench::compare([&] { sum += headingsFor(belief, 3, {}).left_deg; },
        [&] {
            Eigen::Matrix<double, 5, 5> information = Eigen::Matrix<double, 5, 5>::Identity();
            for (int i = 0; i < kSets; ++i) {
                information(0, 1) = i * 1e-6;
                sum += information.inverse().trace();
            }
        },
        9);
    bool kept = bench::report("one hour at 50 Hz, all sources", flown, "sines and arctangents", 8);
    kept = bench::report("one hour at 50 Hz, all sources", {flown.ours_s, 0.05}, "50 ms", 1.0) && kept;
    kept = bench::report("three headings after ten swings", chosen, "inversions", 40) && kept;
    kept = bench::report("three headings after ten swings", {chosen.ours_s, 0.1}, "100 ms", 1.0) && kept;
    std::printf("(%g)\n", sum);
    return kept ? 0 : 1;
}
