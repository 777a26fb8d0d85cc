#pragma once
/// What a bench does at its sensor: S, p and the circuits, each part's share, and Smith's coefficients in a field to choose.

#include <QTabWidget>

#include <optional>

#include "core/base/Clock.h"
#include "core/iron/BenchModel.h"
#include "db/stores/Stores.h"

class QLabel;
class QTableWidget;

namespace lubberline::ui {

class SensorFieldForm;
class SmithTermsPanel;

class BenchResults : public QTabWidget {
    Q_OBJECT

public:
    explicit BenchResults(const Clock& clock, QWidget* parent = nullptr);

    /// The field of the newest swing of the compass is chosen.
    void showFieldOf(db::Stores& stores, CompassId compass);
    void show(const BenchModel& model);
    using QWidget::show;

private:
    QWidget* buildShares();
    QWidget* buildCoefficients(const Clock& clock);
    void showShares(const BenchModel& model);
    void showCoefficients();

    QLabel* m_total = nullptr;
    QTableWidget* m_effects = nullptr;
    SensorFieldForm* m_field = nullptr;
    SmithTermsPanel* m_smith = nullptr;
    std::optional<SensorModel> m_model;
};

} // namespace lubberline::ui
