#pragma once
/// All figures of a sensor model: soft iron, hard iron (Cartesian or polar), soft constants, misalignment, circuits.

#include <QWidget>

#include "ui/sensor/ParameterGrid.h"

class QCheckBox;
class QPushButton;
class QStackedWidget;
class QVBoxLayout;

namespace lubberline::ui {

class CircuitForm;

class SensorForm : public QWidget {
    Q_OBJECT

public:
    explicit SensorForm(QWidget* parent = nullptr);

    /// Not editable: figures still play, names and the list of circuits stay.
    void show(const SensorModel& model, bool editable);

signals:
    void played(const lubberline::SensorModel& model);
    void settled(const QString& what);

private:
    using Grid = ParameterGrid<SensorModel>;
    Grid makeGrid(std::vector<Parameter<SensorModel>> parameters);
    QWidget* buildHardIron();
    void playPolar(const std::function<void(PolarHardIron&)>& change);
    void showHardIron();
    void showCircuits();
    CircuitForm* addCircuitForm();
    void addCircuit();
    void removeCircuit(CircuitForm* form);

    SensorModel m_model;
    PolarHardIron m_polar; ///< keeps its angles while the size is zero
    bool m_editable = false;
    Grid m_softIron, m_hardIron, m_softConstant, m_mount;
    ParameterGrid<PolarHardIron> m_polarGrid;
    QCheckBox* m_asPolar = nullptr;
    QStackedWidget* m_hardIronForms = nullptr;
    QVBoxLayout* m_circuits = nullptr;
    QPushButton* m_addCircuit = nullptr;
    std::vector<CircuitForm*> m_circuitForms;
};

} // namespace lubberline::ui
