#include "ui/inflight/FlightLogPage.h"

#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

#include "core/angle/AngleText.h"
#include "core/inflight/InflightSwing.h"
#include "core/swing/SwingResult.h"
#include "ui/kit/Words.h"
#include "ui/plots/swing/PictureOf.h"
#include "ui/plots/swing/SwingPlot.h"
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
    QStringList lines{FlightLogPage::tr("Wind from %1° at %2 kt ± %3 kt, airspeed %4 kt ± %5 kt, %6 legs.")
                          .arg(plainNumber(solution.air.from_deg(), 0), plainNumber(solution.air.speed_kt(), 1),
                              plainNumber(solution.air.standardError_kt(), 1), plainNumber(solution.air.airspeed_kt, 1),
                              plainNumber(solution.air.airspeedError_kt, 1))
                          .arg(solution.legs.size())};
    for (const auto& warning : solution.warnings)
        lines += toText(warning);
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
    QStringList lines{FlightLogPage::tr("%1 updates: %2.").arg(result.updates).arg(values.join(QStringLiteral(", ")))};
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
    , m_open(new QPushButton(tr("&Open a log of legs or headings…")))
    , m_cancel(new QPushButton(tr("Cancel")))
    , m_make(new QPushButton(tr("&Make a swing of it")))
    , m_plot(makeCurvePlot())
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
    m_noise->setPlaceholderText(tr("error of a heading pair, 0.5°"));
    m_open->setObjectName(QStringLiteral("flightOpen"));
    m_make->setObjectName(QStringLiteral("flightMake"));
    m_make->setEnabled(false);
    m_cancel->hide();
    for (QLineEdit* line : {m_variation, m_noise})
        line->setFixedWidth(fontMetrics().averageCharWidth() * 30);
    for (QWidget* one : std::initializer_list<QWidget*>{m_variation, m_noise, m_open, m_cancel, m_make})
        head().addWidget(one);
    messageLine().setWordWrap(true);
    body().addWidget(m_plot, 1);
    setFocusProxy(m_open);
    follow(*m_plot);
    connect(m_open, &QPushButton::clicked, this, &FlightLogPage::choose);
    connect(m_make, &QPushButton::clicked, this, &FlightLogPage::make);
    connect(m_cancel, &QPushButton::clicked, this, [this] { m_worker.cancel(); });
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
    setTitle(tr("A swing in flight of %1 · %2").arg(toText(aircraft->registration), toText(compass->name)));
    return {};
}

Plot* FlightLogPage::plot() const { return m_plot; }

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
    m_cancel->show();
    m_open->setEnabled(false);
    m_make->setEnabled(false);
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
    const auto* legs = std::get_if<LegsSolution>(&read->solved);
    const auto* continuous = std::get_if<ContinuousResult>(&read->solved);
    m_swing = legs ? swingOf(*legs) : swingOf(continuous->legs);
    QStringList lines{QFileInfo(m_path).fileName()};
    lines += legs ? wordsOf(*legs) : wordsOf(*continuous);
    for (const auto& warning : read->warnings)
        lines += toText(warning);
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
    SwingPicture picture = pictureOf(record, analysis, why, nullptr, {}, AngleStyle::DecimalDegrees);
    picture.readingsTitle = tr("means of legs");
    m_plot->setPicture(picture);
    m_make->setEnabled(!m_swing.readings.empty() && m_compass.id.valid() && !m_stores.readOnly());
}

void FlightLogPage::make()
{
    Swing swing = m_swing;
    swing.compass = m_compass.id;
    // Stored: the same in every language.
    swing.note = "from the log " + QFileInfo(m_path).fileName().toStdString();
    emit makeSwing(swing);
}

} // namespace lubberline::ui
