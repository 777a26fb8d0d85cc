#pragma once
/// The whole fleet, or one type: how many, what is out of limits, and how to go on.

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
    /// Asks storage again for what is shown.
    void refresh();

    static PageDescription description(PageContext& context);
    Result<void> open(const FleetItem& record) override;
    [[nodiscard]] bool isOf(const FleetItem&) const override { return true; }
    void fleetChanged() override { refresh(); }

signals:
    void aircraftChosen(lubberline::AircraftId id);
    void newSwingWanted();
    void importWanted();

private:
    void fillFleet(const std::vector<TypeRow>& types);
    void fillType(const TypeRow& type);
    void add(const TypeRow& type, const AircraftRow& aircraft);

    db::Stores& m_stores;
    AircraftTypeId m_type; ///< not valid: the whole fleet
    QLabel* m_counts;
    QLabel* m_listTitle;
    QTableWidget* m_list;
    std::vector<AircraftId> m_listed;
};

} // namespace lubberline::ui
