#include "ui/sensor/CircuitForm.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QToolButton>

#include "ui/kit/FormField.h"
#include "ui/kit/Words.h"

namespace lubberline::ui {

namespace {

QString prefixOf(int place) { return QStringLiteral("circuit%1").arg(place); }

std::vector<Parameter<Circuit>> part(int place, std::size_t from, std::size_t to)
{
    auto all = circuitParameters(prefixOf(place));
    return {all.begin() + static_cast<std::ptrdiff_t>(from), all.begin() + static_cast<std::ptrdiff_t>(to)};
}

} // namespace

CircuitForm::CircuitForm(int place, QWidget* parent)
    : QGroupBox(parent)
    , m_name(new QLineEdit)
    , m_on(new QCheckBox(tr("on")))
    , m_remove(new QToolButton)
    , m_current(
          part(place, 0, 1),
          [this](const auto& change) {
              change(m_circuit);
              emit played();
          },
          [this](const QString& what) { emit settled(tr("%1 of %2").arg(what, toText(m_circuit.name))); })
    , m_field(
          part(place, 1, 4),
          [this](const auto& change) {
              change(m_circuit);
              emit played();
          },
          [this](const QString& what) { emit settled(tr("%1 of %2").arg(what, toText(m_circuit.name))); })
{
    buildHead(prefixOf(place));
    auto* head = new QHBoxLayout;
    head->addWidget(m_on);
    head->addWidget(m_name, 1);
    head->addWidget(m_remove);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(6, 4, 6, 4);
    layout->setSpacing(2);
    layout->addLayout(head);
    layout->addWidget(m_current.widget());
    layout->addWidget(m_field.widget());
}

void CircuitForm::buildHead(const QString& prefix)
{
    m_on->setObjectName(prefix + QStringLiteral("On"));
    m_name->setObjectName(prefix + QStringLiteral("Name"));
    m_name->setAccessibleName(tr("Name of the circuit"));
    m_remove->setObjectName(prefix + QStringLiteral("Remove"));
    m_remove->setText(QStringLiteral("✕"));
    m_remove->setToolTip(tr("Remove this circuit"));
    m_remove->setAccessibleName(m_remove->toolTip());
    m_remove->setFocusPolicy(Qt::StrongFocus);
    connect(m_on, &QCheckBox::clicked, this, [this](bool on) {
        m_circuit.on = on;
        emit played();
        emit settled(on ? tr("%1 switched on").arg(toText(m_circuit.name)) : tr("%1 switched off").arg(toText(m_circuit.name)));
    });
    connect(m_name, &QLineEdit::editingFinished, this, &CircuitForm::takeName);
    connect(m_remove, &QToolButton::clicked, this, &CircuitForm::removeWanted);
}

void CircuitForm::takeName()
{
    const std::string name = m_name->text().trimmed().toStdString();
    if (m_name->isReadOnly() || name == m_circuit.name)
        return;
    markRefused(*m_name, name.empty() ? tr("a circuit must have a name, as “landing light”") : QString());
    if (name.empty())
        return;
    m_circuit.name = name;
    emit played();
    emit settled(tr("name of a circuit"));
}

void CircuitForm::show(const Circuit& circuit, bool editable)
{
    m_circuit = circuit;
    m_on->setChecked(circuit.on);
    m_name->setReadOnly(!editable);
    m_name->setText(toText(circuit.name));
    markRefused(*m_name, {});
    m_remove->setEnabled(editable);
    m_current.show(circuit);
    m_field.show(circuit);
}

} // namespace lubberline::ui
