#include "core/calibration/Compensation.h"

#include <Eigen/Core>
#include <algorithm>
#include <charconv>
#include <map>

#include "core/algebra/Solve.h"
#include "core/angle/Angle.h"
#include "core/base/Number.h"
#include "core/calibration/ChangeInTime.h"
#include "core/calibration/EllipsoidParts.h"
#include "core/calibration/LogQuality.h"
#include "core/calibration/ModelHeader.h"
#include "core/calibration/ReferenceHeading.h"
#include "core/sensor/Attitude.h"
#include "core/sensor/map/VectorAtan2.h"

namespace lubberline {

namespace {

constexpr double kHelmetRate_hz = 240, kHelmetLatency_ms = 3.5, kHelmetHeading_deg = 0.2;
constexpr double kLevelSwing = 0.1; ///< of the field: 6° of tilt where it points down

HeadingErrors errorsOf(const std::vector<double>& read_deg, const std::vector<double>& magnetic_deg)
{
    HeadingErrors errors;
    std::vector<double> sizes;
    Eigen::Matrix<double, 9, 9> normal = Eigen::Matrix<double, 9, 9>::Zero();
    Eigen::Matrix<double, 9, 1> right = Eigen::Matrix<double, 9, 1>::Zero();
    for (std::size_t row = 0; row < read_deg.size(); ++row) {
        const double error = wrap180(read_deg[row] - magnetic_deg[row]);
        if (!std::isfinite(error))
            continue;
        errors.mean_deg += error;
        errors.rms_deg += error * error;
        sizes.push_back(std::abs(error));
        Eigen::Matrix<double, 9, 1> x;
        x[0] = 1;
        for (int order = 1; order <= 4; ++order) {
            x[2 * order - 1] = std::sin(order * toRadians(magnetic_deg[row]));
            x[2 * order] = std::cos(order * toRadians(magnetic_deg[row]));
        }
        normal.noalias() += x * x.transpose();
        right += error * x;
    }
    if (sizes.empty())
        return errors;
    const auto count = static_cast<double>(sizes.size());
    errors.mean_deg /= count;
    errors.rms_deg = std::sqrt(errors.rms_deg / count);
    std::sort(sizes.begin(), sizes.end());
    errors.p95_deg = sizes[static_cast<std::size_t>(0.95 * (count - 1))];
    errors.max_deg = sizes.back();
    const Eigen::Matrix<double, 9, 1> solved = leastNorm(normal, right);
    std::copy(solved.begin(), solved.end(), errors.harmonics_deg.begin());
    return errors;
}

double spreadOfSizes(const std::vector<double>& sizes)
{
    double mean = 0, squares = 0;
    for (const double size : sizes)
        mean += size / static_cast<double>(sizes.size());
    for (const double size : sizes)
        squares += (size - mean) * (size - mean);
    return sizes.size() > 1 ? std::sqrt(squares / static_cast<double>(sizes.size() - 1)) : 0.0;
}

double meanOf(const std::vector<double>& sizes)
{
    double mean = 0;
    for (const double size : sizes)
        mean += size / static_cast<double>(sizes.size());
    return mean;
}

/// The column of each circuit's current; null where the log has none.
std::vector<const std::vector<double>*> currentsOf(const SensorLog& log, const SensorModel& model)
{
    std::vector<const std::vector<double>*> columns;
    for (const auto& circuit : model.circuits) {
        const auto found
            = std::find_if(log.currents.begin(), log.currents.end(), [&](const LogColumn& column) { return column.name == circuit.name; });
        columns.push_back(found == log.currents.end() ? nullptr : &found->values);
    }
    return columns;
}

void appendCell(std::string& text, double value, char end)
{
    std::array<char, 40> buffer{};
    if (std::isfinite(value))
        text.append(buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, 4).ptr);
    text += end;
}

void doubt(CompensatedLog& result, const SensorLog& log, const CompensationOptions& options, const std::vector<double>& before,
    const std::vector<double>& after)
{
    if (result.spreadAfter > result.spreadBefore && before.size() > 20)
        result.warnings.push_back(
            {MARKED("core",
                 "the field's size spreads by %1 %3 with the model and by %2 %3 without: a log of another sensor, or of another mount?"),
                figureText(result.spreadAfter, 0), figureText(result.spreadBefore, 0), log.figureUnit()});
    if (!options.field || options.field->down_nT == 0 || log.unit == FieldUnit::Counts)
        return;
    const double off = meanOf(after) / options.field->total_nT() - 1;
    if (std::abs(off) > 0.3)
        result.warnings.push_back(
            {MARKED(
                 "core", "the field's size is %1 nT with the model, %2 % off the model's %3 nT: a log of another sensor, unit or place?"),
                figureText(meanOf(after), 0), signedFigureText(100 * off, 0), figureText(options.field->total_nT(), 0)});
}

using ModelRow9 = Eigen::Matrix<double, 9, 1>;

/// d|f| by what may still be wrong with a model, part of the field F: a symmetric matrix (a, b, c, e, f, k) and hard iron.
ModelRow9 sizeRow(const Eigen::Vector3d& along, double field)
{
    ModelRow9 row;
    row << field * along[0] * along[0], 2 * field * along[0] * along[1], 2 * field * along[0] * along[2], field * along[1] * along[1],
        2 * field * along[1] * along[2], field * along[2] * along[2], along;
    return row;
}

/// Iron or a gain that changed during the log: a model is for one of each. By the sizes of the fields that it leaves, which a wrong model
/// makes depend on the attitude, but not on the time.
Message changeDuring(const SensorLog& log, const CompensatedLog& result, const std::vector<std::uint8_t>& usable, double field)
{
    const std::vector<std::size_t> rows = someRows(usable);
    constexpr std::size_t kFewest = 200;
    if (rows.size() < kFewest)
        return {};
    const auto fieldAt = [&](std::size_t row) { return Eigen::Vector3d(result.field[0][row], result.field[1][row], result.field[2][row]); };
    TimeBlocks blocks;
    blocks.fill({Eigen::MatrixXd::Zero(9, 9), Eigen::MatrixXd::Zero(9, 1)});
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(9, 9), score = Eigen::MatrixXd::Zero(9, 1);
    for (const std::size_t row : rows) {
        const Eigen::Vector3d one = fieldAt(row);
        const ModelRow9 design = sizeRow(one.normalized(), field);
        TimeBlock& block = blocks[timeBlockOf(row, log.size())];
        block.normal += design * design.transpose();
        block.score += design * (one.norm() - field);
    }
    for (const TimeBlock& block : blocks) {
        normal += block.normal;
        score += block.score;
    }
    const ModelRow9 always = leastNorm(normal, score);
    std::vector<double> left;
    double squares = 0;
    for (const std::size_t row : rows) {
        const Eigen::Vector3d one = fieldAt(row);
        left.push_back(one.norm() - field - sizeRow(one.normalized(), field).dot(always));
        squares += left.back() * left.back();
    }
    Eigen::MatrixXd steps = Eigen::MatrixXd::Zero(9, 4);
    steps.block<3, 3>(6, 0).setIdentity();
    for (const Eigen::Index size : {0, 3, 5})
        steps(size, 3) = 1;
    auto change = changeInTime(blocks, Eigen::MatrixXd::Identity(9, 9), {steps}, squares / static_cast<double>(rows.size()));
    if (!change)
        return {};
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (change->isAfter(rows[i], log.size()))
            left[i] -= fieldAt(rows[i]).normalized().dot(change->hardIron) + field * change->gain;
    change->widen(std::sqrt(slowResidualFactor(left)));
    return wordsOf(*change, log, field);
}

/// Half of how far the field along z goes, of nine tenths of the samples, as a part of the field: of a level sensor it stays where it is.
double swingOfDown(const std::array<std::vector<double>, 3>& field, double size)
{
    std::vector<double> down;
    for (const double z : field[2])
        if (std::isfinite(z))
            down.push_back(z);
    if (down.empty() || !(size > 0))
        return 0;
    const auto part = [&](double share) {
        const auto at = down.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(down.size() - 1));
        std::nth_element(down.begin(), at, down.end());
        return *at;
    };
    const double high = part(0.95);
    return (high - part(0.05)) / (2 * size);
}

/// What a log without pitch and roll is taken for. @return whether it was tilted all the same
bool tellLevelTaken(CompensatedLog& result, const std::vector<double>& sizes)
{
    const double swing = swingOfDown(result.field, meanOf(sizes));
    if (swing <= kLevelSwing) {
        result.warnings.push_back({MARKED("core", "without pitch and roll the headings are those of a level compass")});
        return false;
    }
    result.warnings.push_back(
        {MARKED("core",
             "without pitch and roll the headings are those of a level compass, and this one was tilted: the field along z goes up and down by %1 % of the field; expected %2 % or less. Headings of it mean nothing, and there is no deviation map"),
            figureText(100 * swing, 0), figureText(100 * kLevelSwing, 0)});
    return true;
}

/// Cells that hold samples, by pitch and then heading. @param referenced whether the heading column is a reference
std::vector<ErrorCell> errorMap(
    const SensorLog& log, const std::vector<double>& before_deg, const std::vector<double>& after_deg, bool referenced)
{
    std::map<std::pair<long, long>, ErrorCell> cells; // by pitch, heading
    const auto headings = std::lround(360 / kCellHeading_deg);
    for (std::size_t row = 0; row < log.size(); ++row) {
        const double magnetic_deg = referenced ? log.heading_deg[row] : after_deg[row];
        const double pitch_deg = log.pitch_deg.empty() ? 0.0 : log.pitch_deg[row];
        const double before = wrap180(magnetic_deg - before_deg[row]), after = wrap180(magnetic_deg - after_deg[row]);
        if (!std::isfinite(before) || !std::isfinite(after) || !std::isfinite(pitch_deg))
            continue;
        const long pitch = std::lround(pitch_deg / kCellPitch_deg),
                   heading = std::lround(wrap360(magnetic_deg) / kCellHeading_deg) % headings;
        ErrorCell& cell = cells[{pitch, heading}];
        cell.heading_deg = static_cast<double>(heading) * kCellHeading_deg;
        cell.pitch_deg = static_cast<double>(pitch) * kCellPitch_deg;
        ++cell.samples;
        cell.before_deg += before;
        if (referenced)
            cell.after_deg = cell.after_deg.value_or(0.0) + after;
    }
    std::vector<ErrorCell> map;
    for (auto& [place, cell] : cells) {
        cell.before_deg /= static_cast<double>(cell.samples);
        if (cell.after_deg)
            *cell.after_deg /= static_cast<double>(cell.samples);
        map.push_back(cell);
    }
    return map;
}

/// Fills sigma_deg of each.
void addSigma(std::vector<ErrorCell>& map, const SensorModel& model, const ModelUncertainty& uncertainty, const MeridianField& field)
{
    for (ErrorCell& cell : map)
        if (const auto sigma_rad
            = headingSigma_rad(model, uncertainty, field, {MagneticHeading::fromDegrees(cell.heading_deg), toRadians(cell.pitch_deg), 0}))
            cell.sigma_deg = toDegrees(*sigma_rad);
}

} // namespace

Result<CompensatedLog> compensate(const SensorLog& log, const SensorModel& model, const CompensationOptions& options)
{
    SensorModel still = model; // without the circuits that the log tells of
    const auto currents = currentsOf(log, model);
    for (std::size_t k = 0; k < currents.size(); ++k)
        still.circuits[k].on = still.circuits[k].on && currents[k] == nullptr;
    const auto compensator = compensatorOf(still);
    if (!compensator)
        return compensator.error();
    const LogQuality quality = qualityOf(log);
    CompensatedLog result;
    result.rate_hz = quality.rate_hz;
    result.warnings = quality.remarks;
    const Eigen::Matrix3d mount = rotation(model.misalignment.roll_rad, model.misalignment.pitch_rad, model.misalignment.yaw_rad);
    std::vector<double> sizesBefore, sizesAfter;
    std::vector<std::uint8_t> whole(log.size(), 0);
    for (std::size_t row = 0; row < log.size(); ++row) {
        Eigen::Vector3d measured = log.at(row);
        for (std::size_t k = 0; k < currents.size(); ++k)
            if (currents[k])
                measured -= mount * model.circuits[k].field_nT_per_A * (*currents[k])[row];
        const Eigen::Vector3d field = compensator->field(measured);
        for (std::size_t axis = 0; axis < 3; ++axis)
            result.field[axis].push_back(field[static_cast<Eigen::Index>(axis)]);
        const double pitch_deg = log.pitch_deg.empty() ? 0 : log.pitch_deg[row], roll_deg = log.roll_deg.empty() ? 0 : log.roll_deg[row];
        const bool usable = field.allFinite() && quality.faults[row] != SampleFault::Spike && std::isfinite(pitch_deg + roll_deg);
        whole[row] = usable ? 1 : 0;
        result.before_deg.push_back(usable ? headingOf_deg(log.at(row), pitch_deg, roll_deg) : kNoValue);
        result.after_deg.push_back(usable ? headingOf_deg(field, pitch_deg, roll_deg) : kNoValue);
        if (!usable)
            continue;
        sizesBefore.push_back(log.at(row).norm());
        sizesAfter.push_back(field.norm());
    }
    if (sizesAfter.empty())
        return Error{ErrorCode::InvalidInput, MARKED("core", "holds no usable sample")};
    result.spreadBefore = spreadOfSizes(sizesBefore);
    result.spreadAfter = spreadOfSizes(sizesAfter);
    doubt(result, log, options, sizesBefore, sizesAfter);
    if (Message change = changeDuring(log, result, whole, meanOf(sizesAfter)); !change.empty())
        result.warnings.push_back(std::move(change));
    if (!log.heading_deg.empty()) {
        if (const Message own = headingOfItsOwn(log, whole); own.empty()) {
            result.before = errorsOf(result.before_deg, log.heading_deg);
            result.after = errorsOf(result.after_deg, log.heading_deg);
        } else {
            result.warnings.push_back(own);
        }
    }
    if (const bool level = log.pitch_deg.empty() || log.roll_deg.empty(); !level || !tellLevelTaken(result, sizesAfter))
        result.map = errorMap(log, result.before_deg, result.after_deg, result.after.has_value());
    if (options.uncertainty && options.field && options.field->down_nT != 0)
        addSigma(result.map, model, *options.uncertainty, *options.field);
    std::optional<double> latency;
    if (options.latency_ms)
        latency = *options.latency_ms + options.filter_ms;
    std::optional<double> rate; // to 0.01 Hz: times of a log are rounded
    if (result.rate_hz)
        rate = std::round(100 * *result.rate_hz) / 100;
    result.demands = {{{MARKED("core", "samples a second")}, rate, kHelmetRate_hz, "Hz", true},
        {{MARKED("core", "latency of the sensor and the filter")}, latency, kHelmetLatency_ms, "ms", false},
        {{MARKED("core", "heading error, rms")}, result.after ? std::optional(result.after->rms_deg) : std::nullopt, kHelmetHeading_deg,
            "deg", false}};
    return result;
}

void levelHeadings(const std::array<std::span<const double>, 3>& measured, const Eigen::Matrix3d& matrix, const Eigen::Vector3d& offset,
    std::span<double> heading_deg)
{
    constexpr std::size_t kChunk = 512;
    std::array<double, kChunk> forward{}, starboard{};
    const Eigen::Vector3d shift = matrix * offset;
    for (std::size_t from = 0; from < heading_deg.size(); from += kChunk) {
        const std::size_t count = std::min(kChunk, heading_deg.size() - from);
        const double* x = measured[0].data() + from;
        const double* y = measured[1].data() + from;
        const double* z = measured[2].data() + from;
        for (std::size_t i = 0; i < count; ++i) {
            forward[i] = matrix(0, 0) * x[i] + matrix(0, 1) * y[i] + matrix(0, 2) * z[i] - shift[0];
            starboard[i] = -(matrix(1, 0) * x[i] + matrix(1, 1) * y[i] + matrix(1, 2) * z[i] - shift[1]);
        }
        vectorAtan2(starboard.data(), forward.data(), heading_deg.data() + from, count);
        for (std::size_t i = from; i < from + count; ++i)
            heading_deg[i] = kDegreesPerRadian * heading_deg[i] + (heading_deg[i] < 0 ? 360.0 : 0.0);
    }
}

std::string writeCompensatedCsv(const SensorLog& log, const CompensatedLog& compensated)
{
    const std::string unit = log.unit == FieldUnit::Counts ? "" : "_nT";
    std::string text = log.time_s.empty() ? "" : "time_s,";
    text += "bx" + unit + ",by" + unit + ",bz" + unit + ",heading_before_deg,heading_after_deg\n";
    for (std::size_t row = 0; row < log.size(); ++row) {
        if (!log.time_s.empty())
            text.append(shortestNumber(log.time_s[row])) += ',';
        for (const auto& axis : compensated.field)
            appendCell(text, axis[row], ',');
        appendCell(text, compensated.before_deg[row], ',');
        appendCell(text, compensated.after_deg[row], '\n');
    }
    return text;
}

} // namespace lubberline
