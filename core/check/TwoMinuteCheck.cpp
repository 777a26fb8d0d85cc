#include "core/check/TwoMinuteCheck.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

#include "core/angle/Angle.h"
#include "core/angle/PrintedHeading.h"
#include "core/base/Number.h"
#include "core/check/CheckRandom.h"
#include "core/check/Evidence.h"
#include "core/check/FaultTest.h"

namespace lubberline {

namespace {

constexpr int kDraws = 20; ///< of each possibility

/// A heading that was read several times is one reading: datum, place and a compass that sticks err alike, and are no surer by half for
/// being looked at twice.
constexpr double kSameHeading_deg = 5;

/// Readings of one heading, each group in the order in which it was read.
std::vector<std::vector<Observation>> byHeading(std::span<const Observation> readings)
{
    std::vector<std::vector<Observation>> groups;
    for (const Observation& reading : readings) {
        const auto same = std::ranges::find_if(groups, [&](const auto& group) {
            return std::abs(wrap180(reading.compass.degrees() - group.front().compass.degrees())) < kSameHeading_deg;
        });
        if (same == groups.end())
            groups.push_back({reading});
        else
            same->push_back(reading);
    }
    return groups;
}

double differenceFromCard_deg(const CompassBelief& belief, const Observation& reading)
{
    return wrap180(deviationOf(reading.magnetic, reading.compass).degrees() - deviationAt(belief.card, reading.compass).degrees());
}

Readings<5> readingsOf(const CompassBelief& belief, std::span<const Observation> readings, const CheckOptions& options)
{
    Readings<5> taken;
    for (const auto& group : byHeading(readings)) {
        Eigen::Matrix<double, 5, 1> row = Eigen::Matrix<double, 5, 1>::Zero();
        const double first_deg = differenceFromCard_deg(belief, group.front());
        double beyond_deg = 0; // about the first, which may lie near ±180°
        for (const Observation& reading : group) {
            row += rowAt(reading.compass.degrees());
            beyond_deg += wrap180(differenceFromCard_deg(belief, reading) - first_deg);
        }
        const auto count = static_cast<double>(group.size());
        taken.take(row / count, wrap180(first_deg + beyond_deg / count), options.readingError_deg);
    }
    return taken;
}

/// Which headings were read several times, and where the readings contradict each other.
std::vector<Message> doubtsOfRepeats(const CompassBelief& belief, std::span<const Observation> readings, const CheckOptions& options)
{
    std::vector<Message> doubts;
    for (const auto& group : byHeading(readings)) {
        if (group.size() < 2)
            continue;
        const double first_deg = differenceFromCard_deg(belief, group.front());
        double least = 0, most = 0;
        for (const Observation& reading : group) {
            const double beyond = wrap180(differenceFromCard_deg(belief, reading) - first_deg);
            least = std::min(least, beyond);
            most = std::max(most, beyond);
        }
        const std::string at = figureText(printedHeading_deg(group.front().compass.degrees(), 0), 0);
        constexpr double kContradiction = 4.2; // of two readings; three standard deviations of their difference
        if (most - least > kContradiction * options.readingError_deg)
            doubts.push_back({MARKED("core",
                                  "the readings on %1° contradict each other by %2°: one is a slip, or the compass sticks; read it again "
                                  "(their mean was taken)"),
                at, figureText(most - least, 1)});
        else
            doubts.push_back({MARKED_N("core", "%1° was read %n time(s): it counts as one reading, the mean"), at, group.size()});
    }
    return doubts;
}

double chanceOf(const CompassBelief& belief, const Readings<5>& readings, const CheckOptions& options)
{
    const FaultTest fault(belief.card, options.tolerance_deg, options.limit_deg);
    CheckRandom random(7);
    double sum = 0, faults = 0, most = -1e300;
    std::vector<std::pair<double, double>> found; // log weight, share of faults
    found.reserve(belief.possible.size());
    Eigen::Matrix<double, 5, 1> variance, normal;
    for (const PossibleChange& possible : belief.possible) {
        if (!(possible.weight > 0))
            continue;
        variance = Eigen::Map<const Eigen::Matrix<double, 5, 1>>(possible.variance_deg2.data());
        const Conditioned<5> given = conditionedOn(readings, variance);
        int count = 0;
        for (int i = 0; i < kDraws; ++i) {
            for (double& one : normal)
                one = random.normal();
            const Eigen::Matrix<double, 5, 1> change = given.mean + given.root * normal;
            count += fault.isFault(change);
        }
        found.emplace_back(given.logWeight + std::log(possible.weight), count / double(kDraws));
        most = std::max(most, found.back().first);
    }
    for (const auto& [logWeight, share] : found) {
        const double weight = std::exp(logWeight - most);
        sum += weight;
        faults += weight * share;
    }
    return faults / sum;
}

} // namespace

double chanceOfFault(const CompassBelief& belief, std::span<const Observation> readings, const CheckOptions& options)
{
    return chanceOf(belief, readingsOf(belief, readings, options), options);
}

Message whatIsUnknown(const CompassBelief& belief)
{
    if (belief.hasHistory)
        return {};
    return MARKED("core",
        "this compass has no swing on record: the check cannot know its card, and holds what was read against no deviation at all and "
        "the sizes that compasses of its kind have");
}

Result<CheckVerdict> verdictOf(const CompassBelief& belief, std::span<const Observation> readings, const CheckOptions& options)
{
    if (readings.empty())
        return Error{ErrorCode::InvalidInput, MARKED("core", "no reading that counts; expected one at least, better two or three")};
    CheckVerdict verdict;
    verdict.before = chanceOfFault(belief, {}, options);
    Readings<5> taken = readingsOf(belief, readings, options);
    const double fault = chanceOf(belief, taken, options);
    taken.weighted.setZero();
    verdict.reachable = chanceOf(belief, taken, options);
    verdict.holds = fault <= options.accepted;
    verdict.errorProbability = verdict.holds ? fault : 1 - fault;
    for (const Observation& reading : readings) {
        const double difference = differenceFromCard_deg(belief, reading);
        verdict.differences_deg.push_back(difference);
        if (std::abs(difference) >= verdict.largestRead_deg) {
            verdict.largestRead_deg = std::abs(difference);
            verdict.at_deg = reading.compass.degrees();
        }
    }
    constexpr double kOtherSide_deg = 150;
    if (std::all_of(
            verdict.differences_deg.begin(), verdict.differences_deg.end(), [](double off) { return std::abs(off) > kOtherSide_deg; }))
        verdict.warnings.push_back(MARKED("core",
            "every reading is half a circle from the card: the compass or the datum was read from its other side; read them again before it is swung"));
    std::set<int> headings;
    for (const Observation& reading : readings)
        headings.insert(static_cast<int>(reading.compass.degrees() / 10));
    if (headings.size() < 2)
        verdict.warnings.push_back(MARKED("core",
            "it was read on one heading only: what changed elsewhere is not seen, and the verdict rests on what compasses of its kind and history do"));
    if (Message unknown = whatIsUnknown(belief); !unknown.empty())
        verdict.warnings.push_back(std::move(unknown));
    std::ranges::move(doubtsOfRepeats(belief, readings, options), std::back_inserter(verdict.warnings));
    if (verdict.reachable > options.accepted)
        verdict.warnings.push_back(
            {MARKED("core",
                 "even readings that agree with the card in full would leave a chance of %1 % that it does not hold: "
                 "these headings are too few to clear this compass"),
                figureText(100 * verdict.reachable, 0)});
    return verdict;
}

Message inWords(const CheckVerdict& verdict, const CheckOptions& options)
{
    const auto percent = [](double probability) {
        const double share = 100 * probability;
        return share < 0.1 ? std::string("< 0.1")
            : share > 99.9 ? std::string("> 99.9")
                           : figureText(share, share < 1 || share > 99 ? 1 : 0);
    };
    if (verdict.holds)
        return {MARKED("core", "the card holds within %1° on all headings; this is wrong with a probability of %2 %"),
            figureText(options.tolerance_deg, 1), percent(verdict.errorProbability)};
    return {MARKED("core", "swing it: with a probability of %1 % the card does not hold within %2° any more; this is wrong with %3 %"),
        percent(1 - verdict.errorProbability), figureText(options.tolerance_deg, 1), percent(verdict.errorProbability)};
}

} // namespace lubberline
