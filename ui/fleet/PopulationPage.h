#pragma once
/// Years of swings as a population, a question a tab: the pattern, who next, the history of a compass, and the tables behind them. It is
/// computed on a worker with a connection of its own: a first look at a part of the swings comes at once, the whole follows.

#include <memory>

#include "ui/fleet/PopulationNews.h"
#include "ui/kit/FileQuestions.h"
#include "ui/kit/Page.h"
#include "ui/kit/Worker.h"
#include "ui/plots/fleet/FleetDrawing.h"

class QLabel;
class QProgressBar;
class QPushButton;
class QTableWidget;
class QTabWidget;

namespace lubberline::ui {

class HistoryPanel;
class PaintedPlot;
class PopulationFilters;

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
    void computed(bool whole);

private:
    void build();
    QWidget* buildCommands();
    QWidget* buildPattern();
    QWidget* buildRanking();
    void compute();
    void computeWhole();
    void take(Result<std::shared_ptr<const PopulationNews>> news);
    void fill();
    void fillTables();
    void tellHeading(double heading_deg);
    void updatePlots();
    [[nodiscard]] PopulationDrawing drawing() const;

    db::Stores& m_stores;
    FileQuestions m_questions;
    std::shared_ptr<const PopulationNews> m_news;
    FleetOptions m_options; ///< of what is being computed
    DistributionDrawing m_distributions;
    bool m_changed = false; ///< the fleet, since what is shown or computed was read
    std::optional<double> m_chosen_deg;
    std::vector<SwingId> m_behind; ///< of the rows of m_swings
    CompassId m_wantedCompass;     ///< whose history is shown first

    PopulationFilters* m_filters;
    QLabel* m_state;
    QProgressBar* m_progress;
    QPushButton *m_compute, *m_cancel, *m_save;
    QTabWidget* m_tabs;
    PaintedPlot *m_curve, *m_polar, *m_histograms;
    QTableWidget *m_swings, *m_ranking;
    QLabel* m_behindWords;
    HistoryPanel* m_history;
    QTabWidget* m_tables;
    Worker<std::shared_ptr<const PopulationNews>> m_worker; ///< last: its work ends before anything else of the page
};

} // namespace lubberline::ui
