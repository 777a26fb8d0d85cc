#pragma once
/// Every page of the window with each of its tabs, panels and steps in front, one after the other: for tests that look at all of them.

#include <QAbstractButton>
#include <QCheckBox>
#include <QComboBox>
#include <QRadioButton>
#include <QTabWidget>

#include <functional>

#include "tests/ui/window/Fixture.h"
#include "ui/guided/GuidedPage.h"
#include "ui/guided/GuidedStation.h"
#include "ui/intake/ImportPanels.h"
#include "ui/kit/Words.h"
#include "ui/window/PageStack.h"

namespace lubberline::ui {

using LookAt = std::function<void(const QString& where)>;

namespace every {

inline void settle()
{
    for (int i = 0; i < 3; ++i)
        QApplication::processEvents();
}

/// Each tab of what is in front, and each panel that a button opens.
inline void partsOf(QWidget& page, const QString& where, const LookAt& look)
{
    settle();
    look(where);
    for (auto* tabs : page.findChildren<QTabWidget*>()) {
        if (!tabs->isVisible())
            continue;
        const int before = tabs->currentIndex();
        for (int tab = 0; tab < tabs->count(); ++tab) {
            tabs->setCurrentIndex(tab);
            settle();
            look(QStringLiteral("%1, tab %2").arg(where, tabs->tabText(tab)));
        }
        tabs->setCurrentIndex(before);
    }
    for (auto* choice : page.findChildren<QComboBox*>()) {
        if (!choice->isVisible() || !choice->isEnabled() || choice->isEditable() || choice->objectName().isEmpty())
            continue;
        const int before = choice->currentIndex();
        for (int one = 0; one < choice->count(); ++one) {
            choice->setCurrentIndex(one);
            settle();
            look(QStringLiteral("%1, %2 of %3").arg(where, choice->currentText(), choice->objectName()));
        }
        choice->setCurrentIndex(before);
        settle();
    }
    for (auto* button : page.findChildren<QAbstractButton*>()) {
        if (!button->isVisible() || !button->isEnabled() || !button->isCheckable() || button->objectName().isEmpty()
            || qobject_cast<QCheckBox*>(button) || qobject_cast<QRadioButton*>(button))
            continue;
        const bool before = button->isChecked();
        button->setChecked(!before);
        settle();
        look(QStringLiteral("%1, %2").arg(where, button->objectName()));
        button->setChecked(before);
    }
    settle();
}

/// The steps of a guided swing, from the preparation to the review, with a fault on the way.
inline void stepsOfGuided(OpenWindow& open, SmallFleet& fleet, const LookAt& look)
{
    SwingJob job;
    job.plan.checkPoints = 8;
    job.checklist = {"All movable parts, doors and seats as in flight, gear down and locked", "No magnetic tools near the compass"};
    job.datum.name = "sighting compass of the hangar";
    job.datum.kind = DatumKind::SightingCompass;
    job.datum.ahead = SightingDirection::Reciprocal;
    Swing particulars;
    particulars.compass = fleet.compass;
    particulars.date = "2026-11-23";
    const auto id = fleet.stores.jobs.start(particulars, job);
    if (!id)
        qFatal("no guided swing: %s", qPrintable(messageOf(id.error())));
    open.window.go(*id);
    auto& page = dynamic_cast<GuidedPage&>(open.window.findChild<PageStack*>()->current());
    const auto tell = [&](job::What what) {
        if (const auto told = page.job().tell(std::move(what)); !told)
            qFatal("guided: %s", qPrintable(messageOf(told.error())));
    };
    partsOf(page, QStringLiteral("guided, preparation"), look);
    for (const auto& item : job.checklist)
        tell(job::Ticked{item, true});
    tell(job::InterferenceRead{0, "engines and electrics", 1, 3});
    settle();
    look(QStringLiteral("guided, prepared"));
    tell(job::Prepared{});
    bool skipped = false, turned = false;
    for (int guard = 0; guard < 60 && page.job().state().phase != JobPhase::Review; ++guard) {
        const JobState state = page.job().state();
        const QString where = QStringLiteral("guided, station %1").arg(state.current);
        if (guard < 2 || state.turn || state.phase == JobPhase::Index)
            partsOf(page, where, look);
        if (state.phase == JobPhase::Index) {
            tell(job::IndexLeft{"below half a degree, the mount stays as it is"});
        } else if (state.turn) {
            if (!turned)
                look(where + QStringLiteral(", turn"));
            turned = true;
            tell(job::Adjusted{state.current, state.turn->control, state.turn->compassReads_deg, state.turn->makeCompassRead_deg,
                state.turn->makeCompassRead_deg, {}});
        } else if (const StationState& here = state.stations[static_cast<std::size_t>(state.current)];
                   here.reading && !here.voided && here.correctionsDone < here.station.corrections.size()) {
            tell(job::NotAdjusted{state.current, here.station.corrections[here.correctionsDone].control, "its stop is reached"});
        } else if (!skipped && here.station.phase == StationPhase::Check) {
            skipped = true;
            page.station().skip();
            partsOf(page, where + QStringLiteral(", skip"), look);
            tell(job::StationSkipped{state.current, "the tug cannot get there"});
        } else {
            const double nominal = here.station.nominal_deg;
            tell(job::ReadingTaken{
                state.current, {{nominal}, {}, {nominal}}, nominal, wrap360(nominal - 2 * std::cos(toRadians(nominal))), {}});
        }
    }
    partsOf(page, QStringLiteral("guided, review"), look);
    tell(job::Faulted{"the tow bar has broken"});
    partsOf(page, QStringLiteral("guided, fault"), look);
    open.window.go(fleet.aircraft);
}

} // namespace every

/// @param look is told what is in front each time.
inline void everyPage(OpenWindow& open, SmallFleet& fleet, const LookAt& look)
{
    using namespace std::chrono;
    fleet.stores.setClock(
        {[] { return Clock::Time(sys_days(2026y / November / 24) + hours(10)); }}); // the sun stands over the demonstration's places
    const SwingId draft = fleet.addSwing("2026-11-21", eightPoints()), complete = fleet.addSwing("2026-11-22", eightPoints());
    if (!fleet.stores.signing.complete(complete))
        qFatal("the swing is not complete");
    fleet.stores.changes().announceFleet();
    auto* stack = open.window.findChild<PageStack*>();
    for (const PageDescription& page : stack->descriptions()) {
        const auto opened = [&](const FleetItem& record) { return static_cast<bool>(stack->show(Destination{page.id, record})); };
        if (!opened(fleet.compass) && !opened(draft))
            qFatal("the page %s opens neither a compass nor a swing", qPrintable(page.id));
        every::partsOf(stack->current(), page.id, look);
    }
    open.window.go(complete);
    every::partsOf(stack->current(), QStringLiteral("swing, complete"), look);
    every::stepsOfGuided(open, fleet, look);
    open.window.go({});
    const QString longName = QString(150, QChar('x')) + ".csv";
    open.window.fail(QStringLiteral("/media/stick/%1:12: the heading 361 is none; expected 0 to 360").arg(longName));
    every::settle();
    look(QStringLiteral("a message"));
    open.window.messages().clear();
    open.find<NamingStrip>("namingStrip").ask(longName, {});
    every::settle();
    look(QStringLiteral("whose swing"));
    open.find<NamingStrip>("namingStrip").hide();
}

} // namespace lubberline::ui
