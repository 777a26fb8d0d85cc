#include "ui/intake/LiveInput.h"

#include <QFile>
#include <QSerialPort>
#include <QSerialPortInfo>
#include <QUdpSocket>

#include <algorithm>

namespace lubberline::ui {

namespace {

constexpr int kTryAgain_ms = 2000;

} // namespace

LiveInput::LiveInput(QObject* parent) : QObject(parent)
{
    m_again.setInterval(kTryAgain_ms);
    m_again.setSingleShot(true);
    connect(&m_again, &QTimer::timeout, this, &LiveInput::tryOpen);
    connect(&m_replay, &QTimer::timeout, this, &LiveInput::replayLine);
}

LiveInput::~LiveInput() = default;

QStringList LiveInput::serialPorts()
{
    QStringList ports;
    const auto available = QSerialPortInfo::availablePorts();
    for (const auto& info : available)
        ports << info.systemLocation();
    return ports;
}

void LiveInput::open(const LiveSettings& settings)
{
    close();
    m_settings = settings;
    m_wanted = true;
    tryOpen();
}

void LiveInput::close()
{
    m_wanted = false;
    m_again.stop();
    m_replay.stop();
    m_device.reset();
    m_lines = NmeaLines();
    if (m_state != State::Closed)
        enter(State::Closed, tr("closed"));
}

void LiveInput::tryOpen()
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

void LiveInput::openSerial(const SerialSettings& settings)
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
    enter(State::Open, tr("listening on %1 at %2 baud").arg(settings.port).arg(settings.baud));
}

void LiveInput::openUdp(const UdpSettings& settings)
{
    auto socket = std::make_unique<QUdpSocket>();
    if (!socket->bind(
            QHostAddress::AnyIPv4, static_cast<quint16>(settings.port), QUdpSocket::ShareAddress | QUdpSocket::ReuseAddressHint)) {
        lose(tr("UDP port %1 cannot be used: %2").arg(settings.port).arg(socket->errorString()));
        return;
    }
    QUdpSocket* raw = socket.get();
    connect(raw, &QUdpSocket::readyRead, this, [this, raw] {
        while (raw->hasPendingDatagrams()) {
            QByteArray datagram(static_cast<qsizetype>(raw->pendingDatagramSize()), '\0');
            const qint64 size = raw->readDatagram(datagram.data(), datagram.size());
            if (size > 0)
                takeBytes(datagram.first(size) + '\n'); // a datagram ends a sentence, with or without a line end
        }
    });
    m_device = std::move(socket);
    enter(State::Open, tr("listening on UDP port %1").arg(settings.port));
}

void LiveInput::openReplay(const ReplaySettings& settings)
{
    auto file = std::make_unique<QFile>(settings.path);
    if (!file->open(QIODevice::ReadOnly)) {
        enter(State::Closed, tr("%1 cannot be opened: %2").arg(settings.path, file->errorString()));
        return;
    }
    m_device = std::move(file);
    m_replay.start(1000 / std::clamp(settings.linesPerSecond, 1, 1000));
    enter(State::Open, tr("replaying %1").arg(settings.path));
}

void LiveInput::replayLine()
{
    const QByteArray line = m_device->readLine(static_cast<qint64>(kMaxNmeaLine) * 2);
    if (line.isEmpty()) {
        m_replay.stop();
        m_lines.finish([this](std::string_view last) { emit lineReceived(last); });
        m_device.reset();
        enter(State::Closed, tr("the log has ended"));
        return;
    }
    takeBytes(line);
}

void LiveInput::takeBytes(const QByteArray& bytes)
{
    m_lines.feed({bytes.constData(), static_cast<std::size_t>(bytes.size())}, [this](std::string_view line) { emit lineReceived(line); });
}

void LiveInput::lose(const QString& why)
{
    if (!m_wanted)
        return; // closed by hand in the meantime
    m_device.reset();
    m_again.start();
    enter(State::Waiting, tr("%1; trying again").arg(why));
}

void LiveInput::enter(State state, const QString& words)
{
    m_state = state;
    m_words = words;
    emit stateChanged();
}

} // namespace lubberline::ui
