#pragma once
/// The datum instruments, and what their figures mean, with an example that makes a wrong setting obvious.

#include <functional>
#include <optional>

#include "ui/kit/EditContext.h"
#include "ui/kit/FormField.h"
#include "ui/kit/Page.h"

class QLabel;
class QListWidget;
class QPushButton;
class QUndoStack;

namespace lubberline::ui {

/// What the instrument's setting makes of a figure: "It reads 358 from ahead: the aircraft heads 178 magnetic."
[[nodiscard]] QString datumExample(const DatumInstrument& instrument);

class InstrumentsPage : public Page {
    Q_OBJECT

public:
    /// @param today UTC.
    InstrumentsPage(EditContext& context, QUndoStack& undo, std::function<Date()> today, QWidget* parent = nullptr);
    void reload();

    static PageDescription description(PageContext& context);
    Result<void> open(const FleetItem& record) override;
    [[nodiscard]] bool isOf(const FleetItem&) const override { return true; }

private:
    void build();
    void showInstrument();
    void add();
    void remove();
    /// Made, changed or removed, so that it can be undone.
    void edit(std::optional<DatumInstrument> before, std::optional<DatumInstrument> after, const QString& text);

    EditContext& m_context;
    db::Stores& m_stores;
    QUndoStack& m_undo;
    std::function<Date()> m_today;
    std::vector<DatumInstrument> m_instruments;
    FormFields<DatumInstrument> m_fields;
    QListWidget* m_list;
    QPushButton *m_add, *m_remove;
    QLabel *m_example, *m_state;
};

} // namespace lubberline::ui
