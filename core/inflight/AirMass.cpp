#include "core/inflight/AirMass.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "core/algebra/Solve.h"
#include "core/algebra/Spectra.h"
#include "core/base/Middle.h"
#include "core/inflight/WindVector.h"

namespace lubberline {

namespace {

using Velocity2 = Eigen::Vector2d;

/// Of the scatter about the circle: an airspeed that wanders slowly looks like wind, however many tracks there are.
constexpr double kWandering = 0.4;
constexpr int kCircleRounds = 8;
/// Beyond so many standard deviations a speed is no part of the turn (taking off, braking).
constexpr double kOutsideCircle = 4.0;
/// Smallest eigenvalue of the directions from the wind to the ground velocities: below, they lie on too short an arc to tell a circle.
constexpr double kLeastSpread = 0.02; // an arc of some 130°

struct Circle {
    Velocity2 centre = Velocity2::Zero();
    double radius = 0;
};

/// |g|² = 2 c·g + (r² − |c|²), linear in the unknowns: a start (Kåsa).
Circle linearCircle(const std::vector<Velocity2>& points)
{
    Eigen::MatrixXd design(points.size(), 3);
    Eigen::VectorXd squares(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        design.row(row) << 2.0 * points[i].x(), 2.0 * points[i].y(), 1.0;
        squares(row) = points[i].squaredNorm();
    }
    const Eigen::Vector3d found = pivotedSolve(design, squares).solution.col(0);
    return {{found.x(), found.y()}, std::sqrt(std::max(0.0, found.z() + found.head<2>().squaredNorm()))};
}

Eigen::Matrix3d normalOf(const std::vector<Velocity2>& points, const Circle& circle, Eigen::Vector3d* gradient = nullptr)
{
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    for (const auto& point : points) {
        const Velocity2 away = point - circle.centre;
        const double distance = std::max(away.norm(), 1e-9);
        const Eigen::Vector3d row(-away.x() / distance, -away.y() / distance, -1.0);
        normal += row * row.transpose();
        if (gradient)
            *gradient += row * (distance - circle.radius);
    }
    return normal;
}

std::vector<double> distancesFrom(const std::vector<Velocity2>& points, const Circle& circle)
{
    std::vector<double> off;
    off.reserve(points.size());
    for (const auto& point : points)
        off.push_back((point - circle.centre).norm() - circle.radius);
    return off;
}

double medianSize(std::vector<double> values)
{
    for (double& value : values)
        value = std::abs(value);
    return middleOf(std::move(values));
}

/// Least squares of the distances from the circle.
Circle refined(const std::vector<Velocity2>& points, Circle circle)
{
    for (int round = 0; round < kCircleRounds; ++round) {
        Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
        const Eigen::Matrix3d normal = normalOf(points, circle, &gradient);
        const Eigen::Vector3d step = pivotedSolve(normal, -gradient).solution.col(0);
        circle.centre += step.head<2>();
        circle.radius += step.z();
    }
    return circle;
}

std::vector<Velocity2> withoutStrays(const std::vector<Velocity2>& points, const Circle& circle)
{
    const auto off = distancesFrom(points, circle);
    const double limit = kOutsideCircle * std::max(1.4826 * medianSize(off), 0.05);
    std::vector<Velocity2> kept;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (std::abs(off[i]) <= limit)
            kept.push_back(points[i]);
    return kept;
}

/// Readings one after the other tell the same: so many times fewer of them count.
double repeatedness(const std::vector<double>& off)
{
    double squares = 0.0, products = 0.0;
    for (std::size_t i = 0; i < off.size(); ++i) {
        squares += off[i] * off[i];
        products += i > 0 ? off[i] * off[i - 1] : 0.0;
    }
    const double correlation = std::clamp(squares > 0.0 ? products / squares : 0.0, 0.0, 0.98);
    return (1.0 + correlation) / (1.0 - correlation);
}

} // namespace

double AirMass::from_deg() const { return wrap360(toDegrees(std::atan2(-toward_kt.x(), -toward_kt.y()))); }

double AirMass::standardError_kt() const { return std::sqrt(std::max(0.0, symmetricValues(covariance).maxCoeff())); }

double AirMass::drift_deg() const { return toDegrees(std::asin(std::min(1.0, speed_kt() / std::max(airspeed_kt, 1e-9)))); }

std::optional<AirMass> airMassOf(std::span<const GroundVelocity> velocities, const AirMassOptions& options)
{
    std::vector<Velocity2> points;
    for (const auto& one : velocities)
        points.push_back(velocityOf(one.track_deg, one.speed_kt));
    if (points.size() < std::max<std::size_t>(3, options.fewest))
        return {};
    Circle circle = refined(points, linearCircle(points));
    for (int round = 0; round < 3 && options.dropStrays; ++round) {
        const auto kept = withoutStrays(points, circle);
        if (kept.size() < std::max<std::size_t>(4, points.size() / 2))
            break;
        points = kept;
        circle = refined(points, circle);
    }
    const Eigen::Matrix3d normal = normalOf(points, circle);
    const double spread = symmetricValues(normal).minCoeff() / static_cast<double>(points.size());
    if (!circle.centre.allFinite() || circle.radius <= 0.0 || spread < kLeastSpread)
        return {};
    const auto off = distancesFrom(points, circle);
    double squares = 0.0;
    for (const double one : off)
        squares += one * one;
    const auto freedom = static_cast<double>(points.size() - 3);
    const double scatter2 = freedom > 0 ? squares / freedom : 0.0;
    const double repeated = options.oneAfterOther ? repeatedness(off) : 1.0;
    const double variance = std::max(scatter2 * repeated, options.speedError_kt * options.speedError_kt);
    AirMass air;
    air.toward_kt = circle.centre;
    air.airspeed_kt = circle.radius;
    air.scatter_kt = std::sqrt(scatter2);
    const Eigen::Matrix3d covariance = normal.inverse() * variance;
    air.covariance = covariance.topLeftCorner<2, 2>();
    if (options.oneAfterOther)
        air.covariance.diagonal().array() += std::pow(kWandering * air.scatter_kt, 2);
    air.airspeedError_kt = std::sqrt(covariance(2, 2));
    return air;
}

double headingInWind_deg(const AirMass& air, double track_deg, double speed_kt)
{
    return directionOf_deg(velocityOf(track_deg, speed_kt) - air.toward_kt);
}

Eigen::Vector2d turnedByWind_deg(const AirMass& air, double track_deg, double speed_kt)
{
    const Velocity2 through = velocityOf(track_deg, speed_kt) - air.toward_kt;
    return Velocity2(-through.y(), through.x()) * (kDegreesPerRadian / std::max(through.squaredNorm(), 1e-9));
}

} // namespace lubberline
