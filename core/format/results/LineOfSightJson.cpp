#include "core/format/results/LineOfSightJson.h"

#include <nlohmann/json.hpp>

#include "core/angle/Angle.h"

namespace lubberline {

namespace {

using SightKeys = nlohmann::ordered_json;

SightKeys angleKeys(const SightAngles& angles) { return {{"azimuth_deg", angles.azimuth_deg}, {"elevation_deg", angles.elevation_deg}}; }

SightKeys sightKeys(const SightError& error) { return {{"aircraft", angleKeys(error.aircraft)}, {"turret", angleKeys(error.turret)}}; }

} // namespace

std::string toJson(const SightBudget& budget, std::span<const SightBudget> sweep)
{
    SightKeys json{{"line_of_sight", sightKeys(budget.truth)}};
    json["helmet"] = {{"heading_deg", budget.helmet.heading.degrees()}, {"pitch_deg", toDegrees(budget.helmet.pitch_rad)},
        {"roll_deg", toDegrees(budget.helmet.roll_rad)}};
    json["causes"] = SightKeys::array();
    for (const SightCause& cause : budget.causes) {
        SightKeys one{{"name", cause.name.english()}, {"kind", cause.byChance ? "standard deviation" : "stays"}};
        one.update(sightKeys(cause.error));
        json["causes"].push_back(std::move(one));
    }
    json["stays"] = sightKeys(budget.stays);
    json["standard_deviation"] = sightKeys(budget.byChance);
    json["whole"] = sightKeys(budget.whole);
    json["cockpit_tracking_field"] = "not modelled";
    json["sweep"] = SightKeys::array();
    for (const SightBudget& one : sweep)
        json["sweep"].push_back({{"azimuth_deg", one.look.azimuth_deg}, {"elevation_deg", one.look.elevation_deg},
            {"stays", sightKeys(one.stays)}, {"whole", sightKeys(one.whole)}});
    json["warnings"] = inEnglish(budget.warnings);
    return json.dump(2, ' ', false, SightKeys::error_handler_t::replace);
}

} // namespace lubberline
