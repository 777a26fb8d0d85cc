#pragma once
/// The sensor models of one compass as they are stored, and the one that is being played with: sliders move the played one, and
/// settle() stores it as one undoable edit. A database that can only be read lets play, and stores nothing.

#include <QObject>

#include <vector>

#include "ui/kit/EditContext.h"

class QUndoStack;

namespace lubberline::ui {

class SensorEditor : public QObject {
    Q_OBJECT

public:
    SensorEditor(EditContext& context, QUndoStack& stack, QObject* parent = nullptr);

    /// The newest model is chosen. Errors: those of SensorStore::of(); what was open stays then.
    Result<void> open(CompassId compass);

    [[nodiscard]] CompassId compass() const { return m_compass; }
    [[nodiscard]] bool editable() const { return !m_context.stores.readOnly(); }
    [[nodiscard]] const std::vector<SensorRecord>& records() const { return m_records; }
    [[nodiscard]] int current() const { return m_current; } ///< −1: there is none
    [[nodiscard]] const SensorRecord* record() const { return m_current < 0 ? nullptr : &m_records[static_cast<std::size_t>(m_current)]; }
    [[nodiscard]] const SensorModel& model() const { return m_model; } ///< as it is played; without a record all zero at first
    /// Of the calibration whose figures the model still has.
    [[nodiscard]] std::optional<ModelUncertainty> uncertainty() const;
    [[nodiscard]] QString name() const;

    void choose(int index);
    void play(const SensorModel& model);
    /// Stores what was played; without a record a new one is made. @param what is named in Undo: "hard iron P"
    void settle(const QString& what);

    /// Another name, note …: the record's id stays.
    void change(const SensorRecord& after, const QString& what);
    /// Stored under a name that is free, and chosen. `sensor` has a name.
    void make(SensorRecord sensor, const QString& text);
    void remove();

signals:
    void changed(); ///< another list, record or figures from storage: show all
    void played();  ///< only model() is another
    void failed(const QString& message);

private:
    Result<void> reload();
    void follow();
    void followStored();
    [[nodiscard]] std::string freeName(const std::string& wanted) const;

    EditContext& m_context;
    QUndoStack& m_stack;
    CompassId m_compass;
    std::vector<SensorRecord> m_records;
    int m_current = -1;
    RecordId m_chosen; ///< stays when the list changes
    SensorModel m_model;
};

} // namespace lubberline::ui
