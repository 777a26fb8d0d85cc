#pragma once
/// Lines of lists and of the fleet tree: what storage answers quickly, without readings.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/Date.h"
#include "core/record/Aircraft.h"
#include "core/record/DueRule.h"
#include "core/record/Id.h"
#include "core/record/Status.h"
#include "core/record/Swing.h"

namespace lubberline {

struct TypeRow {
    AircraftTypeId id;
    std::string name;
    int aircraft = 0;
    Status status = Status::NotKnown;
};

struct AircraftRow {
    AircraftId id;
    AircraftTypeId type;
    std::string registration;
    bool demonstration = false;
    Status status = Status::NotKnown;
};

struct CompassRow {
    CompassId id;
    AircraftId aircraft;
    std::string name;
    int swings = 0;
    Status status = Status::NotKnown;
};

/// The results here are a cache that storage keeps beside the readings and that `db verify` recomputes.
struct SwingRow {
    SwingId id;
    CompassId compass;
    Date date;
    SwingKind kind = SwingKind::Check;
    SwingStage stage = SwingStage::AsFound;
    SwingState state = SwingState::Draft;
    int readings = 0;
    std::optional<double> maxAbsDeviation_deg;                 ///< none while the readings do not allow a result
    std::array<std::optional<double>, 5> coefficient_deg = {}; ///< approximate A…E
    Status status = Status::NotKnown;
    int revision = 1;
    bool superseded = false; ///< a later revision amends it
    bool guided = false;     ///< its guided swing is not finished
    bool abandoned = false;  ///< or it was abandoned
};

/// A guided swing that can be taken up.
struct JobRow {
    SwingId swing;
    RecordId job;
    std::string registration, compass;
    Date date; ///< of the swing
    int events = 0;
};

/// A swing with its names, where those of several compasses stand in one list.
struct NewestSwing {
    SwingRow row;
    std::string registration, compass;
};

struct AuditRow {
    std::string timeUtc;
    std::string what; ///< "changed reading"
    std::string detail;
};

/// What a swing that is at least complete says of its compass against its limits.
struct LimitsFinding {
    Date date;
    SwingStage stage = SwingStage::AsFound;
    bool isSigned = false;
    Status status = Status::NotKnown;
    std::optional<double> maxAbsDeviation_deg;
};

/// What the due rules look at, for one compass system.
struct DueCompass {
    AircraftTypeId type;
    AircraftId aircraft;
    CompassId compass;
    RecordId typeRecord, compassRecord;
    std::string typeName, registration, compassName;
    Date installed;                           ///< empty: not stated
    SiteId base;                              ///< of the aircraft
    std::vector<Date> signedSwings;           ///< the day of the newest one that counts as signed
    std::vector<Event> events;                ///< of the aircraft
    std::vector<Waiver> waivers;              ///< that answer those
    std::vector<LimitsFinding> findings = {}; ///< of those that no signed revision amends, newest first, down to what decides
    std::optional<double> limit_deg = {};     ///< the largest deviation that is allowed; none: no limit is set
    std::string limitDocument = {};
};

struct SearchHit {
    std::string text;
    AircraftId aircraft;
    CompassId compass; ///< not valid: the hit is the aircraft
    SwingId swing;     ///< not valid: the hit is the compass or the aircraft
};

struct Totals {
    int types = 0, aircraft = 0, compasses = 0;
    std::int64_t swings = 0;
};

} // namespace lubberline
