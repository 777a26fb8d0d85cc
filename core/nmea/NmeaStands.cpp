#include "core/nmea/NmeaStands.h"

#include <algorithm>
#include <cmath>

#include "core/angle/Angle.h"
#include "core/base/Middle.h"

namespace lubberline {

namespace {

/// Stands nearer to each other than this are on one heading.
constexpr double kOneHeading_deg = 15.0;
constexpr int kHeadingsOfASwing = 3;
/// Who comes round further than this without ever turning faster than a stand is in a slow turn.
constexpr double kStill_deg = 5.0;

/// Used pairs, one after the other, between which the aircraft did not turn.
struct Stand {
    std::vector<std::size_t> pairs;
    double heading_deg = 0;
    double length_s = 0;
    double furthest_deg = 0; ///< from its first heading
};

std::vector<Stand> standsOf(const std::vector<NmeaPair>& pairs, std::span<const double> rates)
{
    std::vector<Stand> stands;
    bool standing = false;
    std::size_t next = 0;
    for (std::size_t i = 0; i < pairs.size() && next < rates.size(); ++i) {
        if (!pairs[i].used)
            continue;
        const bool stood = standing;
        standing = std::abs(rates[next++]) < kSlowestTurn_deg_s;
        if (!standing)
            continue;
        if (!stood || pairs[i].seconds - pairs[stands.back().pairs.back()].seconds > kMostApart_s)
            stands.push_back({{}, pairs[i].magnetic.degrees(), 0.0});
        Stand& stand = stands.back();
        stand.pairs.push_back(i);
        stand.length_s = pairs[i].seconds - pairs[stand.pairs.front()].seconds;
        stand.furthest_deg = std::max(stand.furthest_deg, std::abs(wrap180(pairs[i].magnetic.degrees() - stand.heading_deg)));
    }
    // No more than a slow moment of the turn, or the whole of a slow one.
    std::erase_if(stands, [](const Stand& stand) { return stand.length_s < 1.0 || stand.furthest_deg > kStill_deg; });
    return stands;
}

double usualLength_s(const std::vector<Stand>& stands)
{
    std::vector<double> headings_deg, lengths_s;
    for (const Stand& stand : stands) {
        lengths_s.push_back(stand.length_s);
        const auto same = [&](double heading_deg) { return std::abs(wrap180(heading_deg - stand.heading_deg)) < kOneHeading_deg; };
        if (std::none_of(headings_deg.begin(), headings_deg.end(), same))
            headings_deg.push_back(stand.heading_deg);
    }
    return static_cast<int>(headings_deg.size()) < kHeadingsOfASwing ? kStand_s : std::max(kStand_s, middleOf(std::move(lengths_s)));
}

int leaveOutRepeats(std::vector<NmeaPair>& pairs, double spacing_s)
{
    constexpr double kTooSoon = 0.2;
    int repeats = 0;
    const NmeaPair* last = nullptr;
    for (NmeaPair& pair : pairs) {
        if (!pair.used)
            continue;
        const bool repeats_last
            = last && pair.seconds - last->seconds < kTooSoon * spacing_s && pair.compass.degrees() == last->compass.degrees();
        pair.used = !repeats_last;
        repeats += repeats_last ? 1 : 0;
        last = repeats_last ? last : &pair;
    }
    return repeats;
}

} // namespace

int leaveOutStands(std::vector<NmeaPair>& pairs, std::span<const double> rates, double spacing_s)
{
    const auto stands = standsOf(pairs, rates);
    int leftOut = leaveOutRepeats(pairs, spacing_s);
    if (stands.empty())
        return leftOut;
    const double length_s = usualLength_s(stands);
    for (const Stand& stand : stands)
        for (const std::size_t i : stand.pairs) {
            const bool early = pairs[stand.pairs.back()].seconds - pairs[i].seconds > length_s;
            leftOut += early && pairs[i].used ? 1 : 0;
            pairs[i].used = pairs[i].used && !early;
        }
    return leftOut;
}

double turnOfStep_deg(const HeadingLine& steps)
{
    constexpr double kHalf_steps = 5.0;
    double squares = 0.0, sum = 0.0;
    for (const auto& heading : steps.headings())
        if (const auto rate = steps.rateAt(heading.seconds, kHalf_steps)) {
            squares += *rate * *rate;
            sum += std::abs(*rate);
        }
    return sum > 0.0 ? squares / sum : 0.0;
}

} // namespace lubberline
