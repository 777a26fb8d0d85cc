#pragma once
/// Exchange JSON (`.lubberline.json`): aircraft with compasses, sensor models, swings, readings and events, whole. What is
/// written reads back equal, and is written again byte for byte the same. Raw readings only: results are recomputed by whoever
/// reads.

#include <string>
#include <string_view>

#include "core/base/Result.h"
#include "core/record/Fleet.h"

namespace lubberline {

/// The newest version. 2 has sensor models inside their compass and, in a swing, the field stamp and the index that was
/// removed. 3 has the ramp: instruments, due rules, waivers and causes of events, particulars of bases, a base of aircraft, and
/// in a swing times, signatures, revisions, raw figures and its guided swing (whose particulars are the swing's own). 4 has
/// signatures that say by which version of the signed content they were made. 5 has signatures by its version 3: with what they cover
/// besides the swing, the heads of the audit trail where they were given, and OpenPGP signatures. 6 has in a swing the errors that its
/// readings share. 7 has how sure a calibrated sensor model is, 8 coil benches.
inline constexpr int kExchangeVersion = 8;
/// The lowest version that can hold the fleet: what is written. A file says no more than it must, so that older programs read
/// what they can, and what was written (and hashed) before there was a version 2 is written the same.
[[nodiscard]] int exchangeVersionOf(const Fleet& fleet);

/// UTF-8, two spaces of indentation (a reading in one line), keys in a fixed order, records ordered by RecordId (readings by
/// their place), a newline at the end. What is not stated (no text, no value) is left out. Swings and sensor models stand
/// inside their compass, compasses and events inside their aircraft; type, site and limits are referred to by RecordId. The
/// fleet must hold what its records refer to, and every record must have its RecordId.
[[nodiscard]] std::string writeExchange(const Fleet& fleet);

/// Errors: Format (not JSON: line; not this format; a missing, doubled, unknown or wrong key: its path), NewerSchema (names the
/// version of the file and ours), InvalidInput (a value out of range: its path). `name` is the file named in errors.
Result<Fleet> readExchange(std::string_view text, const std::string& name);

} // namespace lubberline
