#include "ui/sensor/SensorChooser.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

#include "core/record/DefaultNames.h"
#include "ui/kit/Words.h"
#include "ui/sensor/SensorEditor.h"

namespace lubberline::ui {

SensorChooser::SensorChooser(SensorEditor& editor, QWidget* parent)
    : QWidget(parent)
    , m_editor(editor)
    , m_choice(new QComboBox)
    , m_buttons(new QWidget)
    , m_fields([this](const SensorRecord& after, const QString& field) { m_editor.change(after, field); })
    , m_origin(new QLabel)
{
    m_choice->setObjectName(QStringLiteral("sensorChoice"));
    m_choice->setAccessibleName(tr("Sensor models of this compass"));
    auto* head = new QHBoxLayout(m_buttons);
    head->setContentsMargins(0, 0, 0, 0);
    head->setSpacing(3);
    head->addWidget(m_choice, 1);
    m_new = addButton(QStringLiteral("sensorNew"), tr("New"), tr("A new model, all zero"), [this] {
        SensorRecord sensor;
        sensor.name = kNewModel;
        m_editor.make(sensor, tr("new sensor model"));
    });
    m_duplicate = addButton(QStringLiteral("sensorDuplicate"), tr("Duplicate"), tr("A copy of this model, to be compared with it"),
        [this] { m_editor.make(*m_editor.record(), tr("duplicate of %1").arg(m_editor.name())); });
    m_remove
        = addButton(QStringLiteral("sensorRemove"), tr("Remove"), tr("Remove this model (can be undone)"), [this] { m_editor.remove(); });
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(3);
    layout->addWidget(m_buttons);
    buildFields();
    m_origin->setObjectName(QStringLiteral("sensorOrigin"));
    m_origin->setWordWrap(true);
    layout->addWidget(m_origin);
    connect(m_choice, &QComboBox::activated, this, [this](int index) { m_editor.choose(index); });
    connect(&m_editor, &SensorEditor::changed, this, &SensorChooser::follow);
}

QToolButton* SensorChooser::addButton(const QString& name, const QString& text, const QString& tip, const std::function<void()>& act)
{
    auto* button = new QToolButton;
    button->setObjectName(name);
    button->setText(text);
    button->setToolTip(tip);
    button->setFocusPolicy(Qt::StrongFocus);
    m_buttons->layout()->addWidget(button);
    connect(button, &QToolButton::clicked, this, act);
    return button;
}

void SensorChooser::buildFields()
{
    auto* form = new QFormLayout;
    form->setVerticalSpacing(3);
    const auto takeName = [this](SensorRecord& record, const QString& text) -> Result<void> {
        const std::string name = text.trimmed().toStdString();
        if (name.empty())
            return Error{ErrorCode::InvalidInput, said(tr("a model must have a name"))};
        const auto& all = m_editor.records();
        if (std::any_of(all.begin(), all.end(), [&](const SensorRecord& one) { return one.name == name && one.record != record.record; }))
            return Error{ErrorCode::InvalidInput, said(tr("another model of this compass has this name"))};
        record.name = name;
        return {};
    };
    m_fields.addLine(
        *form, tr("&Name:"), QStringLiteral("sensorName"), [](const SensorRecord& record) { return toText(record.name); }, takeName);
    m_fields.addLine(
        *form, tr("N&ote:"), QStringLiteral("sensorNote"), [](const SensorRecord& record) { return toText(record.note); },
        takeText(&SensorRecord::note));
    static_cast<QVBoxLayout*>(layout())->addLayout(form);
}

void SensorChooser::follow()
{
    m_choice->clear();
    for (const SensorRecord& record : m_editor.records())
        m_choice->addItem(toText(record.name));
    m_choice->setCurrentIndex(m_editor.current());
    const bool editable = m_editor.editable(), some = m_editor.record();
    m_choice->setEnabled(some);
    m_new->setEnabled(editable);
    m_duplicate->setEnabled(editable && some);
    m_remove->setEnabled(editable && some);
    m_fields.show(some ? *m_editor.record() : SensorRecord(), editable && some);
    m_origin->setText(!editable ? tr("The database can only be read: sliders play, nothing is stored.")
            : some              ? wordFor(m_editor.record()->origin)
                                : tr("This compass has no model yet. The first figure that you set makes one."));
}

} // namespace lubberline::ui
