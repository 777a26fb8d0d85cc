#pragma once
/// One electrical circuit: name, switch, current, field per ampere.

#include <QGroupBox>

#include "ui/sensor/ParameterGrid.h"

class QCheckBox;
class QLineEdit;
class QToolButton;

namespace lubberline::ui {

class CircuitForm : public QGroupBox {
    Q_OBJECT

public:
    /// @param place among the circuits; object names begin with "circuit0".
    explicit CircuitForm(int place, QWidget* parent = nullptr);

    void show(const Circuit& circuit, bool editable);
    [[nodiscard]] const Circuit& circuit() const { return m_circuit; }

signals:
    void played();
    void settled(const QString& what);
    void removeWanted();

private:
    void buildHead(const QString& prefix);
    void takeName();

    Circuit m_circuit;
    QLineEdit* m_name;
    QCheckBox* m_on;
    QToolButton* m_remove;
    ParameterGrid<Circuit> m_current, m_field;
};

} // namespace lubberline::ui
