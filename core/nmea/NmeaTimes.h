#pragma once
/// The times of what a log holds. Few sentences tell one (RMC, GGA, ZDA); what stands between them gets its time by its place.

#include <optional>
#include <string>
#include <vector>

#include "core/base/Date.h"
#include "core/nmea/HeadingLine.h"
#include "core/nmea/NmeaLog.h"

namespace lubberline {

class NmeaTimes {
public:
    /// The clock is that of `reference` where it tells times, else that which tells most of them. A log without any counts
    /// steps of its reference instead of seconds.
    NmeaTimes(const NmeaLog& log, const NmeaStream& reference);

    /// False: `seconds` are steps of the reference, or what they were stretched to.
    [[nodiscard]] bool told() const { return m_told; }
    /// Makes a step of a log without times so many seconds long.
    void stretch(double secondsOfStep);
    /// [s, on a scale of its own that never runs back] of each sentence of a stream; none where the clock was set back.
    /// One that tells its own time has that. Of the rest, those between two times are taken as evenly spread. Where nearly all such
    /// intervals hold the same number the log is a row of cycles, and the sentences of a cycle are of one moment; a cycle begins
    /// with what the log begins with: the sentences before a time belong to it, or those behind.
    [[nodiscard]] std::vector<std::optional<double>> of(const NmeaStream& stream) const;
    /// How far apart sentences of the stream stand [s]: what the places do not tell is half of that, either way.
    [[nodiscard]] double spacing_s(const NmeaStream& stream) const;
    /// ISO 8601 in UTC; empty where the log does not tell.
    [[nodiscard]] std::string utc(double seconds) const;

private:
    struct Mark {
        std::size_t place = 0;
        double seconds = 0;
        double secondsOfDay = 0;
        Date date;
        bool follows = true; ///< false: the clock was set back before it
    };
    struct Spread {
        double perInterval = 1;
        double offset = 0.5; ///< of the first sentence behind a mark, in spacings
    };
    void takeClock(const NmeaMarks& clock);
    void takeSteps(const NmeaStream& reference);
    [[nodiscard]] Spread spreadOf(const NmeaStream& stream, const std::vector<std::vector<std::size_t>>& intervals) const;
    [[nodiscard]] std::vector<std::vector<std::size_t>> intervalsOf(const NmeaStream& stream) const;
    [[nodiscard]] const Mark* markAt(std::size_t place) const;

    NmeaSource m_clock;
    std::vector<Mark> m_marks;
    double m_typical_s = 1.0;
    bool m_told = false;
};

/// What a stream told, where its time is known, in order of time.
[[nodiscard]] std::vector<TimedHeading> inTime(const NmeaStream& stream, const NmeaTimes& times);

} // namespace lubberline
