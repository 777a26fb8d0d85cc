#include "core/swing/ReadingError.h"

#include <cmath>

#include "core/angle/Angle.h"

namespace lubberline {

double readingError_rad(double compass_deg, double datum_deg) { return toRadians(std::hypot(compass_deg, datum_deg) / std::sqrt(12.0)); }

} // namespace lubberline
