#pragma once
/// From a log of a magnetometer to its calibration: open it, say which column is which, read the verdict and what to do next, see the log,
/// the directions that it covers, and headings or the field's size before and after; save the model.

#include <functional>
#include <memory>
#include <vector>

#include "core/record/SensorRecord.h"
#include "db/stores/Stores.h"
#include "ui/calibration/CalibrationRun.h"
#include "ui/kit/FileQuestions.h"
#include "ui/kit/Page.h"
#include "ui/kit/Worker.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QSettings;
class QTabWidget;

namespace lubberline::ui {

class CoverageSphere;
class DrawnPlot;
class SeriesPlot;

class CalibrationPage : public Page {
    Q_OBJECT

public:
    /// @param stores, settings outlive it
    CalibrationPage(db::Stores& stores, QSettings& settings, FileQuestions questions, QWidget* parent = nullptr);

    void openLog(const QString& path);
    [[nodiscard]] const std::shared_ptr<const CalibrationRun>& run() const { return m_run; }

    static PageDescription description(PageContext& context);
    /// A compass whose sensor models take the calibration; any other record: none.
    Result<void> open(const FleetItem& record) override;
    [[nodiscard]] Shown shown() const override { return {{}, m_compass}; }
    [[nodiscard]] bool isOf(const FleetItem& record) const override; ///< a log that was opened for one compass is no other's
    [[nodiscard]] Plot* plot() const override;
    void writeReport();

signals:
    void storeModel(const lubberline::SensorRecord& sensor); ///< with the compass; undoably

private:
    void build();
    QWidget* buildForm();
    void choose();
    void offerColumns(const SensorLogHeader& header);
    void rememberColumns();
    void start(bool readAgain);
    void take(Result<CalibrationRun> run);
    void showRun();
    void save();
    void store();
    [[nodiscard]] Result<CalibrationWish> wish() const;
    [[nodiscard]] Result<std::string> modelText(const QString& path) const;

    db::Stores& m_stores;
    QSettings& m_settings;
    FileQuestions m_questions;
    QString m_path;
    std::shared_ptr<const SensorLog> m_log; ///< as it was read last
    std::shared_ptr<const CalibrationRun> m_run;
    QLabel *m_file, *m_words;
    std::vector<std::pair<std::string, QComboBox*>> m_columns; ///< key and choice
    QComboBox *m_unit, *m_method;
    QLineEdit *m_field, *m_dip, *m_attitudeError;
    QCheckBox* m_onlySeen;
    QPushButton *m_open, *m_calibrate, *m_cancel, *m_save, *m_store;
    CompassId m_compass;
    QTabWidget* m_tabs;
    SeriesPlot *m_logPlot, *m_beforeAfter;
    DrawnPlot* m_map;
    CoverageSphere* m_sphere;
    Worker<CalibrationRun> m_worker;
};

} // namespace lubberline::ui
