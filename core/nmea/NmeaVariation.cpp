#include "core/nmea/NmeaVariation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "core/base/Middle.h"
#include "core/base/Number.h"
#include "core/earth/FieldModel.h"
#include "core/earth/VariationError.h"
#include "core/record/ClockDates.h"

namespace lubberline {

namespace {

constexpr double kApart_deg = 1.0;

/// What other clocks of the log say of the day.
void compareClocks(const NmeaLog& log, NmeaDate& date)
{
    for (const auto& clock : log.clocks()) {
        const Date first = clock.marks.front().date;
        if ((clock.source.type != "RMC" && clock.source.type != "ZDA") || first.empty())
            continue;
        if (std::abs(daysBetween(first, date.date)) > 1)
            date.doubts.push_back(
                {MARKED("core", "%1 dates the log %2, and not %3"), clock.source.talker + clock.source.type, first, date.date});
    }
}

std::optional<FieldAnswer> modelAt(const NmeaLog& log, Date date)
{
    if (!log.latitude_deg || date.empty())
        return {};
    const auto place = makePlace(*log.latitude_deg, *log.longitude_deg, log.altitude_m.value_or(0.0));
    const double year = yearOf(date);
    const auto model = defaultFieldModel(year);
    if (!place || !model)
        return {};
    auto answer = fieldForCompass(*model, *place, year);
    return answer ? std::optional(std::move(answer.value())) : std::nullopt;
}

/// Why modelAt() has none.
Error whyNoModel(const NmeaLog& log, Date date)
{
    if (!log.latitude_deg || date.empty())
        return {ErrorCode::InvalidInput,
            MARKED(
                "core", "the log tells no position with a date (RMC), so no model can give the variation; expected it stated in degrees")};
    const auto place = makePlace(*log.latitude_deg, *log.longitude_deg, log.altitude_m.value_or(0.0));
    if (!place)
        return place.error();
    const double year = yearOf(date);
    const auto model = defaultFieldModel(year);
    return model ? fieldForCompass(*model, *place, year).error() : model.error();
}

std::string whereOf(const FieldAnswer& answer, Date date)
{
    std::array<char, 96> where{};
    std::snprintf(where.data(), where.size(), " at %.2f° %c, %.2f° %c on ", std::abs(answer.place.latitude_deg),
        answer.place.latitude_deg < 0 ? 'S' : 'N', std::abs(answer.place.longitude_deg), answer.place.longitude_deg < 0 ? 'W' : 'E');
    return answer.model + where.data() + date.text();
}

std::string listed(const std::vector<NmeaVariations>& variations)
{
    std::string text;
    for (const auto& one : variations)
        text += (text.empty() ? "" : ", ") + one.source.talker + one.source.type + " " + signedFigureText(middleOf(one.told_deg), 1) + "°";
    return text;
}

/// Of several the one nearest to the model; without a model the receiver's, which knows where it is.
double chooseOfLog(const NmeaLog& log, const std::optional<double>& model_deg, std::vector<Message>& warnings)
{
    const auto& all = log.variations();
    const auto worth = [&](const NmeaVariations& one) {
        return model_deg ? std::abs(wrap180(middleOf(one.told_deg) - *model_deg)) : one.source.type == "RMC" ? 0.0 : 1.0;
    };
    const auto best
        = std::min_element(all.begin(), all.end(), [&](const auto& one, const auto& other) { return worth(one) < worth(other); });
    const double chosen_deg = middleOf(best->told_deg);
    const bool differ = std::any_of(all.begin(), all.end(),
        [&](const NmeaVariations& one) { return std::abs(wrap180(middleOf(one.told_deg) - chosen_deg)) > kApart_deg; });
    if (differ)
        warnings.push_back({MARKED("core", "the log tells different variations: %1 (east +); that of %2 is taken"), listed(all),
            best->source.talker + best->source.type});
    return chosen_deg;
}

void holdAgainstModel(ChosenVariation& chosen, const FieldAnswer& answer, Date date)
{
    const double apart_deg = std::abs(wrap180(chosen.variation.degrees() - *chosen.model_deg));
    const bool ofLog = chosen.source == "log";
    if (ofLog)
        chosen.standardError_deg = std::max(variationError_deg(answer), apart_deg);
    if (apart_deg <= kApart_deg)
        return;
    chosen.warnings.push_back(
        {ofLog ? MARKED("core",
             "the variation of the log is %1° (east +), that of %2 is %3°: they are %4° apart, and A with them; take the "
             "model's (variation: model) unless you know the log's to be right")
               : MARKED("core", "the variation stated is %1° (east +), that of %2 is %3°: they are %4° apart"),
            signedFigureText(chosen.variation.degrees(), 1), whereOf(answer, date), signedFigureText(*chosen.model_deg, 1),
            figureText(apart_deg, 1)});
}

/// By how much the model would say something else on the day that the log may mean.
double movedByDate_deg(const NmeaLog& log, const NmeaDate& date, const FieldAnswer& answer)
{
    const auto other = date.perhaps.empty() ? std::nullopt : modelAt(log, date.perhaps);
    return other ? std::abs(wrap180(other->field.variation().degrees() - answer.field.variation().degrees())) : 0.0;
}

} // namespace

NmeaDate dateOfLog(const NmeaLog& log, Date stated, Date today)
{
    NmeaDate date{stated.empty() ? log.firstDate : stated, {}, {}};
    if (date.date.empty())
        return date;
    compareClocks(log, date);
    const bool weekZero = beginsGpsWeeks(date.date);
    if (weekZero && stated.empty()) {
        date.perhaps = today; // as good a guess as any
        date.doubts.push_back({MARKED("core",
                                   "the log is dated %1, a day on which the GPS week count began: the receiver did not know the date; "
                                   "state it"),
            date.date});
    }
    if (today.empty())
        return date;
    const int ago = daysBetween(date.date, today);
    if (ago < -1) { // somewhere it is tomorrow already
        date.doubts.push_back({MARKED("core", "the log is dated %1, and today is %2: one of the clocks is wrong"), date.date, today});
    } else if (ago >= kGpsRollOver_days && stated.empty() && !weekZero) {
        date.perhaps = addDays(date.date, ago / kGpsRollOver_days * kGpsRollOver_days);
        date.doubts.push_back(
            {MARKED("core",
                 "the log is dated %1: a receiver that missed the turn of the GPS week count (1024 weeks) writes so for %2; "
                 "state the date"),
                date.date, date.perhaps});
    }
    return date;
}

Result<ChosenVariation> chooseVariation(const NmeaLog& log, const NmeaVariation& wanted, const NmeaDate& date, double stated_deg)
{
    ChosenVariation chosen;
    const auto answer = modelAt(log, date.date);
    if (answer)
        chosen.model_deg = answer->field.variation().degrees();
    if (const auto* stated = std::get_if<Variation>(&wanted)) {
        chosen.variation = *stated;
        chosen.source = "stated";
    } else if (!log.variations().empty() && !std::holds_alternative<VariationOfModel>(wanted)) {
        chosen.variation = Variation::fromDegrees(chooseOfLog(log, chosen.model_deg, chosen.warnings));
        chosen.source = "log";
    } else if (std::holds_alternative<VariationOfLog>(wanted)) {
        return Error{ErrorCode::InvalidInput,
            MARKED("core", "neither RMC nor HDG of the log tells the variation; expected it stated in degrees, or taken from a model")};
    } else if (!answer) {
        return whyNoModel(log, date.date);
    } else {
        chosen.variation = answer->field.variation();
        chosen.source = whereOf(*answer, date.date);
        chosen.standardError_deg = std::hypot(variationError_deg(*answer), movedByDate_deg(log, date, *answer));
        chosen.warnings.insert(chosen.warnings.end(), answer->warnings.begin(), answer->warnings.end());
    }
    if (answer)
        holdAgainstModel(chosen, *answer, date.date);
    else if (chosen.source == "log") {
        chosen.standardError_deg = kUnstatedVariationError_deg;
        chosen.warnings.push_back({MARKED("core", "the variation of the log, %1° (east +), is held against no model: %2"),
            signedFigureText(chosen.variation.degrees(), 1), whyNoModel(log, date.date).message});
    }
    chosen.standardError_deg = std::hypot(chosen.standardError_deg, stated_deg);
    return chosen;
}

} // namespace lubberline
