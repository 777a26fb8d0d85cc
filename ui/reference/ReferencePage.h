#pragma once
/// What a flight does to a vertical and a heading reference: manoeuvres drawn on a time line or typed, sliders, the error against time with the shares of its
/// sources, the loop's gain, and a film of the instrument beside the truth.

#include <QTimer>

#include "core/deviation/Smith.h"
#include "core/reference/ReferenceRun.h"
#include "ui/kit/FileQuestions.h"
#include "ui/kit/Page.h"
#include "ui/kit/Worker.h"
#include "ui/plots/reference/TimePicture.h"

class QCheckBox;
class QComboBox;
class QPushButton;
class QTableWidget;

namespace lubberline::ui {

class DrawnPlot;
class PlaySlider;
class ManoeuvreLine;
class Painted;

/// What the newest swing of a compass tells of its iron.
struct OwnIron {
    QString of; ///< "SP-DEA · standby compass"
    ExactSmith smith;
};
using FindIron = std::function<std::optional<OwnIron>(const FleetItem&)>;

class ReferencePage : public Page {
    Q_OBJECT

public:
    explicit ReferencePage(FileQuestions files, FindIron find = {}, QWidget* parent = nullptr);

    static PageDescription description(PageContext& context);
    Result<void> open(const FleetItem& record) override; ///< a compass whose own deviation may be flown with
    [[nodiscard]] bool isOf(const FleetItem&) const override { return true; }

    [[nodiscard]] Plot* plot() const override;
    [[nodiscard]] const Scenario& scenario() const { return m_scenario; }
    void showScenario(const Scenario& scenario);
    void load();
    void save();
    void writeReport();

protected:
    void anglesChanged() override { run(); }

private:
    void build();
    QWidget* buildControls();
    /// A slider over a figure of the scenario, logarithmic where it spans decades.
    struct Knob {
        PlaySlider* slider;
        class QLabel* value;
        double least, most;
        bool logarithmic;
        QString unit;
        std::function<double(const Scenario&)> show;
        std::function<void(Scenario&, double)> take;
    };
    [[nodiscard]] static int positionOf(const Knob& knob, const Scenario& scenario);
    void addKnob(class QFormLayout& form, const QString& title, const char* name, Knob knob);
    void turned();
    void takeIron();
    [[nodiscard]] SensorModel ownModel() const;
    void takeTable();
    void takeManoeuvres(std::vector<Manoeuvre> manoeuvres);
    void showControls();
    void run();
    void take(Result<ReferenceRun> run);
    void showPictures();
    void showFrame();

    FileQuestions m_files;
    FindIron m_find;
    std::optional<OwnIron> m_own;
    Scenario m_scenario;
    std::optional<ReferenceRun> m_run;
    std::shared_ptr<TimePicture> m_picture = std::make_shared<TimePicture>(); ///< whose film moves
    std::vector<Knob> m_knobs;
    QComboBox *m_loop, *m_compass;
    QCheckBox* m_iron;
    QTableWidget* m_table;
    DrawnPlot *m_time, *m_gain;
    ManoeuvreLine* m_line;
    Painted* m_dials;
    QPushButton* m_film;
    QTimer m_clock;
    bool m_showing = false;
    Worker<ReferenceRun> m_worker;
};

} // namespace lubberline::ui
