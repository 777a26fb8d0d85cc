#include "core/deviation/ExchangedRows.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/deviation/SmithFit.h"

namespace lubberline {

namespace {

constexpr std::size_t kFewestOthers = 6, kMostReadings = 100; // a log is no list that somebody wrote
constexpr double kLeastScatter_deg = 0.6;                     // few others may happen to lie on their curve
constexpr double kFits = 3.5, kDoesNotFit = 5.0;              // standard deviations
/// One exchange explains both readings; two slips that happen to look like it need the same luck twice.
constexpr double kExchanged = 0.95;

bool fitsExchanged(std::span<const Observation> readings, std::size_t one, std::size_t other)
{
    std::vector<Observation> others;
    for (std::size_t i = 0; i < readings.size(); ++i)
        if (i != one && i != other)
            others.push_back(readings[i]);
    if (others.size() < kFewestOthers)
        return false;
    const auto fit = fitExact(others);
    if (!fit || !fit->fitted() || !fit->sigma_rad)
        return false;
    const double scatter_deg = std::max(kLeastScatter_deg, toDegrees(*fit->sigma_rad));
    const auto off = [&](std::size_t magnetic, std::size_t compass) {
        const double read_deg = deviationOf(readings[magnetic].magnetic, readings[compass].compass).degrees();
        return std::abs(wrap180(read_deg - deviationAt(*fit, readings[magnetic].magnetic).degrees())) / scatter_deg;
    };
    return off(one, other) < kFits && off(other, one) < kFits && off(one, one) > kDoesNotFit && off(other, other) > kDoesNotFit;
}

void putFirst(SlippedReading& slip, double fits_deg)
{
    for (SlipCandidate& candidate : slip.candidates)
        candidate.probability *= 1.0 - kExchanged;
    std::erase_if(slip.candidates, [](const SlipCandidate& candidate) { return candidate.probability < 0.01; });
    slip.candidates.insert(slip.candidates.begin(), {Slip::WrongRow, SlippedFigure::Compass, fits_deg, kExchanged * slip.probability});
}

} // namespace

void nameExchangedRows(SlipSearch& search, std::span<const Observation> readings)
{
    if (readings.size() > kMostReadings)
        return;
    std::vector<std::pair<std::size_t, std::size_t>> exchanged; // places in search.slips
    for (std::size_t a = 0; a < search.slips.size(); ++a)
        for (std::size_t b = a + 1; b < search.slips.size(); ++b)
            if (search.slips[a].orReadings.empty() && search.slips[b].orReadings.empty()
                && fitsExchanged(readings, search.slips[a].reading, search.slips[b].reading))
                exchanged.emplace_back(a, b);
    if (exchanged.size() != 1)
        return;
    SlippedReading &one = search.slips[exchanged.front().first], &other = search.slips[exchanged.front().second];
    one.probability = other.probability = std::max(one.probability, other.probability); // one event, seen in both
    putFirst(one, readings[other.reading].magnetic.degrees());
    putFirst(other, readings[one.reading].magnetic.degrees());
}

} // namespace lubberline
