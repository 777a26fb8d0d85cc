#pragma once
/// The undoable edit of a record that is found by its RecordId: an instrument, a rule, a base, an electrical swing.

#include <functional>
#include <optional>

#include "core/base/Contract.h"
#include "ui/kit/Edit.h"

namespace lubberline::ui {

/// How the stores take such a record.
template <class Record>
struct StoredBy {
    std::function<Result<void>(db::Stores& stores, const Record& record)> add;
    std::function<Result<void>(db::Stores& stores, const Record& known, const Record& wanted)> change;
    std::function<Result<void>(db::Stores& stores, const Record& record)> remove;
};

/// From `before` to `after`: a change where both are there, a record made or removed where one is. Both are one record.
template <class Record>
class StoredEdit final : public Edit {
public:
    StoredEdit(EditContext& context, StoredBy<Record> by, std::optional<Record> before, std::optional<Record> after, const QString& text,
        Destination seenAt)
        : Edit(context, text)
        , m_by(std::move(by))
        , m_before(std::move(before))
        , m_after(std::move(after))
        , m_seenAt(std::move(seenAt))
    {
        LUBBERLINE_EXPECT(m_before || m_after, "an edit is of a record");
    }
    [[nodiscard]] Destination seenAt() const override { return m_seenAt; }

protected:
    Result<void> apply() override { return store(m_before, m_after); }
    Result<void> revert() override { return store(m_after, m_before); }

private:
    Result<void> store(const std::optional<Record>& from, const std::optional<Record>& to)
    {
        if (from && to)
            return m_by.change(stores(), *from, *to);
        return to ? m_by.add(stores(), *to) : m_by.remove(stores(), *from);
    }

    StoredBy<Record> m_by;
    std::optional<Record> m_before, m_after;
    Destination m_seenAt;
};

} // namespace lubberline::ui
