#include "core/format/results/CompensationJson.h"

#include <nlohmann/json.hpp>

namespace lubberline {

namespace {

using CompensationKeys = nlohmann::ordered_json;

CompensationKeys errorKeys(const HeadingErrors& errors)
{
    CompensationKeys json{
        {"mean_deg", errors.mean_deg}, {"rms_deg", errors.rms_deg}, {"p95_deg", errors.p95_deg}, {"max_deg", errors.max_deg}};
    json["harmonics"] = CompensationKeys::array();
    for (std::size_t order = 1; order <= 4; ++order)
        json["harmonics"].push_back(
            {{"order", order}, {"sin_deg", errors.harmonics_deg[2 * order - 1]}, {"cos_deg", errors.harmonics_deg[2 * order]}});
    return json;
}

} // namespace

std::string toJson(const CompensatedLog& compensated, const SensorLog& log)
{
    const auto orNull = [](const auto& value) { return value ? CompensationKeys(*value) : CompensationKeys(); };
    CompensationKeys json{{"samples", log.size()}, {"rate_hz", orNull(compensated.rate_hz)}};
    json["heading_error"] = compensated.before && compensated.after ? CompensationKeys{{"sign", "read - magnetic"},
                                {"before", errorKeys(*compensated.before)}, {"after", errorKeys(*compensated.after)}}
                                                                    : CompensationKeys();
    json["field_spread_nT"] = {{"before", compensated.spreadBefore}, {"after", compensated.spreadAfter}};
    json["attitude"] = log.pitch_deg.empty() || log.roll_deg.empty() ? "taken for level" : "of the log";
    json["deviation_map_sign"] = "magnetic - read";
    json["deviation_map"] = CompensationKeys::array();
    for (const ErrorCell& cell : compensated.map)
        json["deviation_map"].push_back({{"heading_deg", cell.heading_deg}, {"pitch_deg", cell.pitch_deg}, {"samples", cell.samples},
            {"before_deg", cell.before_deg}, {"after_deg", orNull(cell.after_deg)}, {"standard_deviation_deg", orNull(cell.sigma_deg)}});
    json["demands"] = CompensationKeys::array();
    for (const auto& demand : compensated.demands)
        json["demands"].push_back({{"name", demand.name.english()}, {"value", orNull(demand.value)}, {"limit", demand.limit},
            {"unit", demand.unit}, {"met", orNull(demand.met())}});
    std::vector<Message> warnings = log.warnings;
    warnings.insert(warnings.end(), compensated.warnings.begin(), compensated.warnings.end());
    json["warnings"] = inEnglish(warnings);
    return json.dump(2, ' ', false, CompensationKeys::error_handler_t::replace);
}

} // namespace lubberline
