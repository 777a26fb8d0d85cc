#pragma once
/// Tests of a sensor from its log: what disturbs it periodically, how it measures in a coil, and what switching things changes. One log at a
/// time; a tab is a test.

#include <memory>
#include <optional>

#include "core/base/Clock.h"
#include "core/calibration/Interference.h"
#include "core/calibration/Spectrum.h"
#include "core/coil/CoilBench.h"
#include "ui/kit/EditContext.h"
#include "ui/kit/FileQuestions.h"
#include "ui/kit/Page.h"
#include "ui/kit/Worker.h"

class QLabel;
class QLineEdit;
class QPushButton;
class QSettings;
class QTableWidget;
class QTabWidget;
class QUndoStack;

namespace lubberline::ui {

class CoilPanel;
class DrawnPlot;
class InstallationPanel;
class LiveActions;

/// What one log tells; a test that it does not allow has its reason.
struct SensorTests {
    std::shared_ptr<const SensorLog> log;
    Result<LogSpectrum> spectrum;
    std::optional<Spectrogram> spectrogram;
    Result<CoilResult> coil;
    std::optional<Result<InterferenceResult>> interference; ///< none: no actions were opened
};

class SensorTestsPage : public Page {
    Q_OBJECT

public:
    /// @param context, undo, settings, clock outlive it
    SensorTestsPage(EditContext& context, QUndoStack& undo, QSettings& settings, FileQuestions questions, QWidget* parent = nullptr);

    static PageDescription description(PageContext& context);
    Result<void> open(const FleetItem& record) override; ///< the compass with which benches are kept, or none
    [[nodiscard]] Shown shown() const override { return {{}, m_compass}; }
    [[nodiscard]] bool isOf(const FleetItem& record) const override; ///< a log that was opened for one compass is no other's
    [[nodiscard]] Plot* plot() const override;
    void openLog(const QString& path);
    void openActions(const QString& path);
    void writeReport();

private:
    void build();
    void run();
    void take(Result<SensorTests> tests);
    void showSpectrum();
    void showInterference();

    db::Stores& m_stores;
    FileQuestions m_questions;
    CompassId m_compass;
    QString m_path, m_actionsPath;
    std::shared_ptr<const SensorTests> m_tests;
    QPushButton *m_open, *m_actions, *m_cancel;
    QLineEdit *m_column, *m_tachometer, *m_delay, *m_limits;
    QTabWidget* m_tabs;
    DrawnPlot *m_spectrum, *m_spectrogram, *m_interference;
    QTableWidget *m_lines, *m_outcomes;
    QLabel *m_filter, *m_verdict;
    CoilPanel* m_coil;
    LiveActions* m_live;
    InstallationPanel* m_installation;
    Worker<SensorTests> m_worker;
};

} // namespace lubberline::ui
