#include "core/procedure/LoadNotes.h"

#include <algorithm>
#include <cmath>

namespace lubberline {

std::vector<LoadNote> loadsPast(const SwingJob& job, const Analysis& analysis, double limit_deg)
{
    std::vector<LoadNote> notes;
    if (!analysis.exact.fitted())
        return notes;
    for (const auto& event : job.events) {
        const auto* read = std::get_if<job::InterferenceRead>(&event.what);
        if (!read)
            continue;
        const double without_deg = deviationAt(analysis.exact, MagneticHeading::fromDegrees(read->heading_deg)).degrees();
        const LoadNote note{read->load, read->heading_deg, wrap180(without_deg - (read->on_deg - read->off_deg))};
        if (std::abs(note.deviation_deg) <= limit_deg)
            continue;
        const auto known = std::find_if(notes.begin(), notes.end(), [&](const LoadNote& other) { return other.load == note.load; });
        if (known == notes.end())
            notes.push_back(note);
        else if (std::abs(note.deviation_deg) > std::abs(known->deviation_deg))
            *known = note;
    }
    return notes;
}

} // namespace lubberline
