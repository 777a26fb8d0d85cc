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

/// A record that is there or gone with all that belongs to it, as one knows it to put it back.
template <class RecordKey>
class FleetRecordEdit : public Edit {
public:
    [[nodiscard]] Destination seenAt() const override { return placeOf(m_there ? FleetItem(m_id) : m_holder); }

protected:
    /// @param id not valid: it is not there yet. @param holder what it is part of: shown while it is gone.
    FleetRecordEdit(EditContext& context, RecordKey id, FleetItem holder, const QString& text)
        : Edit(context, text)
        , m_id(id)
        , m_holder(std::move(holder))
        , m_there(id.valid())
    {
    }
    [[nodiscard]] RecordKey whose() const { return m_id; }
    [[nodiscard]] bool wasTakenOut() const { return !m_removed.empty(); }
    void isMade(RecordKey id)
    {
        m_id = id;
        m_there = true;
    }
    Result<void> takeOut()
    {
        auto removed = db::Removal(this->stores().database()).remove(m_id);
        if (!removed)
            return removed.error();
        m_removed = std::move(removed.value());
        m_there = false;
        return {};
    }
    Result<void> putBack()
    {
        auto back = db::Removal(this->stores().database()).putBack(m_removed);
        m_there = back.ok();
        return back;
    }

private:
    RecordKey m_id;
    FleetItem m_holder;
    db::Removed m_removed;
    bool m_there;
};

/// Made: undone it goes with what was added to it since, which comes back when it is made again.
template <class Record, class RecordKey>
class MakeFleetRecord final : public FleetRecordEdit<RecordKey> {
public:
    MakeFleetRecord(EditContext& context, Record record, const QString& text)
        : FleetRecordEdit<RecordKey>(context, {}, holderOf(record), text)
        , m_record(std::move(record))
    {
    }
    [[nodiscard]] RecordKey made() const { return this->whose(); }

protected:
    Result<void> apply() override
    {
        if (this->wasTakenOut())
            return this->putBack();
        const auto added = this->stores().fleet.add(m_record);
        if (!added)
            return added.error();
        this->isMade(*added);
        return {};
    }
    Result<void> revert() override { return this->takeOut(); }

private:
    Record m_record;
};

template <class RecordKey>
class RemoveFleetRecord final : public FleetRecordEdit<RecordKey> {
public:
    RemoveFleetRecord(EditContext& context, RecordKey id, FleetItem holder, const QString& text)
        : FleetRecordEdit<RecordKey>(context, id, std::move(holder), text)
    {
    }

protected:
    Result<void> apply() override { return this->takeOut(); }
    Result<void> revert() override { return this->putBack(); }
};

} // namespace lubberline::ui
