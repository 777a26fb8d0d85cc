#include "core/format/results/FieldJson.h"

#include <nlohmann/json.hpp>

#include "core/angle/Angle.h"

namespace lubberline {

namespace {

using Json = nlohmann::ordered_json;

Json uncertaintyJson(const std::optional<FieldUncertainty>& uncertainty)
{
    if (!uncertainty)
        return {};
    return {{"X_nT", uncertainty->north_nT}, {"Y_nT", uncertainty->east_nT}, {"Z_nT", uncertainty->down_nT},
        {"H_nT", uncertainty->horizontal_nT}, {"F_nT", uncertainty->total_nT}, {"declination_deg", uncertainty->declination_deg},
        {"inclination_deg", uncertainty->inclination_deg}};
}

} // namespace

std::string toJson(const FieldAnswer& answer)
{
    const EarthField& field = answer.field;
    const Json json{{"model", answer.model}, {"year", answer.year},
        {"place", {{"lat_deg", answer.place.latitude_deg}, {"lon_deg", answer.place.longitude_deg}, {"alt_m", answer.place.height_m}}},
        {"X_nT", field.north_nT}, {"Y_nT", field.east_nT}, {"Z_nT", field.down_nT}, {"H_nT", field.horizontal_nT()},
        {"F_nT", field.total_nT()}, {"declination_deg", field.variation().degrees()},
        {"inclination_deg", toDegrees(field.inclination_rad())},
        {"rates",
            {{"X_nT_per_year", answer.rate.north_nT}, {"Y_nT_per_year", answer.rate.east_nT}, {"Z_nT_per_year", answer.rate.down_nT},
                {"H_nT_per_year", answer.horizontalRate_nT}, {"F_nT_per_year", answer.totalRate_nT},
                {"declination_deg_per_year", answer.declinationRate_deg}, {"inclination_deg_per_year", answer.inclinationRate_deg}}},
        {"uncertainty", uncertaintyJson(answer.uncertainty)}, {"warnings", inEnglish(answer.warnings)}};
    return json.dump(2);
}

} // namespace lubberline
