#include "db/engine/Changes.h"

#include <algorithm>
#include <utility>

#include "core/base/Cases.h"

namespace lubberline::db {

void Changes::note(const Change& change)
{
    if (const auto* swing = std::get_if<change::OfSwing>(&change))
        for (Change& earlier : m_noted)
            if (auto* same = std::get_if<change::OfSwing>(&earlier); same && same->id == swing->id) {
                if (same->only != swing->only)
                    same->only = {};
                return;
            }
    if (std::find(m_noted.begin(), m_noted.end(), change) == m_noted.end())
        m_noted.push_back(change);
}

void Changes::ended(bool committed)
{
    // Who is told may store something in turn: that is a transaction of its own.
    const auto noted = std::exchange(m_noted, {});
    if (committed)
        for (const Change& change : noted)
            tell(change);
}

void Changes::tell(const Change& change)
{
    std::visit(Cases{[this](change::Fleet) { emit fleetChanged(); }, [this](change::OfAircraft one) { emit aircraftChanged(one.id); },
                   [this](change::OfSwing one) { emit swingChanged(one.id, one.only); },
                   [this](change::Sensors one) { emit sensorsChanged(one.of); }, [this](change::Sites) { emit sitesChanged(); },
                   [this](change::Due) { emit dueChanged(); }, [this](change::Electrical one) { emit electricalChanged(one.of); }},
        change);
}

} // namespace lubberline::db
