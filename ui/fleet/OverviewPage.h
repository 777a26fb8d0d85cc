#pragma once
/// The whole fleet, or one type. Of the fleet first what needs a hand today: guided swings that stand half-way, compasses that are due, the
/// newest swings; then what is out of limits.

#include "core/due/DueList.h"
#include "db/stores/Stores.h"
#include "ui/kit/Page.h"

class QLabel;
class QTableWidget;

namespace lubberline::ui {

class OverviewPage : public Page {
    Q_OBJECT

public:
    explicit OverviewPage(db::Stores& stores, QWidget* parent = nullptr);

    void showFleet();
    void showType(AircraftTypeId type);
    /// What is due, the most urgent first.
    void setDue(const std::vector<DueLine>& lines);
    /// Asks storage again for what is shown.
    void refresh();

    static PageDescription description(PageContext& context);
    Result<void> open(const FleetItem& record) override;
    [[nodiscard]] bool isOf(const FleetItem&) const override { return true; }
    [[nodiscard]] Shown shown() const override;
    void fleetChanged() override { refresh(); }

signals:
    void aircraftChosen(lubberline::AircraftId id);
    void placeWanted(const lubberline::ui::FleetItem& item);
    void dueWanted(); ///< the list of all that is due
    void newSwingWanted();
    void importWanted();

protected:
    void anglesChanged() override { refresh(); }

private:
    /// A line of what needs a hand, and where it goes; none: to the list of what is due.
    void addToday(const QString& what, const QIcon& icon, const QString& which, const QString& why, const FleetItem& place);
    void fillToday();
    void addDue();
    void fillFleet(const std::vector<TypeRow>& types);
    void fillType(const TypeRow& type);
    void add(const TypeRow& type, const AircraftRow& aircraft);

    db::Stores& m_stores;
    AircraftTypeId m_type; ///< not valid: the whole fleet
    QLabel* m_counts;
    QLabel* m_listTitle;
    QTableWidget* m_today;
    std::vector<FleetItem> m_places; ///< of its rows
    std::vector<DueLine> m_due;      ///< due or overdue
    QLabel* m_hint;
    QTableWidget* m_list;
    std::vector<AircraftId> m_listed;
};

} // namespace lubberline::ui
