#pragma once
/// Whether a series of dated figures jumps once, with a trend in the null hypothesis so that drift is not called a jump: the largest
/// standardised step over all places where it may have happened. Critical values are those of the series' own dates and weights:
///   errors known: the statistics of all places are one normal vector, and the chance that any is beyond c is
///     Σ_s 2 Φ̄(c) · E[1 / number of places beyond c | place s is beyond c]      (Naiman and Priebe 2001), to any tail;
///   errors known but for one factor: simulated outright.

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/fleet/Proportion.h"

namespace lubberline {

struct DatedValue {
    int day = 0;
    double value = 0;
    double variance = 1;    ///< of its error; with ErrorScale::Unknown, up to a common factor
    bool corrected = false; ///< adjusted between the one before and this one: what happened there is not asked for
    double swingShare = 1;  ///< of its kind's variance of swings (ScatterSize): trained crews have less
};

enum class ErrorScale { Known, Unknown };

struct JumpOptions {
    ErrorScale scale = ErrorScale::Known;
    bool trend = true;
    int leastSegment = 1;             ///< figures on either side of a place
    std::vector<std::size_t> at = {}; ///< jumps that are known already, by the place after them
    double walk_year = 0;             ///< variance by which the figure itself wanders in a year: steps of it are no jumps
};

/// What the dates allow; no figures are in it.
class JumpDesign {
public:
    JumpDesign(std::span<const DatedValue> series, const JumpOptions& options);
    /// Places where a step can be told from what the null holds; empty: nothing can be tested.
    [[nodiscard]] const std::vector<std::size_t>& places() const { return m_places; }
    [[nodiscard]] int freedom() const { return m_freedom; }

    /// The chance that the largest statistic is as far from 0 or farther, if there is no jump. @param draws a place
    [[nodiscard]] double chanceBeyond(double statistic, int draws) const;
    /// Of errors that are known: how many places alone the chance of any is worth, Σ_s E[1 / …] of above, at each of some statistics.
    [[nodiscard]] std::vector<double> worthOfPlaces(std::span<const double> statistics, int draws) const;
    /// The statistic that is exceeded with a chance.
    [[nodiscard]] double criticalValue(double chance, int draws) const;

private:
    friend struct JumpFinder;
    [[nodiscard]] std::vector<double> simulated(int draws) const; ///< sorted |t|
    ErrorScale m_scale;
    std::vector<std::size_t> m_places;
    Eigen::MatrixXd m_null;     ///< orthonormal columns of the null model, whitened
    Eigen::MatrixXd m_steps;    ///< a row a place: its step less the null, whitened, of length 1
    Eigen::VectorXd m_length;   ///< that was taken out of the rows
    Eigen::MatrixXd m_whitener; ///< L⁻¹ of the figures' covariance LLᵀ
    int m_freedom = 0;
};

struct Jump {
    std::size_t after = 0, before = 0; ///< the figures between which it happened
    double change = 0, standardError = 0, statistic = 0;
    double p = 1; ///< over all places
};

/// How well a jump's p is to be known, where the errors are.
enum class JumpChance {
    Exact,    ///< of its pattern of dates (JumpChances.h)
    Decisive, ///< where it is surely above 0.1, only that
    Least     ///< the chance of its place alone, which that of any place is not below: nothing is simulated
};
/// The largest step.
[[nodiscard]] std::optional<Jump> largestJump(
    std::span<const DatedValue> series, const JumpOptions& options, JumpChance chance = JumpChance::Exact);

struct Drift {
    double perYear = 0, standardError = 0, p = 1;
    Interval interval95;
};
/// The trend with known jumps and corrections taken out; none where the dates cannot tell it.
[[nodiscard]] std::optional<Drift> driftOf(std::span<const DatedValue> series, const JumpOptions& options);

} // namespace lubberline
