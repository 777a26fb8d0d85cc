#pragma once
/// Swings as the separation of iron and predictions take them.

#include <optional>

#include "core/base/Result.h"
#include "core/record/Fleet.h"
#include "core/record/SwingJob.h"
#include "core/swing/IronSeparation.h"

namespace lubberline {

/// D and E as the aircraft of a type have them (core/fleet/SoftIron.h), with what an aircraft of it may differ by: for a swing whose headings
/// do not tell one of them. Dimensionless, as in ExactSmith.
struct TypeSoftIron {
    std::optional<Estimate> D, E;
    Message words; ///< where they are from
};

/// The exact coefficients of a swing with their errors, in the field that it keeps (or that of its site and date, when it keeps
/// none). The label is the site's name and the date. Errors: InvalidInput: no field is known for it (says what to state); the
/// readings do not tell five coefficients.
/// @param job the guided swing that it came from, or none: its datum's division is in the errors (core/swing/SwingResult.h).
/// @param type takes the place of D (four cardinals) or E (four intercardinals), and SwingAtPlace::taken says so; none: that is an error.
Result<SwingAtPlace> swingAtPlace(const SwingRecord& record, const SwingJob* job = nullptr, const std::optional<TypeSoftIron>& type = {});
/// From a fit that was made. Errors: InvalidInput: it does not tell all five coefficients.
Result<SwingAtPlace> swingAtPlace(const ExactFit& fit, const MeridianField& field, const std::string& label);

} // namespace lubberline
