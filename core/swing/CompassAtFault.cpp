#include "core/swing/CompassAtFault.h"

#include <cmath>
#include <vector>

#include "core/angle/Circle.h"

namespace lubberline {

namespace {

constexpr double kSpan_deg = 45.0; ///< within which a card may stand still or swing back for many reasons

/// The arc that holds all headings.
double spanOf_deg(const std::vector<double>& headings_deg) { return 360.0 - widestEmptyArc(headings_deg).width_deg(); }

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
    if (spanOf_deg(compass) <= 2.0) {
        const auto shown = static_cast<int>(std::lround(compass.front())) % 360;
        std::string digits = std::to_string(shown);
        digits.insert(0, 3 - digits.size(), '0');
        return Error{ErrorCode::InvalidInput,
            {MARKED("core",
                 "the compass reads %1 on all headings: it is stuck, or one figure was written down for all; no deviation can be told"),
                digits}};
    }
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

std::optional<Message> indexWords(double index_deg)
{
    if (index_deg == 0.0)
        return std::nullopt;
    const auto off = static_cast<int>(std::lround(std::abs(index_deg)));
    const char side = index_deg > 0 ? 'E' : 'W';
    if (off >= 165)
        return Message{
            MARKED("core",
                "the compass reads the reciprocal: %1°%2 was taken out as its index before B, C, D and E; look whether it was read "
                "from the other side or is mounted back to front"),
            off, side};
    return Message{
        MARKED("core",
            "the compass is %1°%2 out as a whole: this was taken out as its index before B, C, D and E; look at its mount and its "
            "lubber line"),
        off, side};
}

} // namespace lubberline
