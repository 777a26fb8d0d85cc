#include "core/calibration/Ellipsoid.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <random>

#include "core/algebra/Solve.h"
#include "core/algebra/Spectra.h"
#include "core/angle/Angle.h"
#include "core/base/Alongside.h"
#include "core/base/Middle.h"
#include "core/base/Number.h"
#include "core/base/VectorClones.h"
#include "core/calibration/ChangeInTime.h"
#include "core/calibration/EllipsoidParts.h"
#include "core/calibration/LogQuality.h"
#include "core/calibration/QuadricFit.h"
#include "core/calibration/Spectrum.h"

namespace lubberline {

namespace {

constexpr double kTrim = 4.0 * 1.4826;

FieldColumns columnsOf(const SensorLog& log) { return {log.field[0], log.field[1], log.field[2]}; }

/// Distance from the quadric, to first order, in the unit of the points: (|V d| − 1)/|V n|.
double distanceFrom(const Quadric& quadric, const Eigen::Vector3d& m)
{
    const Eigen::Vector3d unit = quadric.toUnit * (m - quadric.centre);
    const double size = unit.norm(), slope = (quadric.toUnit * unit).norm();
    return size > 0 && slope > 0 ? (size - 1.0) * size / slope : 1.0 / quadric.toUnit.norm();
}

LUBBERLINE_VECTOR_CLONES void dropOutside(const double* values, std::size_t count, double least, double most, std::uint8_t* used)
{
    for (std::size_t i = 0; i < count; ++i)
        used[i] = static_cast<std::uint8_t>(
            used[i] & static_cast<std::uint8_t>(!(values[i] < least)) & static_cast<std::uint8_t>(!(values[i] > most)));
}

/// Rows far outside of where the log is on an axis: a whole spike of many fields' size would drown all else.
void dropFarRows(const SensorLog& log, const LogQuality& quality, std::vector<std::uint8_t>& used)
{
    const auto rows = someRows(used);
    if (rows.size() < 20)
        return;
    std::vector<double> some;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto& values = log.field[axis];
        some.clear();
        some.reserve(rows.size());
        for (const auto row : rows)
            some.push_back(values[row]);
        const auto twentieth = static_cast<std::ptrdiff_t>(some.size() / 20);
        std::nth_element(some.begin(), some.begin() + twentieth, some.end());
        const double low = some[static_cast<std::size_t>(twentieth)];
        std::nth_element(some.begin() + twentieth, some.end() - 1 - twentieth, some.end());
        const double high = *(some.end() - 1 - twentieth), margin = 1.5 * (high - low);
        if (quality.ends[axis].lowest < low - margin || quality.ends[axis].highest > high + margin)
            dropOutside(values.data(), values.size(), low - margin, high + margin, used.data());
    }
}

/// A sphere through four drawn points that half of the log lies nearest to: a start that no minority of bad samples can move.
std::optional<Quadric> consensusSphere(const SensorLog& log, const std::vector<std::size_t>& rows)
{
    std::mt19937 draw(12345); // the same log gives the same result
    std::optional<Quadric> best;
    double least = std::numeric_limits<double>::max();
    for (int attempt = 0; attempt < 400; ++attempt) {
        Eigen::Matrix4d system;
        Eigen::Vector4d squares;
        for (int i = 0; i < 4; ++i) {
            const Eigen::Vector3d m = log.at(rows[draw() % rows.size()]) - log.at(rows[0]);
            system.row(i) << 2.0 * m.transpose(), 1.0;
            squares[i] = m.squaredNorm();
        }
        const auto solution = solveSquare(system, squares);
        if (!solution)
            continue;
        const Eigen::Vector4d solved = *solution;
        const double radius2 = solved[3] + solved.head<3>().squaredNorm();
        if (!solved.allFinite() || !(radius2 > 0))
            continue;
        Quadric sphere;
        sphere.centre = solved.head<3>() + log.at(rows[0]);
        sphere.toUnit = Eigen::Matrix3d::Identity() / std::sqrt(radius2);
        std::vector<double> away;
        for (const auto row : rows)
            away.push_back(std::abs(distanceFrom(sphere, log.at(row))));
        if (const double middle = middleOf(std::move(away)); middle < least) {
            least = middle;
            best = sphere;
        }
    }
    return best;
}

struct Trimmed {
    std::optional<Quadric> quadric;
    std::vector<std::uint8_t> used;
    double scatter = std::numeric_limits<double>::max(); ///< 1.4826 MAD of all that were offered
};

double scatterOf(const Quadric& quadric, const FieldSamples& samples)
{
    std::vector<double> away;
    away.reserve(samples.size());
    for (const auto& sample : samples)
        away.push_back(std::abs(distanceFrom(quadric, sample)));
    return 1.4826 * middleOf(std::move(away));
}

/// |V (m − c)|² of rows, which is 1 on the quadric. @return how many lie from `least` to `most`
LUBBERLINE_VECTOR_CLONES std::int64_t squaredSizes(const double* x, const double* y, const double* z, std::size_t count, const double* v,
    const double* c, double least, double most, double* square)
{
    std::int64_t between = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const double dx = x[i] - c[0], dy = y[i] - c[1], dz = z[i] - c[2];
        const double ux = v[0] * dx + v[3] * dy + v[6] * dz, uy = v[1] * dx + v[4] * dy + v[7] * dz, uz = v[2] * dx + v[5] * dy + v[8] * dz;
        const double size = ux * ux + uy * uy + uz * uz;
        square[i] = size;
        between += (size >= least) & (size <= most) ? 1 : 0;
    }
    return between;
}

/// Rows of `offered` within the trimming limit of a quadric.
std::vector<std::uint8_t> within(const SensorLog& log, const Quadric& quadric, const std::vector<std::uint8_t>& offered, double scatter)
{
    const double limit = std::max(kTrim / 1.4826 * scatter, 1e-9 / quadric.toUnit.norm());
    std::vector<std::uint8_t> used(offered.size(), 0);
    const Eigen::Matrix3d v = quadric.toUnit;
    const Eigen::Vector3d c = quadric.centre;
    // (size − 1) size/slope against the limit; the slope of V lies between its extremes, which decides nearly all rows without a root.
    const Eigen::Vector3d stretch = symmetricParts(v.transpose() * v).values.cwiseMax(0.0).cwiseSqrt();
    const auto ends
        = [limit](double slope) { return std::pair(std::pow(std::max(0.0, 1.0 - limit * slope), 2), std::pow(1.0 + limit * slope, 2)); };
    const auto [surelyFrom, surelyTo] = ends(stretch.minCoeff() * (1 - 1e-12));
    const auto [maybeFrom, maybeTo] = ends(stretch.maxCoeff() * (1 + 1e-12));
    constexpr std::size_t kRows = 512, kPart = 64 * kRows;
    alongside((offered.size() + kPart - 1) / kPart,
        [&, surelyFrom = surelyFrom, surelyTo = surelyTo, maybeFrom = maybeFrom, maybeTo = maybeTo](std::size_t part) {
            std::array<double, kRows> squares{};
            const std::size_t end = std::min(offered.size(), (part + 1) * kPart);
            for (std::size_t from = part * kPart; from < end; from += kRows) {
                const std::size_t count = std::min(kRows, end - from);
                const auto sure = squaredSizes(&log.field[0][from], &log.field[1][from], &log.field[2][from], count, v.data(), c.data(),
                    surelyFrom, surelyTo, squares.data());
                if (static_cast<std::size_t>(sure) == count) {
                    std::copy_n(
                        offered.begin() + static_cast<std::ptrdiff_t>(from), count, used.begin() + static_cast<std::ptrdiff_t>(from));
                    continue;
                }
                for (std::size_t i = 0; i < count; ++i) {
                    const double square = squares[i];
                    bool in = square >= surelyFrom && square <= surelyTo;
                    if (!in && square >= maybeFrom && square <= maybeTo)
                        in = std::abs(square - std::sqrt(square)) <= limit * (v * (v * (log.at(from + i) - c))).norm();
                    used[from + i] = static_cast<std::uint8_t>(in && offered[from + i] != 0);
                }
            }
        });
    return used;
}

/// @param samples  some of what is offered
Trimmed trimmedFit(const SensorLog& log, const std::vector<std::uint8_t>& offered, const FieldSamples& samples, EllipsoidShape shape,
    std::optional<Quadric> start)
{
    Trimmed result;
    result.used = offered;
    if (start)
        result.used = within(log, *start, offered, scatterOf(*start, samples));
    for (int round = 0; round < 5; ++round) {
        const FieldSamples mine = round == 0 && !start ? samples : samplesOf(log, someRows(result.used));
        if (mine.size() <= freeOf(shape))
            return {};
        const Spread spread = spreadOf(mine);
        const FieldMoments moments = momentsOf(columnsOf(log), result.used, spread.centre, spread.scale);
        result.quadric = adjustedQuadric(moments, shape);
        if (!result.quadric && round == 0 && shape == EllipsoidShape::General)
            result.quadric = constrainedQuadric(moments);
        if (!result.quadric)
            return {};
        result.scatter = scatterOf(*result.quadric, samples);
        auto next = within(log, *result.quadric, offered, result.scatter);
        if (next == result.used)
            break;
        result.used = std::move(next);
    }
    return result;
}

} // namespace

std::string_view nameOf(CalibrationVerdict verdict)
{
    return verdict == CalibrationVerdict::Good ? "good" : verdict == CalibrationVerdict::Doubtful ? "doubtful" : "not determined";
}

double residualOf(const EllipsoidFit& fit, const Eigen::Vector3d& measured)
{
    return ((Eigen::Matrix3d::Identity() + fit.softIron).inverse() * (measured - fit.hardIron)).norm() - fit.field;
}

EllipsoidResult fitEllipsoid(const SensorLog& log, EllipsoidShape shape, std::optional<double> field_nT)
{
    EllipsoidResult result;
    result.samples = log.size();
    if (log.unit == FieldUnit::Counts && field_nT) {
        result.warnings.push_back(
            {MARKED("core", "the log is in counts: the field that was given is not used, and the radius is in counts")});
        field_nT.reset();
    }
    const LogQuality quality = qualityOf(log);
    result.warnings.insert(result.warnings.end(), quality.remarks.begin(), quality.remarks.end());
    if (quality.rate_hz && log.size() > 100) {
        const double onZero_hz = 0.005 * *quality.rate_hz;
        for (Message& folded : std::array{warningOfZero(*quality.rate_hz, onZero_hz), warningOfSlow(*quality.rate_hz, onZero_hz)})
            if (!folded.empty())
                result.warnings.push_back(std::move(folded));
    }
    std::vector<std::uint8_t> offered(log.size());
    std::ranges::transform(quality.faults, offered.begin(),
        [](SampleFault fault) { return static_cast<std::uint8_t>((fault == SampleFault::None) | (fault == SampleFault::Repeat)); });
    dropFarRows(log, quality, offered);
    const auto rows = someRows(offered);
    result.usedRows = offered;
    result.used = static_cast<std::size_t>(std::count(offered.begin(), offered.end(), std::uint8_t{1}));
    if (const Message flat = flatness(log, rows, shape); !flat.empty()) {
        if (Message why = whyFewUsable(log, quality); !why.empty())
            result.reasons.push_back(std::move(why));
        result.reasons.push_back(flat);
        result.nextSteps.push_back({MARKED("core", "turn the sensor through all attitudes, each side up once, with a full turn in each")});
        return result;
    }

    const FieldSamples samples = samplesOf(log, rows);
    Trimmed best = trimmedFit(log, offered, samples, shape, {});
    const double radius = best.quadric ? 1.0 / std::cbrt(best.quadric->toUnit.determinant()) : 0.0;
    if (!best.quadric || best.scatter > 0.01 * radius) {
        Trimmed other = trimmedFit(log, offered, samples, shape, consensusSphere(log, someRows(offered, 1000)));
        if (other.quadric && (!best.quadric || other.scatter < 0.8 * best.scatter))
            best = std::move(other);
    }
    if (!best.quadric) {
        result.reasons.push_back(
            {MARKED("core", "no ellipsoid goes through the samples: too few attitudes, or a field that was not the same everywhere")});
        result.nextSteps.push_back({MARKED("core", "turn the sensor through all attitudes, each side up once, with a full turn in each")});
        return result;
    }
    Message together = leftOutTogether(offered, best.used);
    result.usedRows = std::move(best.used);
    result.used = static_cast<std::size_t>(std::count(result.usedRows.begin(), result.usedRows.end(), std::uint8_t{1}));
    result.fit = fitOf(log, *best.quadric, result.usedRows, shape, field_nT);
    if (shape != EllipsoidShape::General)
        holdAgainstGeneral(result, log, field_nT);
    judge(result, log, field_nT);
    if (!together.empty()) {
        result.verdict = std::max(result.verdict, CalibrationVerdict::Doubtful);
        result.reasons.push_back(std::move(together));
    }
    return result;
}

} // namespace lubberline
