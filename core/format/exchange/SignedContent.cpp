#include "core/format/exchange/SignedContent.h"

#include "core/format/exchange/Exchange.h"

namespace lubberline {

std::string signedContent(const SwingRecord& record, const std::optional<SwingJob>& job, int version)
{
    SwingRecord bare;
    bare.swing = record.swing;
    bare.swing.state = SwingState::Draft;
    bare.swing.signatures.clear();
    bare.type.record = bare.type.name = record.type.record;
    bare.aircraft.record = bare.aircraft.registration = record.aircraft.record;
    bare.compass.record = bare.compass.name = record.compass.record;
    if (record.site) {
        bare.site.emplace();
        bare.site->record = bare.site->name = record.site->record;
    }
    Fleet fleet = toFleet(bare);
    if (job) {
        fleet.jobs = {{fleet.swings.front().id, *job}};
        fleet.jobs.front().job.particulars = {};
    }
    const std::string text = writeExchange(fleet);
    return version == 1 ? text : "lubberline signed content " + std::to_string(version) + "\n" + text;
}

} // namespace lubberline
