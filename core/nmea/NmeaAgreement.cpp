#include "core/nmea/NmeaAgreement.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/Number.h"
#include "core/nmea/NmeaSources.h"

namespace lubberline {

namespace {

constexpr std::size_t kSectors = 8, kFewestBeside = 10; ///< headings are compared by sectors, each of so many moments at least
constexpr double kApartSameKind_deg = 1.0, kApartOtherKind_deg = 1.5;
/// Two instruments of their own scatter against each other by more than this times their rounding, and by a little at least.
constexpr double kOfRounding = 1.25, kLeastScatter_deg = 0.03;

struct Sector {
    double sum = 0, squares = 0;
    std::size_t count = 0;
    void add(double apart_deg) { sum += apart_deg, squares += apart_deg * apart_deg, ++count; }
    [[nodiscard]] double mean() const { return sum / static_cast<double>(count); }
    [[nodiscard]] double standardError() const
    {
        const double n = static_cast<double>(count);
        return std::sqrt(std::max(0.0, squares / n - mean() * mean()) / n);
    }
};

/// What two sources differ by, in all and by the heading. Differences are taken about the first of them, so that instruments half a circle
/// apart have a mean, too.
struct Apart {
    Sector all;
    std::array<Sector, kSectors> sectors;
    std::optional<double> first;
    void add(double turned_deg, double heading_deg);
};

std::size_t sectorOf(double heading_deg)
{
    return static_cast<std::size_t>(wrap360(heading_deg) / 360.0 * static_cast<double>(kSectors)) % kSectors;
}

void Apart::add(double turned_deg, double heading_deg)
{
    first = first.value_or(turned_deg);
    const double difference = *first + wrap180(turned_deg - *first);
    all.add(difference);
    sectors[sectorOf(heading_deg)].add(difference);
}

bool tells(const TimedHeading& heading, NmeaNorth north, double leastSpeed_kt, double mostSpeed_kt)
{
    if (!heading.heading_deg)
        return false;
    return north != NmeaNorth::Track || (heading.speed_kt && *heading.speed_kt >= leastSpeed_kt && *heading.speed_kt < mostSpeed_kt);
}

/// How far the other lies from the reference, at each moment at which both tell.
Apart apartOf(const NmeaStream& reference, const NmeaStream& other, const NmeaTimes& times, double leastSpeed_kt)
{
    const double most_kt = reference.north == other.north ? HUGE_VAL : kFlies_kt;
    const HeadingLine line(inTime(reference, times));
    Apart apart;
    for (const auto& heading : inTime(other, times)) {
        const auto beside = line.at(heading.seconds);
        if (!beside || !tells(heading, other.north, leastSpeed_kt, most_kt) || !tells(*beside, reference.north, leastSpeed_kt, most_kt))
            continue;
        apart.add(wrap180(*heading.heading_deg - *beside->heading_deg), *beside->heading_deg);
    }
    return apart;
}

/// The amplitude of the one-cycle part of what two differ by over the headings, from the means of the sectors; 0 where its scatter
/// explains it, or sectors are missing.
double oneCycle_deg(const Apart& apart)
{
    double sine = 0.0, cosine = 0.0, variance = 0.0;
    for (std::size_t i = 0; i < kSectors; ++i) {
        const Sector& sector = apart.sectors[i];
        if (sector.count < kFewestBeside)
            return 0.0;
        const double middle = 2.0 * kPi * (static_cast<double>(i) + 0.5) / static_cast<double>(kSectors);
        constexpr double kOfMean = 0.974; // sin(22.5°)/22.5°: how much of a cycle's amplitude the mean of an eighth of it keeps
        const double weight = 2.0 / static_cast<double>(kSectors) / kOfMean;
        sine += weight * std::sin(middle) * sector.mean();
        cosine += weight * std::cos(middle) * sector.mean();
        variance += weight * weight / 2.0 * sector.standardError() * sector.standardError();
    }
    constexpr double kSure = 6.0; // neighbours are alike, so a standard error of independent ones is too small
    const double amplitude = std::hypot(sine, cosine);
    return amplitude > kSure * std::sqrt(variance) ? amplitude : 0.0;
}

/// The middle of some angles about the first of them, which they may lie around on both sides of ±180°.
double medianAngle_deg(std::vector<double> angles_deg)
{
    const double first = angles_deg.front();
    for (double& angle : angles_deg)
        angle = first + wrap180(angle - first);
    const auto middle = angles_deg.begin() + static_cast<std::ptrdiff_t>(angles_deg.size() / 2);
    std::nth_element(angles_deg.begin(), middle, angles_deg.end());
    return *middle;
}

/// Step of the figures that a stream is written to [deg]: 1, 0.1, or finer.
double stepOf_deg(const NmeaStream& stream)
{
    for (const double step : {1.0, 0.1})
        if (std::ranges::all_of(stream.sent, [step](const NmeaSent& sent) {
                const double steps = sent.angle_deg.value_or(0.0) / step;
                return std::abs(steps - std::round(steps)) < 1e-6;
            }))
            return step;
    return 0.01;
}

} // namespace

std::vector<NmeaContradiction> contradictionsOf(
    const NmeaLog& log, const NmeaStream& reference, const NmeaStream& compass, const NmeaTimes& times, double leastSpeed_kt)
{
    std::vector<NmeaContradiction> found;
    for (const auto& other : log.streams()) {
        // A second compass has a deviation of its own, and what may be made of the compass contradicts nothing.
        if (&other == &reference || other.north == NmeaNorth::Compass || doubtOfReference(other.source, other.north, compass.source))
            continue;
        const Apart apart = apartOf(reference, other, times, std::max(leastSpeed_kt, 1.0));
        if (apart.all.count < kFewestBeside)
            continue;
        const double mean = apart.all.mean();
        if (other.north == reference.north) {
            if (std::abs(wrap180(mean)) - 3.0 * apart.all.standardError() >= kApartSameKind_deg)
                found.push_back({{MARKED("core",
                                      "%1 stands beside %2 and tells %3° more on average (east +): one of the two is wrong, and the log "
                                      "does not say which; %2 is taken, and A is no surer than that"),
                                     nameOf(other.source), nameOf(reference.source), signedFigureText(wrap180(mean), 1)},
                    std::abs(wrap180(mean)) / std::sqrt(2.0)});
            continue;
        }
        const double largest = oneCycle_deg(apart);
        if (largest >= kApartOtherKind_deg)
            found.push_back({{MARKED("core",
                                  "%1 and %2 disagree by ±%3° over the headings: on wheels a track is the heading, so one of the two is "
                                  "wrong, or a heading that is made of the compass"),
                                 nameOf(other.source), nameOf(reference.source), figureText(largest, 1)},
                0.0});
    }
    return found;
}

std::optional<Message> doubtOfRepetition(const NmeaStream& reference, const NmeaStream& compass, const std::vector<NmeaPair>& pairs)
{
    Apart apart;
    for (const auto& pair : pairs) {
        if (!pair.used)
            continue;
        apart.add(wrap180(pair.magnetic.degrees() - pair.compass.degrees()), pair.compass.degrees());
    }
    const auto seen = std::ranges::count_if(apart.sectors, [](const Sector& sector) { return sector.count >= 3; });
    if (seen < 6)
        return {};
    const double rounding = std::hypot(stepOf_deg(reference), stepOf_deg(compass)) / std::sqrt(12.0);
    const double scatter = apart.all.standardError() * std::sqrt(static_cast<double>(apart.all.count));
    if (scatter > kOfRounding * rounding + kLeastScatter_deg)
        return {};
    return Message{MARKED("core",
                       "%1 differs from the compass by %2° at all headings, within %3°: no second instrument agrees so well. If it is made "
                       "of this compass (by a multiplexer, a plotter, an autopilot), it shows no deviation, and no card may be made of it"),
        nameOf(reference.source), signedFigureText(wrap180(apart.all.mean()), 1), figureText(scatter, 2)};
}

NmeaJumps takeOutJumps(std::vector<TimedHeading>& tracks, const std::vector<TimedHeading>& compass)
{
    constexpr std::size_t kBeside = 7;                         // neighbours on either side
    constexpr double kJump_deg = 15.0, kBackwards_deg = 120.0; // no deviation changes by so much in a few seconds, or is so large
    constexpr double kMostPart = 1.0 / 3.0;
    const HeadingLine line(compass);
    std::vector<std::size_t> places;
    std::vector<double> apart_deg;
    for (std::size_t i = 0; i < tracks.size(); ++i)
        if (const auto beside = tracks[i].heading_deg ? line.at(tracks[i].seconds) : std::nullopt; beside && beside->heading_deg) {
            places.push_back(i);
            apart_deg.push_back(wrap180(*tracks[i].heading_deg - *beside->heading_deg));
        }
    if (places.size() < 2 * kBeside + 1)
        return {};
    const double usual_deg = medianAngle_deg(apart_deg);
    std::vector<std::size_t> away, backwards;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const std::size_t first = std::min(i - std::min(i, kBeside), places.size() - 2 * kBeside - 1);
        const auto begin = apart_deg.begin() + static_cast<std::ptrdiff_t>(first);
        const double near_deg = medianAngle_deg({begin, begin + 2 * kBeside + 1});
        if (std::abs(wrap180(apart_deg[i] - near_deg)) > kJump_deg)
            away.push_back(places[i]);
        else if (std::abs(wrap180(apart_deg[i] - usual_deg)) > kBackwards_deg)
            backwards.push_back(places[i]);
    }
    if (static_cast<double>(away.size() + backwards.size()) > kMostPart * static_cast<double>(places.size()))
        return {};
    for (const auto* those : {&away, &backwards})
        for (const std::size_t place : *those)
            tracks[place].heading_deg.reset();
    return {away.size(), backwards.size()};
}

} // namespace lubberline
