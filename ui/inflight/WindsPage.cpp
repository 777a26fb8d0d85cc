#include "ui/inflight/WindsPage.h"

#include <QComboBox>
#include <QFileInfo>
#include <QHeaderView>
#include <QLineEdit>
#include <QPushButton>
#include <QSplitter>
#include <QTableWidget>

#include "core/base/OutputFile.h"
#include "core/format/results/WindsJson.h"
#include "ui/kit/Words.h"
#include "ui/kit/fit/ControlFit.h"
#include "ui/kit/fit/FlowLayout.h"
#include "ui/plots/drawn/DrawnPlot.h"
#include "ui/plots/inflight/InflightDrawing.h"
#include "ui/report/forms/WindSheet.h"
#include "ui/text/NumberText.h"

namespace lubberline::ui {

namespace {

constexpr double kKnotsOfMetresASecond = 3600.0 / 1852.0;

} // namespace

WindsPage::WindsPage(FileQuestions questions, std::function<QString()> now, QWidget* parent)
    : Page(parent)
    , m_questions(std::move(questions))
    , m_now(std::move(now))
    , m_open(new QPushButton(tr("&Open wind reports…")))
    , m_cancel(new QPushButton(tr("Cancel")))
    , m_factor(new QComboBox)
    , m_sense(new QComboBox)
    , m_unit(new QComboBox)
    , m_table(new QTableWidget)
    , m_control(new QLineEdit)
    , m_scatter(new DrawnPlot(tr("Reports over heading"), {360, 200}))
    , m_rose(new DrawnPlot(tr("Headings flown"), {180, 180}))
    , m_worker([this](Result<WindFile> read) { take(std::move(read)); }, [this](int percent) { say(tr("Reading… %1 %").arg(percent)); })
{
    build();
}

void WindsPage::build()
{
    setTitle(tr("Deviation from winds"));
    say(tr(
        "Open a CSV of wind reports beside a reference wind: ground_speed_kt, track_deg, wind_speed_kt, wind_from_deg, ref_wind_speed_kt, "
        "ref_wind_from_deg; aircraft, flight, time_utc, position."));
    m_open->setObjectName(QStringLiteral("windsOpen"));
    m_table->setObjectName(QStringLiteral("windsTable"));
    m_factor->setObjectName(QStringLiteral("windsFactor"));
    m_factor->addItems({tr("table × 1.05 (paper)"), tr("table × 1.0530 (exact)"), tr("table × 1 (none)")}); // as TableFactor
    m_sense->setObjectName(QStringLiteral("windsSense"));
    m_sense->addItems({tr("winds as the file says"), tr("reported winds: towards"), tr("reference winds: towards"), tr("both: towards"),
        tr("winds: from (believed)")});
    m_unit->setObjectName(QStringLiteral("windsUnit"));
    m_unit->addItems({tr("units as the file says"), tr("reported winds in m/s"), tr("reference winds in m/s")});
    m_table->setColumnCount(10);
    m_table->setHorizontalHeaderLabels({tr("Aircraft"), tr("Flights"), tr("Used"), tr("In phase °"), tr("Quadrature °"), tr("Offset °"),
        tr("± °, 1 se"), tr("Across, kt"), tr("After, kt"), tr("Changed after")});
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->verticalHeader()->hide();
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_cancel->hide();
    m_control->setObjectName(QStringLiteral("windsControl"));
    m_control->setAccessibleName(tr("Held against"));
    m_control->setPlaceholderText(tr("held against (group or aircraft)"));
    m_control->setToolTip(
        tr("Aircraft whose headings are held to be right, as by laser gyros: a name of the column group, or of an aircraft. "
           "What they have in common is the error of the reference wind."));
    showHint(*m_control);
    auto* row = new FlowLayout; // beside the title they would cut it
    for (QWidget* one : std::initializer_list<QWidget*>{m_open, m_cancel, m_factor, m_sense, m_unit, m_control})
        row->addWidget(one);
    body().addLayout(row);
    m_scatter->setObjectName(QStringLiteral("windsScatter"));
    m_rose->setObjectName(QStringLiteral("windsRose"));
    DrawnPicture nothing;
    nothing.notice = tr("Open wind reports to see an aircraft's deviation over heading.");
    m_scatter->setPicture(nothing);
    nothing.notice = tr("The headings that were flown stand here.");
    m_rose->setPicture(nothing);
    auto* plots = new QSplitter(Qt::Horizontal);
    plots->addWidget(m_scatter);
    plots->addWidget(m_rose);
    plots->setStretchFactor(0, 3);
    plots->setStretchFactor(1, 1);
    auto* splitter = new QSplitter(Qt::Vertical);
    splitter->addWidget(m_table);
    splitter->addWidget(plots);
    splitter->setStretchFactor(1, 1);
    body().addWidget(splitter, 1);
    messageLine().setWordWrap(true);
    setFocusProxy(m_open);
    follow(*m_scatter);
    follow(*m_rose);
    connect(m_control, &QLineEdit::returnPressed, this, &WindsPage::start);
    connect(m_open, &QPushButton::clicked, this, &WindsPage::choose);
    connect(m_cancel, &QPushButton::clicked, this, [this] { m_worker.cancel(); });
    connect(m_table, &QTableWidget::itemSelectionChanged, this, &WindsPage::showAircraft);
    for (QComboBox* box : {m_sense, m_unit})
        connect(box, &QComboBox::activated, this, &WindsPage::start);
}

Plot* WindsPage::plot() const { return m_rose->hasFocus() ? m_rose : m_scatter; }
TableFactor WindsPage::factor() const { return static_cast<TableFactor>(m_factor->currentIndex()); }

void WindsPage::choose()
{
    const QString path = m_questions.open(tr("Open wind reports"), tr("Wind CSV (*.csv);;All files (*)"));
    if (!path.isEmpty())
        readReports(path);
}

void WindsPage::readReports(const QString& path)
{
    m_path = path;
    start();
}

void WindsPage::start()
{
    if (m_path.isEmpty())
        return;
    WindOptions options;
    WindReading reading;
    const int sense = m_sense->currentIndex(), unit = m_unit->currentIndex();
    reading.toward = sense == 1 || sense == 3;
    reading.referenceToward = sense == 2 || sense == 3;
    reading.windFactor = unit == 1 ? kKnotsOfMetresASecond : 1.0;
    reading.referenceFactor = unit == 2 ? kKnotsOfMetresASecond : 1.0;
    options.control = m_control->text().trimmed().toStdString();
    options.believed = sense != 0 || unit != 0;
    m_cancel->show();
    m_open->setEnabled(false);
    say(tr("Reading %1 …").arg(QFileInfo(m_path).fileName()));
    m_worker.start([path = m_path.toStdString(), options, reading](
                       const Progress& progress) { return readWindCsvFile(path, options, reading, progress); });
}

void WindsPage::take(Result<WindFile> read)
{
    m_cancel->hide();
    m_open->setEnabled(true);
    if (!read) {
        refuse(messageOf(read.error()));
        return;
    }
    m_file = std::make_shared<const WindFile>(std::move(read.value()));
    fill();
}

void WindsPage::fill()
{
    const WindResult& result = m_file->result;
    const auto figureOr = [](bool told, double value) { return told ? signedNumber(value, 2) : QStringLiteral("–"); };
    m_table->clearSelection();
    m_table->setRowCount(static_cast<int>(result.aircraft.size()));
    for (int row = 0; row < m_table->rowCount(); ++row) {
        const AircraftWinds& one = result.aircraft[static_cast<std::size_t>(row)];
        const ClusteredFit& fit = one.fit.fit;
        const QStringList cells{toText(one.aircraft), QString::number(one.flights), QString::number(one.used),
            figureOr(fit.told[1], fit.value(1)), figureOr(fit.told[2], fit.value(2)), figureOr(fit.told[0], fit.value(0)),
            fit.told[1] && fit.errorsTold ? plainNumber(fit.standardError(1), 2) : QStringLiteral("–"),
            plainNumber(one.before.transverse_kt, 1), one.after ? plainNumber(one.after->transverse_kt, 1) : QStringLiteral("–"),
            one.changes.empty() ? QString() : toText(one.changes.back().afterFlight)};
        for (int column = 0; column < cells.size(); ++column) {
            auto* item = new QTableWidgetItem(cells[column]);
            item->setTextAlignment(Qt::AlignVCenter | (column == 0 || column == 9 ? Qt::AlignLeft : Qt::AlignRight));
            m_table->setItem(row, column, item);
        }
    }
    if (!result.aircraft.empty())
        m_table->selectRow(0);
}

/// Picture and remarks of the chosen aircraft; those of the fleet stand before them.
void WindsPage::showAircraft()
{
    const int row = m_table->currentRow();
    if (!m_file || row < 0 || row >= static_cast<int>(m_file->result.aircraft.size()))
        return;
    const AircraftWinds& one = m_file->result.aircraft[static_cast<std::size_t>(row)];
    QStringList lines{
        tr("%1: %2 reports, %3 used.").arg(QFileInfo(m_path).fileName()).arg(m_file->result.observations).arg(m_file->result.used)};
    for (const auto& warning : m_file->warnings)
        lines += toText(warning);
    if (const auto& control = m_file->result.control; control && one.fitted && control->before.rmse().transverse_kt > 0)
        lines += tr("Across the track %1 is %2 times as far off as %3%4.")
                     .arg(toText(one.aircraft), plainNumber(one.before.transverse_kt / control->before.rmse().transverse_kt, 2),
                         toText(control->group),
                         one.after ? tr(", %1 times once corrected")
                                         .arg(plainNumber(one.after->transverse_kt / control->before.rmse().transverse_kt, 2))
                                   : QString());
    for (const auto& warning : one.warnings)
        lines += toText(one.aircraft) + QStringLiteral(": ") + toText(warning);
    say(lines.join('\n'));
    m_scatter->setPicture(windScatter(one));
    m_rose->setPicture(windRose(one));
}

void WindsPage::writeTables()
{
    if (!m_file) {
        refuse(tr("Nothing to write yet; open wind reports first"));
        return;
    }
    const QString path = m_questions.save(tr("Write the tables"), QStringLiteral("deviation-tables.csv"), tr("CSV (*.csv)"));
    if (path.isEmpty())
        return;
    m_questions.write({path, [result = m_file->result, factor = factor(), from = m_path.toStdString(), path](const Progress&) {
                           return writeWholeFile(path.toStdString(), windTableCsv(result, factor), {from});
                       }});
}

void WindsPage::writeReport()
{
    if (!m_file) {
        refuse(tr("Nothing to write yet; open wind reports first"));
        return;
    }
    const QString path = m_questions.save(tr("Write the report"), QStringLiteral("deviation-from-winds.pdf"), tr("PDF (*.pdf)"));
    if (path.isEmpty())
        return;
    const WindSheet sheet{m_file->result, factor(), QFileInfo(m_path).fileName(), m_now()};
    m_questions.write({path, [sheet, path](const Progress& progress) { return writeWindSheet(sheet, path, progress); }});
}

} // namespace lubberline::ui
