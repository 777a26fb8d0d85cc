#include "ui/sensor/SensorForm.h"

#include <QCheckBox>
#include <QGroupBox>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <algorithm>

#include "core/record/DefaultNames.h"
#include "ui/kit/Words.h"
#include "ui/sensor/CircuitForm.h"

namespace lubberline::ui {

namespace {

QGroupBox* groupOf(const QString& title, QWidget* content)
{
    auto* group = new QGroupBox(title);
    auto* layout = new QVBoxLayout(group);
    layout->setContentsMargins(6, 4, 6, 4);
    layout->setSpacing(2);
    layout->addWidget(content);
    return group;
}

} // namespace

SensorForm::SensorForm(QWidget* parent)
    : QWidget(parent)
    , m_softIron(makeGrid(softIronParameters()))
    , m_hardIron(makeGrid(hardIronParameters()))
    , m_softConstant(makeGrid(softConstantParameters()))
    , m_mount(makeGrid(misalignmentParameters()))
    , m_polarGrid(
          polarParameters(), [this](const auto& change) { playPolar(change); }, [this](const QString& what) { emit settled(what); })
{
    auto* circuits = new QWidget;
    m_circuits = new QVBoxLayout(circuits);
    m_circuits->setContentsMargins(0, 0, 0, 0);
    m_circuits->setSpacing(4);
    m_addCircuit = new QPushButton(tr("&Add a circuit"));
    m_addCircuit->setObjectName(QStringLiteral("circuitAdd"));
    m_circuits->addWidget(m_addCircuit);
    connect(m_addCircuit, &QPushButton::clicked, this, &SensorForm::addCircuit);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(groupOf(tr("Hard iron"), buildHardIron()));
    layout->addWidget(groupOf(tr("Soft iron"), m_softIron.widget()));
    layout->addWidget(groupOf(tr("Electrical circuits"), circuits));
    layout->addWidget(groupOf(tr("Misalignment of the sensor"), m_mount.widget()));
    layout->addWidget(groupOf(tr("Soft constants (act as hard iron does)"), m_softConstant.widget()));
}

SensorForm::Grid SensorForm::makeGrid(std::vector<Parameter<SensorModel>> parameters)
{
    const auto play = [this](const std::function<void(SensorModel&)>& change) {
        change(m_model);
        emit played(m_model);
    };
    return Grid(std::move(parameters), play, [this](const QString& what) { emit settled(what); });
}

QWidget* SensorForm::buildHardIron()
{
    m_asPolar = new QCheckBox(tr("as si&ze and direction"));
    m_asPolar->setObjectName(QStringLiteral("hardIronPolar"));
    m_hardIronForms = new QStackedWidget;
    m_hardIronForms->addWidget(m_hardIron.widget());
    m_hardIronForms->addWidget(m_polarGrid.widget());
    connect(m_asPolar, &QCheckBox::toggled, this, [this](bool polar) {
        showHardIron();
        m_hardIronForms->setCurrentIndex(polar ? 1 : 0);
    });
    auto* content = new QWidget;
    auto* layout = new QVBoxLayout(content);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    layout->addWidget(m_asPolar);
    layout->addWidget(m_hardIronForms);
    return content;
}

void SensorForm::playPolar(const std::function<void(PolarHardIron&)>& change)
{
    change(m_polar);
    m_model.hardIron_nT = fromPolar(m_polar);
    emit played(m_model);
}

void SensorForm::showHardIron()
{
    m_hardIron.show(m_model);
    if (fromPolar(m_polar) != m_model.hardIron_nT)
        m_polar = toPolar(m_model.hardIron_nT);
    m_polarGrid.show(m_polar);
}

void SensorForm::show(const SensorModel& model, bool editable)
{
    m_model = model;
    m_editable = editable;
    m_softIron.show(model);
    m_softConstant.show(model);
    m_mount.show(model);
    showHardIron();
    showCircuits();
}

void SensorForm::showCircuits()
{
    m_addCircuit->setEnabled(m_editable);
    while (m_circuitForms.size() > m_model.circuits.size()) {
        m_circuitForms.back()->hide();
        m_circuitForms.back()->deleteLater(); // it may be the one that is asking
        m_circuitForms.pop_back();
    }
    while (m_circuitForms.size() < m_model.circuits.size())
        m_circuitForms.push_back(addCircuitForm());
    for (std::size_t i = 0; i < m_circuitForms.size(); ++i)
        m_circuitForms[i]->show(m_model.circuits[i], m_editable);
}

CircuitForm* SensorForm::addCircuitForm()
{
    const int place = static_cast<int>(m_circuitForms.size());
    auto* form = new CircuitForm(place);
    m_circuits->insertWidget(place, form);
    connect(form, &CircuitForm::played, this, [this, form, place] {
        m_model.circuits[static_cast<std::size_t>(place)] = form->circuit();
        emit played(m_model);
    });
    connect(form, &CircuitForm::settled, this, &SensorForm::settled);
    connect(form, &CircuitForm::removeWanted, this, [this, form] { removeCircuit(form); });
    return form;
}

void SensorForm::addCircuit()
{
    Circuit circuit;
    circuit.name = std::string(kNewCircuit) + ' ' + std::to_string(m_model.circuits.size() + 1);
    circuit.current_A = 10;
    circuit.on = true;
    m_model.circuits.push_back(circuit);
    emit played(m_model);
    emit settled(tr("new circuit"));
}

void SensorForm::removeCircuit(CircuitForm* form)
{
    const auto place = std::find(m_circuitForms.begin(), m_circuitForms.end(), form) - m_circuitForms.begin();
    const QString name = toText(form->circuit().name);
    m_model.circuits.erase(m_model.circuits.begin() + place);
    emit played(m_model);
    emit settled(tr("%1 removed").arg(name));
}

} // namespace lubberline::ui
