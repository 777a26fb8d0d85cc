#include "ui/intake/NmeaImportPage.h"

#include <QComboBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include <array>
#include <cmath>

#include "core/angle/AngleText.h"
#include "core/base/FileText.h"
#include "core/nmea/NmeaBase.h"
#include "core/swing/Analysis.h"
#include "core/swing/SwingResult.h"
#include "ui/kit/Words.h"
#include "ui/kit/fit/FlowLayout.h"
#include "ui/kit/fit/SideBySide.h"
#include "ui/plots/swing/PictureOf.h"
#include "ui/plots/swing/SwingPlot.h"
#include "ui/text/AngleWords.h"
#include "ui/text/NumberText.h"

namespace lubberline::ui {

namespace {

/// In the order of NmeaReference.
constexpr std::array kReferences{MARKED("ui", "track over ground (RMC, VTG)"), MARKED("ui", "true heading (HDT, THS)"),
    MARKED("ui", "another magnetic heading (HDM, HDG)")};

Result<double> positive(const QString& text, const QString& what)
{
    const auto value = typedNumber(text);
    if (!value || *value < 0 || *value > 1e6)
        return Error{
            ErrorCode::InvalidInput, said(NmeaImportPage::tr("'%1' is not allowed for %2; expected a number from 0 on").arg(text, what))};
    return *value;
}

Result<NmeaVariation> variationOf(const QString& text)
{
    const QString word = text.trimmed().toLower();
    if (word.isEmpty())
        return NmeaVariation(VariationFound{});
    if (word == NmeaImportPage::tr("log"))
        return NmeaVariation(VariationOfLog{});
    if (word == NmeaImportPage::tr("model"))
        return NmeaVariation(VariationOfModel{});
    const auto angle = parseSignedAngle_deg(text.trimmed().toStdString());
    if (!angle)
        return angle.error();
    return NmeaVariation(Variation::fromDegrees(*angle));
}

} // namespace

namespace {

/// How many pairs are used, and how many each cut-off takes; one that is both is counted with the slow ones.
QString cutWords(const NmeaSwing& read, const NmeaOptions& options)
{
    int slow = 0, fast = 0;
    for (const auto& pair : read.pairs) {
        if (pair.used)
            continue;
        const bool isSlow = options.reference == NmeaReference::Track && pair.speed_kt && *pair.speed_kt < options.minSpeed_kt;
        slow += isSlow;
        fast += !isSlow && pair.turnRate_deg_s && std::abs(*pair.turnRate_deg_s) > options.maxTurnRate_deg_s;
    }
    QString words = NmeaImportPage::tr("%1 pairs of headings, %2 used; %3 slower than %4 kt, %5 in a turn faster than %6°/s")
                        .arg(read.pairs.size())
                        .arg(read.used)
                        .arg(slow)
                        .arg(options.minSpeed_kt)
                        .arg(fast)
                        .arg(options.maxTurnRate_deg_s);
    if (const auto rest = static_cast<int>(read.pairs.size() - read.used) - slow - fast; rest > 0)
        words += NmeaImportPage::tr(", %1 left out for another cause (see below)").arg(rest);
    return words + '.';
}

} // namespace

NmeaImportPage::NmeaImportPage(db::Stores& stores, FileQuestions questions, QWidget* parent)
    : Page(parent)
    , m_stores(stores)
    , m_questions(std::move(questions))
    , m_summary(new QLabel)
    , m_reference(new QComboBox)
    , m_wind(new QComboBox)
    , m_kind(new QComboBox)
    , m_variation(new QLineEdit)
    , m_variationError(new QLineEdit)
    , m_speed(new QLineEdit)
    , m_rate(new QLineEdit)
    , m_talker(new QLineEdit)
    , m_date(new QLineEdit)
    , m_read(new QPushButton(tr("&Open a log…")))
    , m_cancel(new QPushButton(tr("Cancel")))
    , m_make(new QPushButton(tr("&Make a swing of it")))
    , m_plot(makeCurvePlot())
    , m_worker([this](Result<NmeaSwing> read) { take(std::move(read)); })
{
    build();
}

void NmeaImportPage::build()
{
    const NmeaOptions usual;
    setTitle(tr("A log of a slow turn as a swing"));
    m_reference->setObjectName(QStringLiteral("nmeaReference"));
    for (const Message reference : kReferences)
        m_reference->addItem(toText(reference));
    m_wind->setObjectName(QStringLiteral("nmeaWind"));
    m_wind->addItems({tr("taken out in flight"), tr("taken out always (afloat)"), tr("none (on wheels)")}); // as NmeaWindChoice
    m_kind->setObjectName(QStringLiteral("nmeaKind"));
    m_kind->addItems(choiceWords<SwingKind>());
    m_kind->setCurrentIndex(static_cast<int>(SwingKind::Calibration));
    m_variation->setObjectName(QStringLiteral("nmeaVariation"));
    m_variation->setPlaceholderText(tr("empty: the log's, else the model's; log; model; or degrees, E +"));
    m_variationError->setObjectName(QStringLiteral("nmeaVariationError"));
    m_variationError->setPlaceholderText(tr("standard error, where you know of one: survey, magnetic storm"));
    m_date->setObjectName(QStringLiteral("nmeaDate"));
    m_date->setPlaceholderText(tr("YYYY-MM-DD, where the log's own is wrong"));
    m_speed->setObjectName(QStringLiteral("nmeaSpeed"));
    m_speed->setText(QString::number(usual.minSpeed_kt));
    m_rate->setObjectName(QStringLiteral("nmeaRate"));
    m_rate->setText(QString::number(usual.maxTurnRate_deg_s));
    m_talker->setObjectName(QStringLiteral("nmeaTalker"));
    m_talker->setPlaceholderText(tr("as HC; empty: the only one"));
    m_read->setObjectName(QStringLiteral("nmeaOpen"));
    m_cancel->setObjectName(QStringLiteral("nmeaCancel"));
    m_make->setObjectName(QStringLiteral("nmeaMake"));
    m_summary->setObjectName(QStringLiteral("nmeaSummary"));
    m_summary->setWordWrap(true);
    m_summary->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_make->setEnabled(false);
    m_cancel->hide();
    auto* form = new QFormLayout;
    form->addRow(tr("&Reference:"), m_reference);
    form->addRow(tr("&Wind on a track:"), m_wind);
    form->addRow(tr("&Variation:"), m_variation);
    form->addRow(tr("Variation sure to (°):"), m_variationError);
    form->addRow(tr("&Slowest used (kt):"), m_speed);
    form->addRow(tr("&Fastest turn used (°/s):"), m_rate);
    form->addRow(tr("Compass &talker:"), m_talker);
    form->addRow(tr("&Date of the log:"), m_date);
    form->addRow(tr("&Kind of swing:"), m_kind);
    auto* buttons = new FlowLayout;
    buttons->addWidget(m_read);
    buttons->addWidget(m_cancel);
    buttons->addWidget(m_make);
    auto* left = new QWidget;
    auto* column = new QVBoxLayout(left);
    column->addLayout(form);
    column->addLayout(buttons);
    column->addWidget(m_summary);
    column->addStretch();
    auto* splitter = new SideBySide;
    splitter->addWidget(new SidePanel(left)); // a log can have much against it
    splitter->addWidget(m_plot);
    splitter->setStretchFactor(1, 1);
    body().addWidget(splitter, 1);
    setFocusProxy(m_read);
    for (QLineEdit* line : {m_variation, m_variationError, m_speed, m_rate, m_talker, m_date})
        connect(line, &QLineEdit::textEdited, this, [this] { m_make->setEnabled(false); }); // Enter reads it again
    connect(m_read, &QPushButton::clicked, this, &NmeaImportPage::choose);
    connect(m_make, &QPushButton::clicked, this, &NmeaImportPage::make);
    connect(m_cancel, &QPushButton::clicked, this, [this] { m_worker.cancel(); });
    follow(*m_plot);
    SwingPicture nothing;
    nothing.whyNoAnalysis = tr("Open a log: what was read on each heading is drawn here.");
    m_plot->setPicture(nothing);
    for (QComboBox* box : {m_reference, m_wind})
        connect(box, &QComboBox::activated, this, &NmeaImportPage::start);
    for (QLineEdit* line : {m_variation, m_variationError, m_speed, m_rate, m_talker, m_date})
        connect(line, &QLineEdit::returnPressed, this, &NmeaImportPage::start);
}

Result<void> NmeaImportPage::showCompass(CompassId compass)
{
    const auto system = m_stores.fleet.compass(compass);
    if (!system)
        return system.error();
    const auto aircraft = m_stores.fleet.aircraft(system->aircraft);
    if (!aircraft)
        return aircraft.error();
    if (m_compass.id != system->id) { // a log is of one aircraft
        m_swing.reset();
        m_path.clear();
        m_summary->clear();
        m_make->setEnabled(false);
    }
    m_compass = *system;
    setTitle(tr("A log of a slow turn as a swing of %1 · %2").arg(toText(aircraft->registration), toText(system->name)));
    return {};
}

void NmeaImportPage::choose()
{
    const QString path = m_questions.open(tr("Open a log"), tr("NMEA 0183 logs (*.nmea *.log *.txt);;All files (*)"));
    if (!path.isEmpty())
        readLog(path);
}

void NmeaImportPage::readLog(const QString& path)
{
    m_path = path;
    start();
}

Result<NmeaOptions> NmeaImportPage::options() const
{
    NmeaOptions options;
    options.reference = static_cast<NmeaReference>(m_reference->currentIndex());
    const auto variation = variationOf(m_variation->text());
    const auto speed = positive(m_speed->text(), tr("the slowest speed"));
    const auto rate = positive(m_rate->text(), tr("the fastest turn"));
    const QString sureTo = m_variationError->text().trimmed();
    const auto error = sureTo.isEmpty() ? Result<double>(0.0) : positive(sureTo, tr("how sure the variation is"));
    if (!variation || !speed || !rate)
        return !variation ? variation.error() : !speed ? speed.error() : rate.error();
    if (!error)
        return error.error();
    const QString typedDay = m_date->text().trimmed();
    const auto day = typedDay.isEmpty() ? std::optional(Date()) : Date::read(typedDay.toStdString());
    if (!day)
        return Error{ErrorCode::InvalidInput, said(tr("'%1' is no date; expected YYYY-MM-DD").arg(m_date->text()))};
    options.date = *day;
    options.wind = static_cast<NmeaWindChoice>(m_wind->currentIndex());
    options.variationError_deg = *error;
    options.variation = *variation;
    options.minSpeed_kt = *speed;
    options.maxTurnRate_deg_s = *rate;
    options.today = m_stores.clock().today();
    options.compassTalker = m_talker->text().trimmed().toUpper().toStdString();
    return options;
}

void NmeaImportPage::start()
{
    if (m_path.isEmpty() || m_worker.running())
        return;
    const auto chosen = options();
    if (!chosen) {
        emit failed(messageOf(chosen.error()));
        return;
    }
    m_datum = Message(kReferences[static_cast<std::size_t>(m_reference->currentIndex())]).english(); // it is stored
    m_used = *chosen;
    m_cancel->show();
    m_read->setEnabled(false);
    m_reference->setEnabled(false);
    m_wind->setEnabled(false);
    m_make->setEnabled(false);
    m_summary->setText(tr("Reading %1 …").arg(QFileInfo(m_path).fileName()));
    m_worker.start(
        [path = m_path.toStdString(), chosen = *chosen](const Progress& progress) { return readNmeaSwingFile(path, chosen, progress); });
}

void NmeaImportPage::take(Result<NmeaSwing> read)
{
    m_cancel->hide();
    m_read->setEnabled(true);
    m_reference->setEnabled(true);
    m_wind->setEnabled(true);
    if (!read) {
        m_swing.reset();
        m_summary->setText(messageOf(read.error()));
        if (read.error().code != ErrorCode::Cancelled)
            emit failed(messageOf(read.error()));
        return;
    }
    if (const auto bases = m_stores.sites.sites())
        holdAgainstBases(*read, m_used, *bases);
    m_swing = std::make_shared<const NmeaSwing>(std::move(read.value()));
    showAnswer();
}

void NmeaImportPage::showAnswer()
{
    const NmeaSwing& read = *m_swing;
    QStringList lines{tr("%1: %2 sentences, %3 with a wrong checksum, %4 lines that are none.")
                          .arg(QFileInfo(m_path).fileName())
                          .arg(read.sentences)
                          .arg(read.badChecksums)
                          .arg(read.otherLines),
        cutWords(read, m_used)};
    if (read.variation)
        lines += tr("Variation %1° (E +): %2.").arg(signedNumber(read.variation->degrees(), 2), toText(read.variationSource));
    for (const auto& warning : read.warnings)
        lines += toText(warning);
    SwingRecord record;
    record.swing = toSwing(read);
    record.compass = m_compass;
    std::shared_ptr<const Analysis> analysis;
    QString why;
    if (auto made = resultOf(record)) {
        analysis = std::make_shared<const Analysis>(std::move(made.value()));
    } else {
        why = toText(made.error().message);
    }
    if (!why.isEmpty())
        lines += why;
    m_summary->setText(inAngleStyle(lines.join('\n')));
    m_plot->setPicture(pictureOf(record, analysis, why, nullptr, {}, shownAngles()));
    m_make->setEnabled(read.used > 0 && !m_stores.readOnly());
}

void NmeaImportPage::make()
{
    Swing swing = toSwing(*m_swing);
    swing.compass = m_compass.id;
    swing.kind = static_cast<SwingKind>(m_kind->currentIndex());
    swing.datum.instrument = m_datum;
    // Stored: the same in every language.
    swing.note = "from the log " + QFileInfo(m_path).fileName().toStdString() + (swing.note.empty() ? "" : "; " + swing.note);
    emit makeSwing(swing);
}

} // namespace lubberline::ui
