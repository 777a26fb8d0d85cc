#include "ui/guided/GuidedPage.h"

#include <QMenu>
#include <QResizeEvent>
#include <QScopedValueRollback>
#include <QScrollArea>
#include <QShortcut>
#include <QSplitter>
#include <QStackedWidget>
#include <QTimer>
#include <QVBoxLayout>

#include "core/swing/Observations.h"
#include "ui/guided/BigWidgets.h"
#include "ui/guided/CrewDisplay.h"
#include "ui/guided/FrontStack.h"
#include "ui/guided/GuidedFault.h"
#include "ui/guided/GuidedPrepare.h"
#include "ui/guided/GuidedReview.h"
#include "ui/guided/GuidedStart.h"
#include "ui/guided/GuidedStation.h"
#include "ui/guided/GuidedWords.h"
#include "ui/guided/StationStrip.h"
#include "ui/guided/TypedFigures.h"
#include "ui/intake/LivePanel.h"
#include "ui/kit/OpenSwings.h"
#include "ui/kit/Words.h"
#include "ui/plots/swing/SwingPlot.h"
#include "ui/text/AngleWords.h"

namespace lubberline::ui {

namespace {

/// Beneath this the plot would take the room of the figures.
constexpr int kWide_px = 900;
constexpr int kFoot_px = 14; // all of them side by side on a small screen

} // namespace

GuidedPage::GuidedPage(db::Stores& stores, std::function<std::string()> nowUtc, QWidget* parent)
    : Page(parent)
    , m_stores(stores)
    , m_nowUtc(std::move(nowUtc))
    , m_work(new QWidget)
    , m_pages(new FrontStack)
    , m_steps(new FrontStack)
    , m_whose(bigLabel("guidedWhose", kTitle_px))
    , m_instrument(bigLabel("guidedInstrument", kTitle_px))
    , m_instruments(new QMenu(this))
    , m_strip(new StationStrip)
    , m_plot(makePolarPlot())
    , m_live(new LivePanel)
{
    GuidedServices services;
    services.nowUtc = m_nowUtc;
    services.store = [this](const SwingJob& job, const JobEvent& event) {
        const QScopedValueRollback storing(m_storing, true);
        auto stored = m_stores.jobs.append(m_swing, job.events.size(), event);
        if (!stored && stored.error().code != ErrorCode::Conflict && stored.error().code != ErrorCode::Frozen)
            emit notStored(m_swing, job.events.size(), event);
        return stored;
    };
    m_job = new GuidedJob(std::move(services), this);
    m_start = new GuidedStart(stores);
    m_prepare = new GuidedPrepare(*m_job);
    m_station = new GuidedStation(*m_job);
    m_review = new GuidedReview(*m_job);
    m_fault = new GuidedFault(*m_job);
    build();
    m_typed = new TypedFigures(stores, *m_steps, this);
    connect(m_typed, &TypedFigures::failed, this, &GuidedPage::failed);
    connect(&stores.changes(), &db::Changes::swingChanged, this, [this](SwingId id) {
        if (id == m_swing)
            lookAgain();
    });
    connect(&stores.changes(), &db::Changes::fleetChanged, this, &GuidedPage::lookAgain);
}

GuidedPage::~GuidedPage() { m_typed->settle(); }

void GuidedPage::build()
{
    for (QWidget* step : std::initializer_list<QWidget*>{m_prepare, m_station, m_review, m_fault})
        m_steps->addWidget(step);
    m_whose->setAlignment(Qt::AlignRight);
    setTitle(tr("Guided swing"));
    titleLine().setFont(bigFont(titleLine().font(), kTitle_px, true));
    titleLine().setWordWrap(true);
    head().addWidget(m_whose, 1);
    auto* middle = new QSplitter;
    middle->addWidget(m_steps);
    middle->addWidget(m_plot);
    middle->setStretchFactor(0, 3);
    middle->setStretchFactor(1, 2);
    auto* foot = new QHBoxLayout;
    auto* instrument = bigButton(tr("Instrument (F3)"), "changeInstrument");
    auto* crew = bigButton(tr("Crew display (F11)"), "crewDisplayButton");
    auto* fault = bigButton(tr("Fault… (F8)"), "reportFault");
    auto* live = bigButton(tr("Live (F12)"), "showLive");
    live->setCheckable(true);
    for (QPushButton* button : {instrument, live, crew, fault}) {
        button->setFont(bigFont(button->font(), kFoot_px));
        foot->addWidget(button);
    }
    foot->addStretch();
    auto* column = new QVBoxLayout(m_work);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_instrument);
    column->addWidget(middle, 1);
    column->addWidget(m_live);
    m_live->setObjectName(QStringLiteral("liveStrip"));
    m_live->hide();
    column->addWidget(m_strip);
    column->addLayout(foot);
    m_pages->addWidget(m_start);
    m_pages->addWidget(m_work);
    body().addWidget(m_pages, 1);

    connect(m_start, &GuidedStart::started, this, [this](SwingId swing) {
        if (const auto taken = takeUp(swing); !taken)
            emit failed(messageOf(taken.error()));
    });
    connect(m_start, &GuidedStart::cancelled, this, &GuidedPage::cancelled);
    connect(m_job, &GuidedJob::changed, this, &GuidedPage::refresh);
    follow(*m_plot);
    connect(m_prepare, &GuidedPrepare::failed, this, &GuidedPage::failed);
    connect(m_station, &GuidedStation::failed, this, &GuidedPage::failed);
    connect(m_review, &GuidedReview::failed, this, &GuidedPage::failed);
    connect(m_fault, &GuidedFault::failed, this, &GuidedPage::failed);
    connect(m_fault, &GuidedFault::givenUp, this, &GuidedPage::abandon);
    connect(m_review, &GuidedReview::finish, this, &GuidedPage::finish);
    connect(m_start, &GuidedStart::goOn, this, [this](SwingId swing) {
        if (const auto taken = takeUp(swing); !taken)
            emit failed(messageOf(taken.error()));
    });
    connect(m_strip, &StationStrip::wanted, this, &GuidedPage::readAgain);
    connect(m_strip, &StationStrip::chosen, this, &GuidedPage::readOut);
    connect(instrument, &QPushButton::clicked, this, &GuidedPage::offerInstruments);
    connect(crew, &QPushButton::clicked, this, &GuidedPage::openCrewDisplay);
    connect(fault, &QPushButton::clicked, this, &GuidedPage::reportFault);
    connect(live, &QPushButton::toggled, this, &GuidedPage::showLive);
    connect(m_live, &LivePanel::failed, this, &GuidedPage::failed);
    connect(m_live, &LivePanel::datumSettled, m_station, &GuidedStation::setDatum);
    connect(m_live, &LivePanel::compassSettled, m_station, &GuidedStation::setCompass);
    auto* toggle = new QShortcut(QKeySequence(Qt::Key_F12), this);
    toggle->setContext(Qt::WidgetWithChildrenShortcut);
    connect(toggle, &QShortcut::activated, live, &QPushButton::toggle);
    for (const auto& [code, take] : {std::pair{Qt::Key_F6, &LivePanel::takeDatum}, {Qt::Key_F7, &LivePanel::takeCompass}}) {
        auto* shortcut = new QShortcut(QKeySequence(code), this);
        shortcut->setContext(Qt::WidgetWithChildrenShortcut);
        connect(shortcut, &QShortcut::activated, m_live, take);
    }
    const auto key = [this](Qt::Key code, void (GuidedPage::*act)()) {
        auto* shortcut = new QShortcut(QKeySequence(code), this);
        shortcut->setContext(Qt::WidgetWithChildrenShortcut);
        connect(shortcut, &QShortcut::activated, this, act);
    };
    key(Qt::Key_F3, &GuidedPage::offerInstruments);
    key(Qt::Key_F11, &GuidedPage::openCrewDisplay);
    key(Qt::Key_F8, &GuidedPage::reportFault);
}

Result<void> GuidedPage::begin(CompassId compass)
{
    if (auto begun = m_start->begin(compass, m_stores.clock().today()); !begun)
        return begun;
    m_typed->settle();
    m_typed->forget();
    m_swing = {};
    m_job->close();
    m_pages->setCurrentWidget(m_start);
    m_whose->setText(m_start->whose());
    setTitle(tr("Guided swing"));
    m_start->setFocus();
    return {};
}

Result<void> GuidedPage::takeUp(SwingId swing)
{
    auto found = m_stores.jobs.jobOf(swing);
    if (!found)
        return found.error();
    if (!*found || (*found)->swing != swing)
        return Error{ErrorCode::NotFound, said(tr("this swing is not a guided one"))};
    if (!isOpenJob(m_stores, swing))
        return Error{ErrorCode::Frozen, said(tr("this guided swing is finished; nothing is added to it"))};
    const auto record = m_stores.swings.record(swing);
    if (!record)
        return record.error();
    std::shared_ptr<const Analysis> analysis;
    QString label;
    if (const auto previous = m_stores.swings.previous(swing); previous && *previous)
        if (auto made = m_stores.results.resultOf((*previous)->id)) {
            analysis = std::make_shared<const Analysis>(std::move(made.value()));
            label = toText((*previous)->date);
        }
    const auto siblings = m_stores.results.siblingsOf(*record);
    if (!siblings)
        return siblings.error();
    m_swing = swing;
    if (auto opened = m_job->open((*found)->job, *record, std::move(analysis), label, *siblings); !opened)
        return opened;
    m_pages->setCurrentWidget(m_work);
    refresh();
    emit stateChanged();
    return {};
}

QString GuidedPage::whose() const { return m_whose->text(); }

void GuidedPage::refresh()
{
    const auto& state = m_job->state();
    m_whose->setText(QStringLiteral("%1 · %2").arg(toText(m_job->record().aircraft.registration), toText(m_job->record().compass.name)));
    setTitle(stepTitle(*m_job));
    m_strip->show(state);
    m_instrument->setText(inAngleStyle(instrumentWords(*m_job)));
    const DatumInstrument& datum = m_job->datum();
    m_live->setDatum({sendsHeadings(datum.kind), datum.givesTrue, m_job->job().particulars.variation_deg});
    switch (state.phase) {
    case JobPhase::Prepare:
        m_prepare->refresh();
        m_steps->setCurrentWidget(m_prepare);
        if (!m_prepare->isAncestorOf(focusWidget())) // who ticks goes on from where he is
            m_prepare->focusField();
        break;
    case JobPhase::Stations:
    case JobPhase::Index:
        m_station->refresh();
        m_steps->setCurrentWidget(m_station);
        m_station->focusField();
        break;
    case JobPhase::Review:
    case JobPhase::Card:
        m_review->refresh();
        m_steps->setCurrentWidget(m_review);
        m_review->focusField();
        break;
    case JobPhase::Fault:
    case JobPhase::Abandoned:
        m_steps->setCurrentWidget(m_fault);
        m_fault->refresh();
        break;
    }
    m_typed->follow(m_swing, m_job->job().events.size());
    m_plot->setPicture(m_job->picture());
    if (state.current >= 0)
        m_plot->setSelectedRow(-1);
}

void GuidedPage::reportFault()
{
    if (!m_job->isOpen() || m_steps->currentWidget() == m_fault) {
        if (m_job->isOpen())
            refresh(); // back to the step
        return;
    }
    m_steps->setCurrentWidget(m_fault);
    m_fault->ask();
}

/// That it was given up is a step of the job by now; the swing stays as a draft.
void GuidedPage::abandon()
{
    const QScopedValueRollback storing(m_storing, true);
    if (const auto done = m_stores.jobs.abandon(m_swing); !done) {
        emit failed(messageOf(done.error()));
        return;
    }
    m_typed->forget();
    emit abandoned(m_job->record().compass.id);
}

void GuidedPage::readAgain(int station)
{
    const StationState& one = m_job->state().stations.at(static_cast<std::size_t>(station));
    if (one.skipped.empty() && !one.reading)
        emit readOut(tr("%1 comes in its turn").arg(stationHeading(one.station.nominal_deg)));
    else
        m_station->readAgainAt(station);
}

void GuidedPage::offerInstruments()
{
    if (!m_job->isOpen())
        return;
    const auto known = m_stores.sites.instruments();
    if (!known) {
        emit failed(messageOf(known.error()));
        return;
    }
    m_instruments->clear();
    std::vector<DatumInstrument> all = known.value();
    all.push_back(plainDatum());
    for (const DatumInstrument& one : all) {
        auto* action = m_instruments->addAction(toText(one.name));
        action->setCheckable(true);
        action->setChecked(one.name == m_job->datum().name);
        connect(action, &QAction::triggered, this, [this, one] { changeInstrument(one); });
    }
    m_instruments->popup(mapToGlobal(rect().center()));
}

/// What is true wants the variation, which is of the swing: without one its figures would mean nothing.
void GuidedPage::changeInstrument(const DatumInstrument& instrument)
{
    if (instrument.name == m_job->datum().name)
        return;
    if (instrument.givesTrue && !m_job->job().particulars.variation_deg) {
        emit failed(
            tr("%1 gives true headings, and this swing has no variation: begin it with a site that has one.").arg(toText(instrument.name)));
        return;
    }
    tell(job::DatumChanged{instrument});
}

void GuidedPage::tell(job::What what)
{
    if (const auto told = m_job->tell(std::move(what)); !told)
        emit failed(messageOf(told.error()));
}

void GuidedPage::finish()
{
    const auto& job = m_job->job();
    const auto& state = m_job->state();
    Swing main = asLeftSwing(job, state);
    main.startUtc = job.events.empty() ? std::string() : job.events.front().timeUtc;
    main.endUtc = job.events.empty() ? std::string() : job.events.back().timeUtc;
    std::vector<Swing> further = furtherSwings(job, state, main, m_stores.clock().today());
    m_job->tellDatumErrors(main);
    for (Swing& swing : further)
        m_job->tellDatumErrors(swing);
    const QScopedValueRollback storing(m_storing, true);
    if (const auto done = m_stores.jobs.finish(m_swing, main, further); !done) {
        emit failed(messageOf(done.error()));
        return;
    }
    m_typed->forget();
    const SwingId made = m_swing;
    m_job->close();
    if (m_crew)
        m_crew->close();
    emit finished(made);
}

/// On a small screen the page scrolls: what was asked for comes into sight when it has got its place.
void GuidedPage::showLive(bool shown)
{
    m_live->setVisible(shown);
    if (shown)
        QTimer::singleShot(0, m_live, [this] {
            for (QWidget* around = m_live->parentWidget(); around; around = around->parentWidget())
                if (auto* scrolled = qobject_cast<QScrollArea*>(around))
                    scrolled->ensureWidgetVisible(m_live);
        });
}

void GuidedPage::openCrewDisplay()
{
    if (!m_job->isOpen())
        return;
    if (!m_crew)
        m_crew = std::make_unique<CrewDisplay>(*m_job);
    if (m_crew->isVisible())
        m_crew->close();
    else
        m_crew->open();
}

void GuidedPage::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    m_plot->setVisible(width() >= kWide_px);
}

/// What was typed last is kept before anything else is shown.
void GuidedPage::hideEvent(QHideEvent* event)
{
    QWidget::hideEvent(event);
    m_typed->settle();
}

void GuidedPage::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    QTimer::singleShot(0, this, &GuidedPage::lookAgain); // when it is in front
    if (m_pages->currentWidget() == m_work && m_job->isOpen())
        refresh();
    else if (m_pages->currentWidget() == m_start)
        m_start->setFocus();
}

} // namespace lubberline::ui
