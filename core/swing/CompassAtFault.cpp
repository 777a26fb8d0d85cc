#include "core/swing/CompassAtFault.h"

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
    if (!A_rad || fit.index_rad != 0.0 || std::abs(toDegrees(*A_rad)) < kOutOfPlace_deg)
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
