#include "core/format/reference/ReferenceJson.h"

#include <cmath>

#include "core/angle/Angle.h"
#include "core/base/Number.h"
#include "core/format/json/JsonWriter.h"
#include "core/reference/LevellingLoop.h"

namespace lubberline {

namespace {

double tenDecimals(double value) { return std::round(value * 1e10) / 1e10 + 0.0; }
double inDegrees(double angle_rad) { return tenDecimals(toDegrees(angle_rad)); }
double sizeOf_deg(const AxisTilt& tilt) { return inDegrees(std::hypot(tilt.forward_rad, tilt.starboard_rad)); }

void writeWarnings(JsonWriter& json, const std::vector<Message>& warnings)
{
    json.beginArray("warnings");
    for (const Message& warning : warnings)
        json.text({}, warning.english());
    json.end();
}

void writeBudget(JsonWriter& json, const ErrorBudget& budget)
{
    json.beginArray("budget");
    for (const ErrorPart& part : budget.parts) {
        json.beginObject({}, true);
        json.text("what", part.what.english());
        json.number("standard_deviation_deg", tenDecimals(part.size_deg));
        json.end();
    }
    json.end();
    json.number("standard_deviation_deg", tenDecimals(budget.total_deg()));
}

std::string withoutNewline(std::string text)
{
    while (!text.empty() && text.back() == '\n')
        text.pop_back();
    return text;
}

} // namespace

const char* nameOf(ErrorSource source)
{
    switch (source) {
    case ErrorSource::Tilt: return "tilt";
    case ErrorSource::OwnDeviation: return "deviation";
    case ErrorSource::Slaving: return "slaving";
    case ErrorSource::Drift: return "drift";
    case ErrorSource::Gimbal: return "gimbal";
    case ErrorSource::Card: return "card";
    case ErrorSource::Together: break;
    }
    return "together";
}

std::vector<std::size_t> pointsOf(const ReferenceRun& run, std::size_t every)
{
    std::vector<std::size_t> points;
    for (std::size_t i = 0; i < run.time_s.size(); i += every)
        points.push_back(i);
    if (points.back() + 1 != run.time_s.size())
        points.push_back(run.time_s.size() - 1);
    return points;
}

std::string toJson(const Scenario& scenario, const ReferenceRun& run, std::size_t every)
{
    const std::vector<std::size_t> points = pointsOf(run, every);
    std::vector<double> figures(points.size());
    JsonWriter json;
    const auto write = [&](std::string_view key, auto figureAt) {
        for (std::size_t i = 0; i < points.size(); ++i)
            figures[i] = figureAt(points[i]);
        json.numbers(key, figures);
    };
    json.beginObject();
    write("time_s", [&](std::size_t i) { return tenDecimals(run.time_s[i]); });
    write("heading_deg", [&](std::size_t i) { return inDegrees(run.heading_rad[i]); });
    write("vertical_error_deg", [&](std::size_t i) { return sizeOf_deg(run.tilt[i]); });
    write("tilt_forward_deg", [&](std::size_t i) { return inDegrees(run.tilt[i].forward_rad); });
    write("tilt_starboard_deg", [&](std::size_t i) { return inDegrees(run.tilt[i].starboard_rad); });
    write("heading_error_deg", [&](std::size_t i) { return inDegrees(run.headingError_rad[i]); });
    json.beginArray("shares");
    for (const ErrorShare& share : run.shares) {
        json.beginObject();
        json.text("source", nameOf(share.source));
        write("heading_error_deg", [&](std::size_t i) { return inDegrees(share.error_rad[i]); });
        json.end();
    }
    json.end();
    const auto optional = [&](std::string_view key, const std::optional<double>& angle_rad) {
        if (angle_rad)
            json.number(key, inDegrees(*angle_rad));
        else
            json.null(key);
    };
    optional("standoff_deg", run.standoff_rad);
    optional("slaving_standoff_deg", run.slavingStandoff_rad);
    if (scenario.vertical) {
        const LoopCharacter loop = characterOf(*scenario.vertical);
        json.beginObject("loop");
        json.boolean("stable", loop.stable);
        json.number("natural_period_s", tenDecimals(2 * kPi / loop.natural_rad_s));
        json.number("damping", tenDecimals(loop.damping));
        json.number("largest_gain", tenDecimals(loop.largestGain));
        json.beginArray("gain");
        for (int i = -4; i <= 12; ++i) {
            const double period_s = std::pow(10.0, 1 + i / 4.0);
            json.beginObject({}, true);
            json.number("period_s", tenDecimals(period_s));
            json.number("gain", tenDecimals(gainAt(*scenario.vertical, 2 * kPi / period_s)));
            json.end();
        }
        json.end();
        json.end();
    } else {
        json.null("loop");
    }
    writeWarnings(json, run.warnings);
    json.end();
    return withoutNewline(json.take());
}

std::string toCsv(const ReferenceRun& run, std::size_t every)
{
    std::string csv = "time_s,heading_deg,vertical_error_deg,tilt_forward_deg,tilt_starboard_deg,heading_error_deg";
    for (const ErrorShare& share : run.shares)
        csv += std::string(",") + nameOf(share.source) + "_deg";
    csv += '\n';
    for (const std::size_t i : pointsOf(run, every)) {
        csv += shortestNumber(tenDecimals(run.time_s[i]));
        for (const double figure : {inDegrees(run.heading_rad[i]), sizeOf_deg(run.tilt[i]), inDegrees(run.tilt[i].forward_rad),
                 inDegrees(run.tilt[i].starboard_rad), inDegrees(run.headingError_rad[i])})
            csv += ',' + shortestNumber(figure);
        for (const ErrorShare& share : run.shares)
            csv += ',' + shortestNumber(inDegrees(share.error_rad[i]));
        csv += '\n';
    }
    return csv;
}

std::string toJson(const SunPosition& sun, const ErrorBudget& budget, const SunDoubts& doubts)
{
    JsonWriter json;
    json.beginObject();
    json.number("azimuth_deg", tenDecimals(sun.azimuth_deg));
    json.number("elevation_deg", tenDecimals(sun.elevation_deg));
    json.number("declination_deg", tenDecimals(sun.declination_deg));
    json.number("local_hour_angle_deg", tenDecimals(sun.hourAngle_deg));
    json.number("azimuth_rate_deg_per_min", tenDecimals(sun.azimuthRate_deg_min));
    if (sun.shadowRatio > 0)
        json.number("shadow_per_height", tenDecimals(sun.shadowRatio));
    else
        json.null("shadow_per_height");
    json.boolean("usable", !doubts.none);
    writeBudget(json, budget);
    writeWarnings(json, doubts.warnings);
    json.end();
    return withoutNewline(json.take());
}

std::string toJson(const Swing& bySun, std::span<const double> errors_deg, const std::vector<Message>& warnings)
{
    JsonWriter json;
    json.beginObject();
    json.text("datum", bySun.datum.instrument);
    json.text("date", bySun.date.text());
    if (bySun.variation_deg)
        json.number("variation_deg", tenDecimals(*bySun.variation_deg));
    else
        json.null("variation_deg");
    json.beginArray("readings");
    for (std::size_t i = 0; i < bySun.readings.size(); ++i) {
        const Reading& reading = bySun.readings[i];
        json.beginObject({}, true);
        json.text("time_utc", reading.timeUtc);
        json.number("true_heading_deg", tenDecimals(reading.trueHeading->degrees()));
        json.number("magnetic_heading_deg", tenDecimals(reading.magnetic->degrees()));
        json.number("compass_heading_deg", tenDecimals(reading.compass->degrees()));
        json.number("deviation_deg", tenDecimals(deviationOf(*reading.magnetic, *reading.compass).degrees()));
        json.number("standard_deviation_deg", tenDecimals(errors_deg[i]));
        json.end();
    }
    json.end();
    json.beginObject("shared_error_deg", true);
    for (std::size_t c = 0; c < bySun.sharedErrors.of_deg.size(); ++c)
        json.number(std::string(1, "ABCDE"[c]) + "_deg", bySun.sharedErrors.of_deg[c]);
    json.end();
    writeWarnings(json, warnings);
    json.end();
    return withoutNewline(json.take());
}

std::string toJson(const ErrorBudget& budget)
{
    JsonWriter json;
    json.beginObject();
    writeBudget(json, budget);
    json.end();
    return withoutNewline(json.take());
}

} // namespace lubberline
