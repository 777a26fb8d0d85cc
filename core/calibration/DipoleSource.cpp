#include "core/calibration/DipoleSource.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <boost/math/distributions/fisher_f.hpp>
#include <cmath>

#include "core/algebra/Products.h"
#include "core/algebra/Solve.h"
#include "core/base/Number.h"

namespace lubberline {

namespace {

constexpr double kMu0Over4Pi_nT = 100.0; ///< T·m/A times 10⁹ nT/T
constexpr std::size_t kFewestReadings = 5;
constexpr double kUnknownOfOne = 9, kUnknownOfTwo = 15; ///< places, moments and a uniform field
constexpr double kFewestLeft = 6;                       ///< figures more than unknown ones, to tell two from one
constexpr double kChanceOfSecond = 1e-6;                ///< it is looked for at many places
constexpr std::size_t kBestBeginnings = 6;
constexpr double kRounding = 1e-18; ///< of the squares: readings without noise
constexpr std::size_t kFewestForNeighbours = 10;
constexpr double kNoChance = 3.3; ///< standard deviations; of a correlation it is 1/√n, and a little more as neighbours are so mutually

/// Field of unit moments along x, y and z.
Eigen::Matrix3d fieldOfUnits(const Eigen::Vector3d& from_m)
{
    const double d = std::max(from_m.norm(), 1e-6);
    const Eigen::Vector3d n = from_m / d;
    return kMu0Over4Pi_nT / (d * d * d) * (3 * n * n.transpose() - Eigen::Matrix3d::Identity());
}

using Places = std::vector<Eigen::Vector3d>;

struct LinearPart {
    Eigen::VectorXd value; ///< the moment of each place, uniform field
    Eigen::VectorXd residual;
    [[nodiscard]] double squares() const { return residual.squaredNorm(); }
};

Eigen::MatrixXd designAt(std::span<const StrayReading> readings, const Places& at_m)
{
    const auto moments = static_cast<Eigen::Index>(3 * at_m.size());
    Eigen::MatrixXd design(static_cast<Eigen::Index>(3 * readings.size()), moments + 3);
    for (std::size_t i = 0; i < readings.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(3 * i);
        for (std::size_t k = 0; k < at_m.size(); ++k)
            design.block<3, 3>(row, static_cast<Eigen::Index>(3 * k)) = fieldOfUnits(readings[i].at_m - at_m[k]);
        design.block<3, 3>(row, moments) = Eigen::Matrix3d::Identity();
    }
    return design;
}

LinearPart solveAt(std::span<const StrayReading> readings, const Eigen::VectorXd& fields, const Places& at_m)
{
    const Eigen::MatrixXd design = designAt(readings, at_m);
    // Columns of one length: a moment of one A·m² far away is little beside a nanotesla.
    const Eigen::VectorXd scale = design.colwise().norm().transpose().cwiseMax(1e-30);
    LinearPart part;
    part.value = pivotedSolve(design * scale.cwiseInverse().asDiagonal(), fields).solution.col(0).cwiseQuotient(scale);
    part.residual = fields - design * part.value;
    return part;
}

struct Placed {
    Places at_m;
    LinearPart part;
};

Eigen::MatrixXd slopeAt(std::span<const StrayReading> readings, const Eigen::VectorXd& fields, const Placed& placed, double step_m)
{
    Eigen::MatrixXd slope(fields.size(), static_cast<Eigen::Index>(3 * placed.at_m.size()));
    for (Eigen::Index i = 0; i < slope.cols(); ++i) {
        Places moved = placed.at_m;
        moved[static_cast<std::size_t>(i / 3)][i % 3] += step_m;
        slope.col(i) = (solveAt(readings, fields, moved).residual - placed.part.residual) / step_m;
    }
    return slope;
}

Placed descendFrom(std::span<const StrayReading> readings, const Eigen::VectorXd& fields, const Places& begin_m, double size_m)
{
    Placed now{begin_m, solveAt(readings, fields, begin_m)};
    double damping = 1e-2;
    constexpr int kMostSteps = 60;
    for (int step = 0; step < kMostSteps && damping < 1e8; ++step) {
        const Eigen::MatrixXd slope = slopeAt(readings, fields, now, 1e-5 * size_m);
        Eigen::MatrixXd normal = product(slope.transpose(), slope);
        normal.diagonal() *= 1 + damping;
        normal.diagonal().array() += 1e-30;
        const Eigen::VectorXd down = solvePositive(normal, slope.transpose() * now.part.residual);
        Places tried = now.at_m;
        for (std::size_t k = 0; k < tried.size(); ++k)
            tried[k] -= down.segment<3>(static_cast<Eigen::Index>(3 * k));
        LinearPart there = solveAt(readings, fields, tried);
        if (!(there.squares() < now.part.squares())) {
            damping *= 10;
            continue;
        }
        const bool settled = now.part.squares() - there.squares() < 1e-14 * now.part.squares();
        now = {tried, std::move(there)};
        damping = std::max(damping / 10, 1e-12);
        if (settled)
            break;
    }
    return now;
}

double nearestTo(std::span<const StrayReading> readings, const Eigen::Vector3d& at_m)
{
    double nearest = std::numeric_limits<double>::max();
    for (const StrayReading& reading : readings)
        nearest = std::min(nearest, (reading.at_m - at_m).norm());
    return nearest;
}

Result<void> checkReadings(std::span<const StrayReading> readings)
{
    if (readings.size() < kFewestReadings)
        return Error{ErrorCode::InvalidInput,
            {MARKED("core", "%1 readings; expected %2 or more: a place, a moment and a uniform field are nine unknown figures"),
                readings.size(), kFewestReadings}};
    for (std::size_t i = 0; i < readings.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
            if (readings[i].at_m == readings[k].at_m)
                return Error{ErrorCode::InvalidInput,
                    {MARKED("core", "readings %1 and %2 are at one place; expected each somewhere else"), k + 1, i + 1}};
    return {};
}

/// Places in and around the readings from which a descent begins.
Places beginnings(std::span<const StrayReading> readings, const Eigen::Vector3d& middle_m, double size_m)
{
    constexpr std::array kParts{-0.6, -0.2, 0.2, 0.6};
    Places all;
    for (const double x : kParts)
        for (const double y : kParts)
            for (const double z : kParts)
                if (const Eigen::Vector3d begin = middle_m + size_m * Eigen::Vector3d(x, y, z); nearestTo(readings, begin) >= 1e-3 * size_m)
                    all.push_back(begin);
    return all;
}

/// A second dipole beside the one that was found; none where it explains no more than chance does.
std::optional<TwoSources> secondBeside(
    std::span<const StrayReading> readings, const Eigen::VectorXd& fields, const Placed& one, const Places& begin_m, double size_m)
{
    const double rest = static_cast<double>(fields.size()) - kUnknownOfTwo;
    if (rest < kFewestLeft)
        return {};
    std::vector<Placed> tried;
    for (const Eigen::Vector3d& begin : begin_m) {
        Places both = one.at_m;
        both.push_back(begin);
        tried.push_back({both, solveAt(readings, fields, both)});
    }
    const auto better = [](const Placed& a, const Placed& b) { return a.part.squares() < b.part.squares(); };
    std::sort(tried.begin(), tried.end(), better);
    tried.resize(std::min(tried.size(), kBestBeginnings));
    for (Placed& placed : tried)
        placed = descendFrom(readings, fields, placed.at_m, size_m);
    const auto best = std::min_element(tried.begin(), tried.end(), better);
    if (best == tried.end())
        return {};
    const double asked = kUnknownOfTwo - kUnknownOfOne, left = best->part.squares(), gained = one.part.squares() - left;
    const double limit = quantile(complement(boost::math::fisher_f(asked, rest), kChanceOfSecond));
    if (!(gained / asked > limit * left / rest))
        return {};
    TwoSources two;
    two.at_m = {best->at_m[0], best->at_m[1]};
    two.moment_A_m2 = {best->part.value.segment<3>(0), best->part.value.segment<3>(3)};
    two.uniform_nT = best->part.value.tail<3>();
    two.rms_nT = std::sqrt(left / rest);
    return two;
}

/// Correlation of what is left at a reading and at the one next to it: of noise it is 0.
double neighboursAgree(std::span<const StrayReading> readings, const Eigen::VectorXd& residual)
{
    double together = 0;
    for (std::size_t i = 0; i < readings.size(); ++i) {
        std::size_t next = i;
        double least = std::numeric_limits<double>::max();
        for (std::size_t k = 0; k < readings.size(); ++k)
            if (const double d = (readings[k].at_m - readings[i].at_m).squaredNorm(); k != i && d < least) {
                least = d;
                next = k;
            }
        together += residual.segment<3>(static_cast<Eigen::Index>(3 * i)).dot(residual.segment<3>(static_cast<Eigen::Index>(3 * next)));
    }
    return together / std::max(residual.squaredNorm(), 1e-300);
}

std::string placeText(const Eigen::Vector3d& at_m)
{
    return signedFigureText(at_m.x(), 2) + ", " + signedFigureText(at_m.y(), 2) + ", " + signedFigureText(at_m.z(), 2);
}

/// Errors that reach from the one dipole to the nearer of the two.
void reachToTheTwo(DipoleSource& source)
{
    const TwoSources& two = *source.two;
    const std::size_t near = (two.at_m[0] - source.at_m).norm() <= (two.at_m[1] - source.at_m).norm() ? 0 : 1;
    const auto reach = [](const Eigen::Vector3d& error, const Eigen::Vector3d& off) {
        return Eigen::Vector3d((error.cwiseAbs2() + off.cwiseAbs2()).cwiseSqrt());
    };
    source.atError_m = reach(source.atError_m, two.at_m[near] - source.at_m);
    source.momentError_A_m2 = std::hypot(source.momentError_A_m2, (two.moment_A_m2[near] - source.moment_A_m2).norm());
    source.uniformError_nT = reach(source.uniformError_nT, two.uniform_nT - source.uniform_nT);
    source.warnings.push_back(
        {MARKED("core",
             "more than one source: one dipole leaves %1 nT (rms), two leave %2 nT, at %3 and at %4 m; the errors reach to them. Take the stronger away, or read nearer to each"),
            figureText(source.rms_nT, 1), figureText(two.rms_nT, 1), placeText(two.at_m[0]), placeText(two.at_m[1])});
}

void widenForNeighbours(DipoleSource& source, std::span<const StrayReading> readings, const Eigen::VectorXd& residual)
{
    const double agree = neighboursAgree(readings, residual), chance = kNoChance * std::sqrt(1.5 / static_cast<double>(residual.size()));
    if (readings.size() < kFewestForNeighbours || agree <= chance)
        return;
    const double factor = std::sqrt((1 + agree) / std::max(1 - agree, 0.05));
    source.atError_m *= factor;
    source.momentError_A_m2 *= factor;
    source.uniformError_nT *= factor;
    source.warnings.push_back(
        {MARKED("core",
             "what is left (%1 nT rms) is alike at neighbouring readings (correlation %2; expected %3 or less), so it is no noise: more than one source, a source that is no dipole from so near, or a field that is not uniform; the errors are %4 times as wide for it"),
            figureText(source.rms_nT, 1), figureText(agree, 2), figureText(chance, 2), figureText(factor, 1)});
}

} // namespace

Eigen::Vector3d DipoleSource::fieldAt_nT(const Eigen::Vector3d& place_m) const { return fieldOfUnits(place_m - at_m) * moment_A_m2; }

Result<DipoleSource> locateDipole(std::span<const StrayReading> readings, double length_m)
{
    if (const auto fine = checkReadings(readings); !fine)
        return fine.error();
    Eigen::VectorXd fields(static_cast<Eigen::Index>(3 * readings.size()));
    Eigen::Vector3d low = readings.front().at_m, high = low, mean = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < readings.size(); ++i) {
        fields.segment<3>(static_cast<Eigen::Index>(3 * i)) = readings[i].field_nT;
        low = low.cwiseMin(readings[i].at_m);
        high = high.cwiseMax(readings[i].at_m);
        mean += readings[i].field_nT / static_cast<double>(readings.size());
    }
    const double size_m = std::max((high - low).norm(), 1e-3);
    double without = 0; // squares that a uniform field alone leaves
    for (const StrayReading& reading : readings)
        without += (reading.field_nT - mean).squaredNorm();
    const Places begin_m = beginnings(readings, (low + high) / 2, size_m);
    std::optional<Placed> best;
    for (const Eigen::Vector3d& begin : begin_m) {
        Placed placed = descendFrom(readings, fields, {begin}, size_m);
        if (!best || placed.part.squares() < best->part.squares())
            best = std::move(placed);
    }
    const double freedom = static_cast<double>(fields.size()) - kUnknownOfOne;
    if (!best || !(best->part.squares() < 0.5 * without))
        return Error{ErrorCode::Numeric,
            MARKED(
                "core", "no dipole explains the readings: the field hardly changes from place to place, or there is more than one source")};
    DipoleSource source;
    source.at_m = best->at_m.front();
    source.moment_A_m2 = best->part.value.head<3>();
    source.uniform_nT = best->part.value.tail<3>();
    source.rms_nT = std::sqrt(best->part.squares() / freedom);
    source.nearest_m = nearestTo(readings, source.at_m);
    const Eigen::MatrixXd design = designAt(readings, best->at_m);
    Eigen::MatrixXd whole(fields.size(), 9);
    whole << slopeAt(readings, fields, *best, 1e-5 * size_m), design;
    const Eigen::VectorXd scale = whole.colwise().norm().transpose().cwiseMax(1e-30);
    const Eigen::MatrixXd scaled = whole * scale.cwiseInverse().asDiagonal();
    const Eigen::MatrixXd inverse = pseudoInverse(product(scaled.transpose(), scaled));
    const auto errorOf = [&](Eigen::Index i) { return source.rms_nT * std::sqrt(std::max(0.0, inverse(i, i))) / scale[i]; };
    source.atError_m = {errorOf(0), errorOf(1), errorOf(2)};
    source.momentError_A_m2 = std::hypot(errorOf(3), errorOf(4), errorOf(5));
    source.uniformError_nT = {errorOf(6), errorOf(7), errorOf(8)};
    const bool exact = best->part.squares() <= kRounding * without;
    if (!exact)
        source.two = secondBeside(readings, fields, *best, begin_m, size_m);
    if (source.two)
        reachToTheTwo(source);
    else if (!exact)
        widenForNeighbours(source, readings, best->part.residual);
    if (length_m > 0 && source.nearest_m < 3 * length_m)
        source.warnings.push_back(
            {MARKED("core", "the nearest reading is %1 m from the source, less than three of its lengths (%2 m): it is no dipole there"),
                figureText(source.nearest_m, 2), figureText(3 * length_m, 2)});
    if (source.atError_m.norm() > 0.5 * source.nearest_m)
        source.warnings.push_back({MARKED("core", "the place is sure to %1 m only: read nearer to it, and on more sides"),
            figureText(source.atError_m.norm(), 2)});
    return source;
}

std::span<const InstallationDistance> installationDistances()
{
    static constexpr std::array<InstallationDistance, 6> kDistances{
        {{MARKED("core", "electric motors and relays, magnets, loudspeakers"), 3.0},
            {MARKED("core", "ferrous parts of more than 1 kg"), 2.5}, {MARKED("core", "ferrous parts of less than 1 kg"), 1.0},
            {MARKED("core", "wires of more than 100 mA"), 1.0}, {MARKED("core", "wires of less than 100 mA"), 0.6},
            {MARKED("core", "another flux gate"), 0.6}}};
    return kDistances;
}

} // namespace lubberline
