#include "core/format/results/SensorTestsJson.h"

#include <nlohmann/json.hpp>

#include "core/angle/Angle.h"

namespace lubberline {

namespace {

using TestKeys = nlohmann::ordered_json;

TestKeys threeKeys(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }
TestKeys threeKeys(const std::optional<Eigen::Vector3d>& v) { return v ? threeKeys(*v) : TestKeys(); }

void addWarnings(TestKeys& json, const SensorLog& log, const std::vector<Message>& warnings)
{
    std::vector<Message> all = log.warnings;
    all.insert(all.end(), warnings.begin(), warnings.end());
    json["warnings"] = inEnglish(all);
}

std::string written(const TestKeys& json) { return json.dump(2, ' ', false, TestKeys::error_handler_t::replace); }

TestKeys coilKeys(const CoilResult& result)
{
    TestKeys json{{"samples", result.samples}, {"used", result.used}, {"range_nT", result.range_nT}, {"scale", threeKeys(result.scale)},
        {"scale_standard_error", threeKeys(result.scaleError)}, {"non_orthogonality_deg", threeKeys(result.nonOrthogonality_deg)}};
    json["misalignment_deg"] = {{"roll", toDegrees(result.misalignment.roll_rad)}, {"pitch", toDegrees(result.misalignment.pitch_rad)},
        {"yaw", toDegrees(result.misalignment.yaw_rad)}};
    json["bias_nT"] = threeKeys(result.bias_nT);
    json["bias_standard_error_nT"] = threeKeys(result.biasError_nT);
    json["bias_at_c"] = result.biasAt_c ? TestKeys(*result.biasAt_c) : TestKeys();
    json["temperature_nT_per_c"] = threeKeys(result.temperature_nT_per_c);
    json["hysteresis_nT"] = threeKeys(result.hysteresis_nT);
    json["nonlinearity_nT"] = threeKeys(result.nonlinearity_nT);
    json["noise_nT"] = threeKeys(result.noise_nT);
    return json;
}

TestKeys driftKeys(const CoilBench& earlier, const CoilBench& later)
{
    const auto drift = driftBetween(earlier, later);
    if (!drift)
        return {{"since", earlier.date.text()}, {"comparable", false}, {"reason", describe(drift.error())}};
    return {{"since", earlier.date.text()}, {"comparable", true}, {"years", drift->years},
        {"bias_at_c", drift->at_c ? TestKeys(*drift->at_c) : TestKeys()}, {"bias_nT_per_year", threeKeys(drift->bias_nT_per_year)},
        {"bias_interval95_nT_per_year", threeKeys(drift->biasInterval_nT_per_year)}, {"scale_per_year", threeKeys(drift->scale_per_year)},
        {"scale_interval95_per_year", threeKeys(drift->scaleInterval_per_year)}, {"noise_ratio", threeKeys(drift->noiseRatio)},
        {"doubts", inEnglish(drift->doubts)}};
}

} // namespace

std::string toJson(const LogSpectrum& spectrum, const SensorLog& log)
{
    TestKeys json{{"column", spectrum.column}, {"rate_hz", spectrum.rate_hz}, {"segment", spectrum.segment},
        {"segments", spectrum.segments}, {"frequency_hz", spectrum.frequency_hz}, {"density_nT2_per_hz", spectrum.density}};
    json["lines"] = TestKeys::array();
    const auto orNothing = [](const std::optional<double>& value) { return value ? TestKeys(*value) : TestKeys(); };
    for (const auto& line : spectrum.lines) {
        TestKeys sources = TestKeys::array();
        for (const auto& one : line.sources)
            sources.push_back({{"source", one.name.english()}, {"alias_of_hz", orNothing(one.aliasOf_hz)}});
        json["lines"].push_back({{"frequency_hz", line.frequency_hz}, {"amplitude_nT", line.amplitude}, {"source", line.source.english()},
            {"alias_of_hz", orNothing(line.aliasOf_hz)}, {"sources", sources}});
    }
    json["filter"] = nullptr;
    if (const auto& filter = spectrum.filter)
        json["filter"] = {{"notches_hz", filter->notches_hz},
            {"low_pass_hz", filter->lowPass_hz ? TestKeys(*filter->lowPass_hz) : TestKeys()}, {"delay_ms", filter->delay_ms},
            {"before_nT_rms", filter->before_rms}, {"left_nT_rms", filter->left_rms}, {"from_hz", filter->from_hz}};
    addWarnings(json, log, spectrum.warnings);
    return written(json);
}

std::string toJson(const CoilResult& result, const SensorLog& log)
{
    TestKeys json = coilKeys(result);
    addWarnings(json, log, result.warnings);
    return written(json);
}

std::string toJson(const std::vector<CoilBench>& benches)
{
    TestKeys json{{"benches", TestKeys::array()}};
    for (std::size_t i = 0; i < benches.size(); ++i) {
        const auto result = coilBench(logOf(benches[i]));
        TestKeys one{{"record", benches[i].record}, {"date", benches[i].date.text()}, {"serial_number", benches[i].serialNumber},
            {"log", benches[i].log}, {"note", benches[i].note}, {"result", result ? coilKeys(*result) : TestKeys()}};
        one["drift"] = nullptr; // since the bench before it; the benches are the newest first
        if (i + 1 < benches.size())
            one["drift"] = driftKeys(benches[i + 1], benches[i]);
        json["benches"].push_back(one);
    }
    return written(json);
}

std::string toJson(const InterferenceResult& result, const SensorLog& log)
{
    TestKeys json{{"actions", TestKeys::array()}};
    for (const auto& action : result.actions)
        json["actions"].push_back({{"action", action.action}, {"from_s", action.from_s}, {"change_nT", threeKeys(action.change_nT)},
            {"worst_nT", threeKeys(action.worst_nT)}, {"worst_at_s", threeKeys(action.worstAt_s)}, {"passes", action.passes}});
    json["passes"] = result.passes;
    json["limits_nT"] = threeKeys(result.limits_nT);
    json["noise_nT"] = threeKeys(result.noise_nT);
    json["circuits"] = TestKeys::array();
    for (const auto& circuit : result.circuits)
        json["circuits"].push_back(
            {{"name", circuit.name}, {"field_nT_per_A", threeKeys(circuit.field_nT_per_A)}, {"current_A", circuit.current_A}});
    addWarnings(json, log, result.warnings);
    return written(json);
}

std::string toJson(const DipoleSource& source)
{
    TestKeys two;
    if (source.two) {
        two = {{"sources", TestKeys::array()}, {"uniform_nT", threeKeys(source.two->uniform_nT)}, {"rms_nT", source.two->rms_nT}};
        for (std::size_t i = 0; i < 2; ++i)
            two["sources"].push_back({{"at_m", threeKeys(source.two->at_m[i])}, {"moment_A_m2", threeKeys(source.two->moment_A_m2[i])}});
    }
    return written({{"at_m", threeKeys(source.at_m)}, {"at_standard_error_m", threeKeys(source.atError_m)},
        {"moment_A_m2", threeKeys(source.moment_A_m2)}, {"moment_size_A_m2", source.moment_A_m2.norm()},
        {"moment_standard_error_A_m2", source.momentError_A_m2}, {"uniform_nT", threeKeys(source.uniform_nT)}, {"rms_nT", source.rms_nT},
        {"nearest_m", source.nearest_m}, {"uniform_standard_error_nT", threeKeys(source.uniformError_nT)}, {"two_sources", two},
        {"warnings", inEnglish(source.warnings)}});
}

std::string toJson(const BothWays& both)
{
    return written(
        {{"difference_deg", {{"constant", both.difference_deg[0]}, {"sin", both.difference_deg[1]}, {"cos", both.difference_deg[2]}}},
            {"standard_error_deg",
                {{"constant", both.standardError_deg[0]}, {"sin", both.standardError_deg[1]}, {"cos", both.standardError_deg[2]}}},
            {"largest_deg", both.largest_deg}, {"residual_deg", both.residual_deg}, {"limit_deg", both.limit_deg}, {"passes", both.passes},
            {"findings", inEnglish(both.findings)}});
}

} // namespace lubberline
