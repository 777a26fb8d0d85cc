#include "ui/intake/LivePanel.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QShortcut>
#include <QTimer>

#include <cmath>

#include "core/angle/PrintedHeading.h"
#include "core/nmea/NmeaDelay.h"
#include "ui/kit/Words.h"

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
    , m_compassValue(new QLabel)
    , m_turn(new QLabel)
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
    m_turn->setObjectName(QStringLiteral("liveTurn"));
    m_notes->setObjectName(QStringLiteral("liveNotes"));
    m_notes->setWordWrap(true);
    m_notes->hide();
    m_useDatum->setObjectName(QStringLiteral("liveTakeDatum"));
    m_useCompass->setObjectName(QStringLiteral("liveTakeCompass"));
    for (QLabel* value : {m_datumValue, m_compassValue}) {
        QFont large = value->font();
        large.setPixelSize(kFigure_px);
        value->setFont(large);
        value->setMinimumWidth(260);
    }
    auto* grid = new QGridLayout(this);
    grid->addWidget(m_kind, 0, 0);
    grid->addWidget(m_where, 0, 1);
    grid->addWidget(m_connect, 0, 2);
    grid->addWidget(m_state, 0, 3);
    grid->addWidget(m_datum, 1, 0);
    grid->addWidget(m_datumValue, 1, 1);
    grid->addWidget(m_useDatum, 1, 2);
    grid->addWidget(m_compass, 2, 0);
    grid->addWidget(m_compassValue, 2, 1);
    grid->addWidget(m_useCompass, 2, 2);
    grid->addWidget(m_turn, 2, 3);
    grid->addWidget(m_notes, 3, 0, 1, 4);
    grid->setColumnStretch(3, 1);

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

/// What is chosen stays chosen; a second talker is offered, and not taken by itself.
void LivePanel::keepChannels(QComboBox& box, const QStringList& channels)
{
    QStringList shown;
    for (int i = 0; i < box.count(); ++i)
        shown += box.itemText(i);
    if (shown == channels)
        return;
    const QString chosen = box.currentText();
    box.clear();
    box.addItems(channels);
    box.setCurrentIndex(std::max(0, static_cast<int>(channels.indexOf(chosen))));
}

QString LivePanel::words(const QString& channel) const
{
    const auto heading = m_heading->heading(channel);
    if (channel.isEmpty() || !heading)
        return QStringLiteral("—");
    return tr("%1° %2")
        .arg(printedHeading_deg(heading->mean_deg, 1), 5, 'f', 1, QChar('0'))
        .arg((heading->settled ? tr("✓ ±%1") : tr("±%1")).arg(heading->spread_deg / 2, 0, 'f', 1));
}

void LivePanel::showHeadings()
{
    keepChannels(*m_datum, m_heading->referenceChannels());
    keepChannels(*m_compass, m_heading->compassChannels());
    m_datumValue->setText(words(m_datum->currentText()) + (m_heading->isTrue(m_datum->currentText()) ? tr(" true") : QString()));
    m_compassValue->setText(words(m_compass->currentText()));
    m_turn->setText(turnWords(m_compass->currentText()));
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
    if (const auto variation = m_heading->variation())
        for (const auto& warning : variation->warnings)
            notes += toText(warning);
    if (m_heading->badHeadings() > 0)
        notes += tr("%n headings are negative or beyond 360 and left out.", nullptr, m_heading->badHeadings());
    m_notes->setText(notes.join('\n'));
    m_notes->setVisible(!notes.isEmpty());
}

std::optional<SettledHeading> LivePanel::settled(const QComboBox& box)
{
    const auto heading = m_heading->heading(box.currentText());
    if (!heading)
        emit failed(tr("Nothing is heard: a heading is expected."));
    else if (!heading->settled)
        emit failed(tr("The heading has not settled yet: it moves by %1° within the window.").arg(heading->spread_deg, 0, 'f', 1));
    return heading && heading->settled ? heading : std::nullopt;
}

void LivePanel::takeDatum()
{
    if (const auto heading = settled(*m_datum))
        emit datumSettled(heading->mean_deg, m_heading->isTrue(m_datum->currentText()));
}

void LivePanel::takeCompass()
{
    if (const auto heading = settled(*m_compass))
        emit compassSettled(heading->mean_deg);
}

} // namespace lubberline::ui
