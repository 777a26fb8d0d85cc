#include "ui/sensor/SensorEdits.h"

#include "core/base/Contract.h"

namespace lubberline::ui {

Result<SensorModelId> SensorEdit::idOf(const RecordId& record) const
{
    const auto sensors = stores().sensors.of(m_compass);
    if (!sensors)
        return sensors.error();
    for (const SensorRecord& sensor : *sensors)
        if (sensor.record == record)
            return sensor.id;
    return SensorModelId();
}

ChangeSensor::ChangeSensor(EditContext& context, SensorRecord before, SensorRecord after, const QString& text)
    : SensorEdit(context, before.compass, text)
    , m_before(std::move(before))
    , m_after(std::move(after))
{
    LUBBERLINE_EXPECT(!m_before.record.empty() && m_before.record == m_after.record, "one record, which is stored");
}

Result<void> ChangeSensor::store(SensorRecord known, SensorRecord sensor) const
{
    const auto id = idOf(sensor.record);
    if (!id)
        return id.error();
    if (!id->valid())
        return Error{ErrorCode::NotFound, {MARKED("ui", "there is no sensor model \"%1\" any more"), sensor.name}};
    known.id = sensor.id = *id;
    return stores().sensors.change(known, sensor);
}

MakeSensor::MakeSensor(EditContext& context, SensorRecord sensor, Direction direction, const QString& text)
    : SensorEdit(context, sensor.compass, text)
    , m_sensor(std::move(sensor))
    , m_direction(direction)
{
    if (m_sensor.record.empty())
        m_sensor.record = newRecordId();
}

Result<void> MakeSensor::make() const
{
    SensorRecord sensor = m_sensor;
    sensor.id = {};
    const auto stored = stores().sensors.add(sensor);
    return stored ? Result<void>() : Result<void>(stored.error());
}

Result<void> MakeSensor::remove() const
{
    const auto id = idOf(m_sensor.record);
    if (!id)
        return id.error();
    return id->valid()
        ? stores().sensors.remove(*id)
        : Result<void>(Error{ErrorCode::NotFound, {MARKED("ui", "there is no sensor model \"%1\" any more"), m_sensor.name}});
}

} // namespace lubberline::ui
