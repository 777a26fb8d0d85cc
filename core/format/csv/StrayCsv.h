#pragma once
/// Stray field around a source: `x_m, y_m, z_m, bx_nT, by_nT, bz_nT`, a reading a row.

#include <istream>
#include <string>
#include <vector>

#include "core/calibration/DipoleSource.h"

namespace lubberline {

/// Errors: Format, InvalidInput with the line (a column or a figure that is missing), Io. "-": standard input.
Result<std::vector<StrayReading>> readStrayCsv(std::istream& input, const std::string& name);
Result<std::vector<StrayReading>> readStrayCsvFile(const std::string& path);

} // namespace lubberline
