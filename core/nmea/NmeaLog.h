#pragma once
/// What a log holds: the headings and tracks of each sender in their order, the times that were told, and what is to be told of it.

#include <array>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/base/Date.h"
#include "core/nmea/NmeaValues.h"

namespace lubberline {

/// Who sent something, by which sentence.
struct NmeaSource {
    std::string talker, type;
    friend auto operator<=>(const NmeaSource&, const NmeaSource&) = default;
};

enum class NmeaNorth { Compass, True, Track };

/// One heading or track. `place` counts the sentences of the log, so that what stands between what is known.
struct NmeaSent {
    std::size_t place = 0;
    std::optional<double> angle_deg; ///< none: a track without a fix
    std::optional<double> speed_kt;
    bool untimed = false; ///< a sentence that should tell its time, and does not
};

/// All that one source sent.
struct NmeaStream {
    NmeaSource source;
    NmeaNorth north = NmeaNorth::Compass;
    std::vector<NmeaSent> sent;
};

/// A time of day that was told.
struct NmeaMark {
    std::size_t place = 0;
    double secondsOfDay = 0;
    Date date; ///< newest that was told; empty: none yet
};
struct NmeaMarks {
    NmeaSource source;
    std::vector<NmeaMark> marks;
};

/// The variations that one source told [deg, east positive].
struct NmeaVariations {
    NmeaSource source;
    std::vector<double> told_deg;
};

class NmeaLog {
public:
    /// Takes one line of the log.
    void take(std::string_view line);
    /// Takes a sentence that was read already.
    void take(const NmeaSentence& sentence);

    [[nodiscard]] const std::vector<NmeaStream>& streams() const { return m_streams; }
    [[nodiscard]] const std::vector<NmeaMarks>& clocks() const { return m_clocks; }
    [[nodiscard]] const std::vector<NmeaVariations>& variations() const { return m_variations; }

    std::int64_t lines = 0, sentences = 0, badChecksums = 0, withoutChecksum = 0, otherLines = 0;
    std::int64_t badHeadings = 0;                   ///< negative, or beyond 360
    std::int64_t noHeadings = 0;                    ///< THS of mode V
    std::int64_t fixes = 0, noFixes = 0;            ///< RMC and VTG with and without one
    std::array<std::int64_t, 4> ofMode{};           ///< tracks and true headings by NmeaMode
    std::int64_t deviations = 0;                    ///< HDG that state a deviation other than zero
    std::optional<Deviation> largestDeviation = {}; ///< of those
    std::int64_t unreadAngles = 0;                  ///< variations and deviations that are no size with its side
    std::string firstUnread = {};                   ///< of those, as it is written: "-15.2,W"
    /// Times, dates and places that are none (hour 24, 31 November, latitude 95°), and the first of each as it is written.
    std::int64_t unreadTimes = 0, unreadDates = 0, unreadPlaces = 0;
    NmeaUnread firstUnreads = {};
    std::int64_t headings = 0;                                     ///< of all compasses
    std::optional<double> latitude_deg, longitude_deg, altitude_m; ///< of the first fix
    Date firstDate;

private:
    void take(const NmeaCompass& compass);
    void take(const NmeaWater& water);
    void take(const NmeaTrack& track);
    void takeUnread(const NmeaSentence& sentence);
    void take(const NmeaFix& fix);
    void takePlace(std::optional<double> latitude, std::optional<double> longitude);
    void takeTime(const NmeaSource& source, const std::optional<NmeaTime>& time);
    void takeVariation(const NmeaSource& source, const std::optional<Variation>& variation, const std::string& unread);
    void send(const NmeaSource& source, NmeaNorth north, std::optional<double> angle_deg, std::optional<double> speed_kt = {},
        bool untimed = false);

    std::vector<NmeaStream> m_streams;
    std::vector<NmeaMarks> m_clocks;
    std::vector<NmeaVariations> m_variations;
    std::set<std::string> m_checking; ///< talkers that send checksums
    std::size_t m_place = 0;
    Date m_date;
};

} // namespace lubberline
