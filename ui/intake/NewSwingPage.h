#pragma once
/// Asks for what a swing must have before its first reading: the aircraft and its compass, picked or typed anew.

#include <functional>

#include "core/record/FleetRows.h"
#include "ui/kit/EditContext.h"
#include "ui/kit/Page.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QUndoStack;

namespace lubberline::ui {

class NewSwingPage : public Page {
    Q_OBJECT

public:
    NewSwingPage(EditContext& context, QUndoStack& stack, QWidget* parent = nullptr);

    /// Opens with what the window shows already chosen; a compass or aircraft that is not valid is left open.
    void begin(AircraftId aircraft, CompassId compass);
    /// The base that it begins with from now on; one that is not there is none.
    void setUsualSite(std::function<RecordId()> record) { m_usualSite = std::move(record); }

    static PageDescription description(PageContext& context);
    Result<void> open(const FleetItem& record) override;

protected:
    bool eventFilter(QObject* object, QEvent* event) override;

signals:
    void created(lubberline::SwingId id);
    void cancelled();

private:
    void build();
    void loadTypes();
    void loadAircraft();
    void loadCompasses();
    void loadLimits();
    void updateLimits();
    void create();
    void preselect(AircraftId aircraft, CompassId compass);
    [[nodiscard]] Result<AircraftTypeId> typeChosen();
    [[nodiscard]] Result<AircraftId> aircraftChosen();
    [[nodiscard]] Result<CompassId> compassChosen(AircraftId aircraft);
    [[nodiscard]] Result<SiteId> siteChosen();
    [[nodiscard]] Result<SwingId> store();

    EditContext& m_context;
    QUndoStack& m_stack;
    std::function<RecordId()> m_usualSite;
    QComboBox* m_type;
    QComboBox* m_aircraft;
    QComboBox* m_compass;
    QComboBox* m_limits; ///< for a new compass; a known one keeps its own
    QComboBox* m_site;
    QComboBox* m_kind;
    QComboBox* m_stage;
    QLineEdit* m_date;
    QPushButton* m_create;
    std::vector<TypeRow> m_types;
    std::vector<AircraftRow> m_aircraftRows;
    std::vector<CompassRow> m_compasses;
    std::vector<Site> m_sites;
    std::vector<LimitsProfile> m_profiles;
};

} // namespace lubberline::ui
