#pragma once
/// What of the fleet is looked at as a population, and how: the fields above the page.

#include <QWidget>

#include "core/fleet/FleetReport.h"
#include "core/fleet/FleetSelection.h"
#include "db/stores/Stores.h"

class QComboBox;
class QLineEdit;
class QSpinBox;

namespace lubberline::ui {

class PopulationFilters : public QWidget {
    Q_OBJECT

public:
    explicit PopulationFilters(db::Stores& stores, QWidget* parent = nullptr);

    /// Names anew; what is chosen stays. @param fleet  of which compass systems are offered; none: none yet.
    void load(const FleetSwings* fleet);
    void chooseType(const QString& name);

    struct Wish {
        FleetSelection selection;
        FleetOptions options;
    };
    /// Errors: InvalidInput (a date that is none).
    [[nodiscard]] Result<Wish> wish() const;

private:
    db::Stores& m_stores;
    QComboBox *m_type, *m_compass, *m_site, *m_base, *m_stage, *m_radio, *m_vote;
    QSpinBox* m_grid;
    QLineEdit *m_from, *m_to, *m_training;
};

} // namespace lubberline::ui
