#pragma once
/// The compass headings of a log with what was known when each was sent: what swings are made from.

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/nmea/NmeaValues.h"

namespace lubberline {

/// Who sent a heading, by which sentence.
struct NmeaSource {
    std::string talker, type;
    friend auto operator<=>(const NmeaSource&, const NmeaSource&) = default;
};

struct NmeaHeadingEvent {
    int source = 0; ///< index of NmeaLog::sources
    CompassHeading heading;
    std::optional<TrueHeading> track, trueHeading;
    std::optional<double> speed_kt;
    std::optional<Variation> variation;
    std::optional<double> seconds; ///< since the log's first midnight, UTC
    std::string date;              ///< newest RMC's; empty: none yet
};

class NmeaLog {
public:
    /// Takes one line of the log.
    void take(std::string_view line);

    [[nodiscard]] const std::vector<NmeaHeadingEvent>& headings() const { return m_headings; }
    [[nodiscard]] const std::vector<NmeaSource>& sources() const { return m_sources; }
    [[nodiscard]] std::int64_t headingsOf(int source) const { return m_counts[source]; }

    std::int64_t lines = 0, sentences = 0, badChecksums = 0, withoutChecksum = 0, otherLines = 0;
    std::optional<double> latitude_deg, longitude_deg, altitude_m; ///< of the first fix
    std::string firstDate;

private:
    void take(const NmeaCompass& compass);
    void take(const NmeaTrack& track);
    void take(const NmeaFix& fix);
    void takeTime(const std::optional<NmeaTime>& time);
    int indexOf(const NmeaSource& source);

    std::vector<NmeaHeadingEvent> m_headings;
    std::vector<NmeaSource> m_sources;
    std::vector<std::int64_t> m_counts;
    std::set<std::string> m_checking; ///< talkers that send checksums
    NmeaHeadingEvent m_now;           ///< what is known at present
    double m_midnights = 0;           ///< seconds of the days passed since the first
};

} // namespace lubberline
