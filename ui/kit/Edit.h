#pragma once
/// The base of all undoable edits. An edit that storage refuses takes itself off the stack and reports the error: what the
/// stack says can be undone is exactly what is stored.

#include <QUndoCommand>

#include "ui/kit/EditContext.h"

namespace lubberline::ui {

class Edit : public QUndoCommand {
public:
    Edit(EditContext& context, const QString& text) : QUndoCommand(text), m_context(context) {}

    void redo() final { settle(apply()); }
    void undo() final { settle(revert()); }

    /// What the window shows before the edit is undone or redone.
    [[nodiscard]] virtual SwingId swing() const { return {}; }
    [[nodiscard]] virtual AircraftId aircraft() const { return {}; }
    [[nodiscard]] virtual CompassId sensorsOf() const { return {}; } ///< its sensor models

protected:
    virtual Result<void> apply() = 0;
    virtual Result<void> revert() = 0;
    [[nodiscard]] EditContext& context() const { return m_context; }
    [[nodiscard]] Storage& storage() const { return m_context.storage; }

private:
    void settle(const Result<void>& done)
    {
        if (done)
            return;
        setObsolete(true);
        m_context.failed(done.error());
    }

    EditContext& m_context;
};

} // namespace lubberline::ui
