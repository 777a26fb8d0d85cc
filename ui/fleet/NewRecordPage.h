#pragma once
/// Asks for what a new type, aircraft or compass must have; the rest is filled in on its own page.

#include "core/record/FleetRows.h"
#include "ui/kit/Page.h"
#include "ui/kit/PageContext.h"
#include "ui/kit/PageDescription.h"

class QComboBox;
class QFormLayout;
class QLineEdit;

namespace lubberline::ui {

class NewRecordPage : public Page {
    Q_OBJECT

public:
    enum class Kind { Type, Aircraft, Compass };
    NewRecordPage(PageContext& context, Kind kind, QWidget* parent = nullptr);

    static PageDescription description(PageContext& context, Kind kind);
    Result<void> open(const FleetItem& record) override;

private:
    void build(QFormLayout& form);
    void fill(const FleetItem& shown);
    void make();
    template <class Id, class Record>
    void store(Record record, const QString& text);

    PageContext& m_context;
    Kind m_kind;
    QComboBox *m_owner, *m_limits; ///< the type of an aircraft, the aircraft of a compass
    QLineEdit *m_name, *m_maker;
    std::vector<std::int64_t> m_owners;
    std::vector<LimitsProfile> m_profiles;
};

/// Taking out what has nothing signed.
[[nodiscard]] std::vector<Command> removalCommands(PageContext& context);

} // namespace lubberline::ui
