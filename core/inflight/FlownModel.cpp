#include "core/inflight/FlownModel.h"

#include "core/algebra/Products.h"
#include "core/algebra/Solve.h"
#include "core/algebra/Spectra.h"
#include "core/angle/Angle.h"
#include "core/sensor/Attitude.h"

namespace lubberline {

namespace {

constexpr double kLeastPart = 1e-12; ///< of the largest variance: beneath it a direction would be known exactly

using Slope = Eigen::Matrix<double, kModelStates, kUncertainParameters>;
using ModelCovariance = Eigen::Matrix<double, kModelStates, kModelStates>;

/// Places of the state among the twelve parameters: k is left out.
constexpr int parameterOf(int place) { return place < 8 ? place : place + 1; }

/// Degrees of a state in one unit of its parameter.
double unitOf(int place, double horizontal_nT) { return place < 8 ? kDegreesPerRadian : kDegreesPerRadian / horizontal_nT; }

/// The state is (gain − 1, offset) over the gain along z, which has no part in it; the mount turns both.
Slope slopeOf(const SensorModel& model, const SensorResponse& response, double horizontal_nT)
{
    const Eigen::Matrix3d mount = rotation(model.misalignment.roll_rad, model.misalignment.pitch_rad, model.misalignment.yaw_rad);
    const double scale = response.gain(2, 2);
    Slope slope = Slope::Zero();
    for (int parameter = 0; parameter < kUncertainParameters; ++parameter) {
        Eigen::Matrix3d gain = Eigen::Matrix3d::Zero();
        Eigen::Vector3d offset_nT = Eigen::Vector3d::Zero();
        if (parameter < 9)
            gain.col(parameter % 3) = mount.col(parameter / 3);
        else
            offset_nT = mount.col(parameter - 9);
        const double ofScale = gain(2, 2) / scale;
        for (int place = 0; place < kModelStates; ++place) {
            const double moved = place < 8 ? gain(place / 3, place % 3) - response.gain(place / 3, place % 3) * ofScale
                                           : offset_nT(place - 8) - response.offset_nT(place - 8) * ofScale;
            slope(place, parameter) = unitOf(place, horizontal_nT) * moved / scale;
        }
    }
    return slope;
}

} // namespace

std::optional<ContinuousState> stateOf(const SensorRecord& sensor, double horizontal_nT)
{
    if (!sensor.uncertainty)
        return {};
    const SensorResponse response = responseOf(sensor.model);
    const double scale = response.gain(2, 2);
    if (!(scale > 0))
        return {};
    ContinuousState state;
    state.horizontal_nT = horizontal_nT;
    state.state_deg = StateFilter::State(kModelStates);
    for (int place = 0; place < kModelStates; ++place)
        state.state_deg(place) = unitOf(place, horizontal_nT)
            * (place < 8 ? response.gain(place / 3, place % 3) / scale - (place / 3 == place % 3 ? 1.0 : 0.0)
                         : response.offset_nT(place - 8) / scale);
    state.covariance = carried(slopeOf(sensor.model, response, horizontal_nT), sensor.uncertainty->covariance);
    const Eigen::VectorXd spectrum = symmetricValues(state.covariance);
    if (!(spectrum(0) > kLeastPart * spectrum(kModelStates - 1)))
        return {};
    return state;
}

std::optional<SensorRecord> flownModel(const ContinuousResult& result, const std::optional<ContinuousState>& before)
{
    const auto over_nT = result.state.horizontal_nT;
    if (!result.told || !over_nT || !result.whole || !result.whole->model)
        return {};
    ModelCovariance covariance = result.state.covariance.topLeftCorner<kModelStates, kModelStates>();
    if (result.widened > 1) {
        ModelCovariance information = inversePositive(covariance) / result.widened;
        if (before)
            information += inversePositive(before->covariance.topLeftCorner<kModelStates, kModelStates>()) * (1 - 1 / result.widened);
        covariance = inversePositive(information);
    }
    SensorRecord sensor;
    sensor.origin = ModelOrigin::EstimatedFromSwings;
    sensor.model = modelOf(result.state.state_deg, *over_nT);
    auto& kept = sensor.uncertainty.emplace().covariance;
    for (int i = 0; i < kModelStates; ++i)
        for (int j = 0; j < kModelStates; ++j)
            kept(parameterOf(i), parameterOf(j)) = covariance(i, j) / (unitOf(i, *over_nT) * unitOf(j, *over_nT));
    return sensor;
}

} // namespace lubberline
