#pragma once
/// The thread's side of a live source: opens it, cuts what it sends into lines, and keeps of a flood what can be looked at. Lives on a
/// thread of its own; what is marked so may be called from any.

#include <QObject>
#include <QTimer>

#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "core/nmea/NmeaLines.h"
#include "ui/intake/LiveSettings.h"

class QIODevice;
class QUdpSocket;

namespace lubberline::ui {

/// What has come since it was asked last.
struct LiveBatch {
    std::vector<std::string> lines;
    qint64 dropped = 0; ///< since the source was opened: more came than can be looked at
};

class LiveReader : public QObject {
    Q_OBJECT

public:
    LiveReader();
    ~LiveReader() override;

    void open(const LiveSettings& settings);
    void close();
    [[nodiscard]] std::pair<LiveState, QString> state() const; ///< from any thread
    [[nodiscard]] LiveBatch take();                            ///< from any thread

signals:
    void stateChanged();
    void linesReady(); ///< some twenty times a second at most

private:
    void tryOpen();
    void openSerial(const SerialSettings& settings);
    void openUdp(const UdpSettings& settings);
    void openReplay(const ReplaySettings& settings);
    void readDatagrams(QUdpSocket& socket);
    void replayLine();
    void takeBytes(const QByteArray& bytes);
    void keep(std::string_view line);
    void enter(LiveState state, const QString& words);
    void lose(const QString& why);

    LiveSettings m_settings;
    bool m_wanted = false; ///< from open() to close()
    bool m_thins = false;  ///< a log that is replayed comes as fast as we read it
    std::unique_ptr<QIODevice> m_device;
    NmeaLines m_lines;
    QTimer m_again;  ///< tries a lost source again
    QTimer m_replay; ///< gives the next line of a log
    QTimer m_soon;   ///< tells of what has come
    QTimer m_rest;   ///< reads on after a flood

    mutable std::mutex m_mutex; ///< of all below
    LiveState m_state = LiveState::Closed;
    QString m_words;
    LiveBatch m_batch;
    std::map<std::string, int, std::less<>> m_kept; ///< of this batch, by what the lines begin with
};

} // namespace lubberline::ui
