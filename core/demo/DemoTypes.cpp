#include "core/demo/DemoTypes.h"

#include "core/record/DerivedId.h"

namespace lubberline {

namespace {

DemoCompassKind standby(int points, std::array<double, 5> typical_deg, const char* limits, bool radioPair)
{
    return {"standby compass", CompassKind::DirectReading, Compensator::Magnets, "windscreen frame", 1.0, points, typical_deg, 1.2, 0.35,
        limits, 10.0, false, radioPair};
}

DemoCompassKind remote(
    const char* name, CompassKind kind, const char* location, int points, std::array<double, 5> typical_deg, bool trueDatum)
{
    return {name, kind, Compensator::Screws, location, 0.5, points, typical_deg, 0.22, 0.1, "Slaved HSI (2\u00B0)", 2.0, trueDatum, false};
}

Site site(const char* name, double latitude_deg, double longitude_deg, double elevation_m, double variation_deg)
{
    Site made;
    made.record = recordIdOfSite(name);
    made.name = name;
    made.latitude_deg = latitude_deg;
    made.longitude_deg = longitude_deg;
    made.elevation_m = elevation_m;
    made.variation_deg = variation_deg;
    made.variationSource = "invented for the demonstration, near the truth of 2026";
    made.note = "Demonstration: not a surveyed compass base.";
    return made;
}

} // namespace

const std::vector<DemoType>& demoTypes()
{
    static const std::vector<DemoType> types{
        {"Su-22", "Sukhoi", {"7901", "7902", "7903", "7904"}, 1984,
            {standby(8, {0.6, -2.6, 1.8, 1.4, 0.3}, "14 CFR 25.1327 (10\u00B0)", false),
                remote("remote compass", CompassKind::RemoteStabilised, "fin", 24, {0.2, -0.35, 0.25, 0.3, 0.05}, false)}},
        {"Mi-17", "Mil", {"6901", "6902", "6903", "6904"}, 1988,
            {standby(12, {-0.5, 2.2, -1.9, 1.7, -0.4}, "14 CFR 29.1327 (10\u00B0)", true),
                remote("remote compass", CompassKind::RemoteStabilised, "tail boom", 12, {-0.1, 0.4, -0.3, 0.35, -0.05}, false)}},
        {"PZL-130", "PZL Warszawa-Ok\u0119cie", {"091", "092", "093", "094"}, 1994,
            {standby(8, {0.4, 1.4, 1.1, 0.8, 0.2}, "14 CFR 23.1327 (10\u00B0)", true),
                remote("remote compass", CompassKind::RemoteUnstabilised, "port wing", 12, {0.1, 0.3, 0.2, 0.25, 0.05}, false)}},
        {"M28", "PZL Mielec", {"SP-DEA", "SP-DEB", "SP-DEC", "SP-DED"}, 2003,
            {standby(12, {0.3, -1.8, -1.2, 1.0, 0.1}, "14 CFR 23.1327 (10\u00B0)", false),
                remote("No. 1 flux valve", CompassKind::RemoteStabilised, "starboard wing tip", 24, {0.15, -0.3, -0.25, 0.3, 0.05}, true)}},
    };
    return types;
}

std::vector<Site> demoSites()
{
    return {site("D\u0119blin", 51.55, 21.89, 117, 7.0), site("Bydgoszcz", 53.10, 17.98, 72, 5.5), site("Mielec", 50.32, 21.46, 167, 6.5),
        site("Troms\u00F8", 69.68, 18.92, 10, 11.0), site("Gran Canaria", 27.93, -15.39, 24, -3.3)};
}

} // namespace lubberline
