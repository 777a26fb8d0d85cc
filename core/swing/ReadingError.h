#pragma once
/// What reading a compass by eye leaves uncertain.

namespace lubberline {

/// Standard uncertainty [rad] of one deviation whose compass was read to `compass_deg` and whose datum to `datum_deg`: each is
/// anywhere within half a division (uniform), so that its standard deviation is division/√12; the two are independent.
[[nodiscard]] double readingError_rad(double compass_deg, double datum_deg = 0);

} // namespace lubberline
