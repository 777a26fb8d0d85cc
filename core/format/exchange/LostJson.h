#pragma once
/// What could not be stored, as a line of the recovery file: {"database", "file", "time_utc", "swing", "record", "subject", "place", "event"}
/// is a step of a guided swing, {…, "row", "reading_id", "before", "reading"} a reading.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "core/base/Result.h"
#include "core/record/Swing.h"
#include "core/record/SwingJob.h"

namespace lubberline {

/// A step of a guided swing, with how many steps were known.
struct LostStep {
    std::size_t place = 0;
    JobEvent event;
    friend bool operator==(const LostStep&, const LostStep&) = default;
};
/// A reading as it was to be, and as it was known then.
struct LostReading {
    int row = 0;
    Reading reading;
    ReadingId id = {};                  ///< not valid: a new row
    std::optional<Reading> before = {}; ///< none: a new row, or a line of an earlier program
    friend bool operator==(const LostReading&, const LostReading&) = default;
};

struct LostEntry {
    std::string database; ///< where it belongs: db::Stores::location()
    SwingId swing;
    RecordId record;     ///< of the swing: an id may be another swing's by then
    std::string subject; ///< whose swing it is, for people
    std::variant<LostStep, LostReading> what;
    std::string file = {};    ///< the identity of the database, however it is named; empty: of an earlier program
    std::string timeUtc = {}; ///< when it was to be stored; likewise
    friend bool operator==(const LostEntry&, const LostEntry&) = default;
};

[[nodiscard]] std::string writeLostEntry(const LostEntry& entry); ///< with its line end
/// Errors: Format, InvalidInput (a line that was cut short, too).
Result<LostEntry> readLostEntry(std::string_view line);

} // namespace lubberline
