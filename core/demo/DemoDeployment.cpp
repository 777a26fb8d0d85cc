#include "core/demo/DemoDeployment.h"

#include <cmath>

#include "core/base/Contract.h"

#include "core/iron/BenchModel.h"
#include "core/sensor/SensorReading.h"

namespace lubberline {

namespace {

SensorModel lightTwin()
{
    SensorModel model;
    model.softIron << 0.012, 0.004, 0.021, 0.006, -0.008, -0.017, 0.003, -0.005, 0.010;
    model.hardIron_nT = {-620, 480, 350};
    return model;
}

SensorModel fighter()
{
    SensorModel model;
    model.softIron << 0.018, -0.003, -0.026, 0.002, -0.011, 0.014, 0.006, 0.004, -0.012;
    model.hardIron_nT = {910, -340, -520};
    return model;
}

SensorRecord entered(const SensorModel& model)
{
    SensorRecord sensor;
    sensor.name = "as entered, with landing light";
    sensor.note = "Demonstration: parameters as a survey might have given them; the landing light's supply runs past the sensor.";
    sensor.origin = ModelOrigin::Entered;
    sensor.model = model;
    sensor.model.circuits = {{"landing light", {14.0, -22.0, 6.0}, 10.0, true}, {"pitot heat", {-3.0, 5.5, 1.0}, 8.0, false}};
    return sensor;
}

/// A helicopter's magnetometer in the tail boom: engines and gearbox far off, the tail rotor's drive shaft close by.
IronBench helicopter()
{
    IronBench bench;
    bench.sensor_m = {-7.0, 0.0, -1.2};
    bench.parts = {
        {"port engine", Cylinder{0.5, 1.6}, 8.0, {0.011, 0.0, 0.006}, "", {{"", {0.6, -0.7, -1.9}, 0, 0, 0}}},
        {"starboard engine", Cylinder{0.5, 1.6}, 8.0, {0.009, 0.0, 0.007}, "", {{"", {0.6, 0.7, -1.9}, 0, 0, 0}}},
        {"main gearbox", Box{{0.9, 0.8, 1.0}}, 12.0, {0.004, 0.002, 0.012}, "", {{"", {-1.0, 0.0, -1.8}, 0, 0, 0}}},
        {"tail drive shaft", Cylinder{0.06, 0.9}, 40.0, {0.02, 0.0, 0.0}, "", {{"", {-4.8, 0.1, -1.75}, 0, 0.02, 0}}},
        {"cargo hook", Box{{0.25, 0.15, 0.3}}, 30.0, {0.0, 0.03, 0.05}, "hook",
            {{"stowed", {-3.4, 0.5, 0.1}, 0, 0, 0}, {"lowered", {-3.4, 0.5, 0.9}, 0, 0, 0}}},
    };
    bench.circuits = {{"anti-collision light", {WirePath{{{-3.0, -0.35, -1.5}, {-7.6, -0.35, -1.5}}}}, 6.0, false}};
    return bench;
}

SensorRecord fromBench()
{
    SensorRecord sensor;
    sensor.name = "iron bench, hook stowed";
    sensor.note = "Demonstration: an airframe that nobody has measured.";
    sensor.origin = ModelOrigin::IronBench;
    sensor.bench = helicopter();
    sensor.benchStates = {{"hook", "stowed"}};
    const auto made = benchModel(*sensor.bench, sensor.benchStates);
    LUBBERLINE_EXPECT(made.ok(), "the demonstration's bench can be computed");
    sensor.model = made->model;
    return sensor;
}

} // namespace

const std::vector<DemoDeployment>& demoDeployments()
{
    static const std::vector<DemoDeployment> deployments = [] {
        const SensorRecord bench = fromBench();
        return std::vector<DemoDeployment>{
            {0, 3, fighter(), {}}, {1, 3, bench.model, {bench}}, {3, 2, lightTwin(), {entered(lightTwin())}}};
    }();
    return deployments;
}

const DemoCompassKind& demoMagnetometer()
{
    static const DemoCompassKind kind{"AHRS magnetometer", CompassKind::RemoteUnstabilised, Compensator::None, "tail", 0.25, 12, {}, 0.0,
        0.15, "14 CFR 25.1327 (10\u00B0)", 10.0, false, false};
    return kind;
}

const std::vector<DemoVisit>& demoVisits()
{
    static const std::vector<DemoVisit> visits{{3, 2, 17}, {4, 10, 6}};
    return visits;
}

std::vector<Reading> readDeployed(const SensorModel& hidden, const MeridianField& field, DemoRandom& random)
{
    const DemoCompassKind& kind = demoMagnetometer();
    std::vector<Reading> readings;
    for (int i = 0; i < kind.points; ++i) {
        Reading reading;
        reading.nominal_deg = 360.0 * i / kind.points;
        reading.magnetic = MagneticHeading::fromDegrees(std::round(2 * (*reading.nominal_deg + random.between(-2.0, 2.0))) / 2);
        const auto seen = readSensor(hidden, field, {*reading.magnetic, 0, 0});
        if (seen.compass)
            reading.compass = CompassHeading::fromDegrees(
                std::round((seen.compass->degrees() + random.normal(kind.noise_deg)) / kind.resolution_deg) * kind.resolution_deg);
        readings.push_back(reading);
    }
    return readings;
}

} // namespace lubberline
