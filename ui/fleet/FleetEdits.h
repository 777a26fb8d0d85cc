#pragma once
/// Undoable: a type, an aircraft or a compass is made, or taken out with all that belongs to it.

#include "db/transfer/Removal.h"
#include "ui/kit/Edit.h"

namespace lubberline::ui {

/// Made: undone it goes with what was added to it since, which comes back when it is made again.
template <class Record, class RecordKey>
class MakeFleetRecord final : public Edit {
public:
    MakeFleetRecord(EditContext& context, Record record, const QString& text) : Edit(context, text), m_record(std::move(record)) {}
    [[nodiscard]] RecordKey made() const { return m_id; }
    [[nodiscard]] Destination seenAt() const override { return m_there ? Destination{{}, m_id} : Destination{}; }

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
    RemoveFleetRecord(EditContext& context, RecordKey id, const QString& text) : Edit(context, text), m_id(id) {}
    /// What holds it, or it itself where it is there.
    [[nodiscard]] Destination seenAt() const override { return m_there ? Destination{{}, m_id} : Destination{}; }

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
    db::Removed m_removed;
    bool m_there = true;
};

} // namespace lubberline::ui
