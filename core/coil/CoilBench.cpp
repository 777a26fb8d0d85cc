#include "core/coil/CoilBench.h"

#include <Eigen/LU>
#include <algorithm>

#include "core/algebra/Products.h"
#include "core/algebra/Solve.h"
#include "core/algebra/Spectra.h"
#include "core/angle/Angle.h"
#include "core/base/FileText.h"
#include "core/base/Number.h"

namespace lubberline {

namespace {

constexpr std::size_t kLeastEachWay = 3;
constexpr double kLeastScale = 0.5, kMostScale = 2; ///< of a sensor whose columns say nT

struct BenchRows {
    std::vector<std::size_t> rows;
    std::array<const std::vector<double>*, 3> applied{};
    std::array<std::vector<double>, 3> way; ///< +1: the applied field rose last, −1: it fell, 0: not moved yet
    std::vector<double> temperature;        ///< from its mean; empty: none, or it did not change
    std::optional<double> meanTemperature_c;
};

Result<BenchRows> benchRows(const SensorLog& log)
{
    BenchRows bench;
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (bench.applied[axis] = columnOf(log, kAppliedColumns[axis]); !bench.applied[axis])
            return Error{ErrorCode::InvalidInput,
                MARKED("core", "has no applied field; expected the columns ax_nT, ay_nT, az_nT beside bx_nT, by_nT, bz_nT")};
    const auto* temperature = columnOf(log, "temperature_c");
    std::array<double, 3> last{}, way{};
    for (std::size_t row = 0; row < log.size(); ++row) {
        bool whole = log.hasField(row) && (!temperature || std::isfinite((*temperature)[row]));
        for (const auto* column : bench.applied)
            whole = whole && std::isfinite((*column)[row]);
        if (!whole)
            continue;
        // An axis that rests while another moves is on neither way; while all rest, it stays on its own.
        bool moved = false;
        for (std::size_t axis = 0; axis < 3; ++axis)
            moved = moved || (!bench.rows.empty() && (*bench.applied[axis])[row] != last[axis]);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double now = (*bench.applied[axis])[row];
            if (moved)
                way[axis] = now > last[axis] ? 1.0 : now < last[axis] ? -1.0 : 0.0;
            last[axis] = now;
            bench.way[axis].push_back(way[axis]);
        }
        bench.rows.push_back(row);
        if (temperature)
            bench.temperature.push_back((*temperature)[row]);
    }
    if (bench.rows.size() < 8)
        return Error{ErrorCode::Numeric, {MARKED("core", "has %1 whole rows; expected 8 or more"), bench.rows.size()}};
    if (temperature) {
        double mean = 0;
        for (const double value : bench.temperature)
            mean += value / static_cast<double>(bench.temperature.size());
        bench.meanTemperature_c = mean;
        const auto [low, high] = std::minmax_element(bench.temperature.begin(), bench.temperature.end());
        if (*high - *low < 1.0)
            bench.temperature.clear();
        for (auto& value : bench.temperature)
            value -= mean;
    }
    return bench;
}

bool bothWays(const std::vector<double>& way)
{
    return std::count(way.begin(), way.end(), 1.0) >= static_cast<std::ptrdiff_t>(kLeastEachWay)
        && std::count(way.begin(), way.end(), -1.0) >= static_cast<std::ptrdiff_t>(kLeastEachWay);
}

/// Largest part of the residual that a curve of third order along the axis explains; takes it out of the residual.
double takeNonlinearity(Eigen::VectorXd& residual, const Eigen::VectorXd& along)
{
    const double range = along.cwiseAbs().maxCoeff();
    if (range <= 0)
        return 0;
    Eigen::MatrixXd curve(residual.size(), 4);
    const Eigen::VectorXd u = along / range;
    curve << Eigen::VectorXd::Ones(u.size()), u, u.cwiseAbs2(), u.cwiseProduct(u.cwiseAbs2());
    const PivotedSolution fit = pivotedSolve(curve, residual);
    if (fit.rank < 4)
        return 0;
    const Eigen::VectorXd bent = curve * fit.solution;
    residual -= bent;
    return bent.cwiseAbs().maxCoeff();
}

void takeAxes(CoilResult& result)
{
    Eigen::Matrix3d axes;
    for (Eigen::Index i = 0; i < 3; ++i) {
        result.scale[i] = result.gain.row(i).norm();
        axes.row(i) = result.gain.row(i) / result.scale[i];
    }
    const auto lean
        = [&](Eigen::Index i, Eigen::Index j) { return toDegrees(std::asin(std::clamp(axes.row(i).dot(axes.row(j)), -1.0, 1.0))); };
    result.nonOrthogonality_deg = {lean(0, 1), lean(0, 2), lean(1, 2)};
    const SingularParts parts = singularParts(axes);
    const Eigen::Matrix3d turn = product(parts.U, parts.V.transpose());
    if (turn.determinant() < 0) {
        result.warnings.push_back({MARKED("core",
            "an odd number of the sensor's axes runs against the coil's: its frame is left-handed, and no rotation describes its mount")});
        return;
    }
    result.misalignment.pitch_rad = -std::asin(std::clamp(turn(0, 2), -1.0, 1.0));
    result.misalignment.yaw_rad = std::atan2(turn(0, 1), turn(0, 0));
    result.misalignment.roll_rad = std::atan2(turn(1, 2), turn(2, 2));
}

/// No sensor measures half or twice of what is applied along every axis: then one of both columns is in another unit than it says.
Message otherUnit(const Eigen::Vector3d& scale)
{
    const double least = scale.minCoeff(), most = scale.maxCoeff();
    if (most >= kLeastScale && least <= kMostScale)
        return {}; // of one axis only it is the sensor's own
    struct Unit {
        double ratio;
        Pattern words;
    };
    static constexpr std::array<Unit, 6> kUnits{
        {{1e-3, MARKED("core", "the measured columns look like µT")}, {1e-2, MARKED("core", "the measured columns look like mG")},
            {1e-5, MARKED("core", "the measured columns look like G")}, {1e3, MARKED("core", "the applied columns look like µT")},
            {1e2, MARKED("core", "the applied columns look like mG")}, {1e5, MARKED("core", "the applied columns look like G")}}};
    Message looks = MARKED("core", "a column is in another unit, or is not that field");
    for (const Unit& unit : kUnits)
        if (least > kLeastScale * unit.ratio && most < kMostScale * unit.ratio)
            looks = unit.words;
    return {MARKED("core", "has %1 to %2 nT measured per nT applied; expected %3 to %4: %5"), figureText(least, 5), figureText(most, 5),
        figureText(kLeastScale, 1), figureText(kMostScale, 0), std::move(looks)};
}

} // namespace

Result<CoilResult> coilBench(const SensorLog& log)
{
    if (log.unit == FieldUnit::Counts && log.others.empty())
        return Error{ErrorCode::InvalidInput,
            MARKED("core", "has no applied field; expected the columns ax_nT, ay_nT, az_nT beside bx_nT, by_nT, bz_nT")};
    const auto bench = benchRows(log);
    if (!bench)
        return bench.error();
    CoilResult result;
    result.samples = log.size();
    result.used = bench->rows.size();
    result.biasAt_c = bench->meanTemperature_c;
    const auto count = static_cast<Eigen::Index>(result.used);
    const bool warm = !bench->temperature.empty();
    const bool loops = bothWays(bench->way[0]) && bothWays(bench->way[1]) && bothWays(bench->way[2]);
    const Eigen::Index columns = 4 + (warm ? 1 : 0) + (loops ? 1 : 0);
    if (warm)
        result.temperature_nT_per_c = Eigen::Vector3d::Zero();
    if (loops)
        result.hysteresis_nT = Eigen::Vector3d::Zero();
    double largest = 0;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        Eigen::MatrixXd design(count, columns);
        Eigen::VectorXd measured(count);
        for (Eigen::Index i = 0; i < count; ++i) {
            const auto at = static_cast<std::size_t>(i), row = bench->rows[at];
            for (Eigen::Index k = 0; k < 3; ++k) {
                design(i, k) = (*bench->applied[static_cast<std::size_t>(k)])[row];
                largest = std::max(largest, std::abs(design(i, k)));
            }
            design(i, 3) = 1;
            if (warm)
                design(i, 4) = bench->temperature[at];
            if (loops)
                design(i, columns - 1) = 0.5 * bench->way[static_cast<std::size_t>(axis)][at];
            measured[i] = log.field[static_cast<std::size_t>(axis)][row];
        }
        Eigen::VectorXd scale = design.colwise().norm().transpose().cwiseMax(1e-300);
        const PivotedSolution fit = pivotedSolve(design * scale.asDiagonal().inverse(), measured);
        if (fit.rank < columns)
            return Error{ErrorCode::Numeric,
                MARKED("core",
                    "the applied field does not go through all three axes by itself (and temperature, where there is one); expected steps along x, y and z")};
        const Eigen::VectorXd solved = scale.asDiagonal().inverse() * fit.solution.col(0);
        Eigen::VectorXd residual = measured - design * solved;
        const double scatter = residual.squaredNorm() / static_cast<double>(std::max<Eigen::Index>(1, count - columns));
        const Eigen::MatrixXd inverse = inversePositive(product(design.transpose(), design));
        result.gain.row(axis) = solved.head<3>().transpose();
        result.bias_nT[axis] = solved[3];
        result.biasError_nT[axis] = std::sqrt(scatter * inverse(3, 3));
        result.scaleError[axis] = std::sqrt(scatter * inverse(axis, axis));
        if (warm)
            (*result.temperature_nT_per_c)[axis] = solved[4], result.temperatureError_nT_per_c[axis] = std::sqrt(scatter * inverse(4, 4));
        if (loops)
            (*result.hysteresis_nT)[axis] = solved[columns - 1];
        result.nonlinearity_nT[axis] = takeNonlinearity(residual, design.col(axis));
        result.noise_nT[axis] = std::sqrt(residual.squaredNorm() / static_cast<double>(std::max<Eigen::Index>(1, count - columns - 2)));
    }
    takeAxes(result);
    if (log.unit != FieldUnit::Counts)
        if (Message other = otherUnit(result.scale); !other.empty())
            return Error{ErrorCode::InvalidInput, std::move(other)};
    result.range_nT = largest;
    result.rows = bench->rows;
    if (largest < 60000)
        result.warnings.push_back(
            {MARKED("core",
                 "the applied field went to %1 nT only: beyond it nothing is known of the sensor (a field of the Earth with an aircraft's iron reaches 65 000 nT and more)"),
                figureText(largest, 0)});
    if (log.unit == FieldUnit::Counts)
        result.warnings.push_back(
            {MARKED("core", "the measured field is in counts: scale is counts per nT, and bias, noise and the rest are in counts")});
    return result;
}

} // namespace lubberline
