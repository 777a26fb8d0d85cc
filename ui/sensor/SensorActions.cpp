#include "ui/sensor/SensorActions.h"

#include <QFileInfo>
#include <QGridLayout>
#include <QMenu>
#include <QPushButton>

#include "core/base/OutputFile.h"
#include "core/format/exchange/ModelJson.h"
#include "ui/kit/Words.h"
#include "ui/sensor/SensorEditor.h"
#include "ui/sensor/SensorEstimate.h"
#include "ui/sensor/SensorFieldForm.h"

namespace lubberline::ui {

namespace {

QString modelFilter() { return SensorActions::tr("Sensor model (*.json)"); }

} // namespace

SensorActions::SensorActions(const Parts& parts, FileQuestions files, QWidget* parent)
    : QWidget(parent)
    , m_parts(parts)
    , m_files(std::move(files))
{
    auto* layout = new QGridLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(3);
    m_estimate = addButton(QStringLiteral("sensorEstimate"), tr("Es&timate from swings"), 0, 0);
    m_bench = addButton(QStringLiteral("sensorBench"), tr("&Iron bench…"), 0, 1);
    m_load = addButton(QStringLiteral("sensorLoad"), tr("Loa&d model…"), 1, 0);
    m_save = addButton(QStringLiteral("sensorSave"), tr("Save &model…"), 1, 1);
    addEstimates(*m_estimate);
    connect(m_load, &QPushButton::clicked, this, &SensorActions::load);
    connect(m_save, &QPushButton::clicked, this, &SensorActions::save);
    connect(m_bench, &QPushButton::clicked, this, &SensorActions::benchWanted);
    connect(&m_parts.editor, &SensorEditor::changed, this, &SensorActions::follow);
}

QPushButton* SensorActions::addButton(const QString& name, const QString& text, int row, int column)
{
    auto* button = new QPushButton(text);
    button->setObjectName(name);
    static_cast<QGridLayout*>(layout())->addWidget(button, row, column);
    return button;
}

void SensorActions::addEstimates(QPushButton& button)
{
    auto* menu = new QMenu(&button);
    const auto add = [this, menu](const QString& name, const QString& text, const std::function<void()>& act) {
        auto* action = menu->addAction(text, this, act);
        action->setObjectName(name);
    };
    add(QStringLiteral("estimateHardIron"), tr("Newest swing, B and C as &hard iron"), [this] { estimateFromNewest(Origin::HardIron); });
    add(QStringLiteral("estimateSoftIron"), tr("Newest swing, B and C as &vertical soft iron"),
        [this] { estimateFromNewest(Origin::VerticalSoftIron); });
    add(QStringLiteral("estimateSeparated"), tr("Swings at several &places, separated"), [this] { estimateBySeparation(); });
    button.setMenu(menu);
}

void SensorActions::follow()
{
    m_load->setEnabled(m_parts.editor.editable());
    m_estimate->setEnabled(m_parts.editor.editable());
}

void SensorActions::take(const Result<SensorRecord>& estimate)
{
    if (!estimate)
        emit failed(messageOf(estimate.error()));
    else
        m_parts.editor.make(*estimate, tr("estimate from swings"));
}

void SensorActions::estimateFromNewest(Origin origin)
{
    take(ui::estimateFromNewest(m_parts.stores, m_parts.editor.compass(), origin, m_parts.field.field()));
}

void SensorActions::estimateBySeparation() { take(ui::estimateBySeparation(m_parts.stores, m_parts.editor.compass())); }

void SensorActions::load()
{
    const QString path = m_files.open(tr("Load a sensor model"), modelFilter());
    if (path.isEmpty())
        return;
    auto setup = readModelJsonFile(path.toStdString());
    if (!setup)
        return emit failed(messageOf(setup.error()));
    SensorRecord sensor;
    sensor.name = QFileInfo(path).completeBaseName().toStdString();
    sensor.note = setup->note;
    sensor.origin = ModelOrigin::Loaded;
    sensor.model = setup->model;
    sensor.uncertainty = setup->uncertainty;
    m_parts.editor.make(std::move(sensor), tr("load %1").arg(QFileInfo(path).fileName()));
    if (const auto field = fieldOf(*setup))
        m_parts.field.showTyped(*field);
    else
        emit failed(tr("The model was loaded; its field was not: %1").arg(messageOf(field.error())));
    emit m_parts.field.changed();
}

void SensorActions::save()
{
    const QString path = m_files.save(tr("Save the sensor model"), m_parts.editor.name() + QStringLiteral(".json"), modelFilter());
    if (path.isEmpty())
        return;
    const SensorRecord* record = m_parts.editor.record();
    const SensorSetup setup{
        m_parts.field.stated(), m_parts.editor.model(), record ? record->note : std::string(), m_parts.editor.uncertainty()};
    if (const auto written = writeWholeFile(path.toStdString(), writeModelJson(setup)); !written)
        emit failed(messageOf(written.error()));
}

} // namespace lubberline::ui
