#pragma once
/// A moment, as ISO 8601 writes it.

#include <chrono>
#include <string_view>

#include "core/base/Result.h"

namespace lubberline {

using UtcTime = std::chrono::sys_time<std::chrono::milliseconds>;

/// "2026-06-21T11:30:00Z", "2026-06-21 11:30Z", "2026-06-21T13:30:00.5+02:00" (seconds may be left out). A time without Z or offset is
/// refused: an hour of daylight saving turns the sun by some 15°. Errors: InvalidInput.
Result<UtcTime> readUtcTime(std::string_view iso);
/// As records keep it: a moment of readUtcTime that is UTC and written so ("2026-06-21T11:30:00Z"), which sorts as a text.
[[nodiscard]] bool isUtcText(std::string_view iso);
/// Decimal days since 2000-01-01T12:00 UTC.
[[nodiscard]] double daysSince2000(UtcTime time);

} // namespace lubberline
