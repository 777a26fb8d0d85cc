#pragma once
/// Swings as the separation of iron and predictions take them.

#include "core/base/Result.h"
#include "core/record/Fleet.h"
#include "core/record/SwingJob.h"
#include "core/swing/IronSeparation.h"

namespace lubberline {

/// The exact coefficients of a swing with their errors, in the field that it keeps (or that of its site and date, when it keeps
/// none). The label is the site's name and the date. Errors: InvalidInput: no field is known for it (says what to state); the
/// readings do not tell five coefficients.
/// @param job the guided swing that it came from, or none: its datum's division is in the errors (core/swing/SwingResult.h).
Result<SwingAtPlace> swingAtPlace(const SwingRecord& record, const SwingJob* job = nullptr);
/// From a fit that was made. Errors: InvalidInput: it does not tell all five coefficients.
Result<SwingAtPlace> swingAtPlace(const ExactFit& fit, const MeridianField& field, const std::string& label);

} // namespace lubberline
