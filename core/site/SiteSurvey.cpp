#include "core/site/SiteSurvey.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/record/RecordWords.h"

namespace lubberline {

namespace {

constexpr double kMilitaryRange_deg = 12.0 / 60.0;

std::optional<Extent> extentOf(std::span<const SurveyPoint> points, std::optional<double> SurveyPoint::*what)
{
    Extent extent;
    double sum = 0.0, first = 0.0; // from the first value: declinations are alike, and sums of differences keep their digits
    for (const auto& point : points) {
        if (!(point.*what))
            continue;
        const double value = *(point.*what);
        if (extent.count == 0)
            extent.least = extent.most = first = value;
        extent.least = std::min(extent.least, value);
        extent.most = std::max(extent.most, value);
        sum += value - first;
        ++extent.count;
    }
    if (extent.count == 0)
        return {};
    extent.mean = first + sum / extent.count;
    return extent;
}

bool finite(const SurveyPoint& point)
{
    return std::isfinite(point.east_m) && std::isfinite(point.north_m) && std::isfinite(point.height_m)
        && std::isfinite(point.declination_deg.value_or(0.0)) && std::isfinite(point.total_nT.value_or(0.0));
}

SiteClass classOf(double off_deg)
{
    for (const auto& rule : classRules())           // the strictest first
        if (off_deg <= rule.permissible_deg + 1e-9) // 0.1° typed as 5.2 − 5.1 is 0.1°
            return rule.siteClass;
    return SiteClass::None;
}

} // namespace

std::span<const ClassRule> classRules()
{
    static const std::array rules{
        ClassRule{SiteClass::Class1, 0.1, "CAANZ AC 43-7, as quoted by the survey of Nelson Airport, 2019"},
        ClassRule{SiteClass::Class2, 0.25, "CAP 562, second-hand: not read at its source"},
    };
    return rules;
}

Result<SurveySummary> summarise(std::span<const SurveyPoint> points, double horizontal_nT)
{
    if (!std::all_of(points.begin(), points.end(), finite))
        return Error{ErrorCode::InvalidInput, MARKED("core", "a survey point is not a number; expected metres, degrees and nT")};
    SurveySummary summary;
    summary.declination_deg = extentOf(points, &SurveyPoint::declination_deg);
    summary.total_nT = extentOf(points, &SurveyPoint::total_nT);
    if (!summary.declination_deg && !summary.total_nT)
        return Error{
            ErrorCode::InvalidInput, MARKED("core", "no point of the survey has a declination or a total field; expected at least one")};
    if (summary.declination_deg) {
        const auto& declination = *summary.declination_deg;
        summary.largestOff_deg = std::max(declination.most - declination.mean, declination.mean - declination.least);
        summary.withinMilitaryRange = declination.range() <= kMilitaryRange_deg + 1e-9;
        summary.meets = classOf(summary.largestOff_deg);
    }
    if (summary.total_nT && horizontal_nT > 0.0) {
        const double part = summary.total_nT->range() / 2.0 / horizontal_nT;
        summary.equivalent_deg = part < 1.0 ? std::asin(part) * kDegreesPerRadian : 90.0;
        if (!summary.declination_deg)
            summary.meets = classOf(*summary.equivalent_deg);
    }
    return summary;
}

double paintedLineOffset_deg(Variation painted, Variation today) { return wrap180(painted.degrees() - today.degrees()); }

Message whyUnfit(const SiteFitness& site, Date date)
{
    if (!site.certificateExpiry.empty() && site.certificateExpiry < date)
        return Message{MARKED("core", "the base's certificate ended on %1"), site.certificateExpiry};
    const bool enough = site.wanted == SiteClass::None || site.siteClass == SiteClass::Class1 || site.siteClass == site.wanted;
    if (!enough)
        return Message{MARKED("core", "the base is of %1, and the procedure wants %2"), shownWord(site.siteClass), shownWord(site.wanted)};
    return {};
}

} // namespace lubberline
