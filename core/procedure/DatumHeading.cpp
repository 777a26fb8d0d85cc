#include "core/procedure/DatumHeading.h"

#include <algorithm>
#include <cmath>

#include "core/base/Number.h"

namespace lubberline {

namespace {

/// Three readings of one thing that differ by more are not three readings of one thing.
constexpr double kMostApart_deg = 10.0;

double spreadOf(const std::vector<double>& headings_deg, double mean_deg)
{
    double least = 0.0, most = 0.0;
    for (const double heading : headings_deg) {
        const double off = wrap180(heading - mean_deg);
        least = std::min(least, off);
        most = std::max(most, off);
    }
    return most - least;
}

/// Of the mean: half a division either way, evenly likely, and the scatter of what was read.
double uncertaintyOf(const std::vector<double>& headings_deg, double mean_deg, double resolution_deg)
{
    const double division = resolution_deg / std::sqrt(12.0);
    const auto count = static_cast<double>(headings_deg.size());
    if (headings_deg.size() < 2)
        return division;
    double squares = 0.0;
    for (const double heading : headings_deg)
        squares += std::pow(wrap180(heading - mean_deg), 2);
    return std::hypot(division, std::sqrt(squares / (count - 1.0) / count));
}

/// `whose`: figures that lie apart (%1).
Error apart(Pattern whose, const std::vector<double>& figures_deg)
{
    std::string list;
    for (const double figure : figures_deg)
        list += (list.empty() ? "" : ", ") + shortestNumber(figure);
    return {ErrorCode::InvalidInput, {whose, list}};
}

struct Side {
    double mean_deg = 0, spread_deg = 0, uncertainty_deg = 0;
};

Result<Side> sideOf(Pattern apartWords, const std::vector<double>& figures_deg, double resolution_deg)
{
    const double mean = meanHeading_deg(figures_deg), spread = spreadOf(figures_deg, mean);
    if (spread > kMostApart_deg)
        return apart(apartWords, figures_deg);
    return Side{mean, spread, uncertaintyOf(figures_deg, mean, resolution_deg)};
}

} // namespace

double meanHeading_deg(const std::vector<double>& headings_deg)
{
    LUBBERLINE_EXPECT(!headings_deg.empty(), "a mean needs a heading");
    double off = 0.0; // from the first: exact for equal headings, and right across north
    for (const double heading : headings_deg)
        off += wrap180(heading - headings_deg.front());
    return wrap360(headings_deg.front() + off / static_cast<double>(headings_deg.size()));
}

bool sendsHeadings(DatumKind kind)
{
    return kind == DatumKind::DigitalCompass || kind == DatumKind::TransferGyro || kind == DatumKind::Inertial;
}

Result<DatumHeading> datumHeading(const DatumInstrument& instrument, const RawFigures& raw, std::optional<Variation> variation)
{
    if (raw.datum_deg.empty() && raw.astern_deg.empty())
        return Error{ErrorCode::InvalidInput, MARKED("core", "no figure of the datum instrument; expected one to three")};
    if (instrument.givesTrue && !variation)
        return Error{ErrorCode::InvalidInput,
            {MARKED("core", "%1 gives true headings, and the variation is not stated; expected it (degrees, east positive)"),
                instrument.name}};
    const double turnAhead = instrument.ahead == SightingDirection::Reciprocal ? 180.0 : 0.0;
    std::vector<double> headings; // of the aircraft's axis, one a side
    DatumHeading heading;
    double variance = 0.0;
    const auto takeSide = [&](Pattern apartWords, const std::vector<double>& figures, double turn) -> Result<void> {
        if (figures.empty())
            return {};
        const auto side = sideOf(apartWords, figures, instrument.resolution_deg);
        if (!side)
            return side.error();
        headings.push_back(side->mean_deg + turn);
        heading.spread_deg = std::max(heading.spread_deg, side->spread_deg);
        variance += side->uncertainty_deg * side->uncertainty_deg;
        return {};
    };
    if (const auto taken = takeSide(
            MARKED("core", "the datum's figures %1 lie more than 10° apart; expected readings of one heading"), raw.datum_deg, turnAhead);
        !taken)
        return taken.error();
    if (const auto taken = takeSide(MARKED("core", "the figures from astern %1 lie more than 10° apart; expected readings of one heading"),
            raw.astern_deg, turnAhead + 180.0);
        !taken)
        return taken.error();
    if (headings.size() == 2) {
        const double differ = wrap180(headings[0] - headings[1]);
        if (std::abs(differ) > kMostApart_deg)
            return Error{ErrorCode::InvalidInput,
                {MARKED("core",
                     "ahead and astern differ by %1° after turning; one of them was read the other way round, or is not of this heading"),
                    shortestNumber(std::round(std::abs(differ) * 10) / 10)}};
        heading.collimation_deg = differ / 2.0;
    }
    const double axis = wrap360(meanHeading_deg(headings) + instrument.zero_deg);
    heading.magnetic = instrument.givesTrue ? toMagnetic(TrueHeading::fromDegrees(axis), *variation) : MagneticHeading::fromDegrees(axis);
    heading.uncertainty_deg = std::sqrt(variance) / static_cast<double>(headings.size());
    return heading;
}

Result<CompassFigure> compassFigure(const RawFigures& raw, double resolution_deg)
{
    if (raw.compass_deg.empty())
        return Error{ErrorCode::InvalidInput, MARKED("core", "no figure of the compass; expected one to three")};
    const auto side = sideOf(MARKED("core", "the compass's figures %1 lie more than 10° apart; expected readings of one heading"),
        raw.compass_deg, resolution_deg);
    if (!side)
        return side.error();
    return CompassFigure{CompassHeading::fromDegrees(side->mean_deg), side->spread_deg, side->uncertainty_deg};
}

bool calibrationOver(const DatumInstrument& instrument, Date date)
{
    return !instrument.calibrationDue.empty() && instrument.calibrationDue < date;
}

} // namespace lubberline
