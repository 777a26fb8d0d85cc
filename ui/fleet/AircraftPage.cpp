#include "ui/fleet/AircraftPage.h"

#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QTabWidget>
#include <QTableWidget>
#include <QUndoStack>
#include <QVBoxLayout>

#include <algorithm>

#include "core/deviation/Smith.h"
#include "ui/earth/FieldText.h"
#include "ui/fleet/EventsPanel.h"
#include "ui/fleet/RecordEdits.h"
#include "ui/kit/Badge.h"
#include "ui/kit/DueBadge.h"
#include "ui/kit/OpenSwings.h"
#include "ui/kit/Words.h"
#include "ui/kit/fit/SideBySide.h"
#include "ui/kit/fit/TableFit.h"
#include "ui/plots/swing/HistoryPlot.h"
#include "ui/text/AngleWords.h"
#include "ui/text/NumberText.h"

namespace lubberline::ui {

namespace {

/// Under a heading that names the unit.
QString sizeFigure(double size_deg)
{
    return shownAngles() == AngleStyle::DegreesMinutes ? shownSize(size_deg, 2) : plainNumber(size_deg, 2);
}

enum CompassColumn { CompassName, CompassSwings, CompassState, CompassDue, kCompassColumns };
enum SwingColumn { SwungOn, Kind, Stage, State, Readings, Largest, CoefficientA, Standing = CoefficientA + 5, kSwingColumns };

QString deviationText(std::optional<double> angle_deg) { return angle_deg ? shownFigure(*angle_deg, 2) : QStringLiteral("—"); }

} // namespace

AircraftPage::AircraftPage(EditContext& context, QUndoStack& stack, QWidget* parent)
    : Page(parent)
    , m_context(context)
    , m_stack(stack)
    , m_aircraft([this](const Aircraft& after, const QString& field) {
        m_stack.push(new ChangeRecord<Aircraft>(
            m_context, after.id, m_aircraft.record(), after, tr("%1 of %2").arg(field, toText(after.registration))));
    })
    , m_compass([this](const CompassSystem& after, const QString& field) {
        m_stack.push(new ChangeRecord<CompassSystem>(
            m_context, after.aircraft, m_compass.record(), after, tr("%1 of %2").arg(field, toText(after.name))));
    })
    , m_events(new EventsPanel(context, stack))
    , m_compassTable(new QTableWidget(0, kCompassColumns))
    , m_shownCompass(new QLabel)
    , m_open(new QVBoxLayout)
    , m_swingTable(new QTableWidget(0, kSwingColumns))
{
    titleLine().setObjectName(QStringLiteral("aircraftTitle"));
    setTitle(tr("Aircraft"));
    auto* tabs = new QTabWidget;
    tabs->setDocumentMode(true);
    tabs->addTab(buildAircraftForm(), tr("&Aircraft"));
    tabs->addTab(buildCompassForm(), tr("&Compass"));
    tabs->addTab(m_events, tr("E&vents"));
    auto* splitter = new SideBySide(SideBySide::Narrow::Stays);
    splitter->addWidget(tabs);
    splitter->addWidget(buildSwings());
    splitter->setStretchFactor(0, 1);
    splitter->setStretchFactor(1, 4);
    splitter->setSizes({310, 720});
    body().addWidget(splitter, 1);
    setFocusProxy(m_swingTable);
    const auto changed = [this](AircraftId id) {
        if (id == aircraft())
            refresh();
    };
    connect(&context.stores.changes(), &db::Changes::aircraftChanged, this, changed);
    connect(&context.stores.changes(), &db::Changes::fleetChanged, this, &AircraftPage::refresh);
}

QWidget* AircraftPage::buildSwings()
{
    m_swingTable->setObjectName(QStringLiteral("swingTable"));
    wrapHeadings(*m_swingTable); // sets a header of its own: before its sections are moved
    m_swingTable->setAccessibleName(tr("Swings"));
    m_swingTable->setHorizontalHeaderLabels({tr("Date"), tr("Kind"), tr("Stage"), tr("State"), tr("N"), tr("Largest (°)"), "A (°)", "B (°)",
        "C (°)", "D (°)", "E (°)", tr("Verdict")});
    m_swingTable->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_swingTable->horizontalHeader()->setStretchLastSection(true);
    // What is looked for first stands first: on a small screen the coefficients are scrolled to.
    for (int place = 0; const int column : {SwungOn, State, Standing, Largest, Readings, Kind, Stage})
        m_swingTable->horizontalHeader()->moveSection(m_swingTable->horizontalHeader()->visualIndex(column), place++);
    m_swingTable->verticalHeader()->hide();
    m_swingTable->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
    m_swingTable->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_swingTable->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_swingTable->setSelectionMode(QAbstractItemView::SingleSelection);
    m_swingTable->setTabKeyNavigation(false);
    m_swingTable->setAlternatingRowColors(true);
    connect(m_swingTable, &QTableWidget::cellActivated, this,
        [this](int row) { emit swingChosen(m_listed.at(static_cast<std::size_t>(row))); });
    m_compassTable->setObjectName(QStringLiteral("compassTable"));
    m_compassTable->setAccessibleName(tr("Compasses of this aircraft"));
    wrapHeadings(*m_compassTable);
    m_compassTable->setHorizontalHeaderLabels({tr("Compass"), tr("Swings"), tr("State"), tr("Due")});
    m_compassTable->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_compassTable->horizontalHeader()->setStretchLastSection(true);
    m_compassTable->verticalHeader()->hide();
    m_compassTable->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
    m_compassTable->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_compassTable->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_compassTable->setSelectionMode(QAbstractItemView::SingleSelection);
    m_compassTable->setTabKeyNavigation(false);
    connect(m_compassTable, &QTableWidget::currentCellChanged, this, [this](int row) { chooseCompass(row); });
    auto* page = new QWidget;
    auto* layout = new QVBoxLayout(page);
    layout->setContentsMargins(0, 0, 0, 0);
    m_shownCompass->setObjectName(QStringLiteral("shownCompass"));
    m_shownCompass->setWordWrap(true);
    QFont strong = m_shownCompass->font();
    strong.setBold(true);
    m_shownCompass->setFont(strong);
    layout->addWidget(m_compassTable);
    layout->addWidget(m_shownCompass);
    layout->addLayout(m_open);
    m_historyPlace = new QVBoxLayout;
    layout->addLayout(m_historyPlace, 3);
    auto* hint = new QLabel(tr("Swings of this compass, newest first. Enter or double click opens one."));
    hint->setWordWrap(true);
    layout->addWidget(hint);
    layout->addWidget(m_swingTable, 2);
    return page;
}

Result<void> AircraftPage::showAircraft(AircraftId id, CompassId compass) { return load(id, compass); }

void AircraftPage::refresh()
{
    if (!aircraft().valid())
        return;
    const auto shown = load(aircraft(), compass());
    if (!shown && shown.error().code != ErrorCode::NotFound)
        emit failed(messageOf(shown.error()));
}

QString AircraftPage::typeName(AircraftTypeId id) const
{
    const auto types = m_context.stores.fleet.types();
    if (types)
        for (const TypeRow& type : *types)
            if (type.id == id)
                return tr("%1 · ").arg(toText(type.name));
    return {};
}

Result<void> AircraftPage::load(AircraftId id, CompassId compass)
{
    const auto record = m_context.stores.fleet.aircraft(id);
    if (!record)
        return record.error();
    auto compasses = m_context.stores.fleet.compassesOf(id);
    if (!compasses)
        return compasses.error();
    m_aircraft.show(*record, !m_context.stores.readOnly());
    m_compasses = std::move(compasses.value());
    listCompasses();
    m_events->showAircraft(id);
    const bool known = std::any_of(m_compasses.begin(), m_compasses.end(), [compass](const CompassRow& row) { return row.id == compass; });
    if (known || !m_compasses.empty())
        return loadCompass(known ? compass : worst());
    m_compass.show({}, false);
    showTitle();
    showSwings({}, {}, {});
    return {};
}

/// Whose page it is, down to the compass whose swings are shown.
void AircraftPage::showTitle()
{
    const Aircraft& record = m_aircraft.record();
    const QString title = typeName(record.type) + toText(record.registration) + (record.demonstration ? tr(" · DEMONSTRATION") : QString());
    setTitle(title);
    const QString name = compass().valid() ? toText(m_compass.record().name) : QString();
    if (!name.isEmpty())
        setWindowTitle(QStringLiteral("%1 · %2").arg(title, name));
    m_shownCompass->setText(name.isEmpty() ? tr("No compass is entered yet") : name);
}

void AircraftPage::listCompasses()
{
    const QSignalBlocker quiet(m_compassTable);
    m_compassChoice->clear();
    m_compassTable->setRowCount(static_cast<int>(m_compasses.size()));
    for (int row = 0; row < m_compassTable->rowCount(); ++row) {
        const CompassRow& compass = m_compasses[static_cast<std::size_t>(row)];
        m_compassChoice->addItem(badgeIcon(compass.status), tr("%1 (swings: %2)").arg(toText(compass.name)).arg(compass.swings));
        m_compassTable->setItem(row, CompassName, new QTableWidgetItem(toText(compass.name)));
        m_compassTable->setItem(row, CompassSwings, new QTableWidgetItem(QString::number(compass.swings)));
        m_compassTable->setItem(row, CompassState, new QTableWidgetItem(badgeIcon(compass.status), badgeWord(compass.status)));
        const auto due = m_due.find(compass.id);
        const DueState state = due == m_due.end() ? DueState::NotDue : due->second;
        m_compassTable->setItem(
            row, CompassDue, state == DueState::NotDue ? new QTableWidgetItem : new QTableWidgetItem(dueIcon(state), dueWord(state)));
    }
    constexpr int kMostRows = 4;
    const int rows = std::clamp(m_compassTable->rowCount(), 1, kMostRows);
    m_compassTable->setFixedHeight(heightOfRows(*m_compassTable, rows) + m_compassTable->horizontalScrollBar()->sizeHint().height());
}

CompassId AircraftPage::worst() const
{
    const auto weight = [this](const CompassRow& row) {
        const auto due = m_due.find(row.id);
        return std::pair(row.status == Status::OutOfLimits, due == m_due.end() ? DueState::NotDue : due->second);
    };
    return std::max_element(m_compasses.begin(), m_compasses.end(), [&](const CompassRow& a, const CompassRow& b) {
        return weight(a) < weight(b);
    })->id;
}

void AircraftPage::setDue(std::map<CompassId, DueState> due)
{
    m_due = std::move(due);
    if (!aircraft().valid())
        return;
    listCompasses();
    markCompass();
}

/// A guided swing that stands half-way is gone on with from here.
void AircraftPage::offerOpen()
{
    while (QLayoutItem* item = m_open->takeAt(0)) {
        item->widget()->hide();
        item->widget()->deleteLater(); // it may be the one that was pressed
        delete item;
    }
    const auto open = openSwings(m_context.stores);
    for (const OpenSwing& one : open ? *open : std::vector<OpenSwing>()) {
        if (one.compass != compass())
            continue;
        auto* button = new QPushButton(one.words);
        button->setObjectName(QStringLiteral("goOnGuided"));
        button->setAutoDefault(true);
        connect(button, &QPushButton::clicked, this, [this, swing = one.swing] { emit swingChosen(swing); });
        m_open->addWidget(button);
    }
}

void AircraftPage::chooseCompass(int row)
{
    if (row < 0 || row >= static_cast<int>(m_compasses.size()) || m_compasses[static_cast<std::size_t>(row)].id == compass())
        return;
    if (const auto shown = loadCompass(m_compasses[static_cast<std::size_t>(row)].id); !shown)
        emit failed(messageOf(shown.error()));
    else {
        m_asked = compass();
        emit stateChanged();
    }
}

void AircraftPage::markCompass()
{
    const QSignalBlocker quiet(m_compassTable);
    for (std::size_t i = 0; i < m_compasses.size(); ++i)
        if (m_compasses[i].id == compass()) {
            m_compassChoice->setCurrentIndex(static_cast<int>(i));
            m_compassTable->setCurrentCell(static_cast<int>(i), CompassName);
        }
}

void AircraftPage::loadLimits()
{
    auto profiles = m_context.stores.sites.limitsProfiles();
    m_profiles = profiles ? std::move(profiles.value()) : std::vector<LimitsProfile>();
    m_limits->clear();
    m_limits->addItem(tr("none set"));
    for (const LimitsProfile& profile : m_profiles) {
        m_limits->addItem(toText(profile.name));
        m_limits->setItemData(m_limits->count() - 1, toText(profile.document + ": " + profile.scope), Qt::ToolTipRole);
    }
}

Result<void> AircraftPage::loadCompass(CompassId id)
{
    const auto record = m_context.stores.fleet.compass(id);
    if (!record)
        return record.error();
    const auto swings = m_context.stores.swings.swingsOf(id);
    const auto marks = swings ? db::signedMarks(m_context.stores.database(), *swings) : swings.error();
    if (!marks)
        return marks.error();
    loadLimits();
    m_compass.show(*record, !m_context.stores.readOnly());
    markCompass();
    showTitle();
    offerOpen();
    showSwings(*swings, *marks, *record);
    return {};
}

void AircraftPage::showSwings(const std::vector<SwingRow>& swings, const std::vector<db::SignedMark>& marks, const CompassSystem& compass)
{
    m_listed.clear();
    m_swingTable->setRowCount(static_cast<int>(swings.size()));
    for (int row = 0; row < static_cast<int>(swings.size()); ++row) {
        const SwingRow& swing = swings[static_cast<std::size_t>(row)];
        m_listed.push_back(swing.id);
        const auto set = [this, row](int column, const QString& text, bool number) {
            auto* item = new QTableWidgetItem(text);
            item->setTextAlignment(Qt::AlignVCenter | (number ? Qt::AlignRight : Qt::AlignLeft));
            m_swingTable->setItem(row, column, item);
        };
        set(SwungOn, toText(swing.date), false);
        set(Kind, statedWord(swing.kind), false);
        set(Stage, statedWord(swing.stage), false);
        set(State, stateWords(swing.state, marks[static_cast<std::size_t>(row)]), false);
        set(Readings, QString::number(swing.readings), true);
        set(Largest, swing.maxAbsDeviation_deg ? sizeFigure(*swing.maxAbsDeviation_deg) : QStringLiteral("—"), true);
        for (const Coefficient coefficient : kCoefficients)
            set(CoefficientA + static_cast<int>(indexOf(coefficient)), deviationText(swing.coefficient_deg[indexOf(coefficient)]), true);
        set(Standing, badgeWord(swing.status), false);
        m_swingTable->item(row, Standing)->setIcon(badgeIcon(swing.status));
    }
    showHistory(swings, compass);
}

void AircraftPage::showHistory(const std::vector<SwingRow>& swings, const CompassSystem& compass)
{
    if (!m_history) {
        m_history = new HistoryPlot(this);
        m_historyPlace->addWidget(m_history);
        setTabOrder(m_history, m_swingTable); // as they are read
        follow(*m_history);
        connect(m_history, &HistoryPlot::swingSelected, this,
            [this](int swing) { emit swingChosen(m_listed.at(static_cast<std::size_t>(swing))); });
    }
    std::vector<HistoryPoint> points;
    for (std::size_t row = swings.size(); row-- > 0;) { // oldest first
        const QDate date = QDate::fromString(toText(swings[row].date), Qt::ISODate);
        if (date.isValid())
            points.push_back({date, static_cast<int>(row), swings[row].coefficient_deg, swings[row].maxAbsDeviation_deg});
    }
    const auto profile
        = std::find_if(m_profiles.begin(), m_profiles.end(), [&compass](const LimitsProfile& one) { return one.id == compass.limits; });
    m_history->setHistory(points, profile == m_profiles.end() ? std::nullopt : profile->maxDeviation_deg);
}

Plot* AircraftPage::plot() const { return m_history; }

} // namespace lubberline::ui
