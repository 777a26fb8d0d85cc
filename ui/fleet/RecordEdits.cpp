#include "ui/fleet/RecordEdits.h"

#include "core/base/Contract.h"
#include "core/procedure/JobState.h"
#include "ui/kit/OpenSwings.h"

namespace lubberline::ui {

ChangeSwing::ChangeSwing(EditContext& context, Swing before, Swing after, const QString& text)
    : Edit(context, text)
    , m_before(std::move(before))
    , m_after(std::move(after))
{
    LUBBERLINE_EXPECT(m_before.readings.size() == m_after.readings.size(), "particulars change no rows");
}

Result<void> ChangeSwing::store(const Swing& from, const Swing& to) const
{
    Swing known = from, particulars = to;
    known.id = particulars.id = swing();
    if (auto stored = stores().swings.change(known, particulars); !stored)
        return stored;
    for (std::size_t row = 0; row < to.readings.size(); ++row) {
        if (to.readings[row] == from.readings[row])
            continue;
        Reading before = from.readings[row], reading = to.readings[row];
        before.id = reading.id = context().readings.current(reading.id);
        if (auto stored = stores().swings.changeReading(particulars.id, before, reading); !stored)
            return stored;
    }
    return {};
}

MakeSwing::MakeSwing(EditContext& context, Swing swing, Direction direction, const QString& text)
    : Edit(context, text)
    , m_swing(std::move(swing))
    , m_direction(direction)
    , m_exists(direction == Direction::Remove)
{
}

Result<void> MakeSwing::make()
{
    const SwingId before = context().swings.current(m_swing.id);
    Swing whole = m_swing;
    whole.id = {};
    const auto stored = stores().swings.add(whole);
    if (!stored)
        return stored.error();
    m_exists = true;
    if (auto made = makeGuided(*stored); !made)
        return made;
    const auto record = stores().swings.record(*stored);
    if (!record)
        return record.error();
    if (before.valid())
        context().swings.replace(before, *stored);
    for (std::size_t row = 0; row < m_swing.readings.size(); ++row)
        context().readings.replace(context().readings.current(m_swing.readings[row].id), record->swing.readings.at(row).id);
    m_swing = record->swing;
    return {};
}

Result<std::optional<MakeSwing::Guided>> MakeSwing::guided(SwingId id) const
{
    auto found = stores().jobs.jobOf(id);
    if (!found)
        return found.error();
    if (!*found || (*found)->swing != id)
        return std::optional<Guided>();
    auto typed = stores().jobs.typed(id);
    if (!typed)
        return typed.error();
    const auto state = stateOf((*found)->job);
    return std::optional(
        Guided{std::move((*found)->job), isOpenJob(stores(), id), state && state->phase == JobPhase::Abandoned, std::move(typed.value())});
}

Result<void> MakeSwing::makeGuided(SwingId id) const
{
    if (!m_guided)
        return {};
    auto& jobs = stores().jobs;
    const bool finished = !m_guided->open && !m_guided->abandoned;
    if (const auto added = jobs.add(id, m_guided->job, finished); !added)
        return added.error();
    if (!m_guided->open && m_guided->abandoned)
        return jobs.abandon(id);
    return m_guided->open ? jobs.keepTyped(id, m_guided->job.events.size(), m_guided->typed) : Result<void>();
}

Result<void> MakeSwing::remove()
{
    const SwingId id = swing();
    // What was entered since it was made comes back with it.
    const auto record = stores().swings.record(id);
    if (!record)
        return record.error();
    auto job = guided(id);
    if (!job)
        return job.error();
    if (auto removed = stores().swings.remove(id); !removed)
        return removed;
    m_swing = record->swing;
    m_guided = std::move(job.value());
    m_exists = false;
    return {};
}

} // namespace lubberline::ui
