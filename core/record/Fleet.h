#pragma once
/// Whole records together, by value: what the exchange file holds, what the demonstration makes, what a report needs.

#include <optional>
#include <string>
#include <vector>

#include "core/record/Aircraft.h"
#include "core/record/CoilBench.h"
#include "core/record/DueRule.h"
#include "core/record/ElectricalSwing.h"
#include "core/record/SensorRecord.h"
#include "core/record/Site.h"
#include "core/record/Swing.h"
#include "core/record/SwingJob.h"

namespace lubberline {

/// A guided swing with the swing that it belongs to; its particulars are those of that swing.
struct JobRecord {
    SwingId swing;
    SwingJob job;
    friend bool operator==(const JobRecord&, const JobRecord&) = default;
};

/// An electrical swing of a compass.
struct ElectricalRecord {
    CompassId compass;
    ElectricalSwing swing;
    friend bool operator==(const ElectricalRecord&, const ElectricalRecord&) = default;
};

/// A coil bench of a compass's sensor.
struct CoilRecord {
    CompassId compass;
    CoilBench bench;
    friend bool operator==(const CoilRecord&, const CoilRecord&) = default;
};

/// A self-contained part of a fleet. References between records are by the ids inside this struct, which are its own
/// (1, 2, 3 …): they say nothing about any database. Records are told apart across machines by their RecordId.
struct Fleet {
    std::vector<LimitsProfile> limits;
    std::vector<Site> sites;
    std::vector<AircraftType> types;
    std::vector<Aircraft> aircraft;
    std::vector<CompassSystem> compasses;
    std::vector<SensorRecord> sensors;
    std::vector<Event> events;
    std::vector<Swing> swings;
    std::vector<JobRecord> jobs;
    std::vector<ElectricalRecord> electrical;
    std::vector<CoilRecord> coilBenches;
    std::vector<Waiver> waivers; ///< each answers an event of this fleet
    std::vector<DatumInstrument> instruments;
    std::vector<DueRule> dueRules;
    friend bool operator==(const Fleet&, const Fleet&) = default;
};

/// One swing with everything that is printed beside it.
struct SwingRecord {
    Swing swing;
    CompassSystem compass;
    Aircraft aircraft;
    AircraftType type;
    std::optional<Site> site;
    std::optional<LimitsProfile> limits;
    friend bool operator==(const SwingRecord&, const SwingRecord&) = default;
};

/// The record as a fleet of one swing, ids renumbered: what the exchange writer and the hash take. Records that have no
/// RecordId yet get the one that is derived from their names (core/record/DerivedId.h); a type or compass without a name is
/// "not stated".
[[nodiscard]] Fleet toFleet(const SwingRecord& record);

/// A swing of the fleet with what it refers to there; what the fleet does not hold is empty.
[[nodiscard]] SwingRecord recordIn(const Fleet& fleet, const Swing& swing);

} // namespace lubberline
