#include "ui/recovery/LostMerge.h"

namespace lubberline::ui {

namespace {

/// For each field that is typed; false from `each` ends it.
template <class Each>
bool forFields(Each each)
{
    return each(&Reading::nominal_deg) && each(&Reading::magnetic) && each(&Reading::compass) && each(&Reading::trueHeading)
        && each(&Reading::pitch_deg) && each(&Reading::roll_deg) && each(&Reading::note) && each(&Reading::exclusion);
}

/// Rows have numbers that a database gives out again: a row of another heading is another reading.
bool isAnother(const Reading& before, const Reading& kept, const Reading& now, const Reading* ours)
{
    const auto moved
        = [&](auto field) { return now.*field != before.*field && kept.*field == before.*field && !(ours && now.*field == ours->*field); };
    return moved(&Reading::nominal_deg) || moved(&Reading::magnetic);
}

} // namespace

bool says(const Reading& now, const Reading& before, const Reading& kept)
{
    return forFields([&](auto field) { return kept.*field == before.*field || kept.*field == now.*field; });
}

MergedReading mergedReading(const Reading& before, const Reading& kept, const Reading& now, const Reading* ours)
{
    MergedReading merged{now};
    const bool fits = !isAnother(before, kept, now, ours) && forFields([&](auto field) {
        if (kept.*field == before.*field || kept.*field == now.*field)
            return true; // not what was typed, or stored already
        if (now.*field != before.*field && !(ours && now.*field == ours->*field))
            return false;
        merged.reading.*field = kept.*field;
        return true;
    });
    // A figure is not taken over beside one that contradicts it: the row stays whole as it is stored.
    return fits ? merged : MergedReading{now, true};
}

} // namespace lubberline::ui
