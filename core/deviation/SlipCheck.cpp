#include "core/deviation/SlipCheck.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "core/angle/Circle.h"
#include "core/deviation/SlipVariants.h"
#include "core/deviation/SmithFit.h"

namespace lubberline {

namespace {

using Vector5 = Eigen::Matrix<double, 5, 1>;
using Matrix5 = Eigen::Matrix<double, 5, 5>;

constexpr double kTwitch_deg = 0.4;       ///< of a reader and a swaying card, besides the resolution
constexpr double kTurnedWithin_deg = 3.0; ///< how near to the wanted heading an aircraft is turned (procedures: within 5°)
constexpr double kLeastShown = 0.01;
// A heading on an exact step of the round was laid out, and not read: seldom its figure slips, and never to one beside the steps.
constexpr double kStep_deg = 45.0, kOnStep_deg = 1e-6, kLaidOutRead = 0.1, kLaidOutBeside = 1e-3;

Vector5 designAt(double compass_deg)
{
    const double z = toRadians(compass_deg);
    return {1.0, std::sin(z), std::cos(z), std::sin(2 * z), std::cos(2 * z)};
}

Vector5 degreesOf(const ApproximateSmith& smith)
{
    return Vector5{smith.A_rad, smith.B_rad, smith.C_rad, smith.D_rad, smith.E_rad} * kDegreesPerRadian;
}

double normalDensity(double off, double sigma) { return std::exp(-0.5 * off * off / (sigma * sigma)) / (sigma * std::sqrt(2.0 * kPi)); }

/// The curve that is expected, in degrees, with its uncertainty.
class Expectation {
public:
    explicit Expectation(const SlipContext& context);
    double deviation_deg(double compass_deg) const { return designAt(compass_deg).dot(m_mean); }
    double sigma_deg(double compass_deg) const;
    /// ψ' = ψ − δ(ψ'), by iteration; deviations of compasses that can be steered by converge.
    double compass_deg(double magnetic_deg) const;
    /// Density of reading `compass_deg` on `magnetic_deg` [1/°].
    double likelihood(double magnetic_deg, double compass_deg) const
    {
        return normalDensity(wrap180(magnetic_deg - compass_deg - deviation_deg(compass_deg)), sigma_deg(compass_deg));
    }

private:
    Vector5 m_mean;
    Matrix5 m_covariance;
    double m_noise_deg;
};

Expectation::Expectation(const SlipContext& context) : m_noise_deg(std::hypot(context.resolution_deg / std::sqrt(12.0), kTwitch_deg))
{
    Vector5 prior = degreesOf(byHeadingAsRead(context.expected.mean));
    const Vector5 spread = degreesOf(context.expected.standardDeviation);
    // A compass that is far out as a whole, and was not before, or of which nothing was known, stays where it is.
    const double index_deg = context.earlier.empty() ? 0.0 : largeIndex_deg(context.earlier);
    if (index_deg != 0.0 && std::abs(wrap180(index_deg - prior(0))) > kLargeIndex_deg)
        prior(0) = index_deg;
    const double weight = 1.0 / (m_noise_deg * m_noise_deg);
    Matrix5 information = spread.array().square().inverse().matrix().asDiagonal();
    Vector5 sum = information * prior;
    for (const auto& reading : context.earlier) {
        const Vector5 x = designAt(reading.compass.degrees());
        information += weight * x * x.transpose();
        // Of one that reads the reciprocal +179° and −179° are two degrees apart.
        sum += weight * toDegrees(nearTo_rad(deviationOf(reading.magnetic, reading.compass).radians(), toRadians(prior(0)))) * x;
    }
    const Eigen::LLT<Matrix5> solver(information);
    m_mean = solver.solve(sum);
    m_covariance = solver.solve(Matrix5::Identity());
}

double Expectation::sigma_deg(double compass_deg) const
{
    const Vector5 x = designAt(compass_deg);
    return std::sqrt(x.dot(m_covariance * x) + m_noise_deg * m_noise_deg);
}

double Expectation::compass_deg(double magnetic_deg) const
{
    double compass = magnetic_deg;
    for (int i = 0; i < 20; ++i)
        compass = magnetic_deg - deviation_deg(compass);
    return wrap360(compass);
}

double likelihoodOfDatum(double magnetic_deg, const std::optional<double>& nominal_deg)
{
    return nominal_deg ? normalDensity(wrap180(magnetic_deg - *nominal_deg), kTurnedWithin_deg) : 1.0 / 360.0;
}

bool onStep(double magnetic_deg) { return std::abs(std::remainder(magnetic_deg, kStep_deg)) < kOnStep_deg; }

/// All headings of the swing until now, this one included.
bool laidOut(const Observation& reading, const SlipContext& context)
{
    return onStep(reading.magnetic.degrees()) && std::all_of(context.earlier.begin(), context.earlier.end(), [](const Observation& one) {
        return onStep(one.magnetic.degrees());
    });
}

/// Every slip with its weight: how likely it is before the reading is looked at, times how well it explains the reading.
std::vector<SlipCandidate> weighedSlips(const Observation& reading, const SlipContext& context, const Expectation& expectation)
{
    const double magnetic = reading.magnetic.degrees(), compass = reading.compass.degrees();
    const double datumHere = likelihoodOfDatum(magnetic, context.nominal_deg);
    std::vector<SlipCandidate> slips;
    for (const auto& variant : slipVariantsOf(compass))
        slips.push_back({variant.slip, SlippedFigure::Compass, variant.meant_deg,
            variant.prior * datumHere * expectation.likelihood(magnetic, variant.meant_deg)});
    const bool placed = laidOut(reading, context);
    const auto readAs = [placed](double meant_deg) { return !placed ? 1.0 : onStep(meant_deg) ? kLaidOutRead : kLaidOutBeside; };
    for (const auto& variant : slipVariantsOf(magnetic))
        slips.push_back({variant.slip, SlippedFigure::Datum, variant.meant_deg,
            variant.prior * readAs(variant.meant_deg) * likelihoodOfDatum(variant.meant_deg, context.nominal_deg)
                * expectation.likelihood(variant.meant_deg, compass)});
    const double turned = wrap360(2.0 * magnetic - compass);
    slips.push_back(
        {Slip::WrongSign, SlippedFigure::Compass, turned, kWrongSignRate * datumHere * expectation.likelihood(magnetic, turned)});
    const double each = kWrongRowRate / static_cast<double>(std::max<std::size_t>(context.otherNominals_deg.size(), 1));
    for (const double nominal : context.otherNominals_deg) {
        // On another row the aircraft stood within the usual few degrees of that row's heading.
        const double off = wrap180(compass - expectation.compass_deg(nominal));
        slips.push_back({Slip::WrongRow, SlippedFigure::Compass, nominal,
            each * datumHere * normalDensity(off, std::hypot(expectation.sigma_deg(compass), kTurnedWithin_deg))});
    }
    return slips;
}

} // namespace

ExpectedCurve anyCurve() { return {{}, {toRadians(3.0), toRadians(10.0), toRadians(10.0), toRadians(3.0), toRadians(2.0)}}; }

ExpectedCurve curveAfter(const ApproximateSmith& lastSwing)
{
    return {lastSwing, {toRadians(1.0), toRadians(3.0), toRadians(3.0), toRadians(0.7), toRadians(0.7)}};
}

SlipJudgement judgeReading(const Observation& reading, const SlipContext& context)
{
    const Expectation expectation(context);
    const double datumHere = likelihoodOfDatum(reading.magnetic.degrees(), context.nominal_deg);
    SlipJudgement judgement;
    judgement.expected = CompassHeading::fromDegrees(expectation.compass_deg(reading.magnetic.degrees()));
    judgement.expectedError_deg = expectation.sigma_deg(judgement.expected.degrees());
    judgement.candidates = weighedSlips(reading, context, expectation);
    judgement.probabilityAsRead = datumHere * expectation.likelihood(reading.magnetic.degrees(), reading.compass.degrees());
    judgement.probabilityUnexplained = kUnexplainedRate / 360.0 * (datumHere + 1.0 / 360.0) / 2.0; // either figure, anywhere

    double total = judgement.probabilityAsRead + judgement.probabilityUnexplained;
    for (const auto& candidate : judgement.candidates)
        total += candidate.probability;
    judgement.probabilityAsRead /= total;
    judgement.probabilityUnexplained /= total;
    for (auto& candidate : judgement.candidates)
        candidate.probability /= total;
    std::erase_if(judgement.candidates, [](const auto& candidate) { return candidate.probability < kLeastShown; });
    std::sort(judgement.candidates.begin(), judgement.candidates.end(),
        [](const auto& a, const auto& b) { return a.probability > b.probability; });
    return judgement;
}

} // namespace lubberline
