#pragma once
/// Compass bases, and the limits that a swing is held against.

#include <optional>
#include <string>
#include <vector>

#include "core/base/Date.h"
#include "core/record/Id.h"

namespace lubberline {

/// A point of the grid. What was not measured is not there.
struct SurveyPoint {
    double east_m = 0, north_m = 0;        ///< from the centre of the base, true north up
    double height_m = 0;                   ///< of the sensor above ground
    std::optional<double> declination_deg; ///< east positive, reduced to the survey's epoch
    std::optional<double> total_nT;
    friend bool operator==(const SurveyPoint&, const SurveyPoint&) = default;
};

/// Classes by what a compass base may turn a needle; data with their source (docs/bibliography.md).
enum class SiteClass { None, Class1, Class2 };

/// A compass base (rose, pad) where aircraft are swung.
struct Site {
    SiteId id;
    RecordId record = {};
    std::string name;                    ///< unique
    std::optional<double> latitude_deg;  ///< north positive
    std::optional<double> longitude_deg; ///< east positive
    std::optional<double> elevation_m;
    std::optional<double> variation_deg; ///< true − magnetic, east positive
    std::string variationSource;         ///< model or certificate, with its epoch
    std::string note;
    std::string owner = {};
    SiteClass siteClass = SiteClass::None;           ///< as certified
    std::string certificate = {};                    ///< its number or document
    Date certificateExpiry = {};                     ///< empty: none stated
    std::optional<double> paintedVariation_deg = {}; ///< the variation that the painted lines were laid out with; east positive
    Date paintedDate = {};                           ///< of that
    Date surveyDate = {};
    std::string surveyor = {}, surveyInstrument = {};
    std::vector<SurveyPoint> survey = {}; ///< in the order of the sheet; may be empty
    friend bool operator==(const Site&, const Site&) = default;
};

/// Limits are data with a named source, never constants in code.
struct LimitsProfile {
    LimitsProfileId id;
    RecordId record = {};
    std::string name;     ///< unique
    std::string document; ///< "14 CFR 25.1327"
    std::string issue;
    std::string scope;                      ///< what it applies to, in words
    std::optional<double> maxDeviation_deg; ///< the largest |deviation| allowed after compensation [deg]
    std::optional<double> maxSpread_deg;    ///< the largest maximum − minimum deviation allowed [deg]
    friend bool operator==(const LimitsProfile&, const LimitsProfile&) = default;
};

/// The profiles that are shipped: only those whose source was read (docs/bibliography.md)
/// (14 CFR 23/25/27/29.1327: 10°; TM 1-1500-204-23-4: spread 5°; slaved HSI of an aeroplane maintenance manual: 2°).
[[nodiscard]] const std::vector<LimitsProfile>& shippedLimitsProfiles();

} // namespace lubberline
