#pragma once
/// Where live sentences come from: a serial port, a UDP port, or a log that is replayed. A source that vanishes is tried again
/// until it is closed by hand; what it sends is cut into lines whatever it babbles.

#include <QObject>
#include <QString>
#include <QTimer>

#include <memory>
#include <string_view>
#include <variant>

#include "core/nmea/NmeaLines.h"

class QIODevice;

namespace lubberline::ui {

struct SerialSettings {
    QString port;    ///< "/dev/ttyUSB0" or the name of the system's list
    int baud = 4800; ///< NMEA 0183's own; high-speed talkers 38400
};
struct UdpSettings {
    int port = 10110; ///< the port registered for NMEA 0183 over IP
};
struct ReplaySettings {
    QString path;
    int linesPerSecond = 10;
};
using LiveSettings = std::variant<SerialSettings, UdpSettings, ReplaySettings>;

class LiveInput : public QObject {
    Q_OBJECT

public:
    enum class State { Closed, Open, Waiting }; ///< Waiting: not there at the moment, tried again every two seconds

    explicit LiveInput(QObject* parent = nullptr);
    ~LiveInput() override;

    void open(const LiveSettings& settings);
    void close();
    [[nodiscard]] State state() const { return m_state; }
    [[nodiscard]] const QString& words() const { return m_words; } ///< the state in words, with what went wrong

    /// The system's serial ports.
    [[nodiscard]] static QStringList serialPorts();

signals:
    void lineReceived(std::string_view line); ///< on the window's thread; the view is valid during the call
    void stateChanged();

private:
    void tryOpen();
    void openSerial(const SerialSettings& settings);
    void openUdp(const UdpSettings& settings);
    void openReplay(const ReplaySettings& settings);
    void enter(State state, const QString& words);
    void lose(const QString& why);
    void takeBytes(const QByteArray& bytes);
    void replayLine();

    LiveSettings m_settings;
    State m_state = State::Closed;
    bool m_wanted = false; ///< from open() to close()
    QString m_words;
    std::unique_ptr<QIODevice> m_device;
    NmeaLines m_lines;
    QTimer m_again;  ///< tries a lost source again
    QTimer m_replay; ///< gives the next line of a log
};

} // namespace lubberline::ui
