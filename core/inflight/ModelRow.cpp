#include "core/inflight/ModelRow.h"

#include <cmath>

#include "core/angle/Angle.h"
#include "core/sensor/Attitude.h"

namespace lubberline {

StateFilter::State modelRow(double compass_deg, double deviation_deg, const FlownAt& at, double horizontal_nT)
{
    const double read = toRadians(compass_deg), magnetic = read + toRadians(deviation_deg);
    const Eigen::Matrix3d level = rotation(toRadians(at.roll_deg), toRadians(at.pitch_deg), 0); // level axes into body axes
    const double tangent = at.field.down_nT / at.field.horizontal_nT;
    const Eigen::Vector3d field = level * Eigen::Vector3d(std::cos(magnetic), -std::sin(magnetic), tangent);
    const Eigen::Vector3d across = level * Eigen::Vector3d(std::sin(read), std::cos(read), 0);
    StateFilter::State row(kModelStates);
    for (int axis = 0, place = 0; axis < 3; ++axis)
        for (int along = 0; along < 3 && place < 8; ++along)
            row(place++) = across(axis) * field(along);
    row.tail<3>() = across * (horizontal_nT / at.field.horizontal_nT);
    return row;
}

std::array<StateFilter::State, 5> levelRows(const MeridianField& field, double horizontal_nT)
{
    std::array<StateFilter::State, 5> rows;
    rows.fill(StateFilter::State::Zero(kModelStates));
    constexpr int kHeadings = 24;
    for (int i = 0; i < kHeadings; ++i) {
        const double heading = 2 * kPi * i / kHeadings;
        const StateFilter::State row = modelRow(toDegrees(heading), 0, {0, 0, field}, horizontal_nT) / kHeadings;
        const std::array<double, 5> waves{
            1, 2 * std::sin(heading), 2 * std::cos(heading), 2 * std::sin(2 * heading), 2 * std::cos(2 * heading)};
        for (std::size_t c = 0; c < rows.size(); ++c)
            rows[c] += waves[c] * row;
    }
    return rows;
}

SensorModel modelOf(const StateFilter::State& state_deg, double horizontal_nT)
{
    SensorModel model;
    for (int place = 0; place < 8; ++place)
        model.softIron(place / 3, place % 3) = toRadians(state_deg(place));
    for (int axis = 0; axis < 3; ++axis)
        model.hardIron_nT(axis) = toRadians(state_deg(8 + axis)) * horizontal_nT;
    return model;
}

} // namespace lubberline
