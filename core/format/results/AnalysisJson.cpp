#include "core/format/results/AnalysisJson.h"

#include <nlohmann/json.hpp>

#include <cmath>

#include "core/deviation/SlipWords.h"
#include "core/swing/CardRemarks.h"

namespace lubberline {

namespace {

using Json = nlohmann::ordered_json;

/// Angles are computed in radians; what rounding leaves of 3.0000000000000004 degrees is cut at 1e-12.
double clean(double value)
{
    const double rounded = std::round(value * 1e12) / 1e12;
    return std::abs(value) < 1e3 && std::isfinite(rounded) ? rounded + 0.0 : value;
}

Json degrees(double angle_rad) { return clean(toDegrees(angle_rad)); }

Json degrees(std::optional<double> angle_rad) { return angle_rad ? degrees(*angle_rad) : Json(); }

template <class Heading>
Json headingJson(Heading heading)
{
    const double heading_deg = clean(heading.degrees());
    return heading_deg < 360.0 ? heading_deg : 0.0;
}

/// Infinity (the condition of a matrix that has no rank) is null, too.
Json plain(std::optional<double> value) { return value && std::isfinite(*value) ? Json(*value) : Json(); }

std::string keyOf(Coefficient coefficient, const char* unit) { return letterOf(coefficient) + std::string(unit); }

Json fitJson(const SmithFitReport& fit, const char* unit, Json (*convert)(std::optional<double>))
{
    Json json, errors, intervals;
    for (const Coefficient coefficient : kCoefficients) {
        json[keyOf(coefficient, unit)] = convert(fit.of(coefficient));
        errors[keyOf(coefficient, unit)] = convert(fit.standardError[indexOf(coefficient)]);
        intervals[keyOf(coefficient, unit)] = convert(fit.interval95(coefficient));
    }
    json[std::string("standard_error") + unit] = errors;
    json[std::string("interval_95") + unit] = intervals; // half widths
    json["interval_factor"] = plain(fit.intervalFactor);
    json["lag_one_correlation"] = plain(fit.lagOneCorrelation);
    json["index_deg"] = degrees(fit.index_rad);
    json["rms_deg"] = fit.fitted() ? degrees(fit.rms_rad) : Json();
    json["max_abs_residual_deg"] = fit.fitted() ? degrees(fit.maxAbsResidual_rad) : Json();
    json["condition_number"] = plain(fit.conditionNumber);
    json["sigma_deg"] = degrees(fit.sigma_rad);
    json["degrees_of_freedom"] = fit.degreesOfFreedom;
    json["rank"] = fit.rank;
    return json;
}

Json rulesJson(const std::optional<PointRules>& rules)
{
    if (!rules)
        return {};
    Json json;
    json["method"] = rules->points == 8 ? "eight-point" : "four-point";
    json["points"] = rules->points;
    json["argument"] = rules->argument == HeadingArgument::Magnetic ? "magnetic" : "compass";
    json["A_deg"] = degrees(rules->A_rad);
    json["B_deg"] = degrees(rules->B_rad);
    json["C_deg"] = degrees(rules->C_rad);
    json["D_deg"] = degrees(rules->D_rad);
    json["E_deg"] = degrees(rules->E_rad);
    return json;
}

Json harmonicsJson(const Harmonics& harmonics)
{
    Json json{{"argument", "magnetic"}, {"method", harmonics.method == HarmonicsMethod::Fft ? "fft" : "least squares"},
        {"highest_resolvable", harmonics.highestResolvable}, {"condition_number", plain(harmonics.conditionNumber)},
        {"noise_floor_deg", degrees(harmonics.noiseFloor_rad)}, {"orders", Json::array()}};
    for (const auto& order : harmonics.orders)
        json["orders"].push_back({{"order", order.order}, {"sin_deg", degrees(order.sin_rad)}, {"cos_deg", degrees(order.cos_rad)},
            {"amplitude_deg", degrees(order.amplitude_rad())}, {"phase_deg", degrees(order.phase_rad())},
            {"standard_error_deg", degrees(order.standardError_rad)}, {"nyquist", order.nyquist}});
    return json;
}

Json readingJson(const AnalysedReading& reading)
{
    return {{"magnetic_heading_deg", headingJson(reading.magnetic)}, {"compass_heading_deg", headingJson(reading.compass)},
        {"deviation_deg", clean(reading.deviation.degrees())}, {"residual_approximate_deg", degrees(reading.residualApproximate_rad)},
        {"residual_exact_deg", degrees(reading.residualExact_rad)}, {"studentised_residual", plain(reading.studentised)},
        {"outlier", reading.suspect}};
}

/// What stands behind line ends moved to the right.
std::string indented(const std::string& text, std::size_t by)
{
    std::string moved;
    for (const char c : text) {
        moved += c;
        if (c == '\n')
            moved.append(by, ' ');
    }
    return moved;
}

/// Rows count from 1, in the order of `readings`.
Json slipsJson(const Analysis& analysis)
{
    Json json = Json::array();
    for (const auto& slip : analysis.slips.slips) {
        Json others = Json::array(), candidates = Json::array();
        for (const auto other : slip.orReadings)
            others.push_back(other + 1);
        for (const auto& candidate : slip.candidates)
            candidates.push_back({{"what", codeOf(candidate.slip)},
                {"means_deg", candidate.slip == Slip::Unexplained ? Json() : Json(clean(candidate.meant_deg))},
                {"probability", clean(candidate.probability)}});
        json.push_back({{"row", slip.reading + 1}, {"magnetic_heading_deg", headingJson(analysis.readings[slip.reading].magnetic)},
            {"probability", clean(slip.probability)}, {"or_rows", others}, {"candidates", candidates}});
    }
    return json;
}

/// All but the readings.
Json analysisJson(const Analysis& analysis)
{
    Json json;
    json["approximate"] = fitJson(analysis.approximate, "_deg", [](std::optional<double> value) { return degrees(value); });
    json["exact"] = fitJson(analysis.exact, "", plain);
    json["point_rules"] = rulesJson(analysis.pointRules);
    json["harmonics"] = harmonicsJson(analysis.harmonics);
    json["summary"] = {{"max_abs_deviation_deg", degrees(analysis.summary.maxAbsDeviation_rad)},
        {"at_magnetic_heading_deg", headingJson(analysis.summary.maxAbsDeviationAt)},
        {"rms_deviation_deg", degrees(analysis.summary.rmsDeviation_rad)},
        {"min_deviation_deg", degrees(analysis.summary.minDeviation_rad)},
        {"max_deviation_deg", degrees(analysis.summary.maxDeviation_rad)}, {"spread_deg", degrees(analysis.summary.spread_rad())}};
    json["slips"] = slipsJson(analysis);
    json["slips_seen_from_deg"] = plain(analysis.slips.seenFrom_deg);
    json["warnings"] = inEnglish(analysis.warnings);
    return json;
}

} // namespace

void writeJson(const Analysis& analysis, const Removal* removal, const TextSink& put)
{
    put("{\n  \"readings\": [");
    for (std::size_t i = 0; i < analysis.readings.size(); ++i)
        put((i == 0 ? "\n    " : ",\n    ") + indented(readingJson(analysis.readings[i]).dump(2), 4));
    put(analysis.readings.empty() ? "]," : "\n  ],");
    Json json = analysisJson(analysis);
    if (removal) {
        Json remaining = Json::array();
        for (const double left_rad : removal->remaining_rad)
            remaining.push_back(degrees(left_rad));
        json["removal"] = {{"remaining_deg", std::move(remaining)}, {"max_abs_deg", degrees(removal->maxAbs_rad)},
            {"rms_deg", degrees(removal->rms_rad)}, {"harmonics", harmonicsJson(removal->harmonics)}};
    }
    put(std::string_view(json.dump(2)).substr(1)); // it goes on behind the readings, in the same object
}

std::string toJson(const Analysis& analysis, const Removal* removal)
{
    std::string text;
    writeJson(analysis, removal, [&text](std::string_view part) { text += part; });
    return text;
}

std::string toJson(const Card& card, const SwingRecord& record)
{
    const auto& options = card.options;
    Json json{{"rows", Json::array()}};
    for (const auto& row : card.rows)
        json["rows"].push_back(
            {{"for_deg", headingJson(row.magnetic)}, {"steer_deg", headingJson(row.steer)}, {"steer_rounded_deg", row.steerRounded_deg()},
                {"for_rounded_deg", row.magneticRounded_deg()}, {"residual_deg", clean(row.residual.degrees())},
                {"band_95_deg", degrees(row.band_rad)}, {"unread", row.unread}, {"over_limit", overLimit(row, record.limits)},
                {"halfway_deg", plain(row.halfway.curve_deg)}, {"halfway_interpolated_deg", clean(row.halfway.interpolated_deg)}});
    json["residual_max_abs_deg"] = degrees(card.residualMaxAbs_rad);
    json["by"] = options.by == CardBy::Magnetic ? "magnetic" : "compass";
    json["from"] = options.source == CardSource::Fit ? "fit" : "readings";
    json["step_deg"] = options.step_deg;
    json["removed"] = Json::array();
    for (const Coefficient coefficient : kCoefficients)
        if (options.removed.test(indexOf(coefficient)))
            json["removed"].push_back(std::string(1, letterOf(coefficient)));
    json["residual_max"] = {{"deviation_deg", clean(card.largestResidual.deviation.degrees())},
        {"at_magnetic_heading_deg", headingJson(card.largestResidual.at)}};
    json["reading_max"] = {{"deviation_deg", clean(card.largestReading.deviation.degrees())},
        {"at_magnetic_heading_deg", headingJson(card.largestReading.at)}};
    json["misfit_max_abs_deg"] = degrees(card.largestMisfit_rad);
    json["band_95_max_deg"] = degrees(card.widestBand_rad);
    json["between_rows_max_error_deg"] = degrees(card.betweenRows_rad);
    json["between_rows_worst_at_deg"] = clean(card.betweenRowsAt_deg);
    json["finer_step_deg"] = card.finerStep_deg > 0 ? Json(card.finerStep_deg) : Json();
    json["gaps"] = Json::array();
    for (const auto& gap : card.gaps)
        json["gaps"].push_back({{"from_compass_heading_deg", headingJson(gap.from)}, {"to_compass_heading_deg", headingJson(gap.to)},
            {"width_deg", clean(gap.width_deg)}, {"band_95_max_deg", degrees(gap.widestBand_rad)}});
    json["suspect_readings"] = Json::array();
    for (const auto& suspect : card.suspects)
        json["suspect_readings"].push_back(
            {{"magnetic_heading_deg", headingJson(suspect.at)}, {"off_deg", clean(suspect.deviation.degrees())}});
    json["remarks"] = inEnglish(remarksOn(card, record));
    return json.dump(2);
}

std::string toJson(const Correction& correction, const std::vector<Message>& warnings)
{
    Json json{{"A_deg", degrees(correction.A_rad)}, {"B_deg", degrees(correction.B_rad)}, {"C_deg", degrees(correction.C_rad)},
        {"steps", Json::array()}};
    for (const auto& step : correction.steps)
        json["steps"].push_back({{"coefficient", std::string(1, letterOf(step.coefficient))}, {"on", std::string(1, letterOf(step.on))},
            {"magnetic_heading_deg", headingJson(step.magnetic)}, {"compass_reads_deg", headingJson(step.compassReads)},
            {"make_compass_read_deg", headingJson(step.makeCompassRead)}});
    json["warnings"] = inEnglish(warnings);
    return json.dump(2);
}

} // namespace lubberline
