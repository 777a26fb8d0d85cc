#pragma once
/// The iron bench of a compass: ferrous parts, loops and wires round its sensor, and what they do to it. What is typed is
/// computed on a worker and stored with the compass as a sensor model, undoably.

#include <QTimer>

#include "core/iron/BenchModel.h"
#include "ui/kit/FileQuestions.h"
#include "ui/kit/Page.h"
#include "ui/kit/Worker.h"
#include "ui/sensor/SensorEditor.h"

class QLabel;
class QProgressBar;
class QPushButton;
class QUndoStack;

namespace lubberline::ui {

class BenchDrawing;
class BenchResults;
class BenchTables;

class IronBenchPage : public Page {
    Q_OBJECT

public:
    IronBenchPage(EditContext& context, QUndoStack& stack, FileQuestions files, QWidget* parent = nullptr);
    /// A line that loses the focus with its window must not tell a page that is half gone.
    ~IronBenchPage() override;

    /// The newest bench of the compass, or an empty one. Errors: those of the stores; what was shown stays then.
    Result<void> showCompass(CompassId id);
    [[nodiscard]] CompassId compass() const { return m_editor->compass(); }
    /// What was computed last.
    [[nodiscard]] const std::optional<BenchModel>& result() const { return m_result; }

    static PageDescription description(PageContext& context);
    Result<void> open(const FleetItem& record) override;
    [[nodiscard]] bool isOf(const FleetItem& record) const override;
    [[nodiscard]] Shown shown() const override;

private:
    void build();
    QWidget* buildTools();
    void connectParts();
    void showStored();
    void showBench();
    void showStates();
    void takeTables();
    void takeMove(int part, int placement, const Eigen::Vector3d& centre_m);
    void takeBench(IronBench bench);
    void recompute();
    void showWork(bool shown);
    void take(const Result<BenchModel>& model);
    void showResult(const BenchModel& model);
    void settle();
    void load();
    void save();
    void refuseBench(const QString& why);

    FileQuestions m_files;
    db::Stores& m_stores;
    SensorEditor* m_editor;
    IronBench m_bench;
    BenchStates m_states;
    std::optional<BenchModel> m_result;
    bool m_settle = false; ///< the bench under work is to be stored
    QTimer m_patience;     ///< only work that takes long shows its progress

    QWidget* m_stateBoxes;
    QProgressBar* m_progress;
    QPushButton *m_cancel, *m_load;
    BenchTables* m_tables;
    BenchDrawing* m_drawing;
    BenchResults* m_results;
    Worker<BenchModel> m_worker; ///< the newest bench; its end comes first
};

} // namespace lubberline::ui
