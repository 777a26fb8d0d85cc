#pragma once
/// The coil bench on the page of a sensor's tests: what the log tells, the benches that are kept with the compass, and what became other
/// between two of them.

#include <QStringList>
#include <QWidget>

#include <memory>
#include <vector>

#include "core/coil/CoilHistory.h"
#include "ui/kit/EditContext.h"

class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;
class QUndoStack;

namespace lubberline::ui {

class CoilPanel : public QWidget {
    Q_OBJECT

public:
    /// @param context, undo outlive it
    CoilPanel(EditContext& context, QUndoStack& undo, QWidget* parent = nullptr);

    void setCompass(CompassId compass); ///< not valid: nothing is kept
    void show(const std::shared_ptr<const SensorLog>& log, const Result<CoilResult>& result, const QString& name);
    /// What the kept benches say of the log, for its report: the drift since the newest of them.
    [[nodiscard]] QStringList history() const;

signals:
    void failed(const QString& message);

private:
    void build();
    void reload();
    void showDrift();
    void keep();
    void remove();
    void store(const CoilBench* before, const CoilBench* after, const QString& text);
    [[nodiscard]] Result<CoilBench> typed() const; ///< the log as a record

    EditContext& m_context;
    QUndoStack& m_undo;
    CompassId m_compass;
    std::string m_compassSerial;
    std::vector<CoilBench> m_benches; ///< newest first
    std::shared_ptr<const SensorLog> m_log;
    bool m_measured = false; ///< the log is a bench
    QString m_name;
    QLabel *m_words, *m_drift;
    QTableWidget *m_result, *m_kept;
    QLineEdit *m_date, *m_serial, *m_note;
    QPushButton *m_keep, *m_remove;
};

} // namespace lubberline::ui
