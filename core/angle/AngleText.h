#pragma once
/// Angles as people type and read them.

#include <string>
#include <string_view>

#include "core/angle/Heading.h"
#include "core/base/Result.h"

namespace lubberline {

/// How angles are shown.
enum class AngleStyle { DecimalDegrees, DegreesMinutes };

/// Reads a signed angle [deg, east positive]: `3.25`, `-3.25`, `+3.25`, `3.25W`, `3.25 E`, `3°15'W`, `3 15 W`, `3:15W`,
/// `−3,25` (decimal comma, Unicode minus). W makes negative; a sign together with E or W is an error, as are minutes ≥ 60.
/// @return degrees within [−180, 180]. Errors: InvalidInput, naming the text and what was expected.
Result<double> parseSignedAngle_deg(std::string_view text);

/// Reads a heading: `7`, `007.5`, `7,5`, `7°30'`, `7 30`, `360` (= 0). Errors: InvalidInput (not a number, < 0, > 360, W or E).
/// @return degrees within [0, 360).
Result<double> parseHeading_deg(std::string_view text);

/// "047.5°" or "047°30'"; `decimals` apply to the decimal style. Never "360.0": rounding up at north gives 000.0.
std::string formatHeading(double heading_deg, AngleStyle style = AngleStyle::DecimalDegrees, int decimals = 1);

/// "+3.25°" or "3°15'E"; U+2212 for minus in the decimal style; zero has no sign.
std::string formatSignedAngle(double angle_deg, AngleStyle style = AngleStyle::DecimalDegrees, int decimals = 1);

} // namespace lubberline
