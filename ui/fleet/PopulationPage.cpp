#include "ui/fleet/PopulationPage.h"

#include <QFileInfo>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSplitter>
#include <QTabWidget>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

#include "core/base/OutputFile.h"
#include "core/format/results/FleetJson.h"
#include "ui/fleet/HistoryPanel.h"
#include "ui/fleet/PaintedPlot.h"
#include "ui/fleet/PopulationFilters.h"
#include "ui/kit/Words.h"
#include "ui/kit/fit/FlowLayout.h"
#include "ui/kit/fit/TableFit.h"
#include "ui/report/fleet/FleetDocument.h"
#include "ui/report/fleet/FleetTables.h"

namespace lubberline::ui {

namespace {

constexpr std::size_t kRowsAtOnce = 500;   ///< of a table on screen; files have all
constexpr std::size_t kSwingsBehind = 300; ///< of a heading: those farthest from the mean

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

enum Tab { PatternTab, RankingTab, HistoryTab }; ///< the others are reached by hand only

} // namespace

PopulationPage::PopulationPage(db::Stores& stores, FileQuestions questions, QWidget* parent)
    : Page(parent)
    , m_stores(stores)
    , m_questions(std::move(questions))
    , m_filters(new PopulationFilters(stores))
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
    , m_histograms(new PaintedPlot(QStringLiteral("populationHistograms"),
          [this](QPainter& p, const QRectF& r, const FleetLook& l) {
              m_news ? paintDistributions(p, r, m_distributions, l) : paintNothing(p, r, m_state->text(), l);
          }))
    , m_swings(new QTableWidget)
    , m_ranking(new QTableWidget)
    , m_behindWords(new QLabel)
    , m_history(new HistoryPanel)
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
    m_tabs->addTab(m_history, tr("History of a compass"));
    m_tabs->addTab(m_histograms, tr("Distributions"));
    m_tables->setObjectName(QStringLiteral("populationTables"));
    m_tables->setTabPosition(QTabWidget::South);
    m_tables->setUsesScrollButtons(true);
    m_tabs->addTab(m_tables, tr("Tables"));
    setTitle(tr("Years as a population"));
    body().addWidget(m_filters);
    body().addWidget(buildCommands());
    body().addWidget(m_tabs, 1);
    setFocusProxy(m_compute);
}

QWidget* PopulationPage::buildCommands()
{
    m_compute->setObjectName(QStringLiteral("populationCompute"));
    m_cancel->setObjectName(QStringLiteral("populationCancel"));
    m_save->setObjectName(QStringLiteral("populationSave"));
    m_cancel->setEnabled(false);
    m_save->setEnabled(false);
    m_progress->setRange(0, 100);
    m_progress->setMaximumWidth(140);
    m_state->setObjectName(QStringLiteral("populationState"));
    auto* panel = new QWidget;
    auto* row = new FlowLayout(panel);
    row->setContentsMargins(0, 0, 0, 0);
    m_state->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    for (QWidget* part : std::initializer_list<QWidget*>{m_compute, m_cancel, m_progress, m_state, m_save})
        row->addWidget(part);
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
            if (const auto found = heading(*plot, plot == m_polar, at))
                tellHeading(*found);
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
            m_tabs->setCurrentIndex(HistoryTab);
        }
    });
    return m_ranking;
}

void PopulationPage::tellHeading(double heading_deg)
{
    if (!m_news)
        return;
    for (const auto& point : m_news->report.pattern.points)
        if (std::abs(point.heading_deg - heading_deg) < 1e-6 && point.mean_deg)
            emit readOut(tr("%1°: mean %2°, between aircraft ± %3° (one standard deviation), %n vote(s)", nullptr, point.units)
                             .arg(point.heading_deg, 0, 'f', 1)
                             .arg(signedNumber(*point.mean_deg, 2), numberText(point.between_deg)));
}

Result<void> PopulationPage::open(const FleetItem& record)
{
    m_filters->load(m_news ? &m_news->fleet : nullptr);
    m_wantedCompass = {};
    if (const auto* type = std::get_if<AircraftTypeId>(&record); type && type->valid()) {
        const auto found = m_stores.fleet.type(*type);
        if (!found)
            return found.error();
        m_filters->chooseType(toText(found->name));
    } else if (const auto* compassId = std::get_if<CompassId>(&record); compassId && compassId->valid()) {
        m_wantedCompass = *compassId;
        const auto compass = m_stores.fleet.compass(*compassId);
        const auto aircraft = compass ? m_stores.fleet.aircraft(compass->aircraft) : Result<Aircraft>(compass.error());
        const auto aircraftType = aircraft ? m_stores.fleet.type(aircraft->type) : Result<AircraftType>(aircraft.error());
        if (!aircraftType)
            return aircraftType.error();
        m_filters->chooseType(toText(aircraftType->name));
    }
    compute();
    return {};
}

void PopulationPage::fleetChanged()
{
    m_changed = true;
    if (m_news && !m_worker.running())
        m_state->setText(tr("The fleet has changed since: compute again."));
}

void PopulationPage::compute()
{
    auto wish = m_filters->wish();
    if (!wish)
        return refuse(messageOf(wish.error()));
    m_options = wish->options;
    m_changed = false;
    m_cancel->setEnabled(true);
    m_state->setText(tr("Computing a first look at a part of the swings; all of them follow…"));
    updatePlots();
    m_worker.start([&stores = m_stores, selection = std::move(wish->selection), options = m_options](
                       const Progress& progress) { return populationNews(stores, selection, options, true, progress); });
}

void PopulationPage::computeWhole()
{
    m_changed = false; // what came until now is read
    m_state->setText(tr("All swings are read and computed…"));
    m_worker.start([&stores = m_stores, selection = m_news->selection, options = m_options](
                       const Progress& progress) { return populationNews(stores, selection, options, false, progress); });
}

void PopulationPage::take(Result<std::shared_ptr<const PopulationNews>> news)
{
    if (!news) {
        m_cancel->setEnabled(false);
        m_progress->reset();
        m_state->setText(
            news.error().code == ErrorCode::Cancelled ? tr("Cancelled: what was computed before stays.") : messageOf(news.error()));
        updatePlots();
        return;
    }
    m_news = std::move(news.value());
    m_chosen_deg.reset();
    m_filters->load(&m_news->fleet);
    fill();
    emit computed(!m_news->firstLook);
    if (m_news->firstLook)
        return computeWhole();
    m_cancel->setEnabled(false);
    m_save->setEnabled(true);
    m_progress->setValue(100);
    m_state->setText(m_changed
            ? tr("The fleet has changed since: compute again.")
            : tr("%n swing(s) of %1 aircraft.", nullptr, static_cast<int>(m_news->report.counts.used)).arg(m_news->report.counts.aircraft));
}

PopulationDrawing PopulationPage::drawing() const
{
    if (!m_news) // what is being done, or why nothing is
        return {nullptr, {}, {}, m_state->text()};
    return {&m_news->report.pattern, m_news->report.exceedance.limit_deg, m_chosen_deg, {}};
}

void PopulationPage::updatePlots()
{
    for (auto* plot : {m_curve, m_polar, m_histograms})
        plot->update();
}

void PopulationPage::fill()
{
    const QStringList lines = fleetSummary(m_news->report, m_news->fleet);
    const QString first = m_news->firstLook
        ? tr("A first look at %n swing(s); all are being computed. ", nullptr, static_cast<int>(m_news->report.counts.used))
        : QString();
    say(first + lines.mid(0, 5).join(QStringLiteral(" ")));
    messageLine().setToolTip(lines.join('\n'));
    m_distributions = distributionDrawing(m_news->report, m_news->fleet);
    updatePlots();
    m_swings->setRowCount(0);
    m_behind.clear();
    setTable(*m_ranking, rankingTable(m_news->report, m_news->fleet, kRowsAtOnce));
    m_history->show(m_news, m_wantedCompass);
    fillTables();
}

void PopulationPage::showHistory(std::int32_t compass) { m_history->showCompass(compass); }

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
        {tr("Coefficients"), fleetCoefficientTable(report, fleet)}, {tr("Soft iron"), softIronTable(report)},
        {tr("Harmonics"), fleetHarmonicTable(report)}, {tr("Exceedance"), exceedanceTable(report)},
        {tr("Components"), varianceTable(report)}, {tr("Bases and crews"), plantTable(report)}, {tr("Alarms"), alarmTable(report)},
        {tr("Jumps"), jumpTable(report, fleet)}, {tr("Drifts"), driftTable(report, fleet)}, {tr("Bins"), binTable(report)}};
    for (const auto& [name, table] : tables) {
        auto* widget = new QTableWidget;
        makePlain(*widget, "populationTable");
        widget->setAccessibleName(name);
        setTable(*widget, table);
        fitColumns(*widget);
        m_tables->addTab(widget, QStringLiteral("%1 (%2)").arg(name).arg(table.rows.size()));
    }
    m_tables->setCurrentIndex(std::clamp(shown, 0, m_tables->count() - 1));
}

void PopulationPage::choose(double heading_deg)
{
    if (!m_news)
        return;
    m_chosen_deg = heading_deg;
    const auto all = swingsBehind(*m_news, heading_deg);
    const auto shown = std::min(all.size(), kSwingsBehind);
    m_behindWords->setText(
        tr("%n swing(s) at %1°, those farthest from the mean first; Enter opens one.", nullptr, static_cast<int>(all.size()))
            .arg(heading_deg, 0, 'f', 1));
    m_swings->setRowCount(static_cast<int>(shown));
    m_behind.clear();
    for (std::size_t i = 0; i < shown; ++i) {
        const auto& swing = m_news->fleet.swings[all[i].row];
        const auto& compass = m_news->fleet.compasses[static_cast<std::size_t>(swing.compass)];
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
    m_questions.write({path, [news = m_news, now = toText(m_stores.clock().nowUtc()), ending, path](const Progress& progress) {
                           if (ending == QStringLiteral("csv"))
                               return writeWholeFile(path.toStdString(), toCsv(news->report, news->fleet));
                           if (ending == QStringLiteral("json"))
                               return writeWholeFile(path.toStdString(), toJson(news->report, news->fleet) + "\n");
                           return writeFleetDocument({news->report, news->fleet, news->selection, now}, path,
                               ending == QStringLiteral("html") ? DocumentKind::Html : DocumentKind::Pdf, progress);
                       }});
}

} // namespace lubberline::ui
