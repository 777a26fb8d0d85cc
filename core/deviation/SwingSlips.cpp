#include "core/deviation/SwingSlips.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "core/angle/Circle.h"
#include "core/deviation/CurvePrior.h"
#include "core/deviation/ExchangedRows.h"
#include "core/deviation/SlipVariants.h"

namespace lubberline {

namespace {

using Normal5 = Eigen::Matrix<double, 5, 5>;

/// What crews and compasses add to the division when they read: about half a degree, seldom under a tenth or over two.
constexpr double kHandling_deg = 0.45, kHandlingSpread = 0.9;
constexpr std::array kHandlingSteps{-2.5, -2.0, -1.5, -1.0, -0.5, 0.0, 0.5, 1.0, 1.5, 2.0, 2.5, 3.0};
/// A slip without a name: a few degrees to some tens.
constexpr double kUnnamedSize_deg = 15.0, kUnnamedRate = 5e-4;
/// A reading is looked at again when a slip in it is not thirteen times less likely than none: a look costs seconds, a miss a wrong card.
/// Found by simulation of eight readings to 1° (tests/core/deviation/SwingSlipsTest), where a slip of 5° at a scatter of 0.3° and no slip
/// at 1° are hard to tell apart: 96 in 100 of the one are found, and 7 in 100 of the other are looked at. No prior of the scatter tells them
/// much better: 88, 92, 95 and 97 in 100 are found where 3, 5, 7 and 10 are looked at, and 93 for 5 were the very spread of the simulated
/// curves known. Nor can any: the most powerful test there is between the two (Neyman and Pearson), which knows the spread of the curves and
/// both scatters, looks at 5.3 in 100 where it finds 97. A second slip, which its first could feign, must be likelier than none.
constexpr double kOdds = 0.075, kOddsMore = 1.0;
/// With more readings the scatter is known better and a slip stands out by more, so that less has to be looked at for it: at twelve and more
/// readings some 2 in 100 swings at 1° (5 at the odds of eight), and of slips of 5° at 0.3° and of 8° at 1° as many are found.
constexpr double kOddsOfMany = 0.25;
constexpr double kFewReadings = 8.0, kManyReadings = 12.0;
/// Five coefficients go through five readings: what one of them slipped by is a large coefficient as well as a slip, and only what no
/// compass has is named.
constexpr std::size_t kUnchecked = 5;
constexpr double kOddsUnchecked = 100.0;
/// A reading that could be the slipped one instead must be at least this likely, given that one slipped.
constexpr double kLeastLikely = 0.01;
constexpr double kLeastShown_share = 0.01;
/// Readings beyond this many are only looked at where they stand out most: a log is no list that somebody wrote.
constexpr std::size_t kLookedAt = 48;

Row5 rowOf(Form form, double magnetic_deg, double deviation_deg)
{
    const double z = toRadians(magnetic_deg - deviation_deg);
    if (form == Form::Approximate)
        return {1.0, std::sin(z), std::cos(z), std::sin(2 * z), std::cos(2 * z)};
    const double sum = toRadians(magnetic_deg) + z;
    return {std::cos(toRadians(deviation_deg)), std::sin(z), std::cos(z), std::sin(sum), std::cos(sum)};
}

double sideOf(Form form, double deviation_deg)
{
    return form == Form::Approximate ? toRadians(deviation_deg) : std::sin(toRadians(deviation_deg));
}

/// The deviation of a curve at a magnetic heading [deg].
double curveAt(Form form, const Row5& curve, double magnetic_deg)
{
    if (form == Form::Exact)
        return deviationAt(ExactSmith{curve(0), curve(1), curve(2), curve(3), curve(4)}, MagneticHeading::fromDegrees(magnetic_deg))
            .degrees();
    double deviation_deg = 0;
    for (int i = 0; i < 12; ++i) // deviations of compasses that can be steered by converge
        deviation_deg = wrap180(toDegrees(rowOf(form, magnetic_deg, deviation_deg).dot(curve)));
    return deviation_deg;
}

double logNormal(double off, double variance) { return -0.5 * (off * off / variance + std::log(2.0 * kPi * variance)); }

/// The middle of the deviations on the circle: the one that is nearest to all others. Of a log the mean direction, as every pair would be
/// held against each other.
double middle_deg(std::span<const Observation> readings)
{
    std::vector<double> deviations_deg;
    for (const auto& reading : readings)
        deviations_deg.push_back(deviationOf(reading.magnetic, reading.compass).degrees());
    if (deviations_deg.size() > kLookedAt)
        return circularMean(deviations_deg).mean_deg;
    const auto distance = [&](double at_deg) {
        double sum = 0;
        for (const double deviation_deg : deviations_deg)
            sum += std::abs(wrap180(deviation_deg - at_deg));
        return std::pair(sum, at_deg); // of two equally near the smaller, whatever the order of the readings
    };
    return *std::min_element(deviations_deg.begin(), deviations_deg.end(), [&](double a, double b) { return distance(a) < distance(b); });
}

/// What the other readings say of one, for one size of the scatter and one prior.
struct Foretold {
    double deviation_deg = 0; ///< at the reading's own magnetic heading
    double variance_deg2 = 0; ///< of a reading there
    double logEvidence = 0;   ///< of the other readings
    Row5 curve;
    Normal5 covariance;
};

struct Hypothesis {
    std::size_t reading = 0;
    SlipCandidate candidate; ///< its probability is the odds against "as read"
};

/// One look at the readings that are in.
struct Pass {
    std::vector<Hypothesis> hypotheses;
    std::vector<double> oddsOf; ///< by reading
    double odds = 0;            ///< of any slip against none
};

class Search {
public:
    Search(Form form, std::span<const Observation> readings, double resolution_deg, const std::optional<ExpectedCurve>& history,
        std::span<const double> beyond_rad);
    [[nodiscard]] Pass look() const;
    void takeOut(std::size_t reading)
    {
        m_out[reading] = true;
        add(reading, -1.0);
    }
    [[nodiscard]] double seenFrom_deg() const;

private:
    [[nodiscard]] Foretold foretell(std::size_t reading, double sigma_deg, const CurvePrior& prior) const;
    [[nodiscard]] std::vector<Foretold> foretellings(std::size_t reading) const;
    void weigh(std::size_t reading, Pass& pass) const;
    [[nodiscard]] std::vector<std::size_t> standingOut() const;
    void add(std::size_t reading, double sign);

    Form m_form;
    std::span<const Observation> m_readings;
    double m_middle_deg = 0;
    std::vector<double> m_deviation_deg; ///< the index taken out
    std::vector<double> m_sigmas_deg, m_logPrior;
    std::vector<CurvePrior> m_priors;
    std::vector<bool> m_out; ///< readings found so far
    Normal5 m_information;   ///< Σ x xᵀ of those that are in
    Row5 m_sum;              ///< Σ x sin δ
    double m_squares = 0;
    int m_count = 0;
};

Search::Search(Form form, std::span<const Observation> readings, double resolution_deg, const std::optional<ExpectedCurve>& history,
    std::span<const double> beyond_rad)
    : m_form(form)
    , m_readings(readings)
    , m_middle_deg(middle_deg(readings))
    , m_priors(curvePriors(form, history))
    , m_out(readings.size(), false)
{
    for (std::size_t i = 0; i < readings.size(); ++i) {
        const double beyond_deg = beyond_rad.empty() ? 0.0 : toDegrees(beyond_rad[i]);
        m_deviation_deg.push_back(wrap180(deviationOf(readings[i].magnetic, readings[i].compass).degrees() - m_middle_deg - beyond_deg));
    }
    for (const double step : kHandlingSteps) {
        m_sigmas_deg.push_back(std::hypot(resolution_deg / std::sqrt(12.0), kHandling_deg * std::exp(step * kHandlingSpread)));
        m_logPrior.push_back(-0.5 * step * step);
    }
    m_information.setZero();
    m_sum.setZero();
    for (std::size_t i = 0; i < readings.size(); ++i)
        add(i, 1.0);
}

void Search::add(std::size_t reading, double sign)
{
    const Row5 x = rowOf(m_form, m_readings[reading].magnetic.degrees(), m_deviation_deg[reading]);
    const double side = sideOf(m_form, m_deviation_deg[reading]);
    m_information += sign * x * x.transpose();
    m_sum += sign * side * x;
    m_squares += sign * side * side;
    m_count += sign > 0 ? 1 : -1;
}

Foretold Search::foretell(std::size_t reading, double sigma_deg, const CurvePrior& prior) const
{
    const double magnetic_deg = m_readings[reading].magnetic.degrees();
    const double own = m_out[reading] ? 0.0 : 1.0; // a reading that is out already does not speak
    const Row5 x = rowOf(m_form, magnetic_deg, m_deviation_deg[reading]);
    const double side = sideOf(m_form, m_deviation_deg[reading]);
    const double perVariance = 1.0 / (toRadians(sigma_deg) * toRadians(sigma_deg));
    const Normal5 before = prior.precision.asDiagonal();
    const Normal5 information = before + perVariance * (m_information - own * x * x.transpose());
    const Row5 sum = before * prior.mean + perVariance * (m_sum - own * side * x);
    const Eigen::LLT<Normal5> solver(information);
    const Row5 beta = solver.solve(sum);
    const double squares = perVariance * (m_squares - own * side * side) + prior.mean.dot(before * prior.mean) - sum.dot(beta);
    const double logDeterminant = 2.0 * solver.matrixLLT().diagonal().array().log().sum();

    Foretold foretold;
    foretold.curve = beta;
    foretold.covariance = solver.solve(Normal5::Identity());
    foretold.logEvidence = -(m_count - own) * std::log(sigma_deg) - 0.5 * (squares + logDeterminant) + prior.log;
    foretold.deviation_deg = curveAt(m_form, beta, magnetic_deg);
    const Row5 there = rowOf(m_form, magnetic_deg, foretold.deviation_deg);
    foretold.variance_deg2 = kDegreesPerRadian * kDegreesPerRadian * there.dot(foretold.covariance * there) + sigma_deg * sigma_deg;
    return foretold;
}

/// For all sizes of the scatter and all priors, with the logarithm of how likely each is.
std::vector<Foretold> Search::foretellings(std::size_t reading) const
{
    std::vector<Foretold> all;
    for (const CurvePrior& prior : m_priors)
        for (std::size_t s = 0; s < m_sigmas_deg.size(); ++s) {
            all.push_back(foretell(reading, m_sigmas_deg[s], prior));
            all.back().logEvidence += m_logPrior[s];
        }
    return all;
}

/// Adds every slip of one reading, with its odds against "as read", over all sizes of the scatter.
void Search::weigh(std::size_t reading, Pass& pass) const
{
    const double magnetic_deg = m_readings[reading].magnetic.degrees(), compass_deg = m_readings[reading].compass.degrees();
    const std::vector<Foretold> foretold = foretellings(reading);
    double highest = -std::numeric_limits<double>::max();
    for (const auto& one : foretold)
        highest = std::max(highest, one.logEvidence);
    // Density of a deviation at a magnetic heading, given the other readings, times their evidence.
    const auto density = [&](double atMagnetic_deg, double deviation_deg, double blur_deg) {
        double sum = 0;
        for (const auto& f : foretold) {
            const double curve_deg = atMagnetic_deg == magnetic_deg ? f.deviation_deg : curveAt(m_form, f.curve, atMagnetic_deg);
            sum += std::exp(f.logEvidence - highest + logNormal(wrap180(deviation_deg - curve_deg), f.variance_deg2 + blur_deg * blur_deg));
        }
        return sum;
    };
    const double own_deg = m_deviation_deg[reading];
    const double asRead = std::max(density(magnetic_deg, own_deg, 0.0), 1e-290);
    const auto put = [&](Slip slip, SlippedFigure figure, double meant_deg, double weight) {
        pass.hypotheses.push_back({reading, {slip, figure, meant_deg, weight / asRead}});
        pass.oddsOf[reading] += weight / asRead;
        pass.odds += weight / asRead;
    };
    for (const auto& variant : slipVariantsOf(compass_deg))
        put(variant.slip, SlippedFigure::Compass, variant.meant_deg,
            variant.prior * density(magnetic_deg, wrap180(own_deg + compass_deg - variant.meant_deg), 0.0));
    const double turned_deg = wrap360(2.0 * magnetic_deg - compass_deg);
    put(Slip::WrongSign, SlippedFigure::Compass, turned_deg,
        kWrongSignRate * density(magnetic_deg, wrap180(own_deg + compass_deg - turned_deg), 0.0));
    put(Slip::Unexplained, SlippedFigure::Compass, compass_deg, kUnnamedRate * density(magnetic_deg, own_deg, kUnnamedSize_deg));
}

/// The readings that lie furthest off what the others foretell.
std::vector<std::size_t> Search::standingOut() const
{
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i < m_readings.size(); ++i)
        if (!m_out[i])
            all.push_back(i);
    if (all.size() <= kLookedAt)
        return all;
    const Normal5 information = m_information + Normal5(m_priors.front().precision.asDiagonal()) * 1e-4;
    const Row5 beta = information.llt().solve(m_sum);
    std::vector<double> off(m_readings.size());
    for (const auto i : all)
        off[i] = std::abs(wrap180(m_deviation_deg[i] - curveAt(m_form, beta, m_readings[i].magnetic.degrees())));
    std::nth_element(
        all.begin(), all.begin() + kLookedAt, all.end(), [&](auto a, auto b) { return off[a] != off[b] ? off[a] > off[b] : a < b; });
    all.resize(kLookedAt);
    std::sort(all.begin(), all.end());
    return all;
}

Pass Search::look() const
{
    Pass pass;
    pass.oddsOf.assign(m_readings.size(), 0.0);
    for (const auto i : standingOut())
        weigh(i, pass);
    return pass;
}

double Search::seenFrom_deg() const
{
    // A slip of the usual rate is likelier than none from some 3.5 standard deviations on; the scatter as it is likeliest.
    constexpr double kDeviations = 3.5;
    double worst = 0;
    for (const auto i : standingOut()) {
        const auto foretold = foretellings(i);
        const auto likeliest
            = std::max_element(foretold.begin(), foretold.end(), [](auto& a, auto& b) { return a.logEvidence < b.logEvidence; });
        worst = std::max(worst, kDeviations * std::sqrt(likeliest->variance_deg2));
    }
    return worst;
}

SlippedReading described(const Pass& pass, std::size_t reading)
{
    SlippedReading slipped{reading, pass.oddsOf[reading] / (1.0 + pass.odds), {}, {}};
    for (const auto& hypothesis : pass.hypotheses) {
        const double share = hypothesis.candidate.probability / (1.0 + pass.odds);
        if (hypothesis.reading == reading && share >= kLeastShown_share) {
            slipped.candidates.push_back(hypothesis.candidate);
            slipped.candidates.back().probability = share;
        }
    }
    std::sort(
        slipped.candidates.begin(), slipped.candidates.end(), [](const auto& a, const auto& b) { return a.probability > b.probability; });
    return slipped;
}

/// Both forms side by side; of each pass the one counts that finds less.
class BothForms {
public:
    BothForms(std::span<const Observation> readings, double resolution_deg, const std::optional<ExpectedCurve>& history,
        std::span<const double> beyond_rad)
        : m_exact(Form::Exact, readings, resolution_deg, history, beyond_rad)
        , m_approximate(Form::Approximate, readings, resolution_deg, history, beyond_rad)
    {
    }
    [[nodiscard]] Pass look() const
    {
        Pass exact = m_exact.look();
        if (exact.odds <= kOdds)
            return exact;
        Pass approximate = m_approximate.look();
        return approximate.odds < exact.odds ? approximate : exact;
    }
    void takeOut(std::size_t reading)
    {
        m_exact.takeOut(reading);
        m_approximate.takeOut(reading);
    }
    [[nodiscard]] double seenFrom_deg() const { return m_exact.seenFrom_deg(); }

private:
    Search m_exact, m_approximate;
};

double oddsFor(std::size_t readings)
{
    const double many = std::clamp((static_cast<double>(readings) - kFewReadings) / (kManyReadings - kFewReadings), 0.0, 1.0);
    return kOdds * std::pow(kOddsOfMany / kOdds, many);
}

/// The likeliest and those that could be it instead.
std::vector<std::size_t> likelyOnes(const Pass& pass)
{
    std::vector<std::size_t> likely;
    for (std::size_t i = 0; i < pass.oddsOf.size(); ++i)
        if (pass.oddsOf[i] > kLeastLikely * pass.odds)
            likely.push_back(i);
    std::stable_sort(likely.begin(), likely.end(), [&](auto a, auto b) { return pass.oddsOf[a] > pass.oddsOf[b]; });
    return likely;
}

} // namespace

SlipSearch findSlips(std::span<const Observation> readings, double resolution_deg, const std::optional<ExpectedCurve>& history,
    std::span<const double> beyond_rad, const Progress& progress)
{
    LUBBERLINE_EXPECT(beyond_rad.empty() || beyond_rad.size() == readings.size(), "what is beyond is known of each reading");
    if (readings.size() < 3)
        return {};
    BothForms forms(readings, resolution_deg, history, beyond_rad);
    SlipSearch found;
    const double odds = readings.size() <= kUnchecked && !history ? kOddsUnchecked : oddsFor(readings.size());
    // Beyond a third of the readings nothing is left to hold the others against.
    const std::size_t most = std::max<std::size_t>(1, readings.size() / 3);
    for (Pass pass = forms.look(); found.slips.size() < most && readings.size() - found.slips.size() > 3;) {
        if (progress && !progress(static_cast<double>(found.slips.size()) / static_cast<double>(most)))
            break;
        if (pass.odds <= (found.slips.empty() ? odds : std::max(odds, kOddsMore)))
            break;
        const auto likely = likelyOnes(pass);
        forms.takeOut(likely.front());
        // Readings cannot be told apart when nothing is left to find with the likeliest taken out.
        Pass rest = forms.look();
        if (likely.size() == 1 || rest.odds > kOddsMore) {
            found.slips.push_back(described(pass, likely.front()));
            pass = std::move(rest);
            continue;
        }
        double together = 0;
        for (const auto reading : likely)
            together += pass.oddsOf[reading] / (1.0 + pass.odds);
        for (const auto reading : likely) {
            auto one = described(pass, reading);
            one.probability = together;
            std::copy_if(
                likely.begin(), likely.end(), std::back_inserter(one.orReadings), [reading](auto other) { return other != reading; });
            found.slips.push_back(std::move(one));
        }
        break;
    }
    nameExchangedRows(found, readings);
    found.seenFrom_deg = forms.seenFrom_deg();
    return found;
}

} // namespace lubberline
