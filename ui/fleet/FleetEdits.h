#pragma once
/// Undoable: a type, an aircraft or a compass is made, or taken out with all that belongs to it.

#include "db/transfer/Removal.h"
#include "ui/kit/Edit.h"

namespace lubberline::ui {

/// What is shown when it is gone: that which it was part of.
[[nodiscard]] inline FleetItem holderOf(const AircraftType&) { return {}; }
[[nodiscard]] inline FleetItem holderOf(const Aircraft& aircraft) { return aircraft.type; }
[[nodiscard]] inline FleetItem holderOf(const CompassSystem& compass) { return compass.aircraft; }

[[nodiscard]] inline Destination placeOf(const FleetItem& item)
{
    return std::holds_alternative<std::monostate>(item) ? Destination{QStringLiteral("overview"), {}} : Destination{{}, item};
}

/// Made: undone it goes with what was added to it since, which comes back when it is made again.
template <class Record, class RecordKey>
class MakeFleetRecord final : public Edit {
public:
    MakeFleetRecord(EditContext& context, Record record, const QString& text) : Edit(context, text), m_record(std::move(record)) {}
    [[nodiscard]] RecordKey made() const { return m_id; }
    [[nodiscard]] Destination seenAt() const override { return placeOf(m_there ? FleetItem(m_id) : holderOf(m_record)); }

protected:
    Result<void> apply() override
    {
        if (!m_removed.empty()) {
            auto back = db::Removal(stores().database()).putBack(m_removed);
            m_there = back.ok();
            return back;
        }
        const auto added = stores().fleet.add(m_record);
        if (!added)
            return added.error();
        m_id = *added;
        m_there = true;
        return {};
    }
    Result<void> revert() override
    {
        auto removed = db::Removal(stores().database()).remove(m_id);
        if (!removed)
            return removed.error();
        m_removed = std::move(removed.value());
        m_there = false;
        return {};
    }

private:
    Record m_record;
    RecordKey m_id;
    db::Removed m_removed;
    bool m_there = false;
};

template <class RecordKey>
class RemoveFleetRecord final : public Edit {
public:
    /// @param holder what it is part of: shown while it is gone.
    RemoveFleetRecord(EditContext& context, RecordKey id, FleetItem holder, const QString& text)
        : Edit(context, text)
        , m_id(id)
        , m_holder(std::move(holder))
    {
    }
    [[nodiscard]] Destination seenAt() const override { return placeOf(m_there ? FleetItem(m_id) : m_holder); }

protected:
    Result<void> apply() override
    {
        auto removed = db::Removal(stores().database()).remove(m_id);
        if (!removed)
            return removed.error();
        m_removed = std::move(removed.value());
        m_there = false;
        return {};
    }
    Result<void> revert() override
    {
        auto back = db::Removal(stores().database()).putBack(m_removed);
        m_there = back.ok();
        return back;
    }

private:
    RecordKey m_id;
    FleetItem m_holder;
    db::Removed m_removed;
    bool m_there = true;
};

} // namespace lubberline::ui
