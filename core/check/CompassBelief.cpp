#include "core/check/CompassBelief.h"

#include <algorithm>
#include <cmath>

#include "core/angle/Angle.h"
#include "core/check/CheckRandom.h"

namespace lubberline {

namespace {

constexpr int kWalkNodes = 13;          ///< sizes of walk, from 1/8 to 8 times the plausible one
constexpr int kPossible = 150;          ///< of each kind
constexpr std::uint64_t kSeed = 941973; ///< any: the same answer for the same compass

double walkAt(int node, double plausible) { return plausible * std::pow(2.0, (node - kWalkNodes / 2) / 2.0); }

double normalDensity(double value, double variance) { return std::exp(-value * value / (2 * variance)) / std::sqrt(variance); }

/// How likely the sizes of walk are after the history; before it they are log-normal about the plausible one, within a factor of 2.
std::array<double, kWalkNodes> walkWeights(std::span<const PastSwing> swings, std::size_t c, const PlausibleChange& plausible)
{
    std::array<double, kWalkNodes> logs{};
    for (int node = 0; node < kWalkNodes; ++node) {
        const double off = (node - kWalkNodes / 2) / 2.0; // factors of 2
        logs[static_cast<std::size_t>(node)] = -off * off / 2;
    }
    const PastSwing* before = nullptr;
    for (const PastSwing& swing : swings) {
        if (!swing.value_deg[c])
            continue;
        if (before && !swing.afterCorrection && swing.year > before->year) {
            const double years = swing.year - before->year, step = *swing.value_deg[c] - *before->value_deg[c];
            const double noise = swing.standardError_deg[c] * swing.standardError_deg[c]
                + before->standardError_deg[c] * before->standardError_deg[c] + 2 * plausible.swing_deg[c] * plausible.swing_deg[c];
            const double jumps = -std::expm1(-plausible.jumpsPerYear * years);
            for (int node = 0; node < kWalkNodes; ++node) {
                const double walk = walkAt(node, plausible.walk_deg_year[c]), variance = walk * walk * years + noise;
                logs[static_cast<std::size_t>(node)] += std::log((1 - jumps) * normalDensity(step, variance)
                    + jumps * normalDensity(step, variance + plausible.jump_deg[c] * plausible.jump_deg[c]) + 1e-300);
            }
        }
        before = &swing;
    }
    const double most = *std::max_element(logs.begin(), logs.end());
    double sum = 0;
    for (double& log : logs)
        sum += log = std::exp(log - most);
    for (double& weight : logs)
        weight /= sum;
    return logs;
}

std::size_t chosen(const std::array<double, kWalkNodes>& weights, double uniform)
{
    std::size_t node = 0;
    for (double sum = weights[0]; sum < uniform && node + 1 < kWalkNodes; sum += weights[node])
        ++node;
    return node;
}

} // namespace

PlausibleChange plausibleFor(CompassKind kind)
{
    PlausibleChange plausible;
    if (kind == CompassKind::RemoteStabilised || kind == CompassKind::RemoteUnstabilised) {
        plausible.walk_deg_year = {0.3, 0.3, 0.3, 0.15, 0.15};
        plausible.jump_deg = {2, 2, 2, 1, 1};
    }
    return plausible;
}

CompassBelief beliefOf(std::span<const PastSwing> swings, double year, const PlausibleChange& plausible)
{
    while (!swings.empty() && swings.back().year > year)
        swings = swings.first(swings.size() - 1);
    CompassBelief belief;
    CheckRandom random(kSeed);
    if (swings.empty()) {
        belief.walk_deg_year = plausible.walk_deg_year;
        PossibleChange unknown;
        for (std::size_t c = 0; c < kCoefficientCount; ++c)
            unknown.variance_deg2[c] = plausible.unknown_deg[c] * plausible.unknown_deg[c];
        belief.possible = std::vector<PossibleChange>(kPossible, unknown);
        return belief;
    }
    belief.hasHistory = true;
    const PastSwing& last = swings.back();
    const auto on = [&](Coefficient c) { return toRadians(last.value_deg[indexOf(c)].value_or(0)); };
    belief.card = {on(Coefficient::A), on(Coefficient::B), on(Coefficient::C), on(Coefficient::D), on(Coefficient::E)};
    belief.yearsSince = year - last.year;
    belief.jumpProbability = -std::expm1(-plausible.jumpsPerYear * belief.yearsSince);
    std::array<std::array<double, kWalkNodes>, kCoefficientCount> weights{};
    for (std::size_t c = 0; c < kCoefficientCount; ++c) {
        weights[c] = walkWeights(swings, c, plausible);
        double square = 0;
        for (int node = 0; node < kWalkNodes; ++node) {
            const double walk = walkAt(node, plausible.walk_deg_year[c]);
            square += weights[c][static_cast<std::size_t>(node)] * walk * walk;
        }
        belief.walk_deg_year[c] = std::sqrt(square);
    }
    for (const bool jumped : {false, true})
        for (int i = 0; i < kPossible; ++i) {
            PossibleChange possible;
            possible.jumped = jumped;
            possible.weight = (jumped ? belief.jumpProbability : 1 - belief.jumpProbability) / kPossible;
            for (std::size_t c = 0; c < kCoefficientCount; ++c) {
                const double walk = walkAt(static_cast<int>(chosen(weights[c], random.uniform())), plausible.walk_deg_year[c]);
                const double error = last.value_deg[c] ? last.standardError_deg[c] : plausible.unknown_deg[c];
                possible.variance_deg2[c] = walk * walk * belief.yearsSince + error * error
                    + plausible.swing_deg[c] * plausible.swing_deg[c] + (jumped ? plausible.jump_deg[c] * plausible.jump_deg[c] : 0);
            }
            belief.possible.push_back(possible);
        }
    return belief;
}

Eigen::Matrix<double, 5, 1> rowAt(double compass_deg)
{
    const double angle = toRadians(compass_deg);
    return {1, std::sin(angle), std::cos(angle), std::sin(2 * angle), std::cos(2 * angle)};
}

} // namespace lubberline
