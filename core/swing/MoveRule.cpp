#include "core/swing/MoveRule.h"

#include "core/earth/FieldModel.h"
#include "core/swing/Prediction.h"
#include "core/swing/SwingPlaces.h"

namespace lubberline {

namespace {

Result<MeridianField> fieldAt(const Site& base, Date today)
{
    if (!base.latitude_deg || !base.longitude_deg)
        return Error{
            ErrorCode::InvalidInput, {MARKED("core", "the position of %1 is not stated; expected latitude and longitude"), base.name}};
    const auto place = makePlace(*base.latitude_deg, *base.longitude_deg, base.elevation_m.value_or(0));
    if (!place)
        return place.error();
    const auto stamp = stampField(*place, today);
    return stamp ? Result<MeridianField>(stamp->field.meridian()) : Result<MeridianField>(stamp.error());
}

} // namespace

Result<Message> whySwingAfterMove(const SwingRecord& last, const Site& base, Date today, const SwingJob* job)
{
    const auto there = fieldAt(base, today);
    if (!there)
        return there.error();
    const auto swing = swingAtPlace(last, job);
    if (!swing)
        return swing.error();
    const auto predicted = predict(*swing, *there);
    if (!predicted)
        return predicted.error();
    const auto again = swingAgainAfterMove(*predicted, last.limits);
    return again && again->needed ? Message{MARKED("core", "based at %1: %2"), base.name, again->reason} : Message();
}

} // namespace lubberline
