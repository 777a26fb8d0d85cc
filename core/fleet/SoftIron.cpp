#include "core/fleet/SoftIron.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>

#include "core/base/Normal.h"
#include "core/base/Number.h"

namespace lubberline {

namespace {

constexpr std::size_t kFirst = 3; ///< D; E follows
constexpr int kFewestAircraft = 3;
constexpr double kLeastSpread_deg = 0.2; ///< stores and equipment move D by as much, however alike those aircraft are

/// One aircraft's mean and the error of it.
struct OfAircraft {
    double sum = 0, variance = 0;
    int swings = 0;
};

std::optional<SoftIronCoefficient> coefficientOf(const std::map<std::string_view, OfAircraft>& aircraft)
{
    const auto n = static_cast<int>(aircraft.size());
    if (n < kFewestAircraft)
        return {};
    SoftIronCoefficient one;
    one.aircraft = n;
    double error = 0, squares = 0;
    for (const auto& [name, each] : aircraft) {
        one.mean_deg += each.sum / each.swings / n;
        error += each.variance / (static_cast<double>(each.swings) * each.swings) / n;
    }
    for (const auto& [name, each] : aircraft)
        squares += std::pow(each.sum / each.swings - one.mean_deg, 2);
    const double variance = squares / (n - 1);
    one.standardError_deg = std::sqrt(variance / n);
    one.between_deg = std::sqrt(std::max(0.0, variance - error));
    one.next_deg = std::hypot(one.between_deg, one.standardError_deg);
    const double half = studentFactor(n - 1) * one.next_deg;
    one.next95_deg = {one.mean_deg - half, one.mean_deg + half};
    return one;
}

} // namespace

std::vector<SoftIronStandard> softIronOf(const FleetSwings& fleet, const FleetCurves& curves)
{
    using Kind = std::pair<std::string_view, std::string_view>;
    std::map<Kind, std::array<std::map<std::string_view, OfAircraft>, 2>> kinds;
    for (std::size_t row = 0; row < fleet.swings.size(); ++row) {
        const auto& swing = fleet.swings[row];
        const auto& compass = fleet.compasses[static_cast<std::size_t>(swing.compass)];
        for (std::size_t i = 0; i < 2; ++i) {
            if (!curves.curves[row].known(kFirst + i))
                continue;
            auto& mine = kinds[{compass.type, compass.compass}][i][compass.aircraft];
            mine.sum += curves.curves[row].value_deg[kFirst + i];
            mine.variance += curves.variance_deg2(swing, row, kFirst + i);
            ++mine.swings;
        }
    }
    std::vector<SoftIronStandard> standards;
    for (const auto& [kind, aircraft] : kinds) {
        SoftIronStandard standard{
            std::string(kind.first), std::string(kind.second), coefficientOf(aircraft[0]), coefficientOf(aircraft[1])};
        if (standard.D || standard.E)
            standards.push_back(std::move(standard));
    }
    return standards;
}

ExpectedCurve expectedOf(const SoftIronStandard& standard)
{
    ExpectedCurve expected = anyCurve();
    const auto take = [](const std::optional<SoftIronCoefficient>& told, double& mean_rad, double& deviation_rad) {
        if (!told)
            return;
        mean_rad = toRadians(told->mean_deg);
        deviation_rad = toRadians(std::max((told->next95_deg.high - told->mean_deg) / kNormal95, kLeastSpread_deg));
    };
    take(standard.D, expected.mean.D_rad, expected.standardDeviation.D_rad);
    take(standard.E, expected.mean.E_rad, expected.standardDeviation.E_rad);
    return expected;
}

Message inWords(const SoftIronCoefficient& coefficient, char letter)
{
    return {MARKED("core", "%1 %2\u00B0 \u00B1 %3\u00B0 from %4 aircraft; the next one within %5\u00B0 to %6\u00B0 (95 %)"), letter,
        signedFigureText(coefficient.mean_deg, 2), figureText(coefficient.standardError_deg, 2), coefficient.aircraft,
        signedFigureText(coefficient.next95_deg.low, 2), signedFigureText(coefficient.next95_deg.high, 2)};
}

} // namespace lubberline
