#include "ui/intake/LiveInput.h"

#include <QSerialPortInfo>

#include "ui/intake/LiveReader.h"

namespace lubberline::ui {

LiveInput::LiveInput(QObject* parent) : QObject(parent), m_reader(new LiveReader)
{
    m_reader->moveToThread(&m_thread);
    connect(&m_thread, &QThread::finished, m_reader, &QObject::deleteLater);
    connect(m_reader, &LiveReader::linesReady, this, &LiveInput::deliver);
    connect(m_reader, &LiveReader::stateChanged, this, &LiveInput::lookAtState);
}

LiveInput::~LiveInput()
{
    if (!m_thread.isRunning()) {
        delete m_reader;
        return;
    }
    m_thread.quit();
    m_thread.wait();
}

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
    if (!m_thread.isRunning())
        m_thread.start();
    m_dropped = 0;
    QMetaObject::invokeMethod(
        m_reader, [this, settings] { m_reader->open(settings); }, Qt::BlockingQueuedConnection);
    lookAtState();
}

void LiveInput::close()
{
    if (!m_thread.isRunning())
        return;
    QMetaObject::invokeMethod(
        m_reader, [this] { m_reader->close(); }, Qt::BlockingQueuedConnection);
    static_cast<void>(m_reader->take()); // what was on its way
    lookAtState();
}

void LiveInput::deliver()
{
    const LiveBatch batch = m_reader->take();
    m_dropped = batch.dropped;
    m_delivering = true;
    for (const std::string& line : batch.lines)
        emit lineReceived(line);
    m_delivering = false;
    emit delivered();
}

void LiveInput::lookAtState()
{
    const auto [state, words] = m_reader->state();
    if (state == m_state && words == m_words)
        return;
    if (state != State::Closed || m_state != State::Closed)
        deliver(); // what came before it
    m_state = state;
    m_words = words;
    emit stateChanged();
}

} // namespace lubberline::ui
