#include "core/calibration/Coverage.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/angle/Angle.h"

namespace lubberline {

namespace {

constexpr int kBands = 10, kSectors = 20;         // 200 cells of equal area: bands of equal height
constexpr int kFineBands = 45, kFineSectors = 90; // what stands for the samples when the largest hole is looked for
constexpr int kCandidates = 1500;

double turnOf(const Eigen::Vector3d& u) { return std::atan2(u.y(), u.x()) / (2.0 * kPi) + 0.5; }

int cellOf(const Eigen::Vector3d& u, double turn, int bands, int sectors)
{
    const int band = std::clamp(static_cast<int>((u.z() + 1.0) / 2.0 * bands), 0, bands - 1);
    return band * sectors + std::clamp(static_cast<int>(turn * sectors), 0, sectors - 1);
}

/// Points that lie evenly on a sphere (Fibonacci's lattice).
Eigen::Vector3d evenPoint(int index, int count)
{
    const double z = 1.0 - (2.0 * index + 1.0) / count, r = std::sqrt(1.0 - z * z);
    const double turn = index * kPi * (3.0 - std::sqrt(5.0));
    return {r * std::cos(turn), r * std::sin(turn), z};
}

} // namespace

Message bodyDirection(const Eigen::Vector3d& direction)
{
    constexpr std::array<Pattern, 3> kPlus{
        MARKED("core", "the nose"), MARKED("core", "the starboard (right) side"), MARKED("core", "the belly")};
    constexpr std::array<Pattern, 3> kMinus{MARKED("core", "the tail"), MARKED("core", "the port (left) side"), MARKED("core", "the roof")};
    std::array<Eigen::Index, 3> order{0, 1, 2};
    std::sort(order.begin(), order.end(), [&](Eigen::Index a, Eigen::Index b) { return std::abs(direction[a]) > std::abs(direction[b]); });
    const auto word = [&](Eigen::Index axis) {
        return direction[axis] >= 0 ? kPlus[static_cast<std::size_t>(axis)] : kMinus[static_cast<std::size_t>(axis)];
    };
    if (std::abs(direction[order[1]]) < 0.4 * std::abs(direction[order[0]]))
        return {word(order[0])};
    if (std::abs(direction[order[2]]) < 0.4 * std::abs(direction[order[0]]))
        return {MARKED("core", "the edge between %1 and %2"), word(order[0]), word(order[1])};
    return {MARKED("core", "the corner between %1, %2 and %3"), word(order[0]), word(order[1]), word(order[2])};
}

Coverage coverageOf(std::span<const Eigen::Vector3d> directions)
{
    Coverage coverage;
    std::vector<std::uint8_t> coarse(kBands * kSectors, 0);
    std::vector<Eigen::Vector3d> fine(kFineBands * kFineSectors, Eigen::Vector3d::Zero());
    for (const auto& u : directions) {
        const double turn = turnOf(u);
        coarse[static_cast<std::size_t>(cellOf(u, turn, kBands, kSectors))] = 1;
        fine[static_cast<std::size_t>(cellOf(u, turn, kFineBands, kFineSectors))] = u;
    }
    coverage.share = static_cast<double>(std::count(coarse.begin(), coarse.end(), 1)) / static_cast<double>(coarse.size());
    const std::vector<Eigen::Vector3d> cells = fine;
    fine.erase(std::remove_if(fine.begin(), fine.end(), [](const auto& u) { return u.isZero(); }), fine.end());
    double least = 2.0;
    for (int i = 0; i < kCandidates; ++i) {
        const Eigen::Vector3d at = evenPoint(i, kCandidates);
        // In a hole that is no larger than one already found: mostly the sample of its own cell says so.
        const Eigen::Vector3d& own = cells[static_cast<std::size_t>(cellOf(at, turnOf(at), kFineBands, kFineSectors))];
        if (!own.isZero() && at.dot(own) >= least)
            continue;
        double nearest = -1.0;
        for (auto u = fine.begin(); u != fine.end() && nearest < least; ++u)
            nearest = std::max(nearest, at.dot(*u));
        if (nearest >= least)
            continue;
        least = nearest;
        coverage.gap = at;
    }
    coverage.largestGap_deg = toDegrees(std::acos(std::clamp(least, -1.0, 1.0)));
    coverage.turnTo = {MARKED("core", "point %1 along the Earth's field (towards north, and down in the northern hemisphere)"),
        bodyDirection(coverage.gap)};
    return coverage;
}

} // namespace lubberline
