#pragma once
/// Places as people type and read them.

#include <QString>

#include "core/base/Result.h"
#include "core/earth/EarthField.h"

namespace lubberline::ui {

/// `51.55`, `-33.9`, `51,55 N`, `51°33'N`, `33 54 S`. Errors: InvalidInput (W or E; beyond 90; not an angle).
Result<double> parseLatitude_deg(const QString& text);
/// `21.89`, `340` (wrapped when the place is made), `21°53'E`, `70 40 W`. Errors: InvalidInput (N or S; not an angle).
Result<double> parseLongitude_deg(const QString& text);
/// Height above the ellipsoid in metres, decimal point or comma; empty is 0. Errors: InvalidInput.
Result<double> parseHeight_m(const QString& text);

/// "51.55° N 21.89° E".
[[nodiscard]] QString placeText(const Place& place);
/// For a line of a form, four decimals at most: "51.55 N", "21.89 E", read back by the above.
[[nodiscard]] QString latitudeToType(double latitude_deg);
[[nodiscard]] QString longitudeToType(double longitude_deg);

} // namespace lubberline::ui
