#pragma once
/// Live sentences from a serial port, a UDP port, or a log that is replayed. A source that vanishes is tried again until it is closed
/// by hand; what it sends is cut into lines whatever it babbles. It is read on a thread of its own, and of a flood only so much comes here
/// as the window can look at between two keys.

#include <QObject>
#include <QString>
#include <QThread>

#include <memory>
#include <string_view>

#include "ui/intake/LiveSettings.h"

namespace lubberline::ui {

class LiveReader;

class LiveInput : public QObject {
    Q_OBJECT

public:
    using State = LiveState;

    explicit LiveInput(QObject* parent = nullptr);
    ~LiveInput() override;

    void open(const LiveSettings& settings);
    void close();
    [[nodiscard]] State state() const { return m_state; }
    [[nodiscard]] const QString& words() const { return m_words; } ///< the state in words, with what went wrong
    [[nodiscard]] qint64 dropped() const { return m_dropped; } ///< lines that were left out since open(): more came than can be looked at
    [[nodiscard]] bool delivering() const { return m_delivering; } ///< more lines follow at once; delivered() comes after them

    /// The system's serial ports.
    [[nodiscard]] static QStringList serialPorts();

signals:
    void lineReceived(std::string_view line); ///< on the window's thread; the view is valid during the call
    void delivered();
    void stateChanged();

private:
    void deliver();
    void lookAtState();

    QThread m_thread;
    LiveReader* m_reader; ///< on that thread
    State m_state = State::Closed;
    QString m_words;
    qint64 m_dropped = 0;
    bool m_delivering = false;
};

} // namespace lubberline::ui
