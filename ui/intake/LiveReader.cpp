#include "ui/intake/LiveReader.h"

#include <QFile>
#include <QSerialPort>
#include <QUdpSocket>

#include <algorithm>
#include <utility>

namespace lubberline::ui {

namespace {

constexpr int kTryAgain_ms = 2000;
/// Of a batch: no instrument sends more than some twenty of one sentence a second, and what one floods takes no place from another.
constexpr int kBatch_ms = 50, kMostOfOne = 20;
constexpr std::size_t kMostLines = 200, kMostSenders = 64;
constexpr int kMostDatagrams = 2000; ///< at once; then the window's other work on this machine has its turn

/// "$HCHDG" of "$HCHDG,98.3,…": whose line it is.
std::string_view senderOf(std::string_view line) { return line.substr(0, std::min<std::size_t>(line.find(','), 12)); }

} // namespace

LiveReader::LiveReader() : m_again(this), m_replay(this), m_soon(this), m_rest(this)
{
    m_again.setInterval(kTryAgain_ms);
    m_soon.setInterval(kBatch_ms);
    m_rest.setInterval(kBatch_ms);
    for (QTimer* timer : {&m_again, &m_soon, &m_rest})
        timer->setSingleShot(true);
    connect(&m_again, &QTimer::timeout, this, &LiveReader::tryOpen);
    connect(&m_replay, &QTimer::timeout, this, &LiveReader::replayLine);
    connect(&m_soon, &QTimer::timeout, this, &LiveReader::linesReady);
}

LiveReader::~LiveReader() = default;

std::pair<LiveState, QString> LiveReader::state() const
{
    const std::lock_guard lock(m_mutex);
    return {m_state, m_words};
}

LiveBatch LiveReader::take()
{
    const std::lock_guard lock(m_mutex);
    m_kept.clear();
    LiveBatch batch{std::move(m_batch.lines), m_batch.dropped};
    m_batch.lines.clear();
    return batch;
}

void LiveReader::open(const LiveSettings& settings)
{
    close();
    m_settings = settings;
    m_wanted = true;
    m_thins = !std::holds_alternative<ReplaySettings>(settings);
    {
        const std::lock_guard lock(m_mutex);
        m_batch = {};
        m_kept.clear();
    }
    tryOpen();
}

void LiveReader::close()
{
    m_wanted = false;
    for (QTimer* timer : {&m_again, &m_replay, &m_soon, &m_rest})
        timer->stop();
    m_device.reset();
    m_lines = NmeaLines();
    if (state().first != LiveState::Closed)
        enter(LiveState::Closed, tr("closed"));
}

void LiveReader::tryOpen()
{
    m_device.reset();
    m_lines = NmeaLines(); // half a sentence of before belongs to nothing that comes now
    if (const auto* serial = std::get_if<SerialSettings>(&m_settings))
        openSerial(*serial);
    else if (const auto* udp = std::get_if<UdpSettings>(&m_settings))
        openUdp(*udp);
    else
        openReplay(std::get<ReplaySettings>(m_settings));
}

void LiveReader::openSerial(const SerialSettings& settings)
{
    auto port = std::make_unique<QSerialPort>(settings.port);
    port->setBaudRate(settings.baud);
    if (!port->open(QIODevice::ReadOnly)) {
        lose(tr("%1 cannot be opened: %2").arg(settings.port, port->errorString()));
        return;
    }
    QSerialPort* raw = port.get();
    connect(raw, &QSerialPort::readyRead, this, [this, raw] { takeBytes(raw->readAll()); });
    connect(raw, &QSerialPort::errorOccurred, this, [this](QSerialPort::SerialPortError error) {
        // Damage on the line is found by checksums; these errors are a port that was pulled out (a hang-up reads as ReadError).
        if (error == QSerialPort::ResourceError || error == QSerialPort::ReadError || error == QSerialPort::DeviceNotFoundError
            || error == QSerialPort::PermissionError)
            QMetaObject::invokeMethod(
                this, [this] { lose(tr("the serial port has vanished")); }, Qt::QueuedConnection);
    });
    m_device = std::move(port);
    enter(LiveState::Open, tr("listening on %1 at %2 baud").arg(settings.port).arg(settings.baud));
}

void LiveReader::openUdp(const UdpSettings& settings)
{
    auto socket = std::make_unique<QUdpSocket>();
    const QHostAddress from = settings.fromNetwork ? QHostAddress::AnyIPv4 : QHostAddress::LocalHost;
    // Exclusively: nobody beside us takes what is sent, or sends in another's name from the same port.
    if (!socket->bind(from, static_cast<quint16>(settings.port), QUdpSocket::DontShareAddress)) {
        lose(tr("UDP port %1 cannot be used: %2").arg(settings.port).arg(socket->errorString()));
        return;
    }
    QUdpSocket* raw = socket.get();
    connect(raw, &QUdpSocket::readyRead, this, [this, raw] { readDatagrams(*raw); });
    connect(&m_rest, &QTimer::timeout, raw, [this, raw] { readDatagrams(*raw); });
    m_device = std::move(socket);
    enter(LiveState::Open,
        settings.fromNetwork ? tr("listening on UDP port %1, to every machine in the network").arg(settings.port)
                             : tr("listening on UDP port %1, to this machine only").arg(settings.port));
}

void LiveReader::readDatagrams(QUdpSocket& socket)
{
    if (m_rest.isActive())
        return;
    for (int count = 0; socket.hasPendingDatagrams(); ++count) {
        if (count == kMostDatagrams) {
            m_rest.start();
            return;
        }
        QByteArray datagram(static_cast<qsizetype>(std::max<qint64>(socket.pendingDatagramSize(), 0)), '\0');
        const qint64 size = socket.readDatagram(datagram.data(), datagram.size());
        if (size > 0)
            takeBytes(datagram.first(size) + '\n'); // a datagram ends a sentence, with or without a line end
    }
}

void LiveReader::openReplay(const ReplaySettings& settings)
{
    auto file = std::make_unique<QFile>(settings.path);
    if (!file->open(QIODevice::ReadOnly)) {
        enter(LiveState::Closed, tr("%1 cannot be opened: %2").arg(settings.path, file->errorString()));
        return;
    }
    m_device = std::move(file);
    m_replay.start(1000 / std::clamp(settings.linesPerSecond, 1, 1000));
    enter(LiveState::Open, tr("replaying %1").arg(settings.path));
}

void LiveReader::replayLine()
{
    const QByteArray line = m_device->readLine(static_cast<qint64>(kMaxNmeaLine) * 2);
    if (line.isEmpty()) {
        m_replay.stop();
        m_lines.finish([this](std::string_view last) { keep(last); });
        m_device.reset();
        enter(LiveState::Closed, tr("the log has ended"));
        return;
    }
    takeBytes(line);
}

void LiveReader::takeBytes(const QByteArray& bytes)
{
    m_lines.feed({bytes.constData(), static_cast<std::size_t>(bytes.size())}, [this](std::string_view line) { keep(line); });
}

void LiveReader::keep(std::string_view line)
{
    {
        const std::lock_guard lock(m_mutex);
        if (m_thins) {
            const std::string_view sender = senderOf(line);
            auto kept = m_kept.find(sender);
            const bool full = m_batch.lines.size() >= kMostLines || (kept == m_kept.end() && m_kept.size() >= kMostSenders)
                || (kept != m_kept.end() && kept->second >= kMostOfOne);
            if (full) {
                ++m_batch.dropped;
                return;
            }
            if (kept == m_kept.end())
                kept = m_kept.emplace(sender, 0).first;
            ++kept->second;
        }
        m_batch.lines.emplace_back(line);
    }
    if (!m_soon.isActive())
        m_soon.start();
}

void LiveReader::lose(const QString& why)
{
    if (!m_wanted)
        return; // closed by hand in the meantime
    m_device.reset();
    m_again.start();
    enter(LiveState::Waiting, tr("%1; trying again").arg(why));
}

void LiveReader::enter(LiveState state, const QString& words)
{
    {
        const std::lock_guard lock(m_mutex);
        m_state = state;
        m_words = words;
    }
    emit stateChanged();
}

} // namespace lubberline::ui
