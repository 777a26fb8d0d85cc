#pragma once
/// Years of swings as a population, a question a tab: the pattern, who next, the history of a compass, and the tables behind them. It is
/// computed on a worker with a connection of its own: a first look at a part of the swings comes at once, the whole follows.

#include <memory>

#include "core/fleet/FleetSelection.h"
#include "db/stores/Stores.h"
#include "ui/kit/FileQuestions.h"
#include "ui/kit/Page.h"
#include "ui/kit/Worker.h"
#include "ui/plots/fleet/FleetDrawing.h"
#include "ui/report/page/Table.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QSlider;
class QSpinBox;
class QTableWidget;
class QTabWidget;
class QTimer;

namespace lubberline::ui {

class PaintedPlot;

/// What the worker brings.
struct PopulationNews {
    FleetSwings fleet;
    FleetReport report;
    FleetSelection selection;
    bool firstLook = false; ///< of a part of the swings
};

class PopulationPage : public Page {
    Q_OBJECT

public:
    PopulationPage(db::Stores& stores, FileQuestions questions, QWidget* parent = nullptr);
    ~PopulationPage() override;

    static PageDescription description(PageContext& context);
    /// A type, or an aircraft or compass whose history is looked at; none: the whole fleet.
    Result<void> open(const FleetItem& record) override;
    [[nodiscard]] bool isOf(const FleetItem&) const override { return true; }
    void fleetChanged() override;

    [[nodiscard]] std::shared_ptr<const PopulationNews> news() const { return m_news; } ///< null while nothing was computed
    void choose(double heading_deg);                                                    ///< the swings behind a heading
    void showHistory(std::int32_t compass);                                             ///< of FleetSwings::compasses
    void save();                                                                        ///< asks where; nothing was computed: nothing

signals:
    void openSwing(lubberline::SwingId swing);
    void done(const QString& message);
    void computed(bool whole);

private:
    void build();
    QWidget* buildFilters();
    QWidget* buildPattern();
    QWidget* buildRanking();
    QWidget* buildHistory();
    void loadChoices();
    void compute();
    void computeWhole();
    void take(Result<std::shared_ptr<const PopulationNews>> news);
    void fill();
    void fillRanking();
    void fillTables();
    void fillHistoryChoices();
    void step();
    [[nodiscard]] FleetSelection selection() const;
    [[nodiscard]] FleetOptions options() const;
    [[nodiscard]] PopulationDrawing drawing() const;

    db::Stores& m_stores;
    FileQuestions m_questions;
    std::shared_ptr<const PopulationNews> m_news;
    std::optional<double> m_chosen_deg;
    HistoryDrawing m_history;
    std::vector<SwingId> m_behind; ///< of the rows of m_swings
    CompassId m_wantedCompass;     ///< whose history is shown first

    QComboBox* m_type;
    QComboBox* m_compass;
    QComboBox* m_base;
    QComboBox* m_stage;
    QComboBox* m_vote;
    QSpinBox* m_grid;
    QLabel* m_state;
    QProgressBar* m_progress;
    QPushButton* m_compute;
    QPushButton* m_cancel;
    QPushButton* m_save;
    QTabWidget* m_tabs;
    PaintedPlot* m_curve;
    PaintedPlot* m_polar;
    QTableWidget* m_swings;
    QLabel* m_behindWords;
    QTableWidget* m_ranking;
    QComboBox* m_historyChoice;
    QSlider* m_film;
    QPushButton* m_play;
    QTimer* m_timer;
    PaintedPlot* m_coefficients;
    PaintedPlot* m_curves;
    QLabel* m_historyWords;
    QTabWidget* m_tables;
    Worker<std::shared_ptr<const PopulationNews>> m_worker; ///< last: its work ends before anything else of the page
};

} // namespace lubberline::ui
