#include "core/format/csv/SwingCsv.h"

#include "core/record/DerivedId.h"
#include "core/swing/SwingResult.h"

namespace lubberline {

namespace {

/// The compass base that the file names, with what it states of its place; none when it names none.
std::optional<Site> siteOf(const SwingFile& file)
{
    if (file.site.empty())
        return {};
    Site site;
    site.name = file.site;
    site.latitude_deg = file.latitude_deg;
    if (file.longitude_deg)
        site.longitude_deg = wrap180(*file.longitude_deg);
    site.elevation_m = file.height_m;
    return site;
}

} // namespace

SwingRecord recordOf(SwingFile file)
{
    SwingRecord record;
    record.aircraft.registration = file.aircraft;
    record.aircraft.operatorName = file.operatorName;
    record.type.name = file.type;
    record.compass.name = file.compass;
    record.compass.kind = CompassKind::NotStated;
    record.compass.resolution_deg = divisionOf_deg(file.swing);
    record.compass.resolutionStated = false;
    record.site = siteOf(file);
    record.swing = std::move(file.swing);
    return record;
}

Result<Fleet> toFleet(const SwingFile& file)
{
    if (file.aircraft.empty())
        return Error{ErrorCode::InvalidInput,
            MARKED("core", "the aircraft is not named; expected a line \"# aircraft: REGISTRATION\", or its registration beside the file")};
    SwingRecord record = recordOf(file);
    // The names may have been filled in since the file was read: the same readings of two aircraft are two swings.
    record.swing.record.clear();
    return toFleet(record);
}

} // namespace lubberline
