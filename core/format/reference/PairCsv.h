#pragma once
/// Two compasses read together: columns first_compass_deg and second_compass_deg, and magnetic_heading_deg where a datum told it; any
/// others are left alone. Lines that begin with # are comments. Comma, semicolon or tab; decimal comma where the separator is another.

#include <string>
#include <string_view>
#include <vector>

#include "core/base/Result.h"
#include "core/check/TwoCompasses.h"

namespace lubberline {

/// Rows without one of both headings are passed over. Errors: Format, InvalidInput, with the line.
Result<std::vector<PairReading>> readPairCsv(std::string_view text, const std::string& name);
/// Errors: also Io.
Result<std::vector<PairReading>> readPairCsvFile(const std::string& path);

} // namespace lubberline
