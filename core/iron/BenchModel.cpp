#include "core/iron/BenchModel.h"

#include <algorithm>
#include <numeric>
#include <optional>

#include "core/angle/Angle.h"
#include "core/iron/BenchCheck.h"
#include "core/iron/Coercivity.h"
#include "core/iron/DemagnetisingFactors.h"
#include "core/iron/ShapeGeometry.h"
#include "core/iron/TensorStore.h"
#include "core/sensor/Attitude.h"

namespace lubberline {

namespace {

constexpr double kTensorLengths = 3;
constexpr double kNanoteslaPerTesla = 1e9;
/// A tensor takes about as long as this many dipoles: for an even progress.
constexpr double kTensorWeight = 20'000;

/// A part as the sensor sees it.
struct Placed {
    const FerrousPart* part = nullptr;
    Eigen::Matrix3d turn;         ///< body axes → the part's own
    Eigen::Vector3d sensor_m;     ///< from the part's centre, in its own axes
    std::optional<TensorKey> key; ///< none: a dipole
};

Placed placed(const FerrousPart& part, const Placement& placement, const Eigen::Vector3d& sensor_m)
{
    Placed result{&part, rotation(placement.roll_rad, placement.pitch_rad, placement.yaw_rad), {}, {}};
    result.sensor_m = result.turn * (sensor_m - placement.centre_m);
    if (result.sensor_m.norm() <= kTensorLengths * largestLength_m(part.shape))
        result.key = tensorKey(part.shape, result.sensor_m);
    return result;
}

/// N(r) of a dipole of the part's volume.
Eigen::Matrix3d dipoleTensor(const Placed& one)
{
    const double distance = one.sensor_m.norm();
    const Eigen::Vector3d direction = one.sensor_m / distance;
    return volume_m3(one.part->shape) / (4 * kPi * distance * distance * distance)
        * (Eigen::Matrix3d::Identity() - 3 * direction * direction.transpose());
}

PartEffect effectOf(const Placed& one, const Eigen::Matrix3d& tensor)
{
    const Eigen::Vector3d inside = (one.part->susceptibility * factorsOf(one.part->shape)).array() + 1;
    const Eigen::Matrix3d response = -one.turn.transpose() * tensor * inside.cwiseInverse().asDiagonal();
    PartEffect effect;
    effect.part = one.part->name;
    effect.softIron = one.part->susceptibility * response * one.turn;
    effect.hardIron_nT = response * one.part->remanence_T * kNanoteslaPerTesla;
    effect.distance_m = one.sensor_m.norm();
    effect.dipole = !one.key;
    effect.coercivity_A_per_m = one.part->coercivity_A_per_m;
    return effect;
}

/// Parts that share a tensor one after another, so that only one has to be kept; dipoles first.
std::vector<std::size_t> inOrderOfTensors(const std::vector<Placed>& parts)
{
    const auto rank = [&](std::size_t i) {
        const auto& key = parts[i].key;
        const Eigen::Vector3d size = key ? sizeOf(key->shape) : Eigen::Vector3d::Zero();
        return std::tuple(key ? key->reach : 0.0, key ? key->shape.index() : 0, size.x(), size.y(), size.z());
    };
    std::vector<std::size_t> order(parts.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return rank(a) < rank(b); });
    return order;
}

/// Counts what is done for the one who waits.
class Work {
public:
    Work(const std::vector<Placed>& parts, const Progress& progress) : m_progress(progress)
    {
        for (const auto& part : parts)
            m_all += weightOf(part);
    }
    bool goesOn() const { return !m_progress || m_progress(m_all > 0 ? m_done / m_all : 0); }
    void done(const Placed& part) { m_done += weightOf(part); }
    Progress within(const Placed& part) const
    {
        return [this, weight = weightOf(part)](double fraction) { return !m_progress || m_progress((m_done + fraction * weight) / m_all); };
    }

private:
    static double weightOf(const Placed& part) { return part.key ? kTensorWeight : 1; }
    const Progress& m_progress;
    double m_all = 0, m_done = 0;
};

Result<std::vector<PartEffect>> effectsOf(const std::vector<Placed>& parts, const Progress& progress)
{
    Work work(parts, progress);
    std::vector<PartEffect> effects(parts.size());
    for (const std::size_t i : inOrderOfTensors(parts)) {
        const auto& one = parts[i];
        if (!work.goesOn())
            return Error{ErrorCode::Cancelled, MARKED("core", "the iron bench was cancelled")};
        if (one.key) {
            const auto tensor = tensorFor(*one.key, work.within(one));
            if (!tensor)
                return tensor.error();
            effects[i] = effectOf(one, (*tensor)->at(one.sensor_m / largestLength_m(one.part->shape)));
        } else {
            effects[i] = effectOf(one, dipoleTensor(one));
        }
        work.done(one);
    }
    return effects;
}

Result<std::vector<Circuit>> circuitsOf(const IronBench& bench)
{
    std::vector<Circuit> circuits;
    for (const auto& circuit : bench.circuits) {
        Eigen::Vector3d field = Eigen::Vector3d::Zero();
        for (const auto& conductor : circuit.conductors) {
            if (std::visit([&](const auto& one) { return distanceTo(one, bench.sensor_m); }, conductor) < kLeastWireDistance_m)
                return Error{ErrorCode::InvalidInput,
                    {MARKED("core", "circuit “%1”: the sensor stands on its wire; expected 1 mm or more between them"), circuit.name}};
            if (const auto* loop = std::get_if<CurrentLoop>(&conductor))
                field += fieldOfLoop_nT_per_A(*loop, bench.sensor_m);
            else
                field += fieldOfWire_nT_per_A(std::get<WirePath>(conductor), bench.sensor_m);
        }
        circuits.push_back({circuit.name, field, circuit.current_A, circuit.on});
    }
    return circuits;
}

/// Whether the surface is within two cells of the sensor, where the tensor is smeared.
bool touches(const Placed& one)
{
    if (!one.key)
        return false;
    const double cells_m = 2.5 * 2 * one.key->reach / kBenchTensorCells * largestLength_m(one.part->shape);
    const Eigen::Vector3d size_m = sizeOf(one.part->shape);
    const Eigen::Vector3d inBox = one.sensor_m.cwiseProduct((size_m.array() / (size_m.array() + 2 * cells_m)).matrix());
    return contains(one.part->shape, inBox);
}

std::vector<Message> warningsOf(const std::vector<Placed>& parts)
{
    std::vector<Message> warnings;
    const auto magnetised = std::count_if(parts.begin(), parts.end(), [](const Placed& one) { return one.part->susceptibility > 0; });
    if (magnetised > 0 && parts.size() > 1)
        warnings.push_back(MARKED("core", "parts are magnetised by the Earth's field only, not by one another"));
    for (const auto& one : parts)
        if (touches(one))
            warnings.push_back(
                {MARKED("core", "part “%1” is so near the sensor that its field there is uncertain by 10 % and more"), one.part->name});
    return warnings;
}

} // namespace

Result<BenchModel> benchModel(const IronBench& bench, const BenchStates& states, const Progress& progress)
{
    if (const auto checked = checkBench(bench); !checked)
        return checked.error();
    const auto placements = placementsIn(bench, states);
    if (!placements)
        return placements.error();
    std::vector<Placed> parts;
    for (std::size_t i = 0; i < bench.parts.size(); ++i) {
        parts.push_back(placed(bench.parts[i], (*placements)[i], bench.sensor_m));
        if (contains(bench.parts[i].shape, parts.back().sensor_m))
            return Error{ErrorCode::InvalidInput, {MARKED("core", "part “%1”: the sensor is inside it"), bench.parts[i].name}};
    }
    BenchModel result;
    auto circuits = circuitsOf(bench);
    if (!circuits)
        return circuits.error();
    auto effects = effectsOf(parts, progress);
    if (!effects)
        return effects.error();
    result.parts = std::move(*effects);
    for (const auto& effect : result.parts) {
        result.model.softIron += effect.softIron;
        result.model.hardIron_nT += effect.hardIron_nT;
    }
    result.model.circuits = std::move(*circuits);
    result.warnings = warningsOf(parts);
    for (const auto& effect : result.parts)
        if (Message drift = driftWarning(effect); !drift.empty())
            result.warnings.push_back(std::move(drift));
    return result;
}

} // namespace lubberline
