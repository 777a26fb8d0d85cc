#include "core/swing/IronPosterior.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <random>

#include <boost/math/distributions/chi_squared.hpp>

#include "core/algebra/Cholesky.h"
#include "core/algebra/Products.h"
#include "core/algebra/Solve.h"
#include "core/angle/Angle.h"
#include "core/base/Number.h"

namespace lubberline {

namespace {

/// A, D, E, c, P, κ, f, Q, μ, each in its assumed size (A, D, E in radians).
constexpr int kUnknowns = 9;
using Unknowns = Eigen::Matrix<double, kUnknowns, 1>;
using Weights = Eigen::Matrix<double, kUnknowns, kUnknowns>;
using Coefficients = Eigen::Matrix<double, kCoefficientCount, 1>;
using CoefficientErrors = Eigen::Matrix<double, kCoefficientCount, kCoefficientCount>;
using CoefficientDesign = Eigen::Matrix<double, kCoefficientCount, kUnknowns>;

constexpr int kC = 3, kP = 4, kOwnB = 5, kF = 6, kQ = 7, kOwnC = 8;
constexpr double kUnboundedSize = 10; ///< of A, D and E: whatever the swings say
constexpr double kLeastError = 1e-5;  ///< 0.0006°: keeps the equations soluble where readings have no error at all
constexpr int kSizes = 200;           ///< at which the aircraft's common size is tried
constexpr int kManyDegrees = 100;     ///< of freedom: Student is normal
constexpr std::uint64_t kSeed = 20260610;

/// Normal numbers that are the same on every machine: the standard's engines are exact, its distributions are not.
class NormalNumbers {
public:
    double unit() { return (static_cast<double>(m_engine() >> 11) + 0.5) * 0x1p-53; }
    double normal() // Box and Muller
    {
        const double length = std::sqrt(-2 * std::log(unit()));
        return length * std::cos(2 * kPi * unit());
    }
    /// By how much the errors of a fit may really be larger (or smaller) than its few degrees of freedom made them.
    double errorFactor(int degreesOfFreedom)
    {
        if (degreesOfFreedom == 0 || degreesOfFreedom > kManyDegrees)
            return 1.0;
        double sum = 0;
        for (int i = 0; i < degreesOfFreedom; ++i)
            sum += std::pow(normal(), 2);
        return std::sqrt(degreesOfFreedom / sum);
    }

private:
    std::mt19937_64 m_engine{kSeed};
};

struct KnownSwing {
    CoefficientDesign design;
    Coefficients observed;
    CoefficientErrors errors; ///< covariance
    int degreesOfFreedom = 0;
};

/// Row by row 𝔄 … 𝔈 of the unknowns.
CoefficientDesign designAt(const MeridianField& field, const AssumedIron& assumed)
{
    CoefficientDesign design = CoefficientDesign::Zero();
    const double soft = assumed.verticalSoft * field.down_nT / field.horizontal_nT, hard = assumed.hardIron_nT / field.horizontal_nT;
    const double own = toRadians(assumed.compassOneCycle_deg);
    design(0, 0) = design(3, 1) = design(4, 2) = 1;
    design.block<1, 3>(1, 3) << soft, hard, own;
    design.block<1, 3>(2, 6) << soft, hard, own;
    return design;
}

CoefficientErrors errorsOf(const SwingAtPlace& swing, const AssumedIron& assumed)
{
    const ExactSmith& error = swing.standardError;
    if (!errorsKnown(swing)) // five readings tell five coefficients, and nothing of how well
        return CoefficientErrors::Identity() * std::pow(toRadians(assumed.readingError_deg), 2) * 2 / kCoefficientCount;
    CoefficientErrors errors
        = swing.covariance.value_or(CoefficientErrors(Coefficients(error.A, error.B, error.C, error.D, error.E).cwiseAbs2().asDiagonal()));
    errors.diagonal().array() += kLeastError * kLeastError;
    return errors;
}

KnownSwing known(const SwingAtPlace& swing, const AssumedIron& assumed)
{
    const ExactSmith& exact = swing.exact;
    return {designAt(swing.field, assumed), {exact.A, exact.B, exact.C, exact.D, exact.E}, errorsOf(swing, assumed),
        errorsKnown(swing) ? swing.degreesOfFreedom : 0};
}

/// Squares of the unknowns' sizes for an aircraft that has `size` times the iron.
Unknowns squaresOf(double size, const AssumedIron& assumed)
{
    Unknowns squares = Unknowns::Constant(kUnboundedSize * kUnboundedSize);
    for (const int i : {kC, kF})
        squares(i) = size * size;
    for (const int i : {kP, kQ})
        squares(i) = size * size + std::pow(assumed.compensator_nT / assumed.hardIron_nT, 2);
    squares(kOwnB) = squares(kOwnC) = 1;
    return squares;
}

/// How well B and C of all swings go with an aircraft of that size (logarithm of the normal density).
double likelihood(std::span<const KnownSwing> swings, double size, const AssumedIron& assumed)
{
    const auto count = static_cast<Eigen::Index>(swings.size());
    Eigen::MatrixXd design(2 * count, kUnknowns), errors = Eigen::MatrixXd::Zero(2 * count, 2 * count);
    Eigen::VectorXd observed(2 * count);
    for (Eigen::Index i = 0; i < count; ++i) {
        const KnownSwing& swing = swings[static_cast<std::size_t>(i)];
        design.middleRows<2>(2 * i) = swing.design.middleRows<2>(1);
        errors.block<2, 2>(2 * i, 2 * i) = swing.errors.block<2, 2>(1, 1);
        observed.segment<2>(2 * i) = swing.observed.segment<2>(1);
    }
    const Eigen::MatrixXd lower = choleskyFactor(composed(design, squaresOf(size, assumed)) + errors);
    return -lower.diagonal().array().log().sum() - whitened(lower, observed).squaredNorm() / 2;
}

/// Sizes that are equally likely beforehand, and how likely they are with the swings (sums to 1).
struct Sizes {
    std::vector<double> size, weight;
};

Sizes sizesOf(std::span<const KnownSwing> swings, const AssumedIron& assumed)
{
    Sizes sizes;
    std::vector<double> logarithm;
    const boost::math::chi_squared squares(assumed.degreesOfFreedom);
    for (int i = 0; i < kSizes; ++i) {
        sizes.size.push_back(std::sqrt(assumed.degreesOfFreedom / boost::math::quantile(squares, (i + 0.5) / kSizes)));
        logarithm.push_back(likelihood(swings, sizes.size.back(), assumed));
    }
    const double largest = *std::max_element(logarithm.begin(), logarithm.end());
    for (const double each : logarithm)
        sizes.weight.push_back(std::exp(each - largest));
    const double sum = std::accumulate(sizes.weight.begin(), sizes.weight.end(), 0.0);
    for (double& weight : sizes.weight)
        weight /= sum;
    return sizes;
}

/// As many of the draws for each size as its weight says, in order.
std::vector<double> sizeOfEachDraw(const Sizes& sizes)
{
    std::vector<double> drawn;
    double upTo = 0;
    for (std::size_t i = 0; i < sizes.size.size(); ++i) {
        upTo += sizes.weight[i];
        const auto last = i + 1 == sizes.size.size() ? kIronDraws : std::min<long>(kIronDraws, std::lround(upTo * kIronDraws));
        drawn.insert(drawn.end(), static_cast<std::size_t>(std::max<long>(0, last - static_cast<long>(drawn.size()))), sizes.size[i]);
    }
    return drawn;
}

PossibleIron ironFrom(const Unknowns& unknowns, const AssumedIron& assumed)
{
    const double soft = assumed.verticalSoft, hard = assumed.hardIron_nT, own = toRadians(assumed.compassOneCycle_deg);
    return {unknowns(0), unknowns(1), unknowns(2), soft * unknowns(3), hard * unknowns(4), own * unknowns(5), soft * unknowns(6),
        hard * unknowns(7), own * unknowns(8)};
}

/// What a swing weighs in the normal equations, for errors as the fit states them.
struct SwingWeight {
    Weights weights;
    Unknowns sums;
    int degreesOfFreedom = 0;
};

SwingWeight weightOf(const KnownSwing& swing)
{
    const CoefficientDesign weighted = solvePositive(swing.errors, swing.design);
    return {swing.design.transpose() * weighted, weighted.transpose() * swing.observed, swing.degreesOfFreedom};
}

} // namespace

ExactSmith PossibleIron::at(const MeridianField& field) const
{
    const double tanI = field.down_nT / field.horizontal_nT, H = field.horizontal_nT;
    return {A, c * tanI + P_nT / H + ownB, f * tanI + Q_nT / H + ownC, D, E};
}

Message sayAssumed(const AssumedIron& assumed)
{
    return {
        MARKED("core",
            "vertical soft iron (c, f) of about %1, hard iron (P, Q) of about %2 nT, compensating magnets of about %3 nT and a one-cycle error of the compass itself of about %4\u00b0 (standard deviations)"),
        figureText(assumed.verticalSoft, 3), figureText(assumed.hardIron_nT, 0), figureText(assumed.compensator_nT, 0),
        figureText(assumed.compassOneCycle_deg, 1)};
}

IronPosterior ironOf(std::span<const SwingAtPlace> swings, const AssumedIron& assumed)
{
    std::vector<KnownSwing> known;
    std::vector<SwingWeight> weights;
    for (const auto& swing : swings) {
        known.push_back(lubberline::known(swing, assumed));
        weights.push_back(weightOf(known.back()));
    }
    NormalNumbers random;
    IronPosterior posterior;
    Unknowns sum = Unknowns::Zero();
    for (const double size : sizeOfEachDraw(sizesOf(known, assumed))) {
        Weights normal = squaresOf(size, assumed).cwiseInverse().asDiagonal();
        Unknowns right = Unknowns::Zero(), scatter;
        for (const auto& swing : weights) {
            const double weight = std::pow(random.errorFactor(swing.degreesOfFreedom), -2);
            normal += weight * swing.weights;
            right += weight * swing.sums;
        }
        for (int i = 0; i < kUnknowns; ++i)
            scatter(i) = random.normal();
        const Eigen::LLT<Weights> factors(normal);
        const Unknowns middle = factors.solve(right);
        sum += middle;
        posterior.draws.push_back(ironFrom(middle + Unknowns(factors.matrixU().solve(scatter)), assumed));
    }
    posterior.mean = ironFrom(sum / kIronDraws, assumed);
    return posterior;
}

} // namespace lubberline
