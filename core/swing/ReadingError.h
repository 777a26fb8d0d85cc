#pragma once

#include "core/swing/Analysis.h"

namespace lubberline {

/// Standard uncertainty [rad] of one deviation whose compass was read to `compass_deg` and whose datum to `datum_deg`: each is
/// anywhere within half a division (uniform), so that its standard deviation is division/√12; the two are independent.
[[nodiscard]] double readingError_rad(double compass_deg, double datum_deg = 0);

/// A fit cannot be surer than its readings: where they scatter less than `error_rad` (a few whole degrees that happen to lie on
/// a curve), covariances and standard errors of both fits are those of readings with that error. The scatter itself
/// (sigma_rad), residuals and what is suspect stay as they were found.
void widenToReadings(Analysis& analysis, double error_rad);

} // namespace lubberline
