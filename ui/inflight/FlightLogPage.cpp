#include "ui/inflight/FlightLogPage.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTabWidget>

#include <algorithm>

#include "core/angle/AngleText.h"
#include "core/angle/PrintedHeading.h"
#include "core/inflight/FlownModel.h"
#include "core/inflight/InflightSwing.h"
#include "core/swing/SwingResult.h"
#include "ui/kit/Words.h"
#include "ui/kit/fit/ControlFit.h"
#include "ui/kit/fit/FlowLayout.h"
#include "ui/plots/drawn/DrawnPlot.h"
#include "ui/plots/inflight/InflightDrawing.h"
#include "ui/plots/swing/PictureOf.h"
#include "ui/plots/swing/SwingPlot.h"
#include "ui/report/forms/InflightSheets.h"
#include "ui/text/AngleWords.h"
#include "ui/text/NumberText.h"

namespace lubberline::ui {

namespace {

/// Which of both kinds a log is, its columns say: a log that is no Legs CSV is told as what the other reader misses.
Result<FlightLog> readFlightLog(const std::string& path, const LegsOptions& legs, const ContinuousOptions& filter, const Progress& progress)
{
    auto continuous = readContinuousCsvFile(path, filter, progress);
    if (continuous)
        return FlightLog{std::move(continuous->result), continuous->warnings};
    if (continuous.error().code == ErrorCode::Cancelled || continuous.error().code == ErrorCode::Io)
        return continuous.error();
    if (filter.wholeModelOver_nT)
        return continuous.error();
    const auto file = readLegsCsvFile(path, progress);
    if (!file)
        return continuous.error().line > 1 ? continuous.error() : file.error();
    auto solution = solveLegs(file->legs, legs);
    if (!solution)
        return Error{solution.error().code, solution.error().message, path};
    return FlightLog{std::move(solution.value()), file->warnings};
}

QStringList wordsOf(const LegsSolution& solution)
{
    QStringList lines{FlightLogPage::tr("Wind from %1° at %2 kt ± %3 kt, airspeed %4 kt ± %5 kt (one standard error), %6 legs.")
                          .arg(plainNumber(printedHeading_deg(solution.air.from_deg(), 0), 0), plainNumber(solution.air.speed_kt(), 1),
                              plainNumber(solution.air.standardError_kt(), 1), plainNumber(solution.air.airspeed_kt, 1),
                              plainNumber(solution.air.airspeedError_kt, 1))
                          .arg(solution.legs.size())};
    return lines;
}

QStringList wordsOf(const ContinuousResult& result)
{
    QStringList values;
    for (std::size_t i = 0; i < result.names.size(); ++i)
        values += result.state_deg[i]
            ? FlightLogPage::tr("%1 %2° ± %3°")
                  .arg(toText(result.names[i]), signedNumber(*result.state_deg[i], 2), plainNumber(*result.standardError_deg[i], 2))
            : FlightLogPage::tr("%1 not told").arg(toText(result.names[i]));
    QStringList lines{
        FlightLogPage::tr("%1 updates: %2 (± one standard error).").arg(result.updates).arg(values.join(QStringLiteral(", ")))};
    if (const auto& whole = result.whole) {
        if (const auto& model = whole->model)
            lines += FlightLogPage::tr("Hard iron P %1, Q %2, R %3 nT.")
                         .arg(signedNumber(model->hardIron_nT.x(), 0), signedNumber(model->hardIron_nT.y(), 0),
                             signedNumber(model->hardIron_nT.z(), 0));
        QStringList level;
        for (std::size_t c = 0; c < whole->level_deg.size(); ++c)
            if (whole->level_deg[c])
                level += FlightLogPage::tr("%1 %2° ± %3°")
                             .arg(QString(QLatin1Char("ABCDE"[c])))
                             .arg(signedNumber(*whole->level_deg[c], 2), plainNumber(*whole->levelError_deg[c], 2));
        lines += FlightLogPage::tr("Level, where H is %1 nT: %2 (± one standard error).")
                     .arg(plainNumber(whole->field.horizontal_nT, 0), level.join(QStringLiteral(", ")));
    }
    for (const auto& direction : result.nullDirections)
        lines += toText(direction);
    return lines; // alarms stand among the warnings
}

} // namespace

FlightLogPage::FlightLogPage(db::Stores& stores, FileQuestions questions, QWidget* parent)
    : Page(parent)
    , m_stores(stores)
    , m_questions(std::move(questions))
    , m_variation(new QLineEdit)
    , m_noise(new QLineEdit)
    , m_whole(new QCheckBox(tr("&Whole sensor model")))
    , m_from(new QComboBox)
    , m_open(new QPushButton(tr("&Open a log of legs or headings…")))
    , m_cancel(new QPushButton(tr("Cancel")))
    , m_make(new QPushButton(tr("&Make a swing of it")))
    , m_keep(new QPushButton(tr("&Keep the sensor model")))
    , m_tabs(new QTabWidget)
    , m_plot(makeCurvePlot())
    , m_told(new DrawnPlot(tr("What is told")))
    , m_worker([this](Result<FlightLog> read) { take(std::move(read)); }, [this](int percent) { say(tr("Reading… %1 %").arg(percent)); })
{
    build();
}

void FlightLogPage::build()
{
    setTitle(tr("A swing in flight"));
    say(tr(
        "Legs: track_deg, ground_speed_kt, compass_heading_deg, leg. Continuous: time_s, compass_heading_deg, reference_heading_deg (magnetic) or "
        "deviation_deg, leg, current_A:NAME."));
    m_variation->setObjectName(QStringLiteral("flightVariation"));
    m_variation->setPlaceholderText(tr("variation of the legs, E +"));
    m_noise->setObjectName(QStringLiteral("flightNoise"));
    m_noise->setPlaceholderText(tr("error of a heading pair; as they scatter"));
    m_whole->setObjectName(QStringLiteral("flightWhole"));
    m_whole->setToolTip(tr("Soft and hard iron in place of A to E: the log has pitch_deg, roll_deg, horizontal_nT and dip_deg, too."));
    m_from->setObjectName(QStringLiteral("flightFrom"));
    m_from->setAccessibleName(tr("The whole sensor model begins"));
    m_from->setToolTip(
        tr("A sensor model of this compass whose errors are known: the flight adds to it. Begin anew after the iron was changed."));
    m_from->hide();
    m_keep->setObjectName(QStringLiteral("flightKeep"));
    m_keep->setToolTip(tr("Among the sensor models of the compass, with its errors: the next flight goes on from it."));
    m_keep->setEnabled(false);
    m_keep->hide();
    m_open->setObjectName(QStringLiteral("flightOpen"));
    m_make->setObjectName(QStringLiteral("flightMake"));
    m_make->setEnabled(false);
    m_cancel->hide();
    for (QLineEdit* line : {m_variation, m_noise})
        showHint(*line);
    auto* row = new FlowLayout; // beside the title they would cut it
    for (QWidget* one : std::initializer_list<QWidget*>{m_open, m_cancel, m_make, m_keep, m_variation, m_noise, m_whole, m_from})
        row->addWidget(one);
    body().addLayout(row);
    messageLine().setWordWrap(true);
    m_tabs->addTab(m_plot, tr("Deviation"));
    m_tabs->addTab(m_told, tr("What is told"));
    m_told->setObjectName(QStringLiteral("flightTold"));
    body().addWidget(m_tabs, 1);
    setFocusProxy(m_open);
    follow(*m_plot);
    follow(*m_told);
    showNothing();
    connect(m_tabs, &QTabWidget::currentChanged, this, &Page::stateChanged);
    connect(m_open, &QPushButton::clicked, this, &FlightLogPage::choose);
    connect(m_make, &QPushButton::clicked, this, &FlightLogPage::make);
    connect(m_cancel, &QPushButton::clicked, this, [this] { m_worker.cancel(); });
    connect(m_keep, &QPushButton::clicked, this, &FlightLogPage::keepModel);
    connect(m_whole, &QCheckBox::toggled, this, [this](bool whole) {
        m_from->setVisible(whole && !m_models.empty());
        m_keep->setVisible(whole);
        start();
    });
    connect(m_from, &QComboBox::activated, this, &FlightLogPage::start);
    connect(&m_stores.changes(), &db::Changes::sensorsChanged, this, [this](CompassId compass) {
        if (compass == m_compass.id)
            takeModels();
    });
    for (QLineEdit* line : {m_variation, m_noise}) {
        connect(line, &QLineEdit::textEdited, this, [this] { m_make->setEnabled(false); }); // Enter reads it again
        connect(line, &QLineEdit::returnPressed, this, &FlightLogPage::start);
    }
}

Result<void> FlightLogPage::open(const FleetItem& record)
{
    const auto* id = std::get_if<CompassId>(&record);
    if (!id)
        return Error{ErrorCode::NotFound, said(tr("Choose a compass first"))};
    const auto compass = m_stores.fleet.compass(*id);
    if (!compass)
        return compass.error();
    const auto aircraft = m_stores.fleet.aircraft(compass->aircraft);
    if (!aircraft)
        return aircraft.error();
    m_compass = *compass;
    takeFlown();
    takeModels();
    setTitle(tr("A swing in flight of %1 · %2").arg(toText(aircraft->registration), toText(compass->name)));
    return {};
}

Plot* FlightLogPage::plot() const { return m_tabs->currentIndex() == 0 ? static_cast<Plot*>(m_plot) : m_told; }

/// An empty plot says what to do.
void FlightLogPage::showNothing()
{
    const QString what = tr("Open a log: legs by GPS, or headings beside a reference.");
    SwingPicture picture;
    picture.whyNoAnalysis = what;
    m_plot->setPicture(picture);
    DrawnPicture told;
    told.notice = what;
    m_told->setPicture(told);
}

void FlightLogPage::choose()
{
    const QString path = m_questions.open(tr("Open a log"), tr("CSV (*.csv);;All files (*)"));
    if (!path.isEmpty())
        readLog(path);
}

void FlightLogPage::readLog(const QString& path)
{
    m_path = path;
    start();
}

void FlightLogPage::start()
{
    if (m_path.isEmpty())
        return;
    LegsOptions legs;
    ContinuousOptions filter;
    if (const QString typed = m_variation->text().trimmed(); !typed.isEmpty()) {
        const auto variation_deg = parseSignedAngle_deg(typed.toStdString());
        if (!variation_deg) {
            refuse(messageOf(variation_deg.error()));
            return;
        }
        legs.variation_deg = *variation_deg;
    }
    if (const QString typed = m_noise->text().trimmed(); !typed.isEmpty()) {
        const auto noise_deg = typedNumber(typed);
        if (!noise_deg || *noise_deg < 0.001 || *noise_deg > 90) {
            refuse(tr("'%1' is no error of a heading; expected 0.001 to 90 degrees").arg(typed));
            return;
        }
        filter.noise_deg = *noise_deg;
    }
    filter.start = begin();
    if (m_whole->isChecked())
        filter.wholeModelOver_nT = 0; // that of the log, or of the model that it goes on from
    m_begunAt = filter.start;
    m_begunWords = begunAt();
    m_cancel->show();
    m_open->setEnabled(false);
    m_make->setEnabled(false);
    m_keep->setEnabled(false);
    m_worker.start(
        [path = m_path.toStdString(), legs, filter](const Progress& progress) { return readFlightLog(path, legs, filter, progress); });
}

void FlightLogPage::take(Result<FlightLog> read)
{
    m_cancel->hide();
    m_open->setEnabled(true);
    if (!read) {
        refuse(messageOf(read.error()));
        return;
    }
    m_log = std::make_shared<const FlightLog>(std::move(read.value()));
    const auto* legs = std::get_if<LegsSolution>(&m_log->solved);
    const auto* continuous = std::get_if<ContinuousResult>(&m_log->solved);
    m_swing = legs ? swingOf(*legs) : swingOf(continuous->legs);
    QStringList lines{QFileInfo(m_path).fileName()};
    lines += legs ? wordsOf(*legs) : wordsOf(*continuous);
    if (continuous && !m_begunWords.isEmpty())
        lines += m_begunWords;
    m_said.clear();
    if (legs)
        for (const auto& warning : legs->warnings)
            m_said += toText(warning);
    for (const auto& warning : m_log->warnings)
        m_said += toText(warning);
    lines += m_said;
    m_told->setPicture(legs ? legCircle(*legs) : convergence(*continuous));
    m_tabs->setTabText(1, legs ? tr("Wind") : tr("Convergence"));
    SwingRecord record;
    record.swing = m_swing;
    record.compass = m_compass;
    std::shared_ptr<const Analysis> analysis;
    QString why;
    if (auto made = resultOf(record))
        analysis = std::make_shared<const Analysis>(std::move(made.value()));
    else
        why = toText(made.error().message);
    if (!why.isEmpty())
        lines += why;
    say(lines.join('\n'));
    SwingPicture picture = pictureOf(record, analysis, why, nullptr, {}, shownAngles());
    picture.readingsTitle = tr("means of legs");
    m_plot->setPicture(picture);
    const bool stores = m_compass.id.valid() && !m_stores.readOnly();
    m_make->setEnabled(!m_swing.readings.empty() && stores);
    m_keep->setEnabled(continuous && flownModel(*continuous, m_begunAt) && stores);
}

void FlightLogPage::writeReport()
{
    if (!m_log) {
        refuse(tr("Nothing to write yet; open a log first"));
        return;
    }
    const QString path = m_questions.save(tr("Write the report"), QStringLiteral("swing-in-flight.pdf"), tr("PDF (*.pdf)"));
    if (path.isEmpty())
        return;
    const QString source = QFileInfo(m_path).fileName();
    const auto* legs = std::get_if<LegsSolution>(&m_log->solved);
    ReferenceSheet sheet
        = legs ? legsSheet(*legs, source, m_said) : continuousSheet(std::get<ContinuousResult>(m_log->solved), source, m_said);
    sheet.madeAtUtc = toText(m_stores.clock().nowUtc());
    m_questions.write({path, [sheet, path](const Progress& progress) { return writeReferenceSheet(sheet, path, progress); }});
}

} // namespace lubberline::ui
