#include "ui/sensor/SensorEditor.h"

#include <QUndoStack>

#include <algorithm>

#include "core/record/DefaultNames.h"
#include "ui/kit/Words.h"
#include "ui/sensor/SensorEdits.h"

namespace lubberline::ui {

namespace {

bool sameButSwitches(const SensorModel& before, SensorModel after)
{
    for (std::size_t i = 0; i < std::min(before.circuits.size(), after.circuits.size()); ++i)
        after.circuits[i].on = before.circuits[i].on;
    return before == after;
}

} // namespace

SensorEditor::SensorEditor(EditContext& context, QUndoStack& stack, QObject* parent) : QObject(parent), m_context(context), m_stack(stack)
{
    connect(&context.stores.changes(), &db::Changes::sensorsChanged, this, [this](CompassId compass) {
        if (compass == m_compass)
            followStored();
    });
    connect(&context.stores.changes(), &db::Changes::fleetChanged, this, [this] {
        if (m_compass.valid())
            followStored(); // an import may have brought models
    });
}

Result<void> SensorEditor::open(CompassId compass)
{
    const CompassId before = m_compass;
    m_compass = compass;
    if (auto loaded = reload(); !loaded) {
        m_compass = before;
        return loaded;
    }
    emit changed();
    return {};
}

Result<void> SensorEditor::reload()
{
    auto records = m_context.stores.sensors.of(m_compass);
    if (!records)
        return records.error();
    m_records = std::move(records.value());
    const auto chosen
        = std::find_if(m_records.begin(), m_records.end(), [this](const SensorRecord& one) { return one.record == m_chosen; });
    m_current = m_records.empty() ? -1 : chosen == m_records.end() ? 0 : static_cast<int>(chosen - m_records.begin());
    m_chosen = record() ? record()->record : RecordId();
    m_model = record() ? record()->model : SensorModel();
    return {};
}

/// Where nothing of them has changed, what is being played stays.
void SensorEditor::followStored()
{
    const auto records = m_context.stores.sensors.of(m_compass);
    if (!records || *records != m_records)
        follow();
}

void SensorEditor::follow()
{
    if (const auto loaded = reload(); !loaded)
        emit failed(messageOf(loaded.error()));
    emit changed();
}

QString SensorEditor::name() const { return record() ? toText(record()->name) : tr("new model"); }

void SensorEditor::choose(int index)
{
    m_current = index;
    m_chosen = record()->record;
    m_model = record()->model;
    emit changed();
}

std::optional<ModelUncertainty> SensorEditor::uncertainty() const
{
    const bool same = record() && record()->model.softIron == m_model.softIron && record()->model.hardIron_nT == m_model.hardIron_nT
        && record()->model.misalignment == m_model.misalignment;
    return same ? record()->uncertainty : std::nullopt;
}

void SensorEditor::play(const SensorModel& model)
{
    if (model == m_model)
        return;
    m_model = model;
    emit played();
}

void SensorEditor::settle(const QString& what)
{
    if (!editable() || m_model == (record() ? record()->model : SensorModel()))
        return;
    SensorRecord after = record() ? *record() : SensorRecord();
    if (!sameButSwitches(after.model, m_model))
        after.origin = ModelOrigin::Entered; // no more what a file, swings or the bench gave
    after.uncertainty = uncertainty();
    after.model = m_model;
    if (record())
        return change(after, what);
    after.name = kNewModel;
    make(std::move(after), tr("new sensor model"));
}

void SensorEditor::change(const SensorRecord& after, const QString& what)
{
    if (!editable() || !record() || after == *record())
        return;
    m_stack.push(new ChangeSensor(m_context, *record(), after, tr("%1 of %2").arg(what, toText(record()->name))));
    if (!record() || !(after == *record()))
        follow(); // refused: what is stored is shown
}

void SensorEditor::make(SensorRecord sensor, const QString& text)
{
    if (!editable())
        return;
    sensor.id = {};
    sensor.record = newRecordId();
    sensor.compass = m_compass;
    sensor.name = freeName(sensor.name);
    const RecordId before = m_chosen;
    const RecordId made = sensor.record;
    m_chosen = made; // storage tells of it before push() returns
    m_stack.push(new MakeSensor(m_context, std::move(sensor), MakeSensor::Direction::Make, text));
    if (record() && record()->record == made)
        return;
    m_chosen = before; // refused
    follow();
}

void SensorEditor::remove()
{
    if (editable() && record())
        m_stack.push(new MakeSensor(m_context, *record(), MakeSensor::Direction::Remove, tr("remove %1").arg(toText(record()->name))));
}

std::string SensorEditor::freeName(const std::string& wanted) const
{
    const auto taken = [this](const std::string& name) {
        return std::any_of(m_records.begin(), m_records.end(), [&name](const SensorRecord& one) { return one.name == name; });
    };
    std::string name = wanted;
    for (int number = 2; taken(name); ++number)
        name = wanted + " " + std::to_string(number);
    return name;
}

} // namespace lubberline::ui
