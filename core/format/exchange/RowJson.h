#pragma once
/// The short lists that a row of the database keeps as JSON. Their bytes are those of all versions so far (no spaces, no line end),
/// for a row is compared with what its reader knew of it.

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/Result.h"
#include "core/iron/FerrousPart.h"
#include "core/record/RawFigures.h"

namespace lubberline {

using ExtraColumns = std::vector<std::pair<std::string, std::string>>;

/// [["wind","calm"],["","7"]]: the columns of a reading that we do not know.
[[nodiscard]] std::string writeExtraRow(const ExtraColumns& extra);
/// Errors of these three: Format, InvalidInput (what should be a text or a figure is none).
Result<ExtraColumns> readExtraRow(std::string_view text);

/// [[316,317.5],[137],[]]: datum, astern, compass; an empty text where no figures were kept apart.
[[nodiscard]] std::string writeRawRow(const RawFigures& raw);
Result<RawFigures> readRawRow(std::string_view text);

/// {"gear":"extended"}.
[[nodiscard]] std::string writeStatesRow(const BenchStates& states);
Result<BenchStates> readStatesRow(std::string_view text);

} // namespace lubberline
