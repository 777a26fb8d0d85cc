#include "ui/fleet/PopulationPage.h"

#include <QComboBox>
#include <QFileInfo>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSlider>
#include <QSpinBox>
#include <QSplitter>
#include <QTabWidget>
#include <QTableWidget>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

#include "core/base/OutputFile.h"
#include "core/format/results/FleetJson.h"
#include "db/stores/PopulationStore.h"
#include "ui/fleet/PaintedPlot.h"
#include "ui/kit/Words.h"
#include "ui/report/fleet/FleetDocument.h"
#include "ui/report/fleet/FleetTables.h"

namespace lubberline::ui {

namespace {

constexpr int kFirstLook = 1500;           ///< swings: read and computed well within a third of a second
constexpr std::size_t kRowsAtOnce = 500;   ///< of a table on screen; files have all
constexpr std::size_t kSwingsBehind = 300; ///< of a heading: those farthest from the mean
constexpr int kFilmStep_ms = 700;

void makePlain(QTableWidget& table, const char* name)
{
    table.setObjectName(QString::fromLatin1(name));
    table.verticalHeader()->hide();
    table.horizontalHeader()->setStretchLastSection(true);
    table.setEditTriggers(QAbstractItemView::NoEditTriggers);
    table.setSelectionBehavior(QAbstractItemView::SelectRows);
    table.setSelectionMode(QAbstractItemView::SingleSelection);
    table.setTabKeyNavigation(false);
}

/// A table of the report on screen.
void setTable(QTableWidget& widget, const Table& table)
{
    QStringList heads;
    for (const auto& column : table.columns) {
        QStringList lines{column.head, column.argument, column.unit};
        lines.removeAll(QString());
        heads += lines.join('\n');
    }
    widget.setColumnCount(static_cast<int>(heads.size()));
    widget.setHorizontalHeaderLabels(heads);
    const auto rows = std::min(table.rows.size(), kRowsAtOnce);
    widget.setRowCount(static_cast<int>(rows));
    for (std::size_t row = 0; row < rows; ++row)
        for (std::size_t column = 0; column < table.columns.size(); ++column) {
            auto* item = new QTableWidgetItem(table.rows[row].cells.value(static_cast<qsizetype>(column)));
            item->setToolTip(item->text());
            const bool left = table.columns[column].align == TableColumn::Align::Left;
            item->setTextAlignment((left ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
            if (table.rows[row].look == TableRow::Look::Marked) {
                QFont bold = widget.font();
                bold.setBold(true);
                item->setFont(bold);
            }
            widget.setItem(static_cast<int>(row), static_cast<int>(column), item);
        }
    widget.resizeColumnsToContents();
}

QComboBox* named(QComboBox* box, const char* name)
{
    box->setObjectName(QString::fromLatin1(name));
    box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    return box;
}

/// The chosen item's data: a name, empty for "all".
std::string chosen(const QComboBox& box) { return box.currentData().toString().toStdString(); }

} // namespace

PopulationPage::PopulationPage(db::Stores& stores, FileQuestions questions, QWidget* parent)
    : Page(parent)
    , m_stores(stores)
    , m_questions(std::move(questions))
    , m_type(named(new QComboBox, "populationType"))
    , m_compass(named(new QComboBox, "populationCompass"))
    , m_base(named(new QComboBox, "populationSite"))
    , m_stage(named(new QComboBox, "populationStage"))
    , m_vote(named(new QComboBox, "populationVote"))
    , m_grid(new QSpinBox)
    , m_state(new QLabel)
    , m_progress(new QProgressBar)
    , m_compute(new QPushButton(tr("&Compute")))
    , m_cancel(new QPushButton(tr("Ca&ncel")))
    , m_save(new QPushButton(tr("&Save the report…")))
    , m_tabs(new QTabWidget)
    , m_curve(new PaintedPlot(QStringLiteral("populationCurve"),
          [this](QPainter& p, const QRectF& r, const FleetLook& l) { paintPopulationCurve(p, r, drawing(), l); }))
    , m_polar(new PaintedPlot(QStringLiteral("populationPolar"),
          [this](QPainter& p, const QRectF& r, const FleetLook& l) { paintPopulationPolar(p, r, drawing(), l); }))
    , m_swings(new QTableWidget)
    , m_behindWords(new QLabel)
    , m_ranking(new QTableWidget)
    , m_historyChoice(named(new QComboBox, "populationHistory"))
    , m_film(new QSlider(Qt::Horizontal))
    , m_play(new QPushButton(tr("&Play")))
    , m_timer(new QTimer(this))
    , m_coefficients(new PaintedPlot(QStringLiteral("historyCoefficients"),
          [this](QPainter& p, const QRectF& r, const FleetLook& l) { paintCoefficientHistory(p, r, m_history, l); }))
    , m_curves(new PaintedPlot(QStringLiteral("historyCurves"),
          [this](QPainter& p, const QRectF& r, const FleetLook& l) { paintCurveHistory(p, r, m_history, l); }))
    , m_historyWords(new QLabel)
    , m_tables(new QTabWidget)
    , m_worker([this](Result<std::shared_ptr<const PopulationNews>> news) { take(std::move(news)); },
          [this](int percent) { m_progress->setValue(percent); })
{
    build();
}

PopulationPage::~PopulationPage() { m_worker.cancel(); }

void PopulationPage::build()
{
    m_tabs->setObjectName(QStringLiteral("populationTabs"));
    m_tabs->addTab(buildPattern(), tr("Pattern"));
    m_tabs->addTab(buildRanking(), tr("Who next"));
    m_tabs->addTab(buildHistory(), tr("History of a compass"));
    m_tables->setObjectName(QStringLiteral("populationTables"));
    m_tables->setTabPosition(QTabWidget::South);
    m_tabs->addTab(m_tables, tr("Tables"));
    setTitle(tr("Years as a population"));
    body().addWidget(buildFilters());
    body().addWidget(m_tabs, 1);
    setFocusProxy(m_compute);
}

QWidget* PopulationPage::buildFilters()
{
    m_stage->addItem(tr("found and left"));
    m_stage->addItem(tr("as found"));
    m_stage->addItem(tr("as left"));
    m_vote->addItem(tr("one aircraft, one vote"));
    m_vote->addItem(tr("one swing, one vote"));
    m_grid->setObjectName(QStringLiteral("populationGrid"));
    m_grid->setRange(3, 360);
    m_grid->setValue(8);
    m_grid->setSuffix(tr(" headings"));
    m_compute->setObjectName(QStringLiteral("populationCompute"));
    m_cancel->setObjectName(QStringLiteral("populationCancel"));
    m_save->setObjectName(QStringLiteral("populationSave"));
    m_cancel->setEnabled(false);
    m_save->setEnabled(false);
    m_progress->setRange(0, 100);
    m_progress->setMaximumWidth(140);
    m_state->setObjectName(QStringLiteral("populationState"));
    auto* panel = new QWidget;
    auto* rows = new QVBoxLayout(panel);
    rows->setContentsMargins(0, 0, 0, 0);
    auto* first = new QHBoxLayout;
    for (QWidget* part : std::initializer_list<QWidget*>{m_type, m_compass, m_base, m_stage, m_vote, m_grid})
        first->addWidget(part);
    first->addStretch(1);
    auto* second = new QHBoxLayout;
    for (QWidget* part : std::initializer_list<QWidget*>{m_compute, m_cancel, m_progress})
        second->addWidget(part);
    second->addWidget(m_state, 1);
    second->addWidget(m_save);
    rows->addLayout(first);
    rows->addLayout(second);
    connect(m_compute, &QPushButton::clicked, this, &PopulationPage::compute);
    connect(m_cancel, &QPushButton::clicked, this, [this] { m_worker.cancel(); });
    connect(m_save, &QPushButton::clicked, this, &PopulationPage::save);
    return panel;
}

QWidget* PopulationPage::buildPattern()
{
    makePlain(*m_swings, "populationSwings");
    m_swings->setColumnCount(5);
    m_swings->setHorizontalHeaderLabels({tr("date"), tr("aircraft"), tr("compass"), tr("deviation"), tr("how")});
    m_behindWords->setWordWrap(true);
    m_behindWords->setText(tr("Click a heading: the swings behind it stand here."));
    auto* behind = new QWidget;
    auto* column = new QVBoxLayout(behind);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_behindWords);
    column->addWidget(m_swings, 1);
    auto* lower = new QSplitter(Qt::Horizontal);
    lower->addWidget(m_polar);
    lower->addWidget(behind);
    auto* all = new QSplitter(Qt::Vertical);
    all->addWidget(m_curve);
    all->addWidget(lower);
    const auto heading = [this](const PaintedPlot& plot, bool polar, const QPointF& at) {
        return polar ? polarHeadingAt(plot.plotRect(), drawing(), plot.look(), at)
                     : curveHeadingAt(plot.plotRect(), drawing(), plot.look(), at);
    };
    for (auto* plot : {m_curve, m_polar}) {
        connect(plot, &PaintedPlot::clicked, this, [this, plot, heading](const QPointF& at) {
            if (const auto found = heading(*plot, plot == m_polar, at))
                choose(*found);
        });
        connect(plot, &PaintedPlot::hovered, this, [this, plot, heading](const QPointF& at) {
            const auto found = heading(*plot, plot == m_polar, at);
            if (!found || !m_news)
                return;
            for (const auto& point : m_news->report.pattern.points)
                if (std::abs(point.heading_deg - *found) < 1e-6 && point.mean_deg)
                    emit readOut(tr("%1°: mean %2°, between aircraft ± %3°, %4 votes")
                                     .arg(point.heading_deg, 0, 'f', 1)
                                     .arg(signedNumber(*point.mean_deg, 2), numberText(point.between_deg))
                                     .arg(point.units));
        });
    }
    connect(m_swings, &QTableWidget::itemActivated, this, [this](QTableWidgetItem* item) {
        if (const auto row = static_cast<std::size_t>(item->row()); row < m_behind.size())
            emit openSwing(m_behind[row]);
    });
    return all;
}

QWidget* PopulationPage::buildRanking()
{
    makePlain(*m_ranking, "populationRanking");
    connect(m_ranking, &QTableWidget::itemActivated, this, [this](QTableWidgetItem* item) {
        const auto row = static_cast<std::size_t>(item->row());
        if (m_news && row < m_news->report.ranking.compasses.size()) {
            showHistory(m_news->report.ranking.compasses[row].compass);
            m_tabs->setCurrentIndex(2);
        }
    });
    return m_ranking;
}

QWidget* PopulationPage::buildHistory()
{
    m_film->setObjectName(QStringLiteral("historyFilm"));
    m_film->setToolTip(tr("The swings one after the other"));
    m_play->setObjectName(QStringLiteral("historyPlay"));
    m_historyWords->setWordWrap(true);
    m_historyWords->setObjectName(QStringLiteral("historyWords"));
    m_timer->setInterval(kFilmStep_ms);
    auto* row = new QHBoxLayout;
    row->addWidget(m_historyChoice);
    row->addWidget(m_film, 1);
    row->addWidget(m_play);
    auto* plots = new QSplitter(Qt::Horizontal);
    plots->addWidget(m_coefficients);
    plots->addWidget(m_curves);
    auto* panel = new QWidget;
    auto* column = new QVBoxLayout(panel);
    column->addLayout(row);
    column->addWidget(plots, 1);
    column->addWidget(m_historyWords);
    connect(m_historyChoice, &QComboBox::activated, this, [this] { showHistory(m_historyChoice->currentData().toInt()); });
    connect(m_film, &QSlider::valueChanged, this, [this](int shown) {
        m_history.shown = static_cast<std::size_t>(shown);
        m_coefficients->update();
        m_curves->update();
    });
    connect(m_play, &QPushButton::clicked, this, [this] {
        if (m_timer->isActive())
            return m_timer->stop();
        m_film->setValue(m_film->minimum());
        m_timer->start();
    });
    connect(m_timer, &QTimer::timeout, this, &PopulationPage::step);
    return panel;
}

void PopulationPage::step()
{
    if (m_film->value() >= m_film->maximum())
        m_timer->stop();
    else
        m_film->setValue(m_film->value() + 1);
}

void PopulationPage::loadChoices()
{
    const auto reload = [](QComboBox& box, const QString& all, const QStringList& names) {
        const QString kept = box.currentData().toString();
        box.clear();
        box.addItem(all, QString());
        for (const auto& name : names)
            box.addItem(name, name);
        box.setCurrentIndex(std::max(0, box.findData(kept)));
    };
    QStringList types, bases;
    if (const auto found = m_stores.fleet.types())
        for (const auto& type : *found)
            types += toText(type.name);
    if (const auto found = m_stores.sites.sites())
        for (const auto& site : *found)
            bases += toText(site.name);
    reload(*m_type, tr("all types"), types);
    reload(*m_base, tr("all bases"), bases);
    QStringList names;
    if (m_news)
        for (const auto& compass : m_news->fleet.compasses)
            if (const QString name = toText(compass.compass); !names.contains(name) && names.size() < 50)
                names += name;
    if (const QString kept = m_compass->currentData().toString(); !kept.isEmpty() && !names.contains(kept))
        names += kept;
    reload(*m_compass, tr("all compass systems"), names);
}

Result<void> PopulationPage::open(const FleetItem& record)
{
    loadChoices();
    m_wantedCompass = {};
    if (const auto* type = std::get_if<AircraftTypeId>(&record); type && type->valid()) {
        const auto found = m_stores.fleet.type(*type);
        if (!found)
            return found.error();
        m_type->setCurrentIndex(std::max(0, m_type->findData(toText(found->name))));
    } else if (const auto* compassId = std::get_if<CompassId>(&record); compassId && compassId->valid()) {
        m_wantedCompass = *compassId;
        const auto compass = m_stores.fleet.compass(*compassId);
        const auto aircraft = compass ? m_stores.fleet.aircraft(compass->aircraft) : Result<Aircraft>(compass.error());
        const auto aircraftType = aircraft ? m_stores.fleet.type(aircraft->type) : Result<AircraftType>(aircraft.error());
        if (!aircraftType)
            return aircraftType.error();
        m_type->setCurrentIndex(std::max(0, m_type->findData(toText(aircraftType->name))));
    }
    compute();
    return {};
}

void PopulationPage::fleetChanged()
{
    if (m_news)
        m_state->setText(tr("The fleet has changed since: compute again."));
}

FleetSelection PopulationPage::selection() const
{
    FleetSelection selection;
    selection.type = chosen(*m_type);
    selection.compass = chosen(*m_compass);
    selection.site = chosen(*m_base);
    return selection;
}

FleetOptions PopulationPage::options() const
{
    FleetOptions options;
    options.grid = m_grid->value();
    options.vote = m_vote->currentIndex() == 1 ? FleetVote::Swing : FleetVote::Aircraft;
    if (m_stage->currentIndex() > 0)
        options.stage = m_stage->currentIndex() == 1 ? SwingStage::AsFound : SwingStage::AsLeft;
    options.today_day = dayOfDate(m_stores.clock().today().text()).value_or(0);
    return options;
}

namespace {

/// Runs on the worker.
Result<std::shared_ptr<const PopulationNews>> populationNews(
    const db::Stores& from, const FleetSelection& selection, FleetOptions options, bool firstLook, const Progress& progress)
{
    auto stores = from.openForWorker();
    if (!stores)
        return stores.error();
    const auto part = [&progress](double begin, double end) {
        return [&progress, begin, end](double f) { return progress(begin + f * (end - begin)); };
    };
    auto fleet = db::PopulationStore((*stores)->database()).columns(selection, part(0, 0.4), firstLook ? kFirstLook : 0);
    if (!fleet)
        return fleet.error();
    options.variance = !firstLook;
    auto report = fleetReportOf(*fleet, options, part(0.4, 1.0));
    if (!report)
        return report.error();
    return std::shared_ptr<const PopulationNews>(
        std::make_shared<PopulationNews>(PopulationNews{std::move(fleet.value()), std::move(report.value()), selection, firstLook}));
}

} // namespace

void PopulationPage::compute()
{
    m_cancel->setEnabled(true);
    m_state->setText(tr("A first look at a part of the swings…"));
    m_worker.start([&stores = m_stores, selection = selection(), options = options()](
                       const Progress& progress) { return populationNews(stores, selection, options, true, progress); });
}

void PopulationPage::computeWhole()
{
    m_state->setText(tr("All swings are read and computed…"));
    m_worker.start([&stores = m_stores, selection = m_news->selection, options = options()](
                       const Progress& progress) { return populationNews(stores, selection, options, false, progress); });
}

void PopulationPage::take(Result<std::shared_ptr<const PopulationNews>> news)
{
    if (!news) {
        m_cancel->setEnabled(false);
        m_progress->reset();
        m_state->setText(
            news.error().code == ErrorCode::Cancelled ? tr("Cancelled: what was computed before stays.") : messageOf(news.error()));
        return;
    }
    m_news = std::move(news.value());
    m_chosen_deg.reset();
    loadChoices();
    fill();
    emit computed(!m_news->firstLook);
    if (m_news->firstLook)
        return computeWhole();
    m_cancel->setEnabled(false);
    m_save->setEnabled(true);
    m_progress->setValue(100);
    m_state->setText(tr("%1 swings of %2 aircraft.").arg(m_news->report.counts.used).arg(m_news->report.counts.aircraft));
}

PopulationDrawing PopulationPage::drawing() const
{
    if (!m_news)
        return {};
    return {&m_news->report.pattern, m_news->report.exceedance.limit_deg, m_chosen_deg};
}

void PopulationPage::fill()
{
    const QStringList lines = fleetSummary(m_news->report, m_news->fleet);
    const QString first
        = m_news->firstLook ? tr("A first look at %1 swings; all are being computed. ").arg(m_news->report.counts.used) : QString();
    say(first + lines.mid(0, 5).join(QStringLiteral(" ")));
    messageLine().setToolTip(lines.join('\n'));
    m_curve->update();
    m_polar->update();
    m_swings->setRowCount(0);
    m_behind.clear();
    fillRanking();
    fillHistoryChoices();
    fillTables();
}

void PopulationPage::fillRanking() { setTable(*m_ranking, rankingTable(m_news->report, m_news->fleet, kRowsAtOnce)); }

void PopulationPage::fillTables()
{
    const int shown = m_tables->currentIndex();
    while (m_tables->count() > 0) {
        auto* old = m_tables->widget(0);
        m_tables->removeTab(0);
        delete old;
    }
    const auto& [fleet, report, selection, firstLook] = *m_news;
    const std::pair<QString, Table> tables[] = {{tr("Pattern"), patternTable(report)},
        {tr("Coefficients"), fleetCoefficientTable(report, fleet)}, {tr("Harmonics"), fleetHarmonicTable(report)},
        {tr("Exceedance"), exceedanceTable(report)}, {tr("Components"), varianceTable(report)}, {tr("Bases and crews"), plantTable(report)},
        {tr("Jumps"), jumpTable(report, fleet)}, {tr("Drifts"), driftTable(report, fleet)}, {tr("Bins"), binTable(report)}};
    for (const auto& [name, table] : tables) {
        auto* widget = new QTableWidget;
        makePlain(*widget, "populationTable");
        setTable(*widget, table);
        m_tables->addTab(widget, QStringLiteral("%1 (%2)").arg(name).arg(table.rows.size()));
    }
    m_tables->setCurrentIndex(std::clamp(shown, 0, m_tables->count() - 1));
}

void PopulationPage::fillHistoryChoices()
{
    m_historyChoice->clear();
    const auto add = [this](std::int32_t compass) {
        const auto& one = m_news->fleet.compasses[static_cast<std::size_t>(compass)];
        m_historyChoice->addItem(QStringLiteral("%1 · %2").arg(toText(one.aircraft), toText(one.compass)), compass);
    };
    std::int32_t first = m_news->report.ranking.compasses.empty() ? m_news->report.histories.front().compass
                                                                  : m_news->report.ranking.compasses.front().compass;
    // In the order of the ranking, so that the first to look at is the first to swing; then those that could not be ranked.
    std::vector<bool> listed(m_news->fleet.compasses.size(), false);
    for (const auto& ranked : m_news->report.ranking.compasses)
        if (static_cast<std::size_t>(m_historyChoice->count()) < kRowsAtOnce) {
            add(ranked.compass);
            listed[static_cast<std::size_t>(ranked.compass)] = true;
        }
    for (const auto& history : m_news->report.histories) {
        const bool wanted
            = m_wantedCompass.valid() && m_news->fleet.compasses[static_cast<std::size_t>(history.compass)].id == m_wantedCompass;
        if (wanted)
            first = history.compass;
        if (!listed[static_cast<std::size_t>(history.compass)]
            && (wanted || static_cast<std::size_t>(m_historyChoice->count()) < kRowsAtOnce))
            add(history.compass);
    }
    showHistory(first);
}

void PopulationPage::showHistory(std::int32_t compass)
{
    const auto& report = m_news->report;
    const auto found
        = std::find_if(report.histories.begin(), report.histories.end(), [&](const CompassHistory& one) { return one.compass == compass; });
    if (found == report.histories.end())
        return;
    m_historyChoice->setCurrentIndex(m_historyChoice->findData(compass));
    m_history = historyDrawing(m_news->fleet, report.curves, *found, report.changes);
    m_film->setRange(std::min(1, static_cast<int>(m_history.points.size())), static_cast<int>(m_history.points.size()));
    m_film->setValue(m_film->maximum());
    m_history.shown = m_history.points.size();
    QStringList lines;
    for (const auto& jump : report.changes.jumps)
        if (jump.compass == compass)
            lines += toText(inWords(jump, m_news->fleet)) + QStringLiteral(" — ")
                + toText(inWords(
                    likelyPart(jumpedTogether(report.changes, jump), m_news->fleet.compasses[static_cast<std::size_t>(compass)].kind)));
    for (const auto& each : report.changes.drifts)
        if (each.compass == compass)
            lines += tr("%1 drifts by %2° a year (95 %: %3 to %4).")
                         .arg(QLatin1Char(letterOf(kCoefficients[each.coefficient])))
                         .arg(signedNumber(each.drift.perYear, 2), signedNumber(each.drift.interval95.low, 2),
                             signedNumber(each.drift.interval95.high, 2));
    for (const auto& ranked : report.ranking.compasses)
        if (ranked.compass == compass && ranked.reached50_day)
            lines += tr("Its limit is reached by %1 in half of the futures, by %2 in one of twenty.")
                         .arg(toText(dateOfDay(*ranked.reached50_day)), toText(dateOfDay(*ranked.reached5_day)));
    if (lines.isEmpty())
        lines += tr("No jump and no drift of it is told.");
    lines += tr("Filled: as found; open or dashed: as left. Bars: 95 % by the readings.");
    m_historyWords->setText(lines.join('\n'));
    m_coefficients->update();
    m_curves->update();
}

void PopulationPage::choose(double heading_deg)
{
    if (!m_news)
        return;
    m_chosen_deg = heading_deg;
    const auto& [fleet, report, selection, firstLook] = *m_news;
    double mean = 0;
    for (const auto& point : report.pattern.points)
        if (std::abs(point.heading_deg - heading_deg) < 1e-6)
            mean = point.mean_deg.value_or(0);
    struct Behind {
        std::size_t row;
        GridValue value;
    };
    std::vector<Behind> all;
    for (std::size_t row = 0; row < fleet.swings.size(); ++row)
        if (!report.options.stage || fleet.swings[row].stage == *report.options.stage)
            if (const auto value = valueAt(fleet, fleet.swings[row], report.curves.curves[row], heading_deg, 180.0 / report.options.grid))
                all.push_back({row, *value});
    std::stable_sort(all.begin(), all.end(), [mean](const Behind& a, const Behind& b) {
        return std::abs(a.value.deviation_deg - mean) > std::abs(b.value.deviation_deg - mean);
    });
    const auto shown = std::min(all.size(), kSwingsBehind);
    m_behindWords->setText(
        tr("%1 swings at %2°, those farthest from the mean first; Enter opens one.").arg(all.size()).arg(heading_deg, 0, 'f', 1));
    m_swings->setRowCount(static_cast<int>(shown));
    m_behind.clear();
    for (std::size_t i = 0; i < shown; ++i) {
        const auto& swing = fleet.swings[all[i].row];
        const auto& compass = fleet.compasses[static_cast<std::size_t>(swing.compass)];
        const QStringList cells{toText(dateOfDay(swing.day)), toText(compass.aircraft), toText(compass.compass),
            signedNumber(all[i].value.deviation_deg, 2) + QChar(0xB0), all[i].value.read ? tr("read") : tr("by its own curve")};
        for (int column = 0; column < cells.size(); ++column)
            m_swings->setItem(static_cast<int>(i), column, new QTableWidgetItem(cells[column]));
        m_behind.push_back(swing.id);
    }
    m_swings->resizeColumnsToContents();
    m_curve->update();
    m_polar->update();
}

void PopulationPage::save()
{
    if (!m_news)
        return;
    const QString path = m_questions.save(tr("Save the fleet report"), QStringLiteral("fleet-report.pdf"),
        tr("Report (*.pdf);;Page (*.html);;Tables (*.csv);;Figures (*.json)"));
    if (path.isEmpty())
        return;
    const QString ending = QFileInfo(path).suffix().toLower();
    const auto written = ending == QStringLiteral("csv") ? writeWholeFile(path.toStdString(), toCsv(m_news->report, m_news->fleet))
        : ending == QStringLiteral("json")
        ? writeWholeFile(path.toStdString(), toJson(m_news->report, m_news->fleet) + "\n")
        : writeFleetDocument({m_news->report, m_news->fleet, m_news->selection, toText(m_stores.clock().nowUtc())}, path,
            ending == QStringLiteral("html") ? DocumentKind::Html : DocumentKind::Pdf);
    if (!written)
        emit failed(messageOf(written.error()));
    else
        emit done(tr("wrote %1").arg(path));
}

} // namespace lubberline::ui
