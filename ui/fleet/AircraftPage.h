#pragma once
/// One aircraft: particulars that are edited in place, its compasses with their limits, its events, the swings of a compass and
/// its coefficients over the years.

#include <map>

#include "core/due/DueRules.h"
#include "core/record/FleetRows.h"
#include "db/stores/SwingMarks.h"
#include "ui/kit/EditContext.h"
#include "ui/kit/FormField.h"
#include "ui/kit/Page.h"

class QLabel;
class QTableWidget;
class QUndoStack;
class QVBoxLayout;

namespace lubberline::ui {

class HistoryPlot;
class EventsPanel;

class AircraftPage : public Page {
    Q_OBJECT

public:
    AircraftPage(EditContext& context, QUndoStack& stack, QWidget* parent = nullptr);

    /// @param compass shown first; not valid: the one that needs a hand most.
    Result<void> showAircraft(AircraftId id, CompassId compass);
    /// Asks storage again for what is shown.
    void refresh();

    [[nodiscard]] AircraftId aircraft() const { return m_aircraft.record().id; }
    [[nodiscard]] CompassId compass() const { return m_compass.record().id; }

    static PageDescription description(PageContext& context);
    Result<void> open(const FleetItem& record) override;
    [[nodiscard]] bool isOf(const FleetItem& record) const override;
    [[nodiscard]] Shown shown() const override;
    [[nodiscard]] Plot* plot() const override;
    [[nodiscard]] std::vector<FleetItem> path() const override;

    /// What is due, from the window's watch: it stands beside each compass, and decides which is shown first.
    void setDue(std::map<CompassId, DueState> due);

signals:
    void swingChosen(lubberline::SwingId id);

protected:
    void anglesChanged() override { refresh(); }

private:
    QWidget* buildAircraftForm();
    QWidget* buildCompassForm();
    QWidget* buildSwings();
    Result<void> load(AircraftId id, CompassId compass);
    Result<void> loadCompass(CompassId id);
    void listCompasses();
    void markCompass();
    void showTitle();
    void chooseCompass(int row);
    void offerOpen();
    [[nodiscard]] CompassId worst() const;
    void showSwings(const std::vector<SwingRow>& swings, const std::vector<db::SignedMark>& marks, const CompassSystem& compass);
    void showHistory(const std::vector<SwingRow>& swings, const CompassSystem& compass);
    void loadLimits();
    [[nodiscard]] QString siteName(SiteId id) const;
    [[nodiscard]] Result<SiteId> siteNamed(const QString& name) const;
    [[nodiscard]] QString typeName(AircraftTypeId id) const; ///< with the separator after it

    EditContext& m_context;
    QUndoStack& m_stack;
    FormFields<Aircraft> m_aircraft;
    FormFields<CompassSystem> m_compass;
    QComboBox* m_compassChoice = nullptr;
    QComboBox* m_limits = nullptr;
    EventsPanel* m_events;
    QTableWidget* m_compassTable;
    QLabel* m_shownCompass;
    QVBoxLayout* m_open; ///< a button for each guided swing of the compass that stands half-way
    std::map<CompassId, DueState> m_due;
    QTableWidget* m_swingTable;
    QVBoxLayout* m_historyPlace = nullptr;
    HistoryPlot* m_history = nullptr;
    std::vector<CompassRow> m_compasses;
    std::vector<LimitsProfile> m_profiles;
    std::vector<SwingId> m_listed;
    FleetItem m_asked; ///< a compass, or the aircraft as a whole
};

} // namespace lubberline::ui
