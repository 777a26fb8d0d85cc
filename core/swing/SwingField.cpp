#include "core/swing/SwingField.h"

#include <algorithm>
#include <cmath>

#include "core/angle/Angle.h"
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

std::optional<double> variationBeyondStamp_deg(const Swing& swing)
{
    if (!swing.field || !swing.variation_deg)
        return {};
    return wrap180(*swing.variation_deg - swing.field->field.variation().degrees());
}

} // namespace lubberline
