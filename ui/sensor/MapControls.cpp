#include "ui/sensor/MapControls.h"

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>

#include <array>

#include "ui/kit/Words.h"
#include "ui/kit/fit/FlowLayout.h"
#include "ui/sensor/ParameterCell.h"
#include "ui/sensor/SensorEditor.h"

namespace lubberline::ui {

namespace {

struct Axes {
    AttitudeAxis x, y, held;
};
constexpr std::array kAxes{Axes{AttitudeAxis::Heading, AttitudeAxis::Pitch, AttitudeAxis::Roll},
    Axes{AttitudeAxis::Heading, AttitudeAxis::Roll, AttitudeAxis::Pitch},
    Axes{AttitudeAxis::Pitch, AttitudeAxis::Roll, AttitudeAxis::Heading}};

/// What an entry of "compare with" stands for: its data, so that it is found again when the list is made anew.
const QString kRecord = QStringLiteral("record "), kCircuit = QStringLiteral("circuit ");

ParameterSpec heldSpec()
{
    return {QStringLiteral("mapHeld"), QString(), MapControls::tr("the angle that is held"), QStringLiteral("°"), 1, -180, 180, -180, 180};
}

} // namespace

MapControls::MapControls(const SensorEditor& editor, QWidget* parent)
    : QWidget(parent)
    , m_editor(editor)
    , m_axes(new QComboBox)
    , m_held(new ParameterCell(heldSpec()))
    , m_other(new QComboBox)
    , m_compared(new QComboBox)
{
    m_axes->setObjectName(QStringLiteral("mapAxes"));
    m_axes->setAccessibleName(tr("Axes of the map"));
    m_axes->addItems({tr("heading × pitch, roll held"), tr("heading × roll, pitch held"), tr("pitch × roll, heading held")});
    m_other->setObjectName(QStringLiteral("mapOther"));
    m_other->setAccessibleName(tr("Compare with"));
    m_compared->setObjectName(QStringLiteral("mapCompared"));
    m_compared->setAccessibleName(tr("Which of the two is shown"));
    m_compared->addItems({tr("difference"), tr("this model"), tr("the other")});
    auto* exporting = new QPushButton(tr("E&xport…"));
    exporting->setObjectName(QStringLiteral("mapExport"));
    m_held->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    auto* layout = new FlowLayout(this);
    layout->addWidget(m_axes);
    layout->addWidget(m_held);
    layout->addWidget(labelled(tr("&compare with"), m_other));
    layout->addWidget(m_compared);
    layout->addWidget(exporting);
    chooseAxes();
    followModels();
    connect(m_axes, &QComboBox::activated, this, [this] {
        chooseAxes();
        emit changed();
    });
    connect(m_held, &ParameterCell::played, this, &MapControls::played);
    connect(m_held, &ParameterCell::settled, this, &MapControls::changed);
    connect(m_other, &QComboBox::activated, this, [this] {
        m_compared->setEnabled(m_other->currentIndex() > 0);
        emit changed();
    });
    connect(m_compared, &QComboBox::activated, this, &MapControls::changed);
    connect(exporting, &QPushButton::clicked, this, &MapControls::exportWanted);
    connect(&editor, &SensorEditor::changed, this, &MapControls::followModels);
}

void MapControls::chooseAxes()
{
    const AxisRange range = fullRange(kAxes[static_cast<std::size_t>(m_axes->currentIndex())].held);
    m_held->setValue(0);
    m_held->setRange(range.from_deg, range.to_deg);
}

void MapControls::followModels()
{
    const QVariant chosen = m_other->currentData();
    m_other->clear();
    m_other->addItem(tr("nothing"));
    for (const SensorRecord& record : m_editor.records())
        if (&record != m_editor.record())
            m_other->addItem(toText(record.name), kRecord + toText(record.record));
    for (const Circuit& circuit : m_editor.model().circuits)
        m_other->addItem(
            circuit.on ? tr("%1 off").arg(toText(circuit.name)) : tr("%1 on").arg(toText(circuit.name)), kCircuit + toText(circuit.name));
    m_other->setCurrentIndex(std::max(0, chosen.isValid() ? m_other->findData(chosen) : 0));
    m_compared->setEnabled(m_other->currentIndex() > 0);
}

std::optional<NamedModel> MapControls::other() const
{
    const QString chosen = m_other->currentData().toString();
    for (const SensorRecord& record : m_editor.records())
        if (chosen == kRecord + toText(record.record))
            return NamedModel{record.model, toText(record.name), record.uncertainty};
    NamedModel switched{m_editor.model(), tr("%1, %2").arg(m_editor.name(), m_other->currentText()), m_editor.uncertainty()};
    for (Circuit& circuit : switched.model.circuits)
        if (chosen == kCircuit + toText(circuit.name)) {
            circuit.on = !circuit.on;
            return switched;
        }
    return std::nullopt;
}

void MapControls::fill(ModelView& view) const
{
    const Axes& axes = kAxes[static_cast<std::size_t>(m_axes->currentIndex())];
    view.request = wholeRequest(axes.x, axes.y, m_held->value());
    view.other = other();
    view.compared = static_cast<Compared>(m_compared->currentIndex());
}

} // namespace lubberline::ui
