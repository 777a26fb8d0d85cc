#pragma once
/// Undoable edits of the sensor models of a compass. A model is found by its RecordId: storage gives it another id when it is
/// put back after it was removed.

#include "ui/kit/Edit.h"

namespace lubberline::ui {

class SensorEdit : public Edit {
public:
    SensorEdit(EditContext& context, CompassId compass, const QString& text) : Edit(context, text), m_compass(compass) {}
    [[nodiscard]] CompassId sensorsOf() const override { return m_compass; }

protected:
    /// Not valid: storage has no such model. Errors: those of SensorStore::of().
    Result<SensorModelId> idOf(const RecordId& record) const;

private:
    CompassId m_compass;
};

/// Name, note, model or bench of one record.
class ChangeSensor final : public SensorEdit {
public:
    /// Both are the same record (SensorRecord::record, not empty).
    ChangeSensor(EditContext& context, SensorRecord before, SensorRecord after, const QString& text);

protected:
    Result<void> apply() override { return store(m_before, m_after); }
    Result<void> revert() override { return store(m_after, m_before); }

private:
    Result<void> store(SensorRecord known, SensorRecord sensor) const;
    SensorRecord m_before, m_after;
};

/// A record is made, or removed: the other way round.
class MakeSensor final : public SensorEdit {
public:
    enum class Direction { Make, Remove };
    /// A record without a RecordId gets a random one.
    MakeSensor(EditContext& context, SensorRecord sensor, Direction direction, const QString& text);

protected:
    Result<void> apply() override { return m_direction == Direction::Make ? make() : remove(); }
    Result<void> revert() override { return m_direction == Direction::Make ? remove() : make(); }

private:
    Result<void> make() const;
    Result<void> remove() const;
    SensorRecord m_sensor;
    Direction m_direction;
};

} // namespace lubberline::ui
