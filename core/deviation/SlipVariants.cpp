#include "core/deviation/SlipVariants.h"

#include <array>
#include <cmath>
#include <utility>

namespace lubberline {

namespace {

constexpr double kSwappedDigits = 2e-3, kReciprocal = 1e-3, kFiveDegrees = 2e-3, kTenDegrees = 4e-3, kHundredDegrees = 5e-4;

/// The figure with two of its three digits exchanged; a fraction stays.
std::vector<double> withSwappedDigits(double figure_deg)
{
    const int whole = static_cast<int>(std::floor(figure_deg));
    const std::array<int, 3> digits{whole / 100, whole / 10 % 10, whole % 10};
    std::vector<double> swapped;
    for (const auto& [i, j] : {std::pair(0, 1), std::pair(1, 2), std::pair(0, 2)}) {
        auto other = digits;
        std::swap(other[i], other[j]);
        const int meant = other[0] * 100 + other[1] * 10 + other[2];
        if (meant != whole && meant < 360)
            swapped.push_back(meant + figure_deg - whole);
    }
    return swapped;
}

} // namespace

std::vector<SlipVariant> slipVariantsOf(double figure_deg)
{
    std::vector<SlipVariant> variants;
    const auto swapped = withSwappedDigits(figure_deg);
    for (const double meant : swapped)
        variants.push_back({Slip::SwappedDigits, meant, kSwappedDigits / static_cast<double>(swapped.size())});
    variants.push_back({Slip::Reciprocal, wrap360(figure_deg + 180.0), kReciprocal});
    const auto bothWays = [&](Slip slip, double off_deg, double prior) {
        for (const double off : {-off_deg, off_deg})
            variants.push_back({slip, wrap360(figure_deg + off), prior / 2});
    };
    bothWays(Slip::FiveDegrees, 5.0, kFiveDegrees);
    bothWays(Slip::TenDegrees, 10.0, kTenDegrees);
    bothWays(Slip::HundredDegrees, 100.0, kHundredDegrees);
    return variants;
}

} // namespace lubberline
