#include "core/record/Site.h"

#include "core/record/DerivedId.h"

namespace lubberline {

namespace {

LimitsProfile profile(const char* name, const char* document, const char* issue, const char* scope, std::optional<double> maxDeviation_deg,
    std::optional<double> maxSpread_deg = {})
{
    return {{}, recordIdOfLimits(name), name, document, issue, scope, maxDeviation_deg, maxSpread_deg};
}

} // namespace

const std::vector<LimitsProfile>& shippedLimitsProfiles()
{
    static const std::vector<LimitsProfile> profiles{
        profile("14 CFR 23.1327 (10\u00B0)", "14 CFR 23.1327", "amendment 23-20; withdrawn with amendment 23-64",
            "magnetic direction indicator of a small aeroplane, compensated, level flight, any heading", 10.0),
        profile("14 CFR 25.1327 (10\u00B0)", "14 CFR 25.1327", "",
            "magnetic direction indicator of a transport aeroplane, compensated, normal level flight, any heading", 10.0),
        profile("14 CFR 27.1327 (10\u00B0)", "14 CFR 27.1327", "",
            "magnetic direction indicator of a normal category rotorcraft, compensated, level flight, any heading", 10.0),
        profile("14 CFR 29.1327 (10\u00B0)", "14 CFR 29.1327", "",
            "magnetic direction indicator of a transport category rotorcraft, compensated, level flight, any heading", 10.0),
        profile("TM 1-1500-204-23-4 (spread 5\u00B0)", "TM 1-1500-204-23-4", "",
            "US Army standby compass after compensation: largest deviation less the smallest", {}, 5.0),
        profile("Slaved HSI (2\u00B0)", "aeroplane maintenance manual, HSI and flux detector swing, p. 624", "30 November 2000",
            "horizontal situation indicator slaved to a flux detector, against magnetic heading", 2.0),
    };
    return profiles;
}

} // namespace lubberline
