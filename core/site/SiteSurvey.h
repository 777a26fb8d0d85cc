#pragma once
/// The survey of a compass base, what it says of the base, and the lines that are painted on it.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/angle/Heading.h"
#include "core/base/Date.h"
#include "core/base/Result.h"
#include "core/record/Site.h"

namespace lubberline {

struct ClassRule {
    SiteClass siteClass = SiteClass::None;
    double permissible_deg = 0; ///< largest |declination − mean| allowed
    std::string document;
};
/// Class 1: 0.1° (CAANZ AC 43-7 as quoted by the Nelson survey of 2019); class 2: 0.25° (CAP 562, second-hand: said so in the
/// document).
[[nodiscard]] std::span<const ClassRule> classRules();

struct Extent {
    double least = 0, most = 0, mean = 0;
    int count = 0;
    [[nodiscard]] double range() const { return most - least; }
};

struct SurveySummary {
    std::optional<Extent> declination_deg;
    std::optional<Extent> total_nT;
    double largestOff_deg = 0;            ///< largest |declination − mean|
    std::optional<double> equivalent_deg; ///< half of the range of F as an angle, asin(ΔF/2 ÷ H): where only F was measured
    SiteClass meets = SiteClass::None;    ///< the best class that the survey allows
    bool withinMilitaryRange = false;     ///< range of declination ≤ 12′ (MIL-STD-765A, per CNATRAINST 11130.1D)
};

/// @param horizontal_nT H at the base, for the equivalent angle of total-field surveys; ≤ 0: not known.
/// Errors: InvalidInput (no point with a measurement; not finite).
Result<SurveySummary> summarise(std::span<const SurveyPoint> points, double horizontal_nT);

/// Magnetic lines painted when the declination was `painted` point elsewhere today: a line marked ψ lies on the true bearing
/// ψ + painted, so its magnetic heading today is ψ + (painted − today). @return what to add to a line's figure [°].
[[nodiscard]] double paintedLineOffset_deg(Variation painted, Variation today);

/// May a swing be made here on that day? Empty: yes; else why not (an override needs a reason).
struct SiteFitness {
    Date certificateExpiry; ///< empty: none stated
    SiteClass siteClass = SiteClass::None;
    SiteClass wanted = SiteClass::None; ///< by the procedure
};
[[nodiscard]] Message whyUnfit(const SiteFitness& site, Date date);

} // namespace lubberline
