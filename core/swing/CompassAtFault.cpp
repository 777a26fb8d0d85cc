#include "core/swing/CompassAtFault.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/angle/Circle.h"
#include "core/base/Number.h"

namespace lubberline {

namespace {

constexpr double kSpan_deg = 45.0; ///< within which a card may stand still or swing back for many reasons
/// A card that keeps within so much while the aircraft turns by half a turn or more is held: iron of twice the Earth's field leaves it more.
constexpr double kHeld_deg = 45.0, kTurned_deg = 180.0;

/// The arc that holds all headings.
double spanOf_deg(const std::vector<double>& headings_deg) { return 360.0 - widestEmptyArc(headings_deg).width_deg(); }

std::string threeDigits(double heading_deg)
{
    const std::string digits = std::to_string(static_cast<int>(std::lround(heading_deg)) % 360);
    return std::string(3 - digits.size(), '0') + digits;
}

Error heldWithin(const std::vector<double>& compass, double turned_deg)
{
    const EmptyArc empty = widestEmptyArc(compass);
    return {ErrorCode::InvalidInput,
        {MARKED("core",
             "the compass keeps between %1 and %2 while the aircraft turns through %3°: it sticks, or a field stronger than the Earth's holds "
             "it; no deviation can be told"),
            threeDigits(empty.to_deg), threeDigits(empty.from_deg), static_cast<int>(std::lround(turned_deg))}};
}

/// From here on B and C of the compass as it stands are a quarter of each other's away from those of the compass turned right.
constexpr double kOutOfPlace_deg = 15.0;
/// As much as no compass deviates by, and a scatter that is none of a reading.
constexpr double kNoOneCycle_deg = 90.0, kNoTwoCycles_deg = 60.0, kNoScatter_deg = 30.0, kTellsWithin_deg = 10.0;

/// Of headings that step evenly round the circle in the order in which they are listed: the step, either way round. None of others.
std::optional<double> stepOf_deg(std::span<const Observation> readings)
{
    constexpr std::size_t kFewest = 6;
    if (readings.size() < kFewest)
        return std::nullopt;
    const auto stepAfter
        = [&](std::size_t i) { return wrap180(readings[(i + 1) % readings.size()].magnetic.degrees() - readings[i].magnetic.degrees()); };
    const double step_deg = std::copysign(360.0 / static_cast<double>(readings.size()), stepAfter(0));
    for (std::size_t i = 0; i < readings.size(); ++i)
        if (std::abs(stepAfter(i) - step_deg) > 0.3 * std::abs(step_deg))
            return std::nullopt;
    return step_deg;
}

/// Readings that stand beside the next heading, or the one before, make A of one step of the headings, and leave all else nearly as it was.
std::optional<Message> rowWords(std::span<const Observation> readings, double A_deg)
{
    constexpr double kUsualA_deg = 8.0;
    const auto step_deg = stepOf_deg(readings);
    if (!step_deg || std::abs(std::abs(A_deg) - std::abs(*step_deg)) > std::min(kUsualA_deg, 0.3 * std::abs(*step_deg)))
        return std::nullopt;
    const bool down = (A_deg < 0.0) == (*step_deg > 0.0); // each was read on the heading below it
    const std::size_t by = down ? readings.size() - 1 : 1;
    std::vector<Observation> moved;
    for (std::size_t i = 0; i < readings.size(); ++i)
        moved.push_back({readings[i].magnetic, readings[(i + by) % readings.size()].compass});
    const auto right = fitApproximate(moved, {.uncertainty = false});
    if (!right || !right->of(Coefficient::A) || std::abs(toDegrees(*right->of(Coefficient::A))) > kUsualA_deg)
        return std::nullopt;
    const auto figure = [&](Coefficient which) { return signedFigureText(toDegrees(right->of(which).value_or(0.0)), 1); };
    return Message{down ? MARKED("core",
                       "A is %1°, near one step of the headings (%2°): the readings may stand one row off. Moved down by one row they "
                       "make A %3°, B %4° and C %5°: look at the list before anybody touches the mount")
                        : MARKED("core",
                            "A is %1°, near one step of the headings (%2°): the readings may stand one row off. Moved up by one row they "
                            "make A %3°, B %4° and C %5°: look at the list before anybody touches the mount"),
        signedFigureText(A_deg, 1), figureText(std::abs(*step_deg), 0), figure(Coefficient::A), figure(Coefficient::B),
        figure(Coefficient::C)};
}

} // namespace

std::optional<Error> faultOf(std::span<const Observation> readings)
{
    if (readings.size() < 3)
        return std::nullopt;
    std::vector<double> magnetic, compass;
    for (const auto& reading : readings) {
        magnetic.push_back(reading.magnetic.degrees());
        compass.push_back(reading.compass.degrees());
    }
    if (spanOf_deg(magnetic) < kSpan_deg)
        return std::nullopt;
    if (spanOf_deg(compass) <= 2.0)
        return Error{ErrorCode::InvalidInput,
            {MARKED("core",
                 "the compass reads %1 on all headings: it is stuck, or one figure was written down for all; no deviation can be told"),
                threeDigits(compass.front())}};
    if (const double turned_deg = spanOf_deg(magnetic); turned_deg >= kTurned_deg && spanOf_deg(compass) <= kHeld_deg)
        return heldWithin(compass, turned_deg);
    std::vector<double> differences, sums;
    for (const auto& reading : readings) {
        differences.push_back(reading.magnetic.degrees() - reading.compass.degrees());
        sums.push_back(reading.magnetic.degrees() + reading.compass.degrees());
    }
    const double forwards = circularMean(differences).togetherness, backwards = circularMean(sums).togetherness;
    // Headings on one line (0 and 180) look alike both ways; only a clear case is named.
    if (backwards > 0.9 && 1.0 - backwards < 0.25 * (1.0 - forwards))
        return Error{ErrorCode::InvalidInput,
            MARKED("core",
                "the compass runs backwards: it reads less as the aircraft turns right (a mirrored card, or headings and readings of "
                "opposite senses); no deviation can be told")};
    return std::nullopt;
}

std::optional<Fold> foldOf(std::span<const Observation> readings)
{
    constexpr std::size_t kFewest = 4, kMost = 100;
    constexpr double kFalls_deg = 3.0, kNeighbours_deg = 60.0;
    constexpr double kMisread_deg = 45.0; // a reciprocal falls on both sides of it, and by more
    if (readings.size() < kFewest || readings.size() > kMost)
        return std::nullopt;
    std::vector<Observation> around(readings.begin(), readings.end());
    std::stable_sort(
        around.begin(), around.end(), [](const auto& a, const auto& b) { return a.magnetic.degrees() < b.magnetic.degrees(); });
    const std::size_t n = around.size();
    std::optional<Fold> widest;
    double most_deg = kFalls_deg;
    for (std::size_t first = 0; first < n; ++first) {
        double fallen_deg = 0;
        for (std::size_t steps = 1; steps < n; ++steps) {
            const Observation &here = around[(first + steps - 1) % n], &next = around[(first + steps) % n];
            const double rise_deg = wrap180(next.compass.degrees() - here.compass.degrees());
            const double turned_deg = wrap360(next.magnetic.degrees() - here.magnetic.degrees());
            if (rise_deg >= 0.0 || rise_deg < -kMisread_deg || turned_deg < 1e-6 || turned_deg > kNeighbours_deg)
                break;
            fallen_deg -= rise_deg;
            if (steps >= 2 && fallen_deg >= most_deg) {
                most_deg = fallen_deg;
                widest = Fold{around[first].magnetic, next.magnetic, around[first].compass, next.compass};
            }
        }
    }
    return widest;
}

Message foldWords(const Fold& fold)
{
    return {
        MARKED("core",
            "the compass falls while the aircraft turns right: it reads %1 on %2 and %3 on %4, so that one reading stands for more than "
            "one heading; there is no card of it, and no slip is looked for"),
        threeDigits(fold.reads.degrees()), threeDigits(fold.from.degrees()), threeDigits(fold.readsThen.degrees()),
        threeDigits(fold.to.degrees())};
}

std::optional<Error> faultOf(const ApproximateFit& approximate, const ExactFit& exact)
{
    const bool told = exact.fitted() && exact.degreesOfFreedom > 0 && toDegrees(exact.rms_rad) <= kTellsWithin_deg;
    if (told || !approximate.fitted())
        return std::nullopt;
    Coefficient largest = Coefficient::B;
    double worst = 0; // as a part of what no compass deviates by
    for (const Coefficient one : {Coefficient::B, Coefficient::C, Coefficient::D, Coefficient::E}) {
        const double most_deg = one == Coefficient::B || one == Coefficient::C ? kNoOneCycle_deg : kNoTwoCycles_deg;
        if (const double part = std::abs(toDegrees(approximate.of(one).value_or(0.0))) / most_deg; part > worst) {
            worst = part;
            largest = one;
        }
    }
    if (worst <= 1.0 && toDegrees(approximate.rms_rad) <= kNoScatter_deg)
        return std::nullopt;
    return Error{ErrorCode::InvalidInput,
        {MARKED("core",
             "the compass does not follow the headings: the coefficients that come nearest have %1 %2° and leave a scatter of %3°; no "
             "deviation can be told; expected the readings of one compass beside the headings on which they were made"),
            letterOf(largest), signedFigureText(toDegrees(approximate.of(largest).value_or(0.0)), 0),
            figureText(toDegrees(approximate.rms_rad), 0)}};
}

std::vector<std::size_t> astrayReadings(
    std::span<const Observation> readings, double resolution_deg, const std::optional<ExpectedCurve>& history)
{
    constexpr std::size_t kMost = 100;                            // among more, one reading does not hide that the others follow
    constexpr std::size_t kFewestOfTheRest = 5, kFewestOnOne = 6; // more astray is a list at fault
    if (readings.size() <= kFewestOfTheRest || readings.size() > kMost)
        return {};
    const auto search = findSlips(readings, resolution_deg, history);
    std::vector<std::size_t> astray;
    for (const auto& slip : search.slips)
        if (slip.probability >= 0.9 && slip.orReadings.empty())
            astray.push_back(slip.reading);
    std::sort(astray.begin(), astray.end());
    if (astray.empty() || kFewestOnOne * astray.size() > readings.size())
        return {};
    std::vector<Observation> rest;
    for (std::size_t i = 0; i < readings.size(); ++i)
        if (!std::binary_search(astray.begin(), astray.end(), i))
            rest.push_back(readings[i]);
    const auto approximate = fitApproximate(rest);
    const auto exact = fitExact(rest);
    if (!approximate || !exact || faultOf(*approximate, *exact))
        return {};
    return astray;
}

std::optional<Message> indexWords(double index_deg)
{
    if (index_deg == 0.0)
        return std::nullopt;
    const auto off = static_cast<int>(std::lround(std::abs(index_deg)));
    const char side = index_deg > 0 ? 'E' : 'W';
    if (off >= 165)
        return Message{
            MARKED("core",
                "the compass reads the reciprocal: %1°%2 was taken out as its index before B, C, D and E; look whether it was read from the other side or is mounted back to front"),
            off, side};
    return Message{
        MARKED("core",
            "the compass is %1°%2 out as a whole: this was taken out as its index before B, C, D and E; look at its mount and its lubber line"),
        off, side};
}

std::optional<Message> indexMeaning(double index_deg)
{
    if (index_deg == 0.0)
        return std::nullopt;
    return Message{
        MARKED("core",
            "B, C, D and E are those of the compass turned right in its mount: their heading ψ' is what it reads %1 %2° (the index); A of the approximate coefficients has the index in it, A of the exact ones has not"),
        std::string(index_deg > 0 ? "+" : "−"), figureText(std::abs(index_deg), 0)};
}

std::optional<Message> mountWords(std::span<const Observation> readings, const ApproximateFit& fit)
{
    const auto A_rad = fit.of(Coefficient::A);
    if (!A_rad)
        return std::nullopt;
    if (auto row = rowWords(readings, wrap180(toDegrees(*A_rad))))
        return row;
    if (fit.index_rad != 0.0 || std::abs(toDegrees(*A_rad)) < kOutOfPlace_deg)
        return std::nullopt;
    std::vector<Observation> turned;
    for (const auto& reading : readings)
        turned.push_back({reading.magnetic, CompassHeading::fromRadians(reading.compass.radians() + *A_rad)});
    const auto right = fitApproximate(turned, {.uncertainty = false});
    if (!right || !right->of(Coefficient::B) || !right->of(Coefficient::C))
        return std::nullopt;
    return Message{
        MARKED("core",
            "A is %1°: B, C, D and E hold for the headings that the compass reads as it stands now. Turn it right in its mount before B and C are corrected, and swing again: B will be about %2° and C %3°"),
        signedFigureText(toDegrees(*A_rad), 1), signedFigureText(toDegrees(*right->of(Coefficient::B)), 1),
        signedFigureText(toDegrees(*right->of(Coefficient::C)), 1)};
}

} // namespace lubberline
