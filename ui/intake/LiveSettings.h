#pragma once
/// Where live sentences come from.

#include <QString>

#include <variant>

namespace lubberline::ui {

struct SerialSettings {
    QString port;    ///< "/dev/ttyUSB0" or the name of the system's list
    int baud = 4800; ///< NMEA 0183's own; high-speed talkers 38400
};
struct UdpSettings {
    int port = 10110;         ///< the port registered for NMEA 0183 over IP
    bool fromNetwork = false; ///< from other machines, too: whoever is in the network can then send headings
};
struct ReplaySettings {
    QString path;
    int linesPerSecond = 10;
};
using LiveSettings = std::variant<SerialSettings, UdpSettings, ReplaySettings>;

enum class LiveState { Closed, Open, Waiting }; ///< Waiting: not there at the moment, tried again every two seconds

} // namespace lubberline::ui
