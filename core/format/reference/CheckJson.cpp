#include "core/format/reference/CheckJson.h"

#include <cmath>

#include "core/angle/Angle.h"
#include "core/format/json/JsonWriter.h"

namespace lubberline {

namespace {

double sixDecimals(double value) { return std::round(value * 1e6) / 1e6 + 0.0; }

constexpr std::array<std::string_view, 5> kLetterKeys{"A_deg", "B_deg", "C_deg", "D_deg", "E_deg"};

void writeFive(JsonWriter& json, std::string_view key, const PerCoefficient& values)
{
    json.beginObject(key, true);
    for (std::size_t i = 0; i < values.size(); ++i)
        json.number(kLetterKeys[i], sixDecimals(values[i]));
    json.end();
}

void writeSaid(JsonWriter& json, const std::vector<Message>& warnings)
{
    json.beginArray("warnings");
    for (const Message& warning : warnings)
        json.text({}, warning.english());
    json.end();
}

void writeChosen(
    JsonWriter& json, const CompassBelief& belief, std::size_t swings, const ChosenHeadings& chosen, const CheckOptions& options)
{
    json.beginObject("history");
    json.integer("swings", static_cast<std::int64_t>(swings));
    json.number("years_since_last", sixDecimals(belief.yearsSince));
    writeFive(json, "wanders_deg_per_sqrt_year", belief.walk_deg_year);
    json.number("jump_probability", sixDecimals(belief.jumpProbability));
    writeFive(json, "card",
        {toDegrees(belief.card.A_rad), toDegrees(belief.card.B_rad), toDegrees(belief.card.C_rad), toDegrees(belief.card.D_rad),
            toDegrees(belief.card.E_rad)});
    json.end();
    json.number("tolerance_deg", options.tolerance_deg);
    if (options.limit_deg)
        json.number("limit_deg", *options.limit_deg);
    else
        json.null("limit_deg");
    json.number("reading_error_deg", options.readingError_deg);
    json.numbers("headings_deg", chosen.compass_deg);
    json.beginObject("unknown_deg", true);
    json.number("before", sixDecimals(chosen.before_deg));
    json.number("after", sixDecimals(chosen.left_deg));
    json.number("after_evenly_spaced", sixDecimals(chosen.leftEven_deg));
    json.end();
}

std::string finished(JsonWriter& json)
{
    json.end();
    std::string text = json.take();
    while (!text.empty() && text.back() == '\n')
        text.pop_back();
    return text;
}

} // namespace

std::string toJson(const CompassBelief& belief, std::size_t swings, const ChosenHeadings& chosen, const CheckOptions& options,
    const std::vector<Message>& warnings)
{
    JsonWriter json;
    json.beginObject();
    writeChosen(json, belief, swings, chosen, options);
    json.number("fault_probability", sixDecimals(chanceOfFault(belief, {}, options)));
    writeSaid(json, warnings);
    return finished(json);
}

std::string toJson(const CompassBelief& belief, std::size_t swings, const ChosenHeadings& chosen, const CheckOptions& options,
    std::span<const Observation> readings, const CheckVerdict& verdict)
{
    JsonWriter json;
    json.beginObject();
    json.text("verdict", verdict.holds ? "holds" : "swing it");
    json.number("error_probability", sixDecimals(verdict.errorProbability));
    json.number("fault_probability", sixDecimals(verdict.holds ? verdict.errorProbability : 1 - verdict.errorProbability));
    json.number("fault_probability_before", sixDecimals(verdict.before));
    json.number("fault_probability_if_all_agreed", sixDecimals(verdict.reachable));
    json.beginArray("readings");
    for (std::size_t i = 0; i < readings.size(); ++i) {
        json.beginObject({}, true);
        json.number("compass_heading_deg", sixDecimals(readings[i].compass.degrees()));
        json.number("magnetic_heading_deg", sixDecimals(readings[i].magnetic.degrees()));
        json.number("from_card_deg", sixDecimals(verdict.differences_deg[i]));
        json.end();
    }
    json.end();
    writeChosen(json, belief, swings, chosen, options);
    writeSaid(json, verdict.warnings);
    return finished(json);
}

std::string toJson(const PairVerdict& verdict)
{
    constexpr std::array<std::string_view, 4> kMoved{"neither", "first", "second", "both"};
    JsonWriter json;
    json.beginObject();
    if (verdict.named)
        json.text("moved", kMoved[static_cast<std::size_t>(*verdict.named)]);
    else
        json.null("moved");
    json.number("error_probability", sixDecimals(verdict.errorProbability));
    json.beginObject("probability", true);
    for (std::size_t i = 0; i < kMoved.size(); ++i)
        json.number(kMoved[i], sixDecimals(verdict.probability[i]));
    json.end();
    json.number("first_fault_probability", sixDecimals(verdict.firstFault));
    json.number("second_fault_probability", sixDecimals(verdict.secondFault));
    writeFive(json, "difference", verdict.difference_deg);
    writeFive(json, "difference_standard_error", verdict.differenceError_deg);
    if (verdict.datumOut_deg)
        json.number("datum_out_deg", sixDecimals(*verdict.datumOut_deg));
    else
        json.null("datum_out_deg");
    json.number("rms_difference_deg", sixDecimals(verdict.rms_deg));
    json.integer("pairs", static_cast<std::int64_t>(verdict.readings));
    json.integer("pairs_with_datum", static_cast<std::int64_t>(verdict.withDatum));
    json.integer("headings", static_cast<std::int64_t>(verdict.headings));
    writeSaid(json, verdict.warnings);
    return finished(json);
}

} // namespace lubberline
