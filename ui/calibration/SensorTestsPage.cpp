#include "ui/calibration/SensorTestsPage.h"

#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSplitter>
#include <QTabWidget>
#include <QTableWidget>

#include <algorithm>

#include "core/format/csv/ActionsCsv.h"
#include "core/format/csv/SensorLogCsv.h"
#include "ui/calibration/CoilPanel.h"
#include "ui/calibration/InstallationPanel.h"
#include "ui/calibration/LiveActions.h"
#include "ui/calibration/TestWidgets.h"
#include "ui/kit/CompassTitle.h"
#include "ui/kit/Words.h"
#include "ui/plots/calibration/SensorTestDrawing.h"
#include "ui/plots/drawn/DrawnPlot.h"
#include "ui/report/forms/InstallationSheet.h"
#include "ui/report/forms/SensorTestSheets.h"

namespace lubberline::ui {

namespace {

enum TestTab { kSpectrumTab, kCoilTab, kInterferenceTab, kInstallationTab };

QLineEdit* testLine(const char* name, const QString& hint)
{
    auto* line = new QLineEdit;
    line->setObjectName(QString::fromLatin1(name));
    line->setPlaceholderText(hint);
    line->setAccessibleName(hint);
    line->setMinimumWidth(line->fontMetrics().averageCharWidth() * 14);
    return line;
}

QLabel* testWords(const char* name)
{
    auto* label = new QLabel;
    label->setObjectName(QString::fromLatin1(name));
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
}

Result<SensorTests> runTests(const std::string& path, const std::string& actionsPath, const SpectrumOptions& options,
    const Eigen::Vector3d& limits_nT, const Progress& progress)
{
    auto log = readSensorLogFile(path, {}, progress);
    if (!log)
        return log.error();
    const auto shared = std::make_shared<const SensorLog>(std::move(log.value()));
    SensorTests tests{shared, spectrumOf(*shared, options), {}, coilBench(*shared), {}};
    if (tests.spectrum)
        if (auto spectrogram = spectrogramOf(*shared, tests.spectrum->column, tests.spectrum->segment))
            tests.spectrogram = std::move(spectrogram.value());
    if (!actionsPath.empty()) {
        const auto actions = readActionsFile(actionsPath);
        if (!actions)
            return actions.error();
        tests.interference = interferenceTest(*shared, *actions, limits_nT);
    }
    return tests;
}

} // namespace

SensorTestsPage::SensorTestsPage(EditContext& context, QUndoStack& undo, QSettings& settings, FileQuestions questions, QWidget* parent)
    : Page(parent)
    , m_stores(context.stores)
    , m_questions(std::move(questions))
    , m_open(new QPushButton(tr("&Open a log…")))
    , m_actions(new QPushButton(tr("Open the &actions…")))
    , m_cancel(new QPushButton(tr("Cancel")))
    , m_column(testLine("testsColumn", tr("column: strongest axis")))
    , m_tachometer(testLine("testsTachometer", tr("tachometer column")))
    , m_delay(testLine("testsDelay", tr("filter delay, ms")))
    , m_limits(testLine("testsLimits", tr("limits: 500, 500, 800 nT")))
    , m_tabs(new QTabWidget)
    , m_spectrum(new DrawnPlot(tr("Spectrum"), {320, 180}))
    , m_spectrogram(new DrawnPlot(tr("Spectrogram"), {240, 140}))
    , m_interference(new DrawnPlot(tr("Interference"), {320, 180}))
    , m_lines(testTable("testsLines", tr("Lines")))
    , m_outcomes(testTable("testsActions", tr("Actions")))
    , m_filter(testWords("testsFilter"))
    , m_verdict(testWords("testsVerdict"))
    , m_coil(new CoilPanel(context, undo))
    , m_live(new LiveActions(settings, m_questions, context.stores.clock()))
    , m_installation(new InstallationPanel(settings))
    , m_worker(
          [this](Result<SensorTests> tests) { take(std::move(tests)); }, [this](int percent) { say(tr("Reading… %1 %").arg(percent)); })
{
    setObjectName(QStringLiteral("sensorTestsPage"));
    build();
}

void SensorTestsPage::build()
{
    m_open->setObjectName(QStringLiteral("testsOpen"));
    m_actions->setObjectName(QStringLiteral("testsOpenActions"));
    m_actions->setEnabled(false);
    m_cancel->hide();
    messageLine().setWordWrap(true);
    for (const auto& widgets :
        {std::vector<QWidget*>{m_open, m_actions, m_cancel}, std::vector<QWidget*>{m_column, m_tachometer, m_delay, m_limits}}) {
        auto* row = new QHBoxLayout; // in one they would be wider than a small screen
        for (QWidget* one : widgets)
            row->addWidget(one);
        if (widgets.front() == m_open)
            row->addStretch(1); // the lines take all the room that there is
        body().addLayout(row);
    }
    DrawnPicture nothing;
    nothing.notice = tr("Open a log of the sensor: time_s, bx_nT, by_nT, bz_nT.");
    m_spectrum->setPicture(nothing);
    m_spectrogram->setPicture(nothing);
    nothing.notice = tr("Open a log of the sensor while it stands still, then the list of actions: time_s, action.");
    m_interference->setPicture(nothing);
    auto* spectra = new QSplitter(Qt::Vertical);
    spectra->addWidget(m_spectrum);
    spectra->addWidget(m_spectrogram);
    spectra->addWidget(m_lines);
    spectra->setSizes({300, 190, 120});
    auto* first = new QWidget;
    auto* firstColumn = new QVBoxLayout(first);
    firstColumn->addWidget(spectra, 1);
    firstColumn->addWidget(m_filter);
    auto* third = new QWidget;
    auto* thirdColumn = new QVBoxLayout(third);
    thirdColumn->addWidget(m_verdict);
    auto* outcomes = new QSplitter(Qt::Vertical);
    outcomes->addWidget(m_interference);
    outcomes->addWidget(m_outcomes);
    outcomes->addWidget(m_live);
    outcomes->setSizes({280, 140, 140});
    thirdColumn->addWidget(outcomes, 1);
    m_tabs->addTab(first, tr("Spectrum"));
    m_tabs->addTab(m_coil, tr("Coil bench"));
    m_tabs->addTab(third, tr("Interference"));
    m_tabs->addTab(m_installation, tr("Installation"));
    body().addWidget(m_tabs, 1);
    setFocusProxy(m_open);
    for (DrawnPlot* plot : {m_spectrum, m_spectrogram, m_interference})
        follow(*plot);
    connect(m_open, &QPushButton::clicked, this, [this] {
        if (const QString path = m_questions.open(tr("Open a sensor log"), tr("Sensor logs (*.csv *.txt *.tsv *.dat);;All files (*)"));
            !path.isEmpty())
            openLog(path);
    });
    connect(m_actions, &QPushButton::clicked, this, [this] {
        if (const QString path = m_questions.open(tr("Open the actions"), tr("Actions (*.csv);;All files (*)")); !path.isEmpty())
            openActions(path);
    });
    connect(m_live, &LiveActions::saved, this, [this](const QString& path) {
        say(tr("wrote %1").arg(path));
        if (!m_path.isEmpty())
            openActions(path);
    });
    connect(m_coil, &CoilPanel::failed, this, &Page::failed);
    connect(m_live, &LiveActions::failed, this, &Page::failed);
    connect(m_cancel, &QPushButton::clicked, this, [this] { m_worker.cancel(); });
    connect(m_tabs, &QTabWidget::currentChanged, this, &Page::stateChanged);
    for (QLineEdit* line : {m_column, m_tachometer, m_delay, m_limits})
        connect(line, &QLineEdit::returnPressed, this, &SensorTestsPage::run);
}

Plot* SensorTestsPage::plot() const
{
    if (m_tabs->currentIndex() == kCoilTab || m_tabs->currentIndex() == kInstallationTab)
        return nullptr;
    return m_tabs->currentIndex() == kInterferenceTab ? m_interference : m_spectrogram->hasFocus() ? m_spectrogram : m_spectrum;
}

Result<void> SensorTestsPage::open(const FleetItem& record)
{
    const CompassId compass = compassIn(record);
    const auto title = titleWith(m_stores, compass, tr("Tests of a sensor from its log"));
    if (!title)
        return title.error();
    m_compass = compass;
    setTitle(*title);
    m_coil->setCompass(m_compass);
    return {};
}

bool SensorTestsPage::isOf(const FleetItem& record) const { return !m_compass.valid() || m_compass == compassIn(record); }

void SensorTestsPage::openLog(const QString& path)
{
    m_path = path;
    m_actionsPath.clear(); // they were of another log
    run();
}

void SensorTestsPage::openActions(const QString& path)
{
    m_actionsPath = path;
    m_tabs->setCurrentIndex(kInterferenceTab);
    run();
}

void SensorTestsPage::run()
{
    if (m_path.isEmpty())
        return;
    SpectrumOptions options;
    options.column = m_column->text().trimmed().toStdString();
    options.tachometer = m_tachometer->text().trimmed().toStdString();
    if (const QString typed = m_delay->text().trimmed(); !typed.isEmpty()) {
        const auto delay = typedNumber(typed);
        if (!delay || *delay < 0.01 || *delay > 10000) {
            refuse(tr("“%1” is no delay; expected 0.01 to 10000 ms").arg(typed));
            return;
        }
        options.maxDelay_ms = *delay;
    }
    Eigen::Vector3d limits_nT = kInterferenceLimits_nT;
    if (const QString typed = m_limits->text().trimmed(); !typed.isEmpty()) {
        const auto limits = typedNumbers(typed, 3);
        if (!limits || *std::min_element(limits->begin(), limits->end()) <= 0) {
            refuse(tr("“%1” are no limits; expected three numbers above 0 in nT: x, y, z").arg(typed));
            return;
        }
        limits_nT = {(*limits)[0], (*limits)[1], (*limits)[2]};
    }
    m_cancel->show();
    m_open->setEnabled(false);
    m_worker.start([path = m_path.toStdString(), actions = m_actionsPath.toStdString(), options, limits_nT](
                       const Progress& progress) { return runTests(path, actions, options, limits_nT, progress); });
}

void SensorTestsPage::take(Result<SensorTests> tests)
{
    m_cancel->hide();
    m_open->setEnabled(true);
    if (!tests) {
        refuse(messageOf(tests.error()));
        return;
    }
    m_tests = std::make_shared<const SensorTests>(std::move(tests.value()));
    m_actions->setEnabled(true);
    QStringList lines{QFileInfo(m_path).fileName()};
    for (const Message& warning : m_tests->log->warnings)
        lines += toText(warning);
    if (m_tests->spectrum)
        for (const Message& warning : m_tests->spectrum->warnings)
            lines += toText(warning);
    say(lines.join(u'\n'));
    showSpectrum();
    m_coil->show(m_tests->log, m_tests->coil, QFileInfo(m_path).fileName());
    showInterference();
}

void SensorTestsPage::showSpectrum()
{
    const QString unit = toText(std::string(m_tests->log->figureUnit()));
    if (!m_tests->spectrum) {
        DrawnPicture nothing;
        nothing.notice = messageOf(m_tests->spectrum.error());
        m_spectrum->setPicture(nothing);
        m_spectrogram->setPicture(nothing);
        m_lines->setRowCount(0);
        m_filter->clear();
        return;
    }
    m_spectrum->setPicture(spectrumDrawing(*m_tests->spectrum, unit));
    m_spectrogram->setPicture(spectrogramDrawing(m_tests->spectrogram.value_or(Spectrogram{}), unit));
    fillFrom(*m_lines, linesTable(*m_tests->spectrum, unit));
    m_filter->setText(filterWords(*m_tests->spectrum, unit));
}

void SensorTestsPage::showInterference()
{
    const auto& result = m_tests->interference;
    m_outcomes->setRowCount(0);
    DrawnPicture nothing;
    nothing.notice = result && !*result ? messageOf(result->error()) : tr("Open the list of actions: time_s, action.");
    if (!result || !*result) {
        m_verdict->clear();
        m_interference->setPicture(nothing);
        return;
    }
    QStringList lines{(*result)->passes ? tr("Passes: no action changes the field by more than the limits.")
                                        : tr("Does not pass: an action changes the field by more than the limits.")};
    for (const Message& warning : (*result)->warnings)
        lines += toText(warning);
    m_verdict->setText(lines.join(u'\n'));
    m_interference->setPicture(interferenceDrawing(*m_tests->log, **result));
    fillFrom(*m_outcomes, actionsTable(**result));
}

void SensorTestsPage::writeReport()
{
    const int tab = m_tabs->currentIndex();
    const bool told = tab == kInstallationTab
        || (m_tests
            && (tab == kSpectrumTab   ? m_tests->spectrum.ok()
                    : tab == kCoilTab ? m_tests->coil.ok()
                                      : m_tests->interference && m_tests->interference->ok()));
    if (!told) {
        refuse(tr("Nothing to write yet: this test has no result"));
        return;
    }
    const QString path = m_questions.save(tr("Write the report"),
        tab == kSpectrumTab           ? QStringLiteral("spectrum.pdf")
            : tab == kCoilTab         ? QStringLiteral("coil-bench.pdf")
            : tab == kInterferenceTab ? QStringLiteral("interference.pdf")
                                      : QStringLiteral("installation.pdf"),
        tr("PDF (*.pdf)"));
    if (path.isEmpty())
        return;
    const QString source = QFileInfo(m_path).fileName();
    ReferenceSheet sheet = tab == kSpectrumTab ? spectrumSheet(*m_tests->spectrum, *m_tests->log, source)
        : tab == kCoilTab                      ? coilSheet(*m_tests->coil, source, m_coil->history())
        : tab == kInterferenceTab              ? interferenceSheet(**m_tests->interference, *m_tests->log, source)
                                               : distancesSheet(m_installation->measured_m());
    sheet.madeAtUtc = toText(m_stores.clock().nowUtc());
    m_questions.write({path, [sheet, path](const Progress& progress) { return writeReferenceSheet(sheet, path, progress); }});
}

} // namespace lubberline::ui
