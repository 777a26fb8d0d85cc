#include "core/record/Fleet.h"

#include "core/record/DerivedId.h"

namespace lubberline {

namespace {

void fillIn(std::string& field, const std::string& value)
{
    if (field.empty())
        field = value;
}

/// Records that were never stored have no identity yet.
void fillInRecordIds(Fleet& fleet, const std::string& site)
{
    auto& aircraft = fleet.aircraft.front();
    auto& compass = fleet.compasses.front();
    fillIn(fleet.types.front().record, recordIdOfType(fleet.types.front().name));
    fillIn(aircraft.record, recordIdOfAircraft(aircraft.registration));
    fillIn(compass.record, recordIdOfCompass(aircraft.registration, compass.name));
    fillIn(fleet.swings.front().record, recordIdOfSwing(fleet.swings.front(), aircraft.registration, compass.name, site));
    for (auto& one : fleet.sites)
        fillIn(one.record, recordIdOfSite(one.name));
    for (auto& profile : fleet.limits)
        fillIn(profile.record, recordIdOfLimits(profile.name));
}

template <class Record, class IdType>
const Record* withId(const std::vector<Record>& records, IdType id)
{
    for (const Record& one : records)
        if (id.valid() && one.id == id)
            return &one;
    return nullptr;
}

} // namespace

SwingRecord recordIn(const Fleet& fleet, const Swing& swing)
{
    SwingRecord record;
    record.swing = swing;
    if (const auto* compass = withId(fleet.compasses, swing.compass))
        record.compass = *compass;
    if (const auto* aircraft = withId(fleet.aircraft, record.compass.aircraft))
        record.aircraft = *aircraft;
    if (const auto* type = withId(fleet.types, record.aircraft.type))
        record.type = *type;
    if (const auto* site = withId(fleet.sites, swing.site))
        record.site = *site;
    if (const auto* limits = withId(fleet.limits, record.compass.limits))
        record.limits = *limits;
    return record;
}

Fleet toFleet(const SwingRecord& record)
{
    Fleet fleet;
    fleet.types = {record.type};
    fleet.aircraft = {record.aircraft};
    fleet.compasses = {record.compass};
    fleet.swings = {record.swing};
    auto& swing = fleet.swings.front();
    fleet.types.front().id = AircraftTypeId{1};
    fleet.aircraft.front().id = AircraftId{1};
    fleet.aircraft.front().type = AircraftTypeId{1};
    fleet.aircraft.front().base = {};
    fleet.compasses.front().id = CompassId{1};
    fleet.compasses.front().aircraft = AircraftId{1};
    fleet.compasses.front().limits = {};
    swing.id = SwingId{1};
    swing.compass = CompassId{1};
    swing.site = {};
    for (auto& reading : swing.readings)
        reading.id = {};
    if (record.limits) {
        fleet.limits = {*record.limits};
        fleet.limits.front().id = fleet.compasses.front().limits = LimitsProfileId{1};
    }
    if (record.site) {
        fleet.sites = {*record.site};
        fleet.sites.front().id = swing.site = SiteId{1};
    }
    fillIn(fleet.types.front().name, "type not stated");                // names are what tells records apart
    fillIn(fleet.aircraft.front().registration, "aircraft not stated"); // a report of a nameless file must read back too
    fillIn(fleet.compasses.front().name, "compass not stated");
    fillInRecordIds(fleet, record.site ? record.site->name : std::string());
    return fleet;
}

} // namespace lubberline
