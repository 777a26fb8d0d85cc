#include "core/calibration/AttitudeFit.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "core/algebra/Products.h"
#include "core/algebra/Spectra.h"
#include "core/angle/Angle.h"
#include "core/base/Number.h"
#include "core/calibration/AttitudeParts.h"
#include "core/calibration/ChangeInTime.h"
#include "core/calibration/LogQuality.h"
#include "core/calibration/ModelHeader.h"
#include "core/calibration/ReferenceHeading.h"

namespace lubberline {

namespace {

constexpr int kSectors45 = 8;
constexpr double kGoodHardIron = 0.01, kDeterminedHardIron = 0.05; ///< standard error as a part of F
constexpr double kHeldOutHeading_deg = 2.0;
constexpr double kWellExplained = 0.9, kHalfExplained = 0.5; ///< of the readings' variance

std::vector<std::uint8_t> usableRows(const SensorLog& log, const LogQuality& quality)
{
    std::vector<std::uint8_t> used(log.size(), 0);
    for (std::size_t row = 0; row < log.size(); ++row) {
        bool usable = quality.faults[row] == SampleFault::None || quality.faults[row] == SampleFault::Repeat;
        usable = usable && std::isfinite(log.heading_deg[row]) && std::isfinite(log.pitch_deg[row]) && std::isfinite(log.roll_deg[row]);
        for (const auto& current : log.currents)
            usable = usable && std::isfinite(current.values[row]);
        used[row] = usable ? 1 : 0;
    }
    return used;
}

/// Each axis has the covariance of the regression; its residuals are independent of those of the others.
std::optional<ModelUncertainty> uncertaintyOf(const Regression& fit, double total_nT, double variance)
{
    if (!std::all_of(fit.told.begin(), fit.told.begin() + 4, [](bool told) { return told; }))
        return {};
    ModelUncertainty uncertainty;
    for (Eigen::Index axis = 0; axis < 3; ++axis)
        for (Eigen::Index i = 0; i < 4; ++i)
            for (Eigen::Index j = 0; j < 4; ++j) {
                const auto place = [axis](Eigen::Index regressor) { return regressor < 3 ? 3 * axis + regressor : 9 + axis; };
                const double unit = (i == 3 ? total_nT : 1.0) * (j == 3 ? total_nT : 1.0);
                uncertainty.covariance(place(i), place(j)) = unit * variance * fit.covariance(i, j);
            }
    return uncertainty;
}

SensorModel modelOf(const SensorLog& log, const Regression& fit, double total_nT)
{
    SensorModel model;
    model.softIron = fit.solution.topRows<3>().transpose();
    model.hardIron_nT = total_nT * fit.solution.row(3).transpose();
    const auto scales = currentScales(log);
    for (std::size_t k = 0; k < log.currents.size(); ++k) {
        Circuit circuit;
        circuit.name = log.currents[k].name;
        circuit.field_nT_per_A = total_nT / scales[k] * fit.solution.row(static_cast<Eigen::Index>(4 + k)).transpose();
        model.circuits.push_back(std::move(circuit));
    }
    return model;
}

/// The field of a row by a model whose circuits carry what the log says.
Eigen::Vector3d fieldBy(const SensorModel& model, const Eigen::Matrix3d& inverse, const SensorLog& log, std::size_t row)
{
    Eigen::Vector3d rest = log.at(row) - model.hardIron_nT;
    for (std::size_t k = 0; k < model.circuits.size(); ++k)
        rest -= model.circuits[k].field_nT_per_A * log.currents[k].values[row];
    return inverse * rest;
}

double dipOf_rad(const Eigen::Vector3d& field, double pitch_deg, double roll_deg)
{
    const double sp = std::sin(toRadians(pitch_deg)), cp = std::cos(toRadians(pitch_deg));
    const double sr = std::sin(toRadians(roll_deg)), cr = std::cos(toRadians(roll_deg));
    const double down = -field.x() * sp + field.y() * cp * sr + field.z() * cp * cr;
    return std::asin(std::clamp(down / std::max(field.norm(), 1e-300), -1.0, 1.0));
}

int sectorOf(double heading_deg) { return static_cast<int>(wrap360(heading_deg) / (360.0 / kSectors45)) % kSectors45; }

std::optional<HeldOut> heldOut(const SensorLog& log, const std::vector<std::uint8_t>& used, const AttitudeOptions& options,
    const RegressionMoments& all, const Regression& whole)
{
    const auto scales = currentScales(log);
    HeldOut result;
    double headings = 0, dips = 0, fields = 0, count = 0;
    for (int sector = 0; sector < kSectors45; ++sector) {
        RegressionMoments part;
        std::vector<std::size_t> rows;
        for (std::size_t row = 0; row < log.size(); ++row)
            if (used[row] != 0 && sectorOf(log.heading_deg[row]) == sector) {
                addRow(part, log, row, options.field, scales);
                rows.push_back(row);
            }
        if (rows.empty() || all.rows - part.rows < 2.0 * static_cast<double>(4 + scales.size()))
            continue;
        const Regression fit = regress(without(all, part), toRadians(options.attitudeError_deg));
        if (fit.null.size() != whole.null.size())
            continue; // without this sector less can be told: it would not be the same model
        const SensorModel model = modelOf(log, fit, options.field.total_nT());
        const Eigen::Matrix3d inverse = (Eigen::Matrix3d::Identity() + model.softIron).inverse();
        ++result.blocks;
        for (const auto row : rows) {
            const Eigen::Vector3d field = fieldBy(model, inverse, log, row);
            const double off = wrap180(headingOf_deg(field, log.pitch_deg[row], log.roll_deg[row]) - log.heading_deg[row]);
            const double dip = toDegrees(dipOf_rad(field, log.pitch_deg[row], log.roll_deg[row]) - options.field.inclination_rad());
            headings += off * off;
            dips += dip * dip;
            fields += (field - fieldOfRow(log, row, options.field)).squaredNorm();
            count += 1;
        }
    }
    if (result.blocks == 0)
        return {};
    result.heading_deg = std::sqrt(headings / count);
    result.dip_deg = std::sqrt(dips / count);
    result.field_nT = std::sqrt(fields / count);
    return result;
}

void misalign(AttitudeResult& result)
{
    const SingularParts parts = singularParts(Eigen::Matrix3d::Identity() + result.model.softIron);
    const Eigen::Matrix3d turn = product(parts.U, parts.V.transpose());
    if (turn.determinant() < 0)
        return; // mirrored: no rotation
    result.symmetric = composed(parts.V, parts.values) - Eigen::Matrix3d::Identity();
    result.misalignment.pitch_rad = -std::asin(std::clamp(turn(0, 2), -1.0, 1.0));
    result.misalignment.yaw_rad = std::atan2(turn(0, 1), turn(0, 0));
    result.misalignment.roll_rad = std::atan2(turn(1, 2), turn(2, 2));
}

/// How far a sensor is turned about the vertical, by what the horizontal field does alone: all that a level log tells.
double levelYaw_deg(const SensorModel& model)
{
    const auto& s = model.softIron;
    return toDegrees(std::atan2(s(0, 1) - s(1, 0), 2.0 + s(0, 0) + s(1, 1)));
}

void judgeAttitude(AttitudeResult& result, const AttitudeOptions& options, double explained)
{
    const double total_nT = options.field.total_nT();
    const auto atMost = [&](CalibrationVerdict verdict, Message why) {
        result.reasons.push_back(std::move(why));
        result.verdict = std::max(result.verdict, verdict);
    };
    double worst = 0;
    for (const auto& parameter : result.parameters)
        if (parameter.unit == "nT" && parameter.standard_error)
            worst = std::max(worst, *parameter.standard_error);
    if (worst > kDeterminedHardIron * total_nT)
        atMost(CalibrationVerdict::NotDetermined,
            {MARKED("core", "the standard error of the hard iron is %1 nT; expected %2 nT or less, and nothing is determined above %3 nT"),
                figureText(worst, 0), figureText(kGoodHardIron * total_nT, 0), figureText(kDeterminedHardIron * total_nT, 0)});
    else if (worst > kGoodHardIron * total_nT)
        atMost(CalibrationVerdict::Doubtful,
            {MARKED("core", "the standard error of the hard iron is %1 nT; expected %2 nT or less"), figureText(worst, 0),
                figureText(kGoodHardIron * total_nT, 0)});
    // Of a level swing c and P are told as a sum: that is one of the four less, not two.
    const auto circuitsTold = std::count(result.circuitTold.begin(), result.circuitTold.end(), true);
    const auto fieldTold = result.rank / 3 - circuitsTold;
    if (fieldTold < 3)
        atMost(CalibrationVerdict::NotDetermined,
            {MARKED("core",
                 "of what the field along x, y and z does, and of hard iron, %1 of 4 can be told; expected 3 or more, as a swing through "
                 "all headings tells"),
                fieldTold});
    if (result.rank < result.parametersAsked) {
        atMost(CalibrationVerdict::Doubtful,
            {MARKED("core", "%1 of %2 parameters can be told; what cannot is named"), result.rank, result.parametersAsked});
        result.nextSteps.push_back(
            {MARKED("core", "log all headings at more than one pitch and roll: 20° either way tells all, 5° tells a quarter as well")});
    }
    if (const std::size_t left = result.samples - result.used; left * 5 > result.samples)
        atMost(CalibrationVerdict::Doubtful,
            {MARKED("core", "%1 of %2 samples were left out as spikes or faults; expected one in five or fewer"), left, result.samples});
    if (result.validation && result.validation->heading_deg > kHeldOutHeading_deg)
        atMost(CalibrationVerdict::Doubtful,
            {MARKED("core", "headings that were held out are off by %1° rms; expected %2° or less"),
                figureText(result.validation->heading_deg, 2), figureText(kHeldOutHeading_deg, 1)});
    const double yaw_deg = result.rank < result.parametersAsked ? levelYaw_deg(result.model) : toDegrees(result.misalignment.yaw_rad);
    const bool likeVariation = options.variation && std::abs(options.variation->degrees()) >= 2
        && std::abs(std::abs(yaw_deg) - std::abs(options.variation->degrees())) < 1.0;
    if (likeVariation)
        result.warnings.push_back(
            {MARKED("core",
                 "the sensor seems turned by %1°, which is the variation of the place (%2°): are the headings true instead of magnetic?"),
                signedFigureText(yaw_deg, 1), signedFigureText(options.variation->degrees(), 1)});
    else if (result.rank < result.parametersAsked && fieldTold >= 3 && std::abs(yaw_deg) >= 2)
        result.warnings.push_back(
            {MARKED("core",
                 "the sensor seems turned by %1°: of such a log nothing tells that from headings that are off by it, as true ones are by the variation"),
                signedFigureText(yaw_deg, 1)});
    if (explained < kWellExplained)
        atMost(explained < kHalfExplained ? CalibrationVerdict::NotDetermined : CalibrationVerdict::Doubtful,
            {MARKED("core",
                 "heading, pitch and roll explain %1 % of how the readings vary; expected %2 % or more: they are of another log or clock, or of another sign, order or unit"),
                figureText(100 * explained, 0), figureText(100 * kWellExplained, 0)});
    if (result.rank < result.parametersAsked || explained < kWellExplained)
        return; // of a fit that failed the field is no reading of the log's
    const double scale = std::cbrt(std::abs((Eigen::Matrix3d::Identity() + result.model.softIron).determinant()));
    if (std::abs(scale - 1) > kFieldContradiction)
        atMost(CalibrationVerdict::Doubtful,
            {MARKED("core",
                 "the log's field is %1 nT, %2 % off the %3 nT that were given; expected within %4 %: another unit, another place, or a sensor of another scale, which soft iron then carries"),
                figureText(scale * total_nT, 0), signedFigureText(100 * (scale - 1), 0), figureText(total_nT, 0),
                figureText(100 * kFieldContradiction, 0)});
}

/// What the regression leaves over, before and after any moment. @param residuals of x, of the rows in use
std::optional<ChangeInTime> changeOf(const SensorLog& log, const std::vector<std::uint8_t>& used, const AttitudeOptions& options,
    const Regression& fit, const Eigen::Matrix3d& inverse, std::vector<double> residuals)
{
    std::array<RegressionMoments, kTimeBlocks> moments;
    const auto regressors = fit.solution.rows();
    const auto scales = currentScales(log);
    for (auto& one : moments) {
        one.design = Eigen::MatrixXd::Zero(regressors, regressors);
        one.across = Eigen::MatrixXd::Zero(regressors, 3);
    }
    for (std::size_t row = 0; row < log.size(); ++row)
        if (used[row] != 0)
            addRow(moments[timeBlockOf(row, log.size())], log, row, options.field, scales);
    TimeBlocks blocks;
    for (std::size_t i = 0; i < kTimeBlocks; ++i)
        blocks[i] = {moments[i].design, moments[i].across - product(moments[i].design, fit.solution)};
    // A sum of which no part is told was fitted all the same.
    Eigen::MatrixXd free = Eigen::MatrixXd::Zero(regressors, static_cast<Eigen::Index>(fit.kept.size()));
    for (std::size_t i = 0; i < fit.kept.size(); ++i)
        free(fit.kept[i], static_cast<Eigen::Index>(i)) = 1;
    std::vector<Eigen::MatrixXd> steps(3, Eigen::MatrixXd::Zero(regressors, 2));
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        auto& step = steps[static_cast<std::size_t>(axis)];
        step(3, 0) = 1;
        step.col(1).head<3>() = fit.solution.col(axis).head<3>();
    }
    auto change = changeInTime(blocks, free, steps, fit.variance);
    if (!change)
        return {};
    const double total_nT = options.field.total_nT();
    change->hardIron *= total_nT;
    change->error *= total_nT;
    const double step_nT = (inverse * change->hardIron).x();
    for (std::size_t row = 0, at = 0; row < log.size(); ++row)
        if (used[row] != 0)
            residuals[at++] -= change->isAfter(row, log.size()) ? step_nT : 0.0;
    change->widen(std::sqrt(slowResidualFactor(residuals)));
    return change;
}

/// Hard iron that was another for a part of the log: the mean is wrong by that for each.
void tellChange(AttitudeResult& result, const ChangeInTime& change)
{
    const Eigen::Vector3d wrong = change.hardIron * change.worse();
    for (auto& parameter : result.parameters)
        if (const auto axis = std::string_view("PQR").find(parameter.name);
            parameter.name.size() == 1 && axis != std::string_view::npos && parameter.standard_error)
            parameter.standard_error = std::hypot(*parameter.standard_error, wrong(static_cast<Eigen::Index>(axis)));
    if (result.uncertainty)
        for (Eigen::Index i = 0; i < 3; ++i)
            for (Eigen::Index j = 0; j < 3; ++j)
                result.uncertainty->covariance(9 + i, 9 + j) += wrong(i) * wrong(j);
}

} // namespace

Result<AttitudeResult> fitAttitude(const SensorLog& log, const AttitudeOptions& options)
{
    if (!log.hasAttitude())
        return Error{ErrorCode::InvalidInput, MARKED("core", "has no attitude; expected the columns heading_deg, pitch_deg and roll_deg")};
    if (log.unit == FieldUnit::Counts)
        return Error{ErrorCode::InvalidInput,
            MARKED("core", "is in counts; expected a log in nT, uT, mG or G, as the field that it is held against is")};
    AttitudeResult result;
    result.samples = log.size();
    const LogQuality quality = qualityOf(log);
    result.warnings = quality.remarks;
    const auto used = usableRows(log, quality);
    result.used = static_cast<std::size_t>(std::count(used.begin(), used.end(), std::uint8_t{1}));
    const std::size_t regressors = 4 + log.currents.size();
    if (result.used < regressors + 1) {
        if (Message why = whyFewUsable(log, quality); !why.empty())
            return Error{ErrorCode::Numeric, std::move(why)};
        return Error{ErrorCode::Numeric, {MARKED("core", "has %1 usable samples; expected %2 or more"), result.used, regressors + 1}};
    }
    if (Message own = headingOfItsOwn(log, used); !own.empty())
        return Error{ErrorCode::InvalidInput, std::move(own)};

    const double total_nT = options.field.total_nT();
    const RegressionMoments moments = momentsOfRows(log, used, options.field);
    const Regression fit = regress(moments, toRadians(options.attitudeError_deg));
    if (Message misread = misreadAngles(log, used, options, fit.variance); !misread.empty())
        return Error{ErrorCode::InvalidInput, std::move(misread)};

    result.model = modelOf(log, fit, total_nT);
    result.condition = fit.condition;
    result.parametersAsked = static_cast<int>(3 * regressors);
    result.rank = static_cast<int>(3 * (regressors - fit.null.size()));
    for (Eigen::Index i = 0; i < 3; ++i)
        if (!fit.told[static_cast<std::size_t>(i)])
            result.softTold.col(i).setZero();
    if (!fit.told[3])
        result.hardTold.setZero();
    result.circuitTold.assign(fit.told.begin() + 4, fit.told.end());
    result.sigma_nT = std::sqrt(fit.variance) * total_nT;

    const Eigen::Matrix3d inverse = (Eigen::Matrix3d::Identity() + result.model.softIron).inverse();
    std::vector<double> residuals;
    std::vector<Eigen::Vector3d> directions;
    double squares = 0;
    for (std::size_t row = 0; row < log.size(); ++row) {
        if (used[row] == 0)
            continue;
        const Eigen::Vector3d field = fieldBy(result.model, inverse, log, row), stated = fieldOfRow(log, row, options.field);
        residuals.push_back((field - stated).x());
        squares += (field.norm() - total_nT) * (field.norm() - total_nT);
        directions.push_back(stated / total_nT);
    }
    result.rms_nT = std::sqrt(squares / static_cast<double>(residuals.size()));
    result.coverage = coverageOf(directions);
    const double variance = fit.variance * slowResidualFactor(residuals);
    describeAttitudeParameters(result, log, fit, total_nT, variance);
    result.uncertainty = uncertaintyOf(fit, total_nT, variance);
    const auto change = changeOf(log, used, options, fit, inverse, residuals);
    const Message changed = change ? wordsOf(*change, log, total_nT) : Message();
    if (!changed.empty())
        tellChange(result, *change);
    for (const auto& direction : fit.null)
        result.notSeparable.push_back(inWords(log, direction, total_nT));
    result.notSeparable.push_back({MARKED("core",
        "soft constants D1, D2, D3 and hard iron P, Q, R add up: one survey in one field tells their sum, which stands as P, Q, R")});
    result.notSeparable.push_back({MARKED("core",
        "a turn of the sensor in its mount and the unsymmetric part of soft iron are one thing: the misalignment is stated for symmetric soft iron")});
    misalign(result);
    result.validation = heldOut(log, used, options, moments, fit);
    result.verdict = CalibrationVerdict::Good;
    const Message misnamed = misnamedAngles(log, used, options);
    if (misnamed.empty()) {
        checkAxes(result, moments);
        checkNorth(result, log, used, options, fit.variance);
        judgeAttitude(result, options, explainedPart(moments, fit.variance));
    } else { // all else would be said of a fit that means nothing
        result.reasons.push_back(misnamed);
        result.verdict = CalibrationVerdict::NotDetermined;
        result.nextSteps.push_back({MARKED("core", "put the columns of the attitude right and calibrate once more")});
    }
    if (!changed.empty()) {
        result.verdict = std::max(result.verdict, CalibrationVerdict::Doubtful);
        result.reasons.push_back(changed);
    }
    if (options.attitudeError_deg == 0)
        result.warnings.push_back({MARKED("core",
            "attitude is taken for exact; an error of 1° makes some 420 nT in R: state it (standard deviation), and it is taken out")});
    else
        result.warnings.push_back(
            {MARKED("core",
                 "an attitude error of %1° is taken out of the moments; what is not known of it by a tenth leaves a fifth of its bias"),
                figureText(options.attitudeError_deg, 2)});
    return result;
}

} // namespace lubberline
