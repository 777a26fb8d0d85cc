#pragma once
/// A swing in flight from a log: legs by GPS alone, or a continuous swing against a heading reference. The means of the legs become readings.

#include <memory>
#include <variant>

#include "core/format/csv/InflightCsv.h"
#include "core/record/Fleet.h"
#include "core/record/SensorRecord.h"
#include "db/stores/Stores.h"
#include "ui/kit/FileQuestions.h"
#include "ui/kit/Page.h"
#include "ui/kit/Worker.h"

class QCheckBox;
class QComboBox;
class QLineEdit;
class QPushButton;
class QTabWidget;

namespace lubberline::ui {

class DrawnPlot;
class SwingPlot;

/// What a log turned out to be.
struct FlightLog {
    std::variant<LegsSolution, ContinuousResult> solved;
    std::vector<Message> warnings;
};

class FlightLogPage : public Page {
    Q_OBJECT

public:
    FlightLogPage(db::Stores& stores, FileQuestions questions, QWidget* parent = nullptr);

    static PageDescription description(PageContext& context);
    Result<void> open(const FleetItem& record) override;
    [[nodiscard]] Shown shown() const override { return {m_compass.aircraft, m_compass.id}; }
    [[nodiscard]] Plot* plot() const override;
    void readLog(const QString& path);
    void writeReport(); ///< asks where to: PDF
    void fleetChanged() override;

signals:
    void makeSwing(const lubberline::Swing& swing);
    void storeModel(const lubberline::SensorRecord& sensor);

private:
    void build();
    void choose();
    void start();
    void take(Result<FlightLog> read);
    void make();
    void keepModel();
    void takeFlown();
    void takeModels();
    [[nodiscard]] bool swungSince(const SensorRecord& sensor) const;
    [[nodiscard]] std::optional<ContinuousState> begin() const; ///< where the next log begins
    [[nodiscard]] QString begunAt() const;                      ///< in words; empty: anew
    void showNothing();

    db::Stores& m_stores;
    FileQuestions m_questions;
    CompassSystem m_compass;
    QString m_path;
    Swing m_swing;
    std::optional<ContinuousState> m_before; ///< what the swings in flight on record tell
    int m_flown = 0;                         ///< of these
    /// A sensor model of the compass whose errors are known.
    struct Model {
        SensorRecord record;
        ContinuousState state;
    };
    std::vector<Model> m_models;              ///< newest first
    std::optional<ContinuousState> m_begunAt; ///< where the log that is shown began
    QString m_begunWords;
    std::shared_ptr<const FlightLog> m_log;
    QStringList m_said;
    QLineEdit *m_variation, *m_noise;
    QCheckBox* m_whole; ///< the sensor model in place of A to E
    QComboBox* m_from;  ///< and the one that it goes on from: anew first, then those of m_models
    QPushButton *m_open, *m_cancel, *m_make, *m_keep;
    QTabWidget* m_tabs;
    SwingPlot* m_plot;
    DrawnPlot* m_told;
    Worker<FlightLog> m_worker;
};

} // namespace lubberline::ui
