#include "core/check/CheckHeadings.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

#include "core/base/Contract.h"
#include "core/check/CheckRandom.h"
#include "core/check/FaultTest.h"

namespace lubberline {

namespace {

using Five = Eigen::Matrix<double, 5, 5>;
using Row = Eigen::Matrix<double, 5, 1>;
constexpr int kCandidates = 24;
constexpr int kMostOfACheck = 3;
constexpr double kStep_deg = 15;

/// Second moment of the changes that a card does not survive; of all, where there are next to none of those.
Five worryingChanges(const CompassBelief& belief, const CheckOptions& options)
{
    const FaultTest fault(belief.card, options.tolerance_deg, options.limit_deg);
    CheckRandom random(11);
    Five all = Five::Zero(), faults = Five::Zero();
    double weightAll = 0, weightFaults = 0;
    for (const PossibleChange& possible : belief.possible)
        for (int i = 0; i < 16; ++i) {
            Row change;
            for (std::size_t c = 0; c < kCoefficientCount; ++c)
                change[static_cast<Eigen::Index>(c)] = std::sqrt(possible.variance_deg2[c]) * random.normal();
            const Five square = change * change.transpose() * possible.weight;
            all += square;
            weightAll += possible.weight;
            if (fault.isFault(change)) {
                faults += square;
                weightFaults += possible.weight;
            }
        }
    const bool few = weightFaults < 1e-3 * weightAll;
    Five moment = few ? Five(all / weightAll) : Five(faults / weightFaults);
    // Coefficients were drawn apart; what chance left between them is none of the compass's.
    return moment.diagonal().asDiagonal();
}

/// M = Σ w x xᵀ over heading, so that what is left of a covariance P is the sum over P·M: for the mean 1, ½, ½, ½, ½.
Five allHeadingsAlike() { return Row(1, 0.5, 0.5, 0.5, 0.5).asDiagonal(); }

Five whereTheCardFails(const CompassBelief& belief, const CheckOptions& options)
{
    const FaultTest fault(belief.card, options.tolerance_deg, options.limit_deg);
    Five weighted = Five::Zero();
    double sum = 0, most = 0;
    for (int i = 0; i < kCandidates; ++i) {
        const Row row = rowAt(i * kStep_deg);
        double chance = 0, weight = 0;
        for (const PossibleChange& possible : belief.possible) {
            const double variance = row.cwiseAbs2().dot(Eigen::Map<const Row>(possible.variance_deg2.data()));
            chance += possible.weight * fault.chanceAt(i * kStep_deg, std::sqrt(variance));
            weight += possible.weight;
        }
        chance /= weight;
        most = std::max(most, chance);
        weighted += chance * chance * row * row.transpose();
        sum += chance * chance;
    }
    constexpr double kNextToNever = 1e-4;
    return most < kNextToNever ? allHeadingsAlike() : Five(weighted / sum);
}

double leftOf(const Five& covariance, const Five& weight) { return covariance.cwiseProduct(weight).sum(); }

Five after(const Five& covariance, double heading_deg, double error_deg)
{
    const Row row = rowAt(heading_deg), gain = covariance * row;
    return covariance - gain * gain.transpose() / (row.dot(gain) + error_deg * error_deg);
}

Five afterAll(Five covariance, const std::vector<double>& headings_deg, double error_deg)
{
    for (const double heading : headings_deg)
        covariance = after(covariance, heading, error_deg);
    return covariance;
}

class Search {
public:
    Search(const Five& before, const Five& weight, double error_deg) : m_before(before), m_weight(weight), m_error_deg(error_deg) {}

    [[nodiscard]] std::vector<double> best(int count)
    {
        if (count <= kMostOfACheck) {
            tryFrom(m_before, 0, count);
            return m_best;
        }
        for (int i = 0; i < count; ++i)
            m_best.push_back(bestToAdd(m_best));
        for (int round = 0; round < 10; ++round) {
            const std::vector<double> old = m_best;
            for (double& heading : m_best) {
                std::vector<double> others = m_best;
                others.erase(others.begin() + (&heading - m_best.data()));
                heading = bestToAdd(others);
            }
            if (m_best == old)
                break;
        }
        std::sort(m_best.begin(), m_best.end());
        return m_best;
    }

private:
    void tryFrom(const Five& covariance, int from, int left)
    {
        if (left == 0) {
            const double value = leftOf(covariance, m_weight);
            if (value < m_least - 1e-9) {
                m_least = value;
                m_best = m_trying;
            }
            return;
        }
        for (int i = from; i < kCandidates; ++i) {
            m_trying.push_back(i * kStep_deg);
            tryFrom(after(covariance, i * kStep_deg, m_error_deg), i + 1, left - 1);
            m_trying.pop_back();
        }
    }
    [[nodiscard]] double bestToAdd(const std::vector<double>& others) const
    {
        const Five covariance = afterAll(m_before, others, m_error_deg);
        double least = 1e300, best = 0;
        for (int i = 0; i < kCandidates; ++i) {
            if (std::find(others.begin(), others.end(), i * kStep_deg) != others.end())
                continue; // where it was read already, a shared fault of the ramp would be read twice
            const double value = leftOf(after(covariance, i * kStep_deg, m_error_deg), m_weight);
            if (value < least - 1e-9) {
                least = value;
                best = i * kStep_deg;
            }
        }
        return best;
    }

    const Five &m_before, &m_weight;
    double m_error_deg, m_least = 1e300;
    std::vector<double> m_best, m_trying;
};

} // namespace

std::vector<double> evenHeadings(int count)
{
    std::vector<double> headings;
    for (int i = 0; i < count; ++i)
        headings.push_back(360.0 * i / count);
    return headings;
}

ChosenHeadings headingsFor(const CompassBelief& belief, int count, const CheckOptions& options)
{
    LUBBERLINE_EXPECT(count >= 1 && count <= kCandidates, "1 to 24 headings are chosen");
    const Five before = worryingChanges(belief, options);
    const Five weight = count <= kMostOfACheck ? whereTheCardFails(belief, options) : allHeadingsAlike();
    const auto left_deg = [&](const std::vector<double>& headings_deg) {
        return std::sqrt(leftOf(afterAll(before, headings_deg, options.readingError_deg), weight));
    };
    ChosenHeadings chosen;
    chosen.compass_deg = Search(before, weight, options.readingError_deg).best(count);
    chosen.left_deg = left_deg(chosen.compass_deg);
    chosen.leftEven_deg = left_deg(evenHeadings(count));
    if (chosen.leftEven_deg < chosen.left_deg) { // exchange ends where no single heading is better, and its headings are those of 15°
        chosen.compass_deg = evenHeadings(count);
        chosen.left_deg = chosen.leftEven_deg;
    }
    chosen.before_deg = left_deg({});
    return chosen;
}

} // namespace lubberline
