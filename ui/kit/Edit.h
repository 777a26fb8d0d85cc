#pragma once
/// The base of all undoable edits. An edit that the stores refuse takes itself off the stack and reports the error: what the
/// stack says can be undone is exactly what is stored.

#include <QUndoCommand>

#include "ui/kit/Destination.h"
#include "ui/kit/EditContext.h"

namespace lubberline::ui {

class Edit : public QUndoCommand {
public:
    Edit(EditContext& context, const QString& text) : QUndoCommand(text), m_context(context) {}

    void redo() final
    {
        settle([this] { return apply(); });
    }
    void undo() final
    {
        settle([this] { return revert(); });
    }

    /// What the window shows before the edit is undone or redone.
    [[nodiscard]] virtual SwingId swing() const { return {}; }
    [[nodiscard]] virtual AircraftId aircraft() const { return {}; }
    [[nodiscard]] virtual CompassId sensorsOf() const { return {}; } ///< its sensor models
    /// Where that is seen; no page and no record: nowhere.
    [[nodiscard]] virtual Destination seenAt() const
    {
        if (sensorsOf().valid())
            return {QStringLiteral("sensor"), sensorsOf()};
        if (swing().valid())
            return {{}, swing()};
        return aircraft().valid() ? Destination{{}, aircraft()} : Destination{};
    }

protected:
    virtual Result<void> apply() = 0;
    virtual Result<void> revert() = 0;
    [[nodiscard]] EditContext& context() const { return m_context; }
    [[nodiscard]] db::Stores& stores() const { return m_context.stores; }

private:
    /// Whole or not at all: what an edit stores is one transaction, and which record is which is known as before when it fails.
    template <class Store>
    void settle(Store store)
    {
        const auto readings = m_context.readings;
        const auto swings = m_context.swings;
        const auto done = inOneTransaction(store);
        if (done)
            return;
        m_context.readings = readings;
        m_context.swings = swings;
        setObsolete(true);
        m_context.failed(done.error());
    }

    template <class Store>
    Result<void> inOneTransaction(Store store)
    {
        auto transaction = stores().begin();
        if (!transaction)
            return transaction.error();
        if (auto stored = store(); !stored)
            return stored;
        return transaction->commit();
    }

    EditContext& m_context;
};

} // namespace lubberline::ui
