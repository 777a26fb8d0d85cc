#pragma once
/// A swing on the ramp, one step a page, for cold hands: everything by keyboard, everything stored before it counts.

#include <functional>

#include "db/stores/Stores.h"
#include "ui/guided/GuidedJob.h"
#include "ui/kit/Page.h"

class QLabel;
class QMenu;
class QSettings;
class QStackedWidget;

namespace lubberline::ui {

class Preferences;

class CrewDisplay;
class GuidedFault;
class GuidedPrepare;
class GuidedReview;
class GuidedStart;
class GuidedStation;
class LivePanel;
class StationStrip;
class SwingPlot;
class TypedFigures;

class GuidedPage : public Page {
    Q_OBJECT

public:
    /// @param nowUtc ISO 8601 date and time.
    GuidedPage(db::Stores& stores, std::function<std::string()> nowUtc, QWidget* parent = nullptr);
    ~GuidedPage() override;
    /// What people have chosen once for all: base and instrument, where it is heard from, how large it is.
    void take(const Preferences& preferences, QSettings& settings);

    /// Asks what a new guided swing of this compass is to be.
    Result<void> begin(CompassId compass);
    /// Goes on with one that was begun. Errors: NotFound (it has none), those of the job.
    Result<void> takeUp(SwingId swing);
    [[nodiscard]] SwingId swing() const { return m_swing; }
    [[nodiscard]] bool inWork() const; ///< a swing is taken up
    [[nodiscard]] GuidedJob& job() { return *m_job; }
    [[nodiscard]] GuidedStation& station() { return *m_station; }
    void openCrewDisplay(); ///< F11; closes it where it is open
    void showLive(bool shown);
    [[nodiscard]] LivePanel& live() { return *m_live; }

    static PageDescription description(PageContext& context);
    Result<void> open(const FleetItem& record) override;
    [[nodiscard]] Plot* plot() const override;
    [[nodiscard]] Shown shown() const override;
    [[nodiscard]] std::vector<FleetItem> path() const override;
    [[nodiscard]] QString whose() const override;

signals:
    void finished(lubberline::SwingId swing); ///< the records are made
    void cancelled();
    void abandoned(lubberline::CompassId compass); ///< of this compass: the swing that was begun stays as a draft
    /// A step that could not be stored: (swing, how many were known, step): to be kept elsewhere.
    void notStored(lubberline::SwingId swing, std::size_t place, const lubberline::JobEvent& event);

protected:
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void build();
    void refresh();
    void lookAgain();
    void finish();
    void reportFault();
    void abandon();
    void tell(job::What what);
    void readAgain(int station);
    void offerInstruments(); ///< F3
    void changeInstrument(const DatumInstrument& instrument);

    db::Stores& m_stores;
    std::function<std::string()> m_nowUtc;
    GuidedJob* m_job;
    SwingId m_swing;
    QWidget* m_work; ///< all but the start form
    QStackedWidget* m_pages;
    QStackedWidget* m_steps;
    GuidedStart* m_start;
    GuidedPrepare* m_prepare;
    GuidedStation* m_station;
    GuidedReview* m_review;
    GuidedFault* m_fault;
    QLabel* m_whose;
    QLabel* m_instrument;
    QMenu* m_instruments;
    TypedFigures* m_typed;
    bool m_storing = false; ///< what changes is what this page stores
    StationStrip* m_strip;
    SwingPlot* m_plot;
    LivePanel* m_live;
    std::unique_ptr<CrewDisplay> m_crew;
};

} // namespace lubberline::ui
