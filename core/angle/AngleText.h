#pragma once
/// Angles as people type and read them.

#include <string>
#include <string_view>

#include "core/angle/Heading.h"
#include "core/base/Result.h"

namespace lubberline {

/// How angles are shown.
enum class AngleStyle { DecimalDegrees, DegreesMinutes };

/// Reads a signed angle [deg, east positive]: `3.25`, `-3.25`, `+3.25`, `3.25W`, `3.25 E`, `W 3.25`, `3.25 west`, `3°15'W`, `3 15 W`,
/// `3:15W`, `3°15'30"W`, `−3,25` (decimal comma, Unicode minus). W makes negative; a sign together with E or W is an error, as are
/// minutes ≥ 60, and minutes of one digit behind a space alone (`8 4` may be 84). Any space of core/base/FileText.h may stand between the parts.
/// @return degrees within [−180, 180]. Errors: InvalidInput, naming the text (what cannot be seen in it by its code point) and what was
/// expected; an O, which is east in German and west in French, is refused by that reason.
Result<double> parseSignedAngle_deg(std::string_view text);
/// The same without letters, for what is neither east nor west. @return degrees within [−most_deg, most_deg].
Result<double> parsePlainAngle_deg(std::string_view text, double most_deg);
/// The same with N and S, north positive. @return degrees within [−90, 90].
Result<double> parseLatitude_deg(std::string_view text);

/// From which north a heading was said to be.
enum class North { NotSaid, True, Magnetic, Compass };

struct WrittenHeading {
    double heading_deg = 0; ///< [0, 360)
    North north = North::NotSaid;
    bool fullTurn = false; ///< written as 360
};

/// Reads a heading: `7`, `007.5`, `7,5`, `7°30'`, `7 30`, `360` (= 0); a point of the compass, `NE`, `SSW`, `NbE`, `N by E`; a bearing from
/// north or south, `N 45 E`, `S12°30'W`; with T, M or C behind it when it is said to be true, magnetic or of the compass, `274°T`.
/// Errors: InvalidInput (not a number, < 0, > 360; figures with W or E alone).
Result<WrittenHeading> parseWrittenHeading(std::string_view text);
/// The same where only one north can be meant: another one that is said is an error. @return degrees within [0, 360).
Result<double> parseHeading_deg(std::string_view text, North meant = North::NotSaid);

/// "047.5°" or "047°30'"; `decimals` apply to the decimal style. Never "360.0": rounding up at north gives 000.0.
std::string formatHeading(double heading_deg, AngleStyle style = AngleStyle::DecimalDegrees, int decimals = 1);

/// "+3.25°" or "3°15'E"; U+2212 for minus in the decimal style; zero has no sign.
std::string formatSignedAngle(double angle_deg, AngleStyle style = AngleStyle::DecimalDegrees, int decimals = 1);

} // namespace lubberline
