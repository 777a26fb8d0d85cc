#include "core/swing/SwingField.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/angle/Angle.h"
#include "core/base/Number.h"
#include "core/earth/FieldModel.h"

namespace lubberline {

namespace {

/// Half a metre on the ground: the same place, whatever was rounded on its way through a file.
constexpr double kSamePlace_deg = 5e-6, kSameHeight_m = 0.5;

bool samePlace(const FieldStamp& a, const FieldStamp& b)
{
    return std::abs(a.place.latitude_deg - b.place.latitude_deg) <= kSamePlace_deg
        && std::abs(wrap180(a.place.longitude_deg - b.place.longitude_deg)) <= kSamePlace_deg
        && std::abs(a.place.height_m - b.place.height_m) <= kSameHeight_m && a.date == b.date;
}

bool sameField(const EarthField& a, const EarthField& b)
{
    return std::max({std::abs(a.north_nT - b.north_nT), std::abs(a.east_nT - b.east_nT), std::abs(a.down_nT - b.down_nT)}) <= kSameField_nT;
}

} // namespace

std::optional<FieldStamp> stampFor(const Swing& swing, const std::optional<Site>& site)
{
    if (swing.date.empty() || !site || !site->latitude_deg || !site->longitude_deg)
        return {};
    const auto place = makePlace(*site->latitude_deg, *site->longitude_deg, site->elevation_m.value_or(0.0));
    if (!place)
        return {};
    const auto stamp = stampField(*place, swing.date);
    return stamp ? std::optional(*stamp) : std::nullopt;
}

void stampUnlessSigned(Swing& swing, const std::optional<Site>& site)
{
    if (!swing.field && swing.state != SwingState::Signed)
        swing.field = stampFor(swing, site);
}

StampState stateOf(const Swing& swing, const std::optional<Site>& site)
{
    if (!swing.field)
        return StampState::None;
    const auto now = stampFor(swing, site);
    if (!now || sameField(now->field, swing.field->field))
        return StampState::Current;
    return samePlace(*now, *swing.field) ? StampState::ModelChanged : StampState::PlaceChanged;
}

namespace {

/// The mean declination of the survey's points; none where none was measured.
std::optional<double> surveyed_deg(const Site& site)
{
    double first_deg = 0, sum_deg = 0;
    int count = 0;
    for (const auto& point : site.survey)
        if (point.declination_deg) {
            if (count++ == 0)
                first_deg = *point.declination_deg;
            sum_deg += wrap180(*point.declination_deg - first_deg);
        }
    return count > 0 ? std::optional(wrap180(first_deg + sum_deg / count)) : std::nullopt;
}

/// What one source says of the variation.
struct SaidVariation {
    Pattern who;
    double deg = 0;
};

/// What base, survey and model say.
std::vector<SaidVariation> saidOf(const std::optional<Site>& site, const std::optional<FieldStamp>& model)
{
    std::vector<SaidVariation> said;
    const auto add = [&](const Pattern& who, std::optional<double> deg) {
        if (deg && std::isfinite(*deg))
            said.push_back({who, *deg});
    };
    if (site) {
        add(MARKED("core", "the base states %1"), site->variation_deg);
        add(MARKED("core", "its survey found %1"), surveyed_deg(*site));
    }
    if (model)
        add(MARKED("core", "the model has %1"), model->field.variation().degrees());
    return said;
}

constexpr double kRoundingOfVariation_deg = 1e-9;
bool doubtful(double apart_deg) { return apart_deg >= kDoubtfulVariation_deg - kRoundingOfVariation_deg; }

} // namespace

Message variationDisagreement(const std::optional<Site>& site, const std::optional<FieldStamp>& model, std::optional<double> swing_deg)
{
    auto said = saidOf(site, model);
    if (swing_deg && std::isfinite(*swing_deg))
        said.push_back({MARKED("core", "the swing states %1"), *swing_deg});
    double apart_deg = 0;
    std::vector<Message> words;
    for (std::size_t i = 0; i < said.size(); ++i) {
        words.push_back({said[i].who, signedFigureText(said[i].deg, 2) + "°"});
        for (std::size_t j = 0; j < i; ++j)
            apart_deg = std::max(apart_deg, std::abs(wrap180(said[i].deg - said[j].deg)));
    }
    if (!doubtful(apart_deg))
        return {};
    return {MARKED("core", "VARIATION in doubt, by %1: %2"), figureText(apart_deg, 1) + "°", together(std::move(words))};
}

double variationDoubt_deg(const Swing& swing, const std::optional<Site>& site)
{
    const bool ofTrue
        = std::any_of(swing.readings.begin(), swing.readings.end(), [](const Reading& one) { return one.trueHeading && one.used(); });
    if (!swing.variation_deg || !ofTrue)
        return 0.0;
    double apart_deg = 0;
    for (const auto& one : saidOf(site, swing.field ? swing.field : stampFor(swing, site)))
        apart_deg = std::max(apart_deg, std::abs(wrap180(one.deg - *swing.variation_deg)));
    return doubtful(apart_deg) ? apart_deg : 0.0;
}

std::optional<double> variationBeyondStamp_deg(const Swing& swing)
{
    if (!swing.field || !swing.variation_deg)
        return {};
    return wrap180(*swing.variation_deg - swing.field->field.variation().degrees());
}

} // namespace lubberline
