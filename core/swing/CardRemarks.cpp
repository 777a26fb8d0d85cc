#include "core/swing/CardRemarks.h"

#include <algorithm>
#include <cmath>

#include "core/angle/AngleText.h"
#include "core/base/Number.h"

namespace lubberline {

namespace {

constexpr double kRoundingOfLimits_deg = 1e-9; // as in judge()

std::string remarkHeading(double heading_deg) { return formatHeading(heading_deg, AngleStyle::DecimalDegrees, 0); }
std::string tenthsOfDegree(double angle_deg) { return figureText(angle_deg, 1) + "°"; }

std::string listed(const std::vector<double>& headings_deg)
{
    std::string list;
    for (const double heading_deg : headings_deg)
        list += (list.empty() ? "" : ", ") + remarkHeading(heading_deg);
    return list;
}

template <class Which>
std::vector<double> headingsOf(const Card& card, const Which& which)
{
    std::vector<double> headings_deg;
    for (const auto& row : card.rows)
        if (which(row))
            headings_deg.push_back(card.options.by == CardBy::Magnetic ? row.magnetic.degrees() : row.steer.degrees());
    return headings_deg;
}

void remarkLimits(std::vector<Message>& remarks, const Card& card, const std::optional<LimitsProfile>& limits)
{
    if (!limits)
        return;
    const std::string& source = limits->document.empty() ? limits->name : limits->document;
    if (const auto over = headingsOf(card, [&](const CardRow& row) { return overLimit(row, limits); }); !over.empty())
        remarks.push_back({card.options.by == CardBy::Magnetic ? MARKED("core", "OVER THE LIMIT of %1 (%2): the deviation on magnetic %3")
                                                               : MARKED("core", "OVER THE LIMIT of %1 (%2): the deviation on compass %3"),
            shortestNumber(*limits->maxDeviation_deg) + "°", source, listed(over)});
    const auto [least, most] = std::minmax_element(
        card.rows.begin(), card.rows.end(), [](const CardRow& a, const CardRow& b) { return a.residual.degrees() < b.residual.degrees(); });
    const double spread_deg = most->residual.degrees() - least->residual.degrees();
    if (limits->maxSpread_deg && spread_deg > *limits->maxSpread_deg + kRoundingOfLimits_deg)
        remarks.push_back({MARKED("core", "OVER THE LIMIT of %1 (%2): the spread of the deviation, %3"),
            shortestNumber(*limits->maxSpread_deg) + "°", source, tenthsOfDegree(spread_deg)});
    if (limits->maxDeviation_deg && std::abs(card.largestReading.deviation.degrees()) > *limits->maxDeviation_deg + kRoundingOfLimits_deg)
        remarks.push_back({MARKED("core", "OVER THE LIMIT of %1 (%2): the deviation that was read on magnetic %3, %4"),
            shortestNumber(*limits->maxDeviation_deg) + "°", source, remarkHeading(card.largestReading.at.degrees()),
            signedFigureText(card.largestReading.deviation.degrees(), 1) + "°"});
}

} // namespace

SwungAttitude attitudeOf(const Swing& swing)
{
    SwungAttitude attitude;
    bool stated = true;
    const auto take = [&](std::optional<SwungAttitude::Range>& range, std::optional<double> angle_deg) {
        stated = stated && angle_deg;
        if (!angle_deg)
            return;
        if (!range)
            range = SwungAttitude::Range{*angle_deg, *angle_deg};
        range->least_deg = std::min(range->least_deg, *angle_deg);
        range->most_deg = std::max(range->most_deg, *angle_deg);
        attitude.tilted = attitude.tilted || std::abs(*angle_deg) >= kLevel_deg;
    };
    for (const auto place : usedReadings(swing)) {
        take(attitude.pitch, swing.readings[place].pitch_deg);
        take(attitude.roll, swing.readings[place].roll_deg);
    }
    attitude.level = stated && !attitude.tilted;
    return attitude;
}

Message wordsOf(const SwungAttitude& attitude)
{
    if (!attitude.tilted)
        return {};
    const auto words = [](const std::optional<SwungAttitude::Range>& range) {
        if (!range)
            return std::string("—");
        const auto whole = [](double angle_deg) {
            return std::abs(angle_deg) < 0.05 ? std::string("0°") : signedFigureText(angle_deg, attitudeDecimals(angle_deg)) + "°";
        };
        const std::string least = whole(range->least_deg), most = whole(range->most_deg);
        return least == most ? least : least + " … " + most;
    };
    return {MARKED("core", "NOT LEVEL: swung at pitch %1, roll %2; these are not the figures of level flight"), words(attitude.pitch),
        words(attitude.roll)};
}

double bandInTenths_deg(double band_rad) { return std::max(0.1, toDegrees(band_rad)); }

int attitudeDecimals(double angle_deg) { return std::abs(angle_deg - std::round(angle_deg)) < 0.05 ? 0 : 1; }

bool overLimit(const CardRow& row, const std::optional<LimitsProfile>& limits)
{
    return limits && limits->maxDeviation_deg && std::abs(row.residual.degrees()) > *limits->maxDeviation_deg + kRoundingOfLimits_deg;
}

bool skippedNear(const CardRow& row, const Swing& swing)
{
    double read_deg = 360, skipped_deg = 360;
    for (const auto& reading : swing.readings) {
        const double here_deg = row.magnetic.degrees();
        if (reading.used())
            read_deg = std::min(read_deg, std::abs(wrap180(reading.magnetic->degrees() - here_deg)));
        else if (reading.nominal_deg)
            skipped_deg = std::min(skipped_deg, std::abs(wrap180(*reading.nominal_deg - here_deg)));
    }
    return skipped_deg < read_deg;
}

bool outOfLimits(const Card& card, const std::optional<LimitsProfile>& limits)
{
    std::vector<Message> remarks;
    remarkLimits(remarks, card, limits);
    return !remarks.empty();
}

std::vector<Message> remarksOn(const Card& card, const SwingRecord& record)
{
    std::vector<Message> remarks;
    remarkLimits(remarks, card, record.limits);
    if (card.index_deg != 0.0)
        remarks.push_back({MARKED("core",
                               "THE COMPASS IS %1°%2 OUT AS A WHOLE: its mount, its lubber line, or from which side it was read, is "
                               "to be looked at before anybody steers by it"),
            static_cast<int>(std::lround(std::abs(card.index_deg))), card.index_deg > 0 ? 'E' : 'W'});
    for (const auto& reading : record.swing.readings)
        if (reading.nominal_deg && !reading.complete())
            remarks.push_back({reading.note.empty() ? MARKED("core", "not read on %1") : MARKED("core", "not read on %1 (%2)"),
                remarkHeading(*reading.nominal_deg), reading.note});
    for (const auto& suspect : card.suspects)
        remarks.push_back({MARKED("core", "SUSPECT reading used: on %1, %2 off the curve of the others"),
            remarkHeading(suspect.at.degrees()), tenthsOfDegree(std::abs(suspect.deviation.degrees()))});
    for (const auto& gap : card.gaps)
        remarks.push_back(wordsOf(gap));
    if (const auto unread = headingsOf(card, [](const CardRow& row) { return row.unread; }); !unread.empty())
        remarks.push_back({MARKED("core", "nobody read near these rows: %1"), listed(unread)});
    const std::string off = tenthsOfDegree(toDegrees(card.betweenRows_rad)), at = remarkHeading(card.betweenRowsAt_deg);
    if (card.finerStep_deg != 0)
        remarks.push_back({MARKED("core", "interpolating between rows is off by up to %1 (at %2): a card every %3 leaves %4"), off, at,
            std::to_string(card.finerStep_deg) + "°", tenthsOfDegree(toDegrees(card.finerBetweenRows_rad))});
    else if (toDegrees(card.betweenRows_rad) > kBetweenRows_deg)
        remarks.push_back({MARKED("core", "interpolating between rows is off by up to %1 (at %2)"), off, at});
    if (card.options.source == CardSource::Readings && card.farthestReading_deg > card.options.step_deg / 2.0)
        remarks.push_back({MARKED("core", "the nearest reading to a row is up to %1 away"), figureText(card.farthestReading_deg, 0) + "°"});
    if (const auto tilted = wordsOf(attitudeOf(record.swing)); !tilted.empty())
        remarks.push_back(tilted);
    if (!card.widestBand_rad)
        remarks.push_back(MARKED("core", "how sure these figures are is not known: there are too few readings to tell"));
    return remarks;
}

} // namespace lubberline
