#include "core/nmea/NmeaDelay.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/algebra/Products.h"
#include "core/algebra/Solve.h"
#include "core/angle/Angle.h"
#include "core/base/Middle.h"

namespace lubberline {

namespace {

/// A turn's rate is a slope over so much on either side: the shortest that leaves the rate of the turn clear of the reference's unevenness.
constexpr std::array kHalfSlopes_s{3.0, 6.0, 12.0};
constexpr double kClear = 4.0;
/// More tell nothing new, and a log of hours need not wait.
constexpr std::size_t kMostReadings = 4000;
constexpr int kRounds = 12;
constexpr double kSettled_s = 1e-4;
constexpr double kFurthest_s = 30.0; ///< a log that is later is none of a turn
/// The turn must vary by so much over the same headings, and by so many times what the reference's unevenness alone makes of it.
constexpr double kLeastVariation_deg_s = 0.15;
constexpr double kOverNoise = 3.0;
/// Surer than this the delay is told; it is better than what is known without.
constexpr double kToldWithin_s = 0.35;
/// Readings one after the other tell the same: their products are summed over this.
constexpr double kMemory_s = 20.0;
constexpr double kLeastShare = 0.1;

/// Standard deviation of one heading of the reference about its neighbours [deg]: from second differences.
double unevenness_deg(const HeadingLine& reference)
{
    std::vector<double> bends;
    const auto& headings = reference.headings();
    for (std::size_t i = 2; i < headings.size(); ++i)
        if (headings[i].heading_deg && headings[i - 1].heading_deg && headings[i - 2].heading_deg)
            bends.push_back(std::abs(wrap180(*headings[i].heading_deg - *headings[i - 1].heading_deg)
                - wrap180(*headings[i - 1].heading_deg - *headings[i - 2].heading_deg)));
    if (bends.empty())
        return 0.0;
    return 1.4826 * middleOf(std::move(bends))
        / std::sqrt(6.0); // median → standard deviation; 1 + 4 + 1 parts of it in a second difference
}

/// What that makes of a slope [deg/s].
double rateNoise_deg_s(double unevenness_deg, double step_s, double half_s)
{
    const double steps = std::floor(half_s / step_s);
    return unevenness_deg / (step_s * std::sqrt(std::max(2.0, steps * (steps + 1.0) * (2.0 * steps + 1.0) / 3.0)));
}

/// How the turn rate of a reference is measured.
struct Slope {
    double half_s = kHalfSlopes_s.front();
    double noise_deg_s = 0; ///< standard deviation of a rate
};

Slope slopeOf(const HeadingLine& reference)
{
    const double step_s = reference.step_s(), uneven_deg = unevenness_deg(reference);
    double squares = 0.0, count = 0.0;
    for (const auto& heading : reference.headings())
        if (const auto rate = reference.rateAt(heading.seconds, std::max(kHalfSlopes_s.back(), 3.0 * step_s)))
            squares += *rate * *rate, count += 1.0;
    const double turn_deg_s = std::sqrt(squares / std::max(1.0, count));
    Slope slope;
    for (const double half_s : kHalfSlopes_s) {
        slope.half_s = std::max(half_s, 3.0 * step_s);
        slope.noise_deg_s = rateNoise_deg_s(uneven_deg, step_s, slope.half_s);
        if (kClear * slope.noise_deg_s <= turn_deg_s)
            break;
    }
    return slope;
}

/// The readings that a delay is told by.
struct Turn {
    std::vector<double> seconds, heading_rad, deviation_deg, rate_deg_s;
};

Turn turnAt(std::span<const TimedHeading> compass, const HeadingLine& reference, double half_s, double delay_s)
{
    Turn turn;
    const std::size_t stride = compass.size() / kMostReadings + 1;
    double first_deg = 0.0;
    for (std::size_t i = 0; i < compass.size(); i += stride) {
        const double moment = compass[i].seconds + delay_s;
        const auto heading = reference.at(moment);
        const auto rate = reference.rateAt(moment, half_s);
        if (!heading || !rate)
            continue;
        const double deviation_deg = wrap180(*heading->heading_deg - *compass[i].heading_deg);
        if (turn.seconds.empty())
            first_deg = deviation_deg; // deviations about 180 stay together
        turn.seconds.push_back(compass[i].seconds);
        turn.heading_rad.push_back(toRadians(*compass[i].heading_deg));
        turn.deviation_deg.push_back(first_deg + wrap180(deviation_deg - first_deg));
        turn.rate_deg_s.push_back(*rate);
    }
    return turn;
}

/// What no deviation curve explains of the columns: harmonics up to the fourth where the headings go round, else up to the second.
Eigen::MatrixXd unexplained(const std::vector<double>& headings_rad, const Eigen::MatrixXd& columns)
{
    std::vector<bool> sectors(12, false);
    for (const double heading : headings_rad)
        sectors[static_cast<std::size_t>(heading / (2.0 * kPi) * 12.0) % 12] = true;
    const int orders = std::count(sectors.begin(), sectors.end(), true) == 12 ? 4 : 2;
    Eigen::MatrixXd design(columns.rows(), 1 + 2 * orders);
    for (Eigen::Index row = 0; row < columns.rows(); ++row) {
        design(row, 0) = 1.0;
        for (int order = 1; order <= orders; ++order) {
            const double angle = order * headings_rad[static_cast<std::size_t>(row)];
            design(row, 2 * order - 1) = std::sin(angle);
            design(row, 2 * order) = std::cos(angle);
        }
    }
    return columns - product(design, pivotedSolve(design, columns).solution);
}

struct Estimate {
    double seconds = 0, standardError_s = 0, variation_deg_s = 0;
};

/// Least squares of deviation = curve − rate × delay; its error by the sums of products of neighbours (Newey and West).
std::optional<Estimate> estimate(const Turn& turn)
{
    constexpr std::size_t kFewest = 20;
    if (turn.seconds.size() < kFewest)
        return {};
    Eigen::MatrixXd columns(turn.seconds.size(), 2);
    columns << Eigen::Map<const Eigen::VectorXd>(turn.rate_deg_s.data(), columns.rows()),
        Eigen::Map<const Eigen::VectorXd>(turn.deviation_deg.data(), columns.rows());
    const Eigen::MatrixXd left = unexplained(turn.heading_rad, columns);
    const Eigen::VectorXd rate = left.col(0), deviation = left.col(1);
    const double squares = rate.squaredNorm();
    Estimate found;
    found.variation_deg_s = std::sqrt(squares / static_cast<double>(turn.seconds.size()));
    if (found.variation_deg_s < kLeastVariation_deg_s)
        return {};
    found.seconds = -rate.dot(deviation) / squares;
    const Eigen::VectorXd products = rate.cwiseProduct(deviation + rate * found.seconds);
    const double step_s = (turn.seconds.back() - turn.seconds.front()) / static_cast<double>(turn.seconds.size() - 1);
    const auto longest = std::min<Eigen::Index>(products.size() / 4, 1 + static_cast<Eigen::Index>(kMemory_s / std::max(step_s, 1e-3)));
    double sum = products.squaredNorm();
    for (Eigen::Index lag = 1; lag <= longest; ++lag) {
        const double weight = 1.0 - static_cast<double>(lag) / static_cast<double>(longest + 1);
        sum += 2.0 * weight * products.head(products.size() - lag).dot(products.tail(products.size() - lag));
    }
    found.standardError_s = std::sqrt(std::max(sum, products.squaredNorm())) / squares;
    return found;
}

void countWays(NmeaDelay& delay, const std::vector<double>& rates)
{
    for (const double rate : rates) {
        delay.clockwise += rate >= kSlowestTurn_deg_s ? 1 : 0;
        delay.counterClockwise += rate <= -kSlowestTurn_deg_s ? 1 : 0;
    }
}

bool bothWays(const NmeaDelay& delay, std::size_t readings)
{
    return std::min(delay.clockwise, delay.counterClockwise) >= kLeastShare * static_cast<double>(readings);
}

/// What a second of delay is in A, as the five coefficients are fitted.
double inA(std::span<const TimedHeading> compass, const std::vector<double>& rates)
{
    Eigen::MatrixXd design(compass.size(), 5);
    for (std::size_t i = 0; i < compass.size(); ++i) {
        const double heading = toRadians(*compass[i].heading_deg);
        design.row(static_cast<Eigen::Index>(i)) << 1.0, std::sin(heading), std::cos(heading), std::sin(2 * heading), std::cos(2 * heading);
    }
    const auto column = Eigen::Map<const Eigen::VectorXd>(rates.data(), static_cast<Eigen::Index>(rates.size()));
    return -pivotedSolve(design, column).solution(0);
}

} // namespace

std::vector<double> referenceRates(std::span<const TimedHeading> compass, const HeadingLine& reference, double delay_s)
{
    std::vector<double> rates;
    const double half_s = slopeOf(reference).half_s;
    const HeadingLine card({compass.begin(), compass.end()});
    for (const auto& heading : compass) {
        const auto rate = reference.rateAt(heading.seconds + delay_s, half_s);
        rates.push_back(rate ? *rate : card.rateAt(heading.seconds, half_s).value_or(0.0));
    }
    return rates;
}

NmeaDelay delayOf(std::span<const TimedHeading> compass, const HeadingLine& reference, double spacing_s)
{
    NmeaDelay delay;
    delay.standardError_s = std::hypot(kUsualDelay_s, spacing_s / std::sqrt(12.0));
    const auto rates = referenceRates(compass, reference, 0.0);
    countWays(delay, rates);
    if (!compass.empty())
        delay.A_degPerSecond = inA(compass, rates);
    if (static_cast<double>(delay.clockwise + delay.counterClockwise) < kLeastShare * static_cast<double>(compass.size()))
        return delay;
    delay.told = bothWays(delay, compass.size()) ? DelayTold::TooNoisy : DelayTold::OneWay;
    const Slope slope = slopeOf(reference);
    double seconds = 0.0;
    std::optional<Estimate> found;
    for (int round = 0; round < kRounds; ++round) {
        found = estimate(turnAt(compass, reference, slope.half_s, seconds));
        if (!found || found->variation_deg_s < kOverNoise * slope.noise_deg_s)
            return delay;
        seconds = std::clamp(seconds + found->seconds, -kFurthest_s, kFurthest_s);
        if (std::abs(found->seconds) < kSettled_s)
            break;
    }
    if (found->standardError_s > kToldWithin_s || std::abs(seconds) >= kFurthest_s) {
        delay.told = DelayTold::TooNoisy;
        return delay;
    }
    delay.told = bothWays(delay, compass.size()) ? DelayTold::BothWays : DelayTold::VaryingRate;
    delay.seconds = seconds;
    delay.standardError_s = found->standardError_s;
    return delay;
}

} // namespace lubberline
