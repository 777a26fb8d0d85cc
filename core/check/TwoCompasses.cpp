#include "core/check/TwoCompasses.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "core/angle/Angle.h"
#include "core/base/Number.h"
#include "core/check/CheckRandom.h"
#include "core/check/Evidence.h"
#include "core/check/FaultTest.h"

namespace lubberline {

namespace {

constexpr int kPairs = 150; ///< possibilities of each kind
constexpr int kDrawsOfPair = 16;

double corrected_deg(const CompassBelief& belief, CompassHeading compass)
{
    return compass.degrees() + deviationAt(belief.card, compass).degrees();
}

using TenRow = Eigen::Matrix<double, 10, 1>; ///< of both compasses' changes

/// Of one bin of heading.
struct Bin {
    TenRow difference = TenRow::Zero(), first = TenRow::Zero(), second = TenRow::Zero();
    double difference_deg = 0, first_deg = 0, second_deg = 0;
    double from_deg = 0, least_deg = 0, most_deg = 0; ///< the difference of its first pair; the others about that one
    int count = 0, datums = 0;
};

constexpr double kMostSpread = 6; ///< of the differences of two pairs, four readings: three standard deviations
constexpr int kFewPairs = 10;     ///< read by people; a log's scatter is no contradiction

using Bins = std::map<int, Bin>;

Bins binsOf(const CompassBelief& first, const CompassBelief& second, std::span<const PairReading> pairs)
{
    Bins bins;
    for (const PairReading& pair : pairs) {
        Bin& bin = bins[static_cast<int>(pair.first.degrees() / 10)];
        const double one = corrected_deg(first, pair.first), two = corrected_deg(second, pair.second);
        const Eigen::Matrix<double, 5, 1> rowOne = rowAt(pair.first.degrees()), rowTwo = rowAt(pair.second.degrees());
        bin.difference.head<5>() -= rowOne;
        bin.difference.tail<5>() += rowTwo;
        bin.difference_deg += wrap180(one - two);
        if (bin.count == 0)
            bin.from_deg = wrap180(one - two);
        const double beyond_deg = wrap180(one - two - bin.from_deg);
        bin.least_deg = std::min(bin.least_deg, beyond_deg);
        bin.most_deg = std::max(bin.most_deg, beyond_deg);
        ++bin.count;
        if (pair.datum) {
            bin.first.head<5>() += rowOne;
            bin.second.tail<5>() += rowTwo;
            bin.first_deg += wrap180(pair.datum->degrees() - one);
            bin.second_deg += wrap180(pair.datum->degrees() - two);
            ++bin.datums;
        }
    }
    return bins;
}

Readings<10> pairReadings(const Bins& bins, const CheckOptions& options)
{
    Readings<10> readings;
    for (const auto& [place, bin] : bins) {
        // Where there is a datum both are held against it, and their difference says nothing more.
        if (bin.datums > 0) {
            readings.take(bin.first / bin.datums, bin.first_deg / bin.datums, options.readingError_deg);
            readings.take(bin.second / bin.datums, bin.second_deg / bin.datums, options.readingError_deg);
        } else {
            readings.take(bin.difference / bin.count, bin.difference_deg / bin.count, options.readingError_deg);
        }
    }
    return readings;
}

/// Coefficients of the difference by themselves, with a wide prior that makes few headings no certainty.
void describeDifference(const Bins& bins, const CheckOptions& options, PairVerdict& verdict)
{
    Readings<5> readings;
    double squares = 0;
    for (const auto& [place, bin] : bins) {
        const Eigen::Matrix<double, 5, 1> row = -(bin.difference.head<5>() - bin.difference.tail<5>()) / (2 * bin.count);
        readings.take(row, bin.difference_deg / bin.count, options.readingError_deg);
        squares += std::pow(bin.difference_deg / bin.count, 2);
    }
    const Eigen::Matrix<double, 5, 1> wide = Eigen::Matrix<double, 5, 1>::Constant(100.0);
    const Conditioned<5> given = conditionedOn(readings, wide);
    for (std::size_t c = 0; c < 5; ++c) {
        verdict.difference_deg[c] = given.mean[static_cast<Eigen::Index>(c)];
        verdict.differenceError_deg[c] = given.root.row(static_cast<Eigen::Index>(c)).norm();
    }
    verdict.rms_deg = std::sqrt(squares / static_cast<double>(bins.size()));
}

/// The possibilities of a compass that jumped, or did not; without history there is one kind only.
std::vector<const PossibleChange*> ofKind(const CompassBelief& belief, bool jumped)
{
    std::vector<const PossibleChange*> found;
    for (const PossibleChange& possible : belief.possible)
        if (possible.jumped == jumped && possible.weight > 0)
            found.push_back(&possible);
    return found;
}

struct Drawn {
    double logWeight = 0;
    std::array<int, 4> count{}; ///< of Moved
};

std::vector<Drawn> drawAll(
    const CompassBelief& first, const CompassBelief& second, const Readings<10>& readings, const CheckOptions& options)
{
    const FaultTest faultOne(first.card, options.tolerance_deg, options.limit_deg),
        faultTwo(second.card, options.tolerance_deg, options.limit_deg);
    CheckRandom random(13);
    std::vector<Drawn> all;
    TenRow variance, normal;
    for (const bool oneJumped : {false, true})
        for (const bool twoJumped : {false, true}) {
            const auto ones = ofKind(first, oneJumped), twos = ofKind(second, twoJumped);
            if (ones.empty() || twos.empty())
                continue;
            const double weight = ones.front()->weight * static_cast<double>(ones.size()) * twos.front()->weight
                * static_cast<double>(twos.size()) / kPairs;
            for (int i = 0; i < kPairs; ++i) {
                const auto& one = *ones[static_cast<std::size_t>(random.uniform() * static_cast<double>(ones.size()))];
                const auto& two = *twos[static_cast<std::size_t>(random.uniform() * static_cast<double>(twos.size()))];
                variance << Eigen::Map<const Eigen::Matrix<double, 5, 1>>(one.variance_deg2.data()),
                    Eigen::Map<const Eigen::Matrix<double, 5, 1>>(two.variance_deg2.data());
                const Conditioned<10> given = conditionedOn(readings, variance);
                Drawn drawn{given.logWeight + std::log(weight), {}};
                for (int n = 0; n < kDrawsOfPair; ++n) {
                    for (double& entry : normal)
                        entry = random.normal();
                    const TenRow change = given.mean + given.root * normal;
                    const bool a = faultOne.isFault(change.head<5>()), b = faultTwo.isFault(change.tail<5>());
                    ++drawn.count[(a ? 1u : 0u) + (b ? 2u : 0u)];
                }
                all.push_back(drawn);
            }
        }
    return all;
}

void judge(const std::vector<Drawn>& all, PairVerdict& verdict)
{
    double most = -1e300, sum = 0;
    for (const Drawn& drawn : all)
        most = std::max(most, drawn.logWeight);
    for (const Drawn& drawn : all) {
        const double weight = std::exp(drawn.logWeight - most);
        sum += weight;
        for (std::size_t i = 0; i < 4; ++i)
            verdict.probability[i] += weight * drawn.count[i] / kDrawsOfPair;
    }
    for (double& probability : verdict.probability)
        probability /= sum;
    verdict.firstFault = verdict.probability[1] + verdict.probability[3];
    verdict.secondFault = verdict.probability[2] + verdict.probability[3];
    const auto likeliest = std::max_element(verdict.probability.begin(), verdict.probability.end());
    if (*likeliest >= kNamedFrom)
        verdict.named = static_cast<Moved>(likeliest - verdict.probability.begin());
    verdict.errorProbability = 1 - *likeliest;
}

/// What both compasses are off the datum by, where that is the same of both and little else is left: two compasses with a life of their
/// own seldom move alike, and a variation, a clock or a line that is wrong looks just so.
std::optional<double> datumOutBy_deg(const Bins& bins, const CheckOptions& options)
{
    std::array<std::vector<double>, 2> off_deg;
    for (const auto& [place, bin] : bins)
        if (bin.datums > 0) {
            off_deg[0].push_back(bin.first_deg / bin.datums);
            off_deg[1].push_back(bin.second_deg / bin.datums);
        }
    const auto count = static_cast<double>(off_deg[0].size());
    if (off_deg[0].empty())
        return {};
    std::array<double, 2> mean_deg{};
    for (std::size_t which = 0; which < 2; ++which)
        mean_deg[which] = std::accumulate(off_deg[which].begin(), off_deg[which].end(), 0.0) / count;
    const double alike_deg = (mean_deg[0] + mean_deg[1]) / 2;
    double squares = 0;
    for (std::size_t which = 0; which < 2; ++which)
        for (const double off : off_deg[which])
            squares += std::pow(off - alike_deg, 2);
    const double left_deg = std::sqrt(squares / (2 * count)), error_deg = options.readingError_deg;
    const bool sure = std::abs(alike_deg) > std::max(options.tolerance_deg / 2, 3 * error_deg / std::sqrt(2 * count));
    const bool nothingElse = left_deg < std::max(2 * error_deg, std::abs(alike_deg) / 3);
    return sure && nothingElse ? std::optional(alike_deg) : std::nullopt;
}

} // namespace

Result<PairVerdict> compareCompasses(
    const CompassBelief& first, const CompassBelief& second, std::span<const PairReading> pairs, const CheckOptions& options)
{
    if (pairs.empty())
        return Error{ErrorCode::InvalidInput, MARKED("core", "no pair of readings; expected both compasses read together")};
    PairVerdict verdict;
    const Bins bins = binsOf(first, second, pairs);
    verdict.readings = pairs.size();
    verdict.headings = bins.size();
    for (const auto& [place, bin] : bins)
        verdict.withDatum += static_cast<std::size_t>(bin.datums);
    describeDifference(bins, options, verdict);
    judge(drawAll(first, second, pairReadings(bins, options), options), verdict);
    if (verdict.firstFault > 0.5 && verdict.secondFault > 0.5)
        verdict.datumOut_deg = datumOutBy_deg(bins, options);
    if (verdict.withDatum == 0)
        verdict.warnings.push_back(MARKED("core",
            "no reading has a datum beside it: had both compasses moved alike, their readings would agree; that is not told apart from the datum"));
    if (!first.hasHistory || !second.hasHistory)
        verdict.warnings.push_back(
            MARKED("core", "a compass without a swing on record has no card: what it always deviated counts as if it had moved"));
    if (verdict.headings < verdict.readings)
        verdict.warnings.push_back(
            {MARKED_N("core", "%n pair(s) were read on %1 different headings: those of the same ten degrees count as one, their mean"),
                verdict.readings, verdict.headings});
    for (const auto& [place, bin] : bins)
        if (const double spread_deg = bin.most_deg - bin.least_deg;
            bin.count < kFewPairs && spread_deg > kMostSpread * options.readingError_deg)
            verdict.warnings.push_back(
                {MARKED("core",
                     "the pairs between %1° and %2° contradict each other by %3°: one is a slip, or a compass sticks; read them again"),
                    10 * place, 10 * place + 10, figureText(spread_deg, 1)});
    if (verdict.headings < 4)
        verdict.warnings.push_back(
            {MARKED_N("core", "both were read on %n heading(s) only; what changed elsewhere is not seen"), verdict.headings});
    return verdict;
}

Message inWords(const PairVerdict& verdict)
{
    const auto percent = [](double probability) {
        return probability > 0.99 ? std::string("> 99") : probability < 0.01 ? std::string("< 1") : figureText(100 * probability, 0);
    };
    if (!verdict.named && !verdict.datumOut_deg)
        return {verdict.withDatum > 0
                ? MARKED("core",
                    "not told which: the first has moved with %1 %, the second with %2 %, neither with %3 %; read them on more headings beside the datum")
                : MARKED("core",
                    "not told which: the first has moved with %1 %, the second with %2 %, neither with %3 %; read them once beside a datum"),
            percent(verdict.firstFault), percent(verdict.secondFault), percent(verdict.probability[0])};
    const double probability = 1 - verdict.errorProbability;
    if (verdict.datumOut_deg)
        return {
            MARKED("core",
                "both compasses differ from the datum by %1° alike: the datum (variation, clock, line) may be out, or both moved; hold it against another"),
            signedFigureText(*verdict.datumOut_deg, 1)};
    switch (*verdict.named) {
    case Moved::First: return {MARKED("core", "the first compass moved (%1 %)"), percent(probability)};
    case Moved::Second: return {MARKED("core", "the second compass moved (%1 %)"), percent(probability)};
    case Moved::Both: return {MARKED("core", "both compasses moved (%1 %)"), percent(probability)};
    case Moved::Neither: break;
    }
    if (verdict.withDatum == 0)
        return {MARKED("core", "neither compass moved away from the other (%1 %); whether both moved alike is not told without a datum"),
            percent(probability)};
    return {MARKED("core", "neither compass moved (%1 %)"), percent(probability)};
}

Message whySwing(const PairVerdict& verdict, const std::string& first, const std::string& second)
{
    const double moved = 1 - verdict.probability[static_cast<std::size_t>(Moved::Neither)];
    if (moved < kNamedFrom)
        return {};
    const std::string percent = figureText(100 * std::min(moved, 0.99), 0);
    const Moved which = verdict.named.value_or(Moved::Neither);
    if (which == Moved::First || which == Moved::Second)
        return {MARKED("core", "read beside %1, the compass %2 no longer holds its card (%3 %)"), which == Moved::First ? second : first,
            which == Moved::First ? first : second, percent};
    if (verdict.datumOut_deg)
        return {MARKED("core", "read together, %1 and %2 differ from the datum by %3° alike: the datum may have been out, or both moved"),
            first, second, signedFigureText(*verdict.datumOut_deg, 1)};
    if (which == Moved::Both)
        return {MARKED("core", "read together, neither %1 nor %2 holds its card (%3 %)"), first, second, percent};
    return {MARKED("core", "read together, one of %1 and %2 no longer holds its card, not told which (%3 %)"), first, second, percent};
}

} // namespace lubberline
