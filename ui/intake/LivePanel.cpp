#include "ui/intake/LivePanel.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QShortcut>
#include <QTimer>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/nmea/NmeaDelay.h"
#include "core/nmea/NmeaSources.h"
#include "core/nmea/NmeaSwing.h"
#include "ui/kit/Words.h"
#include "ui/text/AngleWords.h"

namespace lubberline::ui {

namespace {

enum Kind { Serial, Udp, Replay };
constexpr int kFigure_px = 48;
constexpr int kSecond_ms = 1000;
constexpr char kKindKey[] = "live/kind", kWhereKey[] = "live/where";

QString placeFor(int kind)
{
    if (kind == Udp)
        return QString::number(UdpSettings().port);
    if (kind == Replay)
        return {};
    const QStringList ports = LiveInput::serialPorts();
    return (ports.isEmpty() ? QStringLiteral("/dev/ttyUSB0") : ports.front()) + QStringLiteral(" 4800");
}

} // namespace

LivePanel::LivePanel(std::function<double()> now_s, QWidget* parent)
    : QWidget(parent)
    , m_input(new LiveInput(this))
    , m_heading(new LiveHeading(std::move(now_s), this))
    , m_kind(new QComboBox)
    , m_where(new QLineEdit)
    , m_connect(new QPushButton)
    , m_state(new QLabel)
    , m_datum(new QComboBox)
    , m_compass(new QComboBox)
    , m_datumValue(new QLabel)
    , m_datumDetail(new QLabel)
    , m_compassValue(new QLabel)
    , m_compassDetail(new QLabel)
    , m_notes(new QLabel)
    , m_useDatum(new QPushButton(tr("Take as datum (F6)")))
    , m_useCompass(new QPushButton(tr("Take as compass (F7)")))
    , m_silence(new QTimer(this))
{
    build();
    showState();
    showHeadings();
}

void LivePanel::build()
{
    m_kind->setObjectName(QStringLiteral("liveKind"));
    m_kind->addItems({tr("serial port"), tr("UDP port"), tr("replay of a log")});
    m_where->setObjectName(QStringLiteral("liveWhere"));
    m_where->setText(placeFor(Serial));
    m_where->setToolTip(tr(
        "A serial port with its baud rate, as /dev/ttyUSB0 4800; a UDP port, as 10110 (from this machine only) or *:10110 (from every machine in the network); or the path of a log"));
    m_connect->setObjectName(QStringLiteral("liveConnect"));
    m_state->setObjectName(QStringLiteral("liveState"));
    m_datum->setObjectName(QStringLiteral("liveDatumChannel"));
    m_compass->setObjectName(QStringLiteral("liveCompassChannel"));
    m_datumValue->setObjectName(QStringLiteral("liveDatum"));
    m_compassValue->setObjectName(QStringLiteral("liveCompass"));
    m_datumDetail->setObjectName(QStringLiteral("liveDatumDetail"));
    m_compassDetail->setObjectName(QStringLiteral("liveCompassDetail"));
    m_notes->setObjectName(QStringLiteral("liveNotes"));
    m_notes->setWordWrap(true);
    m_notes->hide();
    m_useDatum->setObjectName(QStringLiteral("liveTakeDatum"));
    m_useCompass->setObjectName(QStringLiteral("liveTakeCompass"));
    m_state->setWordWrap(true);
    for (QComboBox* box : {m_datum, m_compass}) {
        box->setPlaceholderText(tr("none yet"));
        box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
        connect(box, &QComboBox::activated, this, [this, box] {
            m_chosen.insert(box);
            showHeadings();
            showNotes();
        });
    }
    m_datum->setAccessibleName(tr("Sentence of the datum"));
    m_compass->setAccessibleName(tr("Sentence of the compass"));
    for (QLabel* value : {m_datumValue, m_compassValue}) {
        QFont large = value->font();
        large.setPixelSize(kFigure_px);
        value->setFont(large);
        value->setMinimumWidth(QFontMetrics(large).horizontalAdvance(shownHeading(0)));
    }
    for (QLabel* detail : {m_datumDetail, m_compassDetail})
        detail->setWordWrap(true);
    auto* source = new QHBoxLayout;
    source->addWidget(m_kind);
    source->addWidget(m_where);
    source->addWidget(m_connect);
    source->addWidget(m_state, 1);
    auto* grid = new QGridLayout;
    int row = 0;
    for (const auto& [box, value, detail, use] : {std::tuple(m_datum, m_datumValue, m_datumDetail, m_useDatum),
             std::tuple(m_compass, m_compassValue, m_compassDetail, m_useCompass)}) {
        grid->addWidget(box, row, 0);
        grid->addWidget(value, row, 1);
        grid->addWidget(detail, row, 2);
        grid->addWidget(use, row, 3);
        ++row;
    }
    grid->setColumnStretch(2, 1);
    auto* column = new QVBoxLayout(this);
    column->addLayout(source);
    column->addLayout(grid);
    column->addWidget(m_notes);

    connect(m_kind, &QComboBox::currentIndexChanged, this, [this](int kind) { m_where->setText(placeFor(kind)); });
    connect(m_where, &QLineEdit::returnPressed, this, &LivePanel::connectOrClose);
    connect(m_connect, &QPushButton::clicked, this, &LivePanel::connectOrClose);
    connect(m_input, &LiveInput::lineReceived, m_heading, &LiveHeading::takeLine);
    connect(m_input, &LiveInput::stateChanged, this, &LivePanel::showState);
    // Of many lines at once the headings are shown once.
    connect(m_heading, &LiveHeading::changed, this, [this] {
        if (!m_input->delivering())
            showHeadings();
    });
    connect(m_input, &LiveInput::delivered, this, &LivePanel::showHeadings);
    connect(m_useDatum, &QPushButton::clicked, this, &LivePanel::takeDatum);
    connect(m_useCompass, &QPushButton::clicked, this, &LivePanel::takeCompass);
    m_silence->setInterval(kSecond_ms);
    connect(m_silence, &QTimer::timeout, this, [this] {
        m_silent_s = m_heading->sentences() == m_heard ? m_silent_s + 1 : 0;
        m_heard = m_heading->sentences();
        showState();
        showNotes();
        showHeadings(); // what is too old is no heading any more
    });
}

void LivePanel::rememberIn(QSettings& settings)
{
    m_settings = &settings;
    const int kind = settings.value(kKindKey, static_cast<int>(Serial)).toInt();
    if (kind < 0 || kind >= m_kind->count())
        return;
    m_kind->setCurrentIndex(kind);
    if (const QString where = settings.value(kWhereKey).toString(); !where.isEmpty())
        m_where->setText(where);
}

void LivePanel::connectOrClose()
{
    if (m_input->state() != LiveInput::State::Closed) {
        m_input->close();
        m_silence->stop();
        m_heading->clear();
        m_chosen.clear();
        showHeadings();
        showNotes();
        return;
    }
    const QStringList parts = m_where->text().split(' ', Qt::SkipEmptyParts);
    if (parts.isEmpty()) {
        emit failed(tr("Where does it come from? A port or the path of a log is expected."));
        return;
    }
    bool number = true;
    if (m_kind->currentIndex() == Udp) {
        QString text = parts.front();
        const bool fromNetwork = text.startsWith(QStringLiteral("*:")) || text.startsWith(QStringLiteral("0.0.0.0:"));
        const int port = text.remove(0, fromNetwork ? text.indexOf(':') + 1 : 0).toInt(&number);
        if (!number || port < 1 || port > 65535) {
            emit failed(tr("'%1' is no UDP port; expected a number from 1 to 65535, as 10110, or *:10110 for the whole network")
                            .arg(parts.front()));
            return;
        }
        m_input->open(UdpSettings{port, fromNetwork});
    } else if (m_kind->currentIndex() == Replay) {
        m_input->open(ReplaySettings{m_where->text().trimmed(), 10});
    } else {
        const int baud = parts.size() > 1 ? parts[1].toInt(&number) : SerialSettings().baud;
        if (!number || baud < 300) {
            emit failed(tr("'%1' is no baud rate; expected one as 4800 or 38400").arg(parts.value(1)));
            return;
        }
        m_input->open(SerialSettings{parts.front(), baud});
    }
    if (m_settings) {
        m_settings->setValue(kKindKey, m_kind->currentIndex());
        m_settings->setValue(kWhereKey, m_where->text().trimmed());
    }
    m_silent_s = 0;
    m_heard = 0;
    m_silence->start();
}

void LivePanel::showState()
{
    m_connect->setText(m_input->state() == LiveInput::State::Closed ? tr("&Connect") : tr("Dis&connect"));
    QStringList words{m_input->words()};
    constexpr int kNoticed_s = 3;
    if (m_input->state() == LiveInput::State::Open && m_silent_s >= kNoticed_s)
        words += tr("silent for %1 s").arg(m_silent_s);
    if (m_heading->badChecksums() > 0)
        words += tr("%n wrong checksums", nullptr, m_heading->badChecksums());
    if (m_input->dropped() > 0)
        words += tr("%1 sentences left out: more come than can be looked at").arg(m_input->dropped());
    words.removeAll(QString());
    m_state->setText(words.join(QStringLiteral(" · ")));
}

/// What somebody chose stays; else the best is taken that needs no choice (-1: none does).
void LivePanel::keepChannels(QComboBox& box, const QStringList& channels, const QString& best)
{
    QStringList shown;
    for (int i = 0; i < box.count(); ++i)
        shown += box.itemText(i);
    const QString before = box.currentText();
    if (shown != channels) {
        box.clear();
        box.addItems(channels);
    }
    const bool stays = m_chosen.contains(&box) && channels.contains(before);
    if (!stays)
        m_chosen.erase(&box);
    box.setCurrentIndex(static_cast<int>(channels.indexOf(stays ? before : best)));
}

void LivePanel::showHeading(const QString& channel, QLabel& figure, QLabel& detail) const
{
    const auto heading = m_heading->heading(channel);
    figure.setText(heading ? shownHeading(heading->mean_deg) : QStringLiteral("—"));
    QStringList words{settlingWords(channel)};
    if (&detail == m_datumDetail)
        words += northWords(channel);
    else
        words += turnWords(channel);
    words.removeAll(QString());
    detail.setText(words.join(QStringLiteral(" · ")));
}

/// Whether it has come to rest, by how much it moves, and how old the last of it is.
QString LivePanel::settlingWords(const QString& channel) const
{
    const auto source = m_heading->source(channel);
    if (!source)
        return {};
    const auto heading = m_heading->heading(channel);
    if (!heading && source->north == NmeaNorth::Track)
        return source->speed_kt ? tr("%1 kt over ground: a track tells a heading from %2 kt on")
                                      .arg(*source->speed_kt, 0, 'f', 1)
                                      .arg(NmeaOptions().minSpeed_kt)
                                : tr("a track whose speed is not told tells no heading");
    if (!heading)
        return tr("nothing new is heard");
    return (heading->settled ? tr("✓ settled: moves by %1 over %n headings, the last %2 s old", nullptr, heading->count)
                             : tr("moves by %1 over %n headings, the last %2 s old", nullptr, heading->count))
        .arg(shownSize(heading->spread_deg))
        .arg(heading->age_s, 0, 'f', 1);
}

std::optional<double> LivePanel::asDatum_deg(const QString& channel, double heading_deg) const
{
    const bool isTrue = m_heading->isTrue(channel);
    if (isTrue == m_expected.isTrue)
        return heading_deg;
    if (!m_expected.variation_deg)
        return {};
    return wrap360(isTrue ? heading_deg - *m_expected.variation_deg : heading_deg + *m_expected.variation_deg);
}

/// From which north it is, and what the datum makes of it.
QString LivePanel::northWords(const QString& channel) const
{
    const auto heading = m_heading->heading(channel);
    if (!heading)
        return {};
    const bool isTrue = m_heading->isTrue(channel);
    const auto taken = asDatum_deg(channel, heading->mean_deg);
    if (isTrue == m_expected.isTrue)
        return isTrue ? tr("true") : tr("magnetic");
    if (!taken)
        return isTrue ? tr("true; the datum is magnetic, and the swing has no variation")
                      : tr("magnetic; the datum is true, and the swing has no variation");
    return (isTrue ? tr("true; with the variation %2 of the swing it is taken as %1 magnetic")
                   : tr("magnetic; with the variation %2 of the swing it is taken as %1 true"))
        .arg(shownHeading(*taken), shownAngle(*m_expected.variation_deg));
}

void LivePanel::showHeadings()
{
    const QStringList compasses = m_heading->compassChannels();
    keepChannels(*m_compass, compasses, compasses.value(0));
    const QString compass = m_compass->currentText();
    const QStringList references = m_heading->referenceChannels(compass);
    const auto alone
        = std::find_if(references.begin(), references.end(), [&](const QString& one) { return m_heading->standsAlone(one, compass); });
    keepChannels(*m_datum, references, alone == references.end() ? QString() : *alone);
    showHeading(m_datum->currentText(), *m_datumValue, *m_datumDetail);
    showHeading(compass, *m_compassValue, *m_compassDetail);
}

void LivePanel::setDatum(const LiveDatum& datum)
{
    m_expected = datum;
    showHeadings();
}

/// The band in which a compass can be read while it turns: slower is no turn, faster the card lags.
QString LivePanel::turnWords(const QString& channel) const
{
    const auto heading = m_heading->heading(channel);
    if (channel.isEmpty() || !heading || !heading->turnRate_deg_s)
        return {};
    const double rate = std::abs(*heading->turnRate_deg_s);
    if (rate < kSlowestTurn_deg_s)
        return tr("steady");
    const QString way = *heading->turnRate_deg_s > 0 ? tr("clockwise") : tr("counter-clockwise");
    if (rate > kFastestTurn_deg_s)
        return tr("turns %1 at %2°/s: too fast, slow down to %3 … %4°/s")
            .arg(way)
            .arg(rate, 0, 'f', 1)
            .arg(kSlowestTurn_deg_s)
            .arg(kFastestTurn_deg_s);
    return tr("turns %1 at %2°/s: within %3 … %4°/s").arg(way).arg(rate, 0, 'f', 1).arg(kSlowestTurn_deg_s).arg(kFastestTurn_deg_s);
}

/// What is wrong with what is sent, though it is well formed.
void LivePanel::showNotes()
{
    QStringList notes;
    const auto reference = m_heading->source(m_datum->currentText()), compass = m_heading->source(m_compass->currentText());
    if (reference && compass)
        if (const auto doubt = doubtOfReference(reference->source, reference->north, compass->source))
            notes += toText(*doubt);
    if (const auto variation = m_heading->variation(m_expected.variation_deg))
        for (const auto& warning : variation->warnings)
            notes += toText(warning);
    if (m_heading->badHeadings() > 0)
        notes += tr("%n headings are negative or beyond 360 and left out.", nullptr, m_heading->badHeadings());
    m_notes->setText(inAngleStyle(notes.join('\n')));
    m_notes->setVisible(!notes.isEmpty());
}

std::optional<SettledHeading> LivePanel::settled(const QComboBox& box)
{
    const auto heading = m_heading->heading(box.currentText());
    if (box.currentIndex() < 0 && box.count() > 0)
        emit failed(tr("Nothing that is sent is a reference by itself: choose the sentence that is the datum."));
    else if (const QString why = settlingWords(box.currentText()); !heading && !why.isEmpty())
        emit failed(tr("%1: %2.").arg(box.currentText(), why));
    else if (!heading)
        emit failed(tr("Nothing is heard: a heading is expected."));
    else if (!heading->settled)
        emit failed(tr("The heading has not settled yet: it moves by %1 within the window.").arg(shownSize(heading->spread_deg)));
    return heading && heading->settled ? heading : std::nullopt;
}

void LivePanel::takeDatum()
{
    if (!m_expected.isSent) {
        emit failed(tr(
            "The datum of this swing is read by a person: a live heading is none of its figures. Choose an instrument that sends headings (F3)."));
        return;
    }
    const auto heading = settled(*m_datum);
    if (!heading)
        return;
    if (const auto taken = asDatum_deg(m_datum->currentText(), heading->mean_deg))
        emit datumSettled(*taken);
    else
        emit failed(tr(
            "The live heading is from another north than the datum, and the swing has no variation: begin it with a site that has one, or choose an instrument that shows what is sent (F3)."));
}

void LivePanel::takeCompass()
{
    if (const auto heading = settled(*m_compass))
        emit compassSettled(heading->mean_deg);
}

} // namespace lubberline::ui
