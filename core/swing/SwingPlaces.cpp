#include "core/swing/SwingPlaces.h"

#include "core/swing/SwingField.h"
#include "core/swing/SwingResult.h"

namespace lubberline {

namespace {

/// The one of D and E that four headings leave open, taken from the type.
std::optional<SwingAtPlace> withTypes(const ExactFit& fit, const MeridianField& field, const std::string& label, const TypeSoftIron& type)
{
    if (fit.parameters != static_cast<int>(kCoefficientCount) - 1)
        return {};
    const bool openD = !fit.of(Coefficient::D);
    const auto& taken = openD ? type.D : type.E;
    if (!taken || (!openD && fit.of(Coefficient::E)))
        return {};
    ExactFit whole = fit;
    const std::size_t open = indexOf(openD ? Coefficient::D : Coefficient::E);
    whole.parameters = static_cast<int>(kCoefficientCount);
    whole.value[open] = taken->value;
    whole.standardError[open] = taken->standardError;
    whole.covariance(static_cast<Eigen::Index>(open), static_cast<Eigen::Index>(open)) = taken->standardError * taken->standardError;
    auto swing = swingAtPlace(whole, field, label);
    if (!swing)
        return {};
    swing->taken = {MARKED("core", "the headings of %1 do not tell %2: its type's is taken (%3)"), label, openD ? 'D' : 'E', type.words};
    return std::move(swing.value());
}

} // namespace

Result<SwingAtPlace> swingAtPlace(const SwingRecord& record, const SwingJob* job, const std::optional<TypeSoftIron>& type)
{
    const std::string label = (record.site ? record.site->name + ", " : std::string()) + record.swing.date.text();
    const auto stamp = record.swing.field ? record.swing.field : stampFor(record.swing, record.site);
    if (!stamp)
        return Error{ErrorCode::InvalidInput,
            {MARKED("core",
                 "the Earth's field of the swing of %1 is not known; expected a site with latitude and longitude, and a date within the magnetic models"),
                label}};
    const auto result = resultOf(record, job, {.maxOrder = 0, .findSlips = false}); // neither harmonics nor slips are asked for
    if (!result)
        return result.error();
    if (type)
        if (auto swing = withTypes(result->exact, stamp->field.meridian(), label, *type))
            return std::move(*swing);
    return swingAtPlace(result->exact, stamp->field.meridian(), label);
}

Result<SwingAtPlace> swingAtPlace(const ExactFit& fit, const MeridianField& field, const std::string& label)
{
    if (fit.parameters != static_cast<int>(kCoefficientCount))
        return Error{ErrorCode::InvalidInput,
            {MARKED("core",
                 "the readings of the swing of %1 do not tell all five coefficients; expected five headings at least, round the compass"),
                label}};
    const auto error = [&fit](Coefficient which) { return fit.standardError[indexOf(which)].value_or(0.0); };
    return SwingAtPlace{fit.smith(),
        {error(Coefficient::A), error(Coefficient::B), error(Coefficient::C), error(Coefficient::D), error(Coefficient::E)}, field, label,
        fit.degreesOfFreedom, fit.covariance, fit.index_rad};
}

} // namespace lubberline
