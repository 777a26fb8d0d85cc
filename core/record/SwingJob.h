#pragma once
/// A guided swing as what happened, in order: events are only ever added, each on disk before the next, so that a job can be
/// taken up after a kill, next day, or on another machine. Where it stands is computed from them: JobState.h.

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/record/DatumInstrument.h"
#include "core/record/RawFigures.h"
#include "core/record/Swing.h"
#include "core/record/SwingPlan.h"

namespace lubberline {

namespace job {

struct Ticked {
    std::string item;
    bool done = true;
    bool operator==(const Ticked&) const = default;
};
/// Compass read with a load (engines, a circuit) off and on.
struct InterferenceRead {
    double heading_deg = 0;
    std::string load;
    double off_deg = 0, on_deg = 0;
    bool operator==(const InterferenceRead&) const = default;
};
struct Prepared {
    std::string note;
    bool operator==(const Prepared&) const = default;
};
struct ReadingTaken {
    int station = 0;
    RawFigures raw;
    double magnetic_deg = 0, compass_deg = 0; ///< the means, after the instrument's own corrections
    std::string note;
    bool operator==(const ReadingTaken&) const = default;
};
/// The station is read again, or after all where it was skipped; the reading that is put aside stays on the record.
struct ReadingRejected {
    int station = 0;
    std::string reason;
    bool operator==(const ReadingRejected&) const = default;
};
struct StationSkipped {
    int station = 0;
    std::string reason;
    bool operator==(const StationSkipped&) const = default;
};
/// A control was turned at a station. `target_deg` is what the compass was to be made to read.
struct Adjusted {
    int station = 0;
    Control control = Control::NorthSouth;
    double before_deg = 0, target_deg = 0, after_deg = 0;
    std::string note; ///< turns of the screw, magnets
    bool operator==(const Adjusted&) const = default;
};
/// The control was not turned, and why (no compensator, within limits, at its stop).
struct NotAdjusted {
    int station = 0;
    Control control = Control::NorthSouth;
    std::string reason;
    bool operator==(const NotAdjusted&) const = default;
};
/// After the check swing: A taken out by turning the compass in its mount, or left in.
struct IndexRemoved {
    double before_deg = 0, target_deg = 0, after_deg = 0;
    bool operator==(const IndexRemoved&) const = default;
};
struct IndexLeft {
    std::string reason;
    bool operator==(const IndexLeft&) const = default;
};
struct Accepted {
    std::string by;
    std::string note;
    bool operator==(const Accepted&) const = default;
}; ///< the review
struct Faulted {
    std::string cause;
    bool operator==(const Faulted&) const = default;
};
struct Mended {
    std::string action;
    bool operator==(const Mended&) const = default;
};
struct Abandoned {
    std::string reason;
    bool operator==(const Abandoned&) const = default;
};

/// The aircraft's heading is told by another instrument from here on.
struct DatumChanged {
    DatumInstrument datum;
    bool operator==(const DatumChanged&) const = default;
};

using What = std::variant<Ticked, InterferenceRead, Prepared, ReadingTaken, ReadingRejected, StationSkipped, Adjusted, NotAdjusted,
    IndexRemoved, IndexLeft, Accepted, Faulted, Mended, Abandoned, DatumChanged>;

} // namespace job

struct JobEvent {
    std::string timeUtc; ///< ISO 8601; the order is that of the list, so that a clock that is set back does no harm
    job::What what;
    friend bool operator==(const JobEvent&, const JobEvent&) = default;
};

/// What is typed into a field and not stored as a step yet.
struct TypedText {
    std::string field, text;
    friend bool operator==(const TypedText&, const TypedText&) = default;
};

struct SwingJob {
    RecordId record;
    PlanOptions plan;
    std::vector<std::string> checklist; ///< what has to be ticked before the first reading
    Swing particulars;                  ///< of the swing that it belongs to: site, date, datum, people, configuration; no readings
    DatumInstrument datum;              ///< as it was set when the job began
    double resolution_deg = 1.0;        ///< of the compass
    std::vector<JobEvent> events;
    friend bool operator==(const SwingJob&, const SwingJob&) = default;
};

} // namespace lubberline
