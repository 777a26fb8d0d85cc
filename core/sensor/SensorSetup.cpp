#include "core/sensor/SensorSetup.h"

#include "core/base/Number.h"

namespace lubberline {

Result<MeridianField> fieldOf(const SensorSetup& setup)
{
    if (const auto* given = std::get_if<MeridianField>(&setup.field))
        return *given;
    if (const auto* total = std::get_if<TotalField>(&setup.field))
        return Error{ErrorCode::InvalidInput,
            {MARKED("core",
                 "of the field only its size is known (%1), not its dip: no deviation can be computed with it; expected H_nT with dip_deg, or a place and date, in \"field\""),
                figureText(total->total_nT, 0)}};
    const auto& [place, date] = std::get<PlaceAndDate>(setup.field);
    const auto year = decimalYear(date);
    if (!year)
        return year.error();
    const auto model = defaultFieldModel(*year);
    if (!model)
        return model.error();
    const auto answer = fieldForCompass(*model, place, *year);
    if (!answer)
        return answer.error();
    return answer->field.meridian();
}

} // namespace lubberline
