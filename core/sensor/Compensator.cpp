#include "core/sensor/Compensator.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "core/algebra/Solve.h"
#include "core/angle/Angle.h"
#include "core/base/Number.h"

namespace lubberline {

namespace {

using Five = Eigen::Matrix<double, 5, 1>;
constexpr double kHeadingStep_deg = 15;
constexpr double kNothing_deg = 1e-4; ///< below it nothing is left to share out

Five asVector(const CompensatorSetting& setting)
{
    Five x;
    x << setting.magnets_nT, setting.foreAft, setting.athwart;
    return x;
}

CompensatorSetting asSetting(const Five& x) { return {x.head<3>(), x[3], x[4]}; }

std::vector<double> stepsOf(double most) { return most > 0 ? std::vector<double>{-most, 0, most} : std::vector<double>{0}; }

std::vector<Attitude> attitudesOf(const AttitudeRange& range)
{
    std::vector<Attitude> attitudes;
    for (const double pitch : stepsOf(range.pitch_deg))
        for (const double roll : stepsOf(range.roll_deg))
            for (double heading = 0; heading < 360; heading += kHeadingStep_deg)
                attitudes.push_back({MagneticHeading::fromDegrees(heading), toRadians(pitch), toRadians(roll)});
    return attitudes;
}

double deviationThere(const SensorResponse& response, const MeridianField& field, const Attitude& attitude)
{
    const SensorReading reading = readSensor(response, field, attitude);
    return reading.deviation ? reading.deviation->degrees() : 180.0;
}

Eigen::VectorXd deviations(const SensorModel& model, const MeridianField& field, const std::vector<Attitude>& attitudes)
{
    const SensorResponse response = responseOf(model);
    Eigen::VectorXd found(static_cast<Eigen::Index>(attitudes.size()));
    for (std::size_t i = 0; i < attitudes.size(); ++i)
        found[static_cast<Eigen::Index>(i)] = deviationThere(response, field, attitudes[i]);
    return found;
}

class Setter {
public:
    Setter(const SensorModel& model, const MeridianField& field, const AttitudeRange& range, const CompensatorReach& reach)
        : m_model(model)
        , m_field(field)
        , m_attitudes(attitudesOf(range))
        , m_weights(Eigen::VectorXd::Ones(static_cast<Eigen::Index>(m_attitudes.size())))
    {
        m_reach << reach.magnets_nT, reach.foreAft, reach.athwart;
        m_unit = m_reach.cwiseMax(Five::Constant(1e-12)) * 1e-5; // small beside the reach, large beside rounding
    }

    [[nodiscard]] Five best()
    {
        Five x = descend(Five::Zero()), least = x;
        double lowest = worst(x);
        constexpr int kRounds = 12;
        for (int round = 0; round < kRounds; ++round) {
            const Eigen::VectorXd size = at(x).cwiseAbs();
            if (!(size.maxCoeff() > kNothing_deg))
                break;
            m_weights = m_weights.cwiseProduct((size / size.maxCoeff()).cwiseMax(1e-3)); // Lawson 1961
            m_weights /= m_weights.mean();
            x = descend(x);
            if (const double now = worst(x); now < lowest) {
                lowest = now;
                least = x;
            }
        }
        return least;
    }

private:
    [[nodiscard]] Eigen::VectorXd at(const Five& x) const
    {
        return deviations(withCompensator(m_model, asSetting(x)), m_field, m_attitudes);
    }
    [[nodiscard]] double worst(const Five& x) const { return at(x).cwiseAbs().maxCoeff(); }
    [[nodiscard]] double cost(const Eigen::VectorXd& deviation) const { return m_weights.dot(deviation.cwiseAbs2()); }
    [[nodiscard]] Five within(const Five& x) const { return x.cwiseMin(m_reach).cwiseMax(-m_reach); }

    [[nodiscard]] Five descend(Five x) const
    {
        Eigen::VectorXd deviation = at(x);
        double now = cost(deviation), damping = 1e-3;
        constexpr int kSteps = 12;
        for (int step = 0; step < kSteps; ++step) {
            Eigen::Matrix<double, Eigen::Dynamic, 5> slope(deviation.size(), 5);
            for (int i = 0; i < 5; ++i) {
                Five moved = x;
                moved[i] += m_unit[i];
                slope.col(i) = m_reach[i] > 0 ? Eigen::VectorXd((at(moved) - deviation) / m_unit[i] * m_reach[i])
                                              : Eigen::VectorXd(Eigen::VectorXd::Zero(deviation.size()));
            }
            const Eigen::Matrix<double, 5, 5> normal = slope.transpose() * m_weights.asDiagonal() * slope;
            const Five gradient = slope.transpose() * (m_weights.asDiagonal() * deviation);
            Eigen::Matrix<double, 5, 5> damped = normal;
            damped.diagonal().array() += damping * (normal.diagonal().array() + 1e-12 * (1 + normal.trace()));
            const Five tried = within(x - solvePositive(damped, gradient).col(0).cwiseProduct(m_reach));
            const Eigen::VectorXd there = at(tried);
            const double cheaper = cost(there);
            if (!(cheaper < now)) {
                damping *= 10;
                if (damping > 1e6)
                    break;
                continue;
            }
            const bool settled = now - cheaper < 1e-9 * now;
            x = tried;
            deviation = there;
            now = cheaper;
            damping = std::max(damping / 10, 1e-9);
            if (settled)
                break;
        }
        return x;
    }

    const SensorModel& m_model;
    const MeridianField& m_field;
    std::vector<Attitude> m_attitudes;
    Eigen::VectorXd m_weights;
    Five m_reach, m_unit;
};

} // namespace

SensorModel withCompensator(SensorModel model, const CompensatorSetting& setting)
{
    model.hardIron_nT += setting.magnets_nT;
    model.softIron(0, 0) += setting.foreAft;
    model.softIron(1, 1) += setting.athwart;
    return model;
}

RangeResidual residualOver(const SensorModel& model, const MeridianField& field, const AttitudeRange& range)
{
    const auto attitudes = attitudesOf(range);
    const Eigen::VectorXd found = deviations(model, field, attitudes);
    RangeResidual residual;
    Eigen::Index place = 0;
    residual.largest_deg = found.cwiseAbs().maxCoeff(&place);
    residual.rms_deg = std::sqrt(found.squaredNorm() / static_cast<double>(found.size()));
    const Attitude& worst = attitudes[static_cast<std::size_t>(place)];
    residual.heading_deg = worst.heading.degrees();
    residual.pitch_deg = toDegrees(worst.pitch_rad);
    residual.roll_deg = toDegrees(worst.roll_rad);
    return residual;
}

CompensatorResult bestCompensator(
    const SensorModel& model, const MeridianField& field, const AttitudeRange& range, const CompensatorReach& reach)
{
    CompensatorResult result;
    result.before = residualOver(model, field, range);
    CompensatorReach levelReach = reach;
    levelReach.magnets_nT.z() = 0; // level it does nothing that could be seen
    result.level = asSetting(Setter(model, field, {0, 0}, levelReach).best());
    result.afterLevel = residualOver(withCompensator(model, result.level), field, range);
    const Five best = Setter(model, field, range, reach).best();
    result.best = asSetting(best);
    result.after = residualOver(withCompensator(model, result.best), field, range);
    if (result.afterLevel.largest_deg < result.after.largest_deg) { // never worse than what is found level
        result.best = result.level;
        result.after = result.afterLevel;
    }
    Five most;
    most << reach.magnets_nT, reach.foreAft, reach.athwart;
    const Five set = asVector(result.best);
    for (int i = 0; i < 5; ++i)
        result.atEnd[static_cast<std::size_t>(i)] = most[i] > 0 && std::abs(set[i]) > 0.999 * most[i];
    if (std::any_of(result.atEnd.begin(), result.atEnd.end(), [](bool end) { return end; }))
        result.warnings.push_back(MARKED("core",
            "a corrector stands at the end of its reach: the iron is more than it can take away; look for the source, or move the sensor"));
    return result;
}

} // namespace lubberline
