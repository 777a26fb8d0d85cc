#pragma once
/// The rules on when a swing is due, and who answered for not swinging; what follows from them: core/due/DueRules.h.

#include <string>

#include "core/base/Date.h"
#include "core/record/Id.h"

namespace lubberline {

/// A calendar rule: data with a named source, never a constant. An aircraft type's own rule goes before one for all.
struct DueRule {
    RecordId record;
    std::string name;  ///< unique
    int months = 24;   ///< after the last signed swing
    int graceDays = 0; ///< overdue only after these
    int warnDays = 30; ///< "due soon" before
    std::string document, issue;
    RecordId type; ///< of the aircraft type it is for; empty: all
    friend bool operator==(const DueRule&, const DueRule&) = default;
};

/// Somebody answers for not swinging after an event (after lightning: two headings 90° apart show no change [CASA]).
struct Waiver {
    RecordId record;
    RecordId event; ///< that it answers
    Date date;
    std::string reason; ///< never empty
    std::string by;     ///< never empty
    friend bool operator==(const Waiver&, const Waiver&) = default;
};

} // namespace lubberline
