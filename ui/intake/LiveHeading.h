#pragma once
/// What a live source says at the moment: the headings of each talker, averaged over a settling window.

#include <QObject>
#include <QStringList>

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "core/nmea/NmeaLog.h"
#include "core/nmea/NmeaVariation.h"
#include "core/nmea/SettlingWindow.h"

namespace lubberline::ui {

/// A heading that is sent: whose, by which sentence. "HCHDG", "GPHDT", "GPRMC" (track).
using LiveChannel = std::string;

/// What is known of one that was heard.
struct LiveSource {
    NmeaSource source;
    NmeaNorth north = NmeaNorth::Compass;
    std::optional<double> speed_kt; ///< of a track, over ground; none: it was not told
};

class LiveHeading : public QObject {
    Q_OBJECT

public:
    /// @param now_s seconds of a clock that does not jump and counts while the machine sleeps; empty: the machine's own. Tests
    /// give theirs.
    explicit LiveHeading(std::function<double()> now_s = {}, QObject* parent = nullptr);

    void setWindow(double length_s, double mostSpread_deg);
    void takeLine(std::string_view line);
    void clear();

    /// Those that were heard and may be the compass, the likeliest first (likelierCompass).
    [[nodiscard]] QStringList compassChannels() const;
    /// All others: true headings, tracks, other compasses. A heading is never its own reference.
    [[nodiscard]] QStringList referenceChannels(const QString& compass) const;
    /// Whether it may be the reference without being asked for: a true heading of another talker than the compass, or a track. What a
    /// compass sends, or its talker, may be made of that compass and would show no deviation.
    [[nodiscard]] bool standsAlone(const QString& reference, const QString& compass) const;
    /// None, too, of a track slower than it tells a heading, and where its speed is not told.
    [[nodiscard]] std::optional<SettledHeading> heading(const QString& channel) const;
    [[nodiscard]] std::optional<LiveSource> source(const QString& channel) const;
    [[nodiscard]] bool isTrue(const QString& channel) const; ///< from true north
    /// The stated variation, else what was told last, held against the model where a place and a date were told, too; else the model's.
    /// None where neither is there.
    [[nodiscard]] std::optional<ChosenVariation> variation(std::optional<double> stated_deg = {}) const;

    [[nodiscard]] int badChecksums() const { return m_bad; }
    [[nodiscard]] int badHeadings() const { return m_badHeadings; } ///< negative, or beyond 360
    [[nodiscard]] int sentences() const { return m_sentences; }

signals:
    void changed();

private:
    struct Channel {
        LiveSource source;
        SettlingWindow window;
    };
    void takeSentence(const NmeaSentence& sentence);
    void add(const LiveSource& source, double heading_deg);
    [[nodiscard]] const Channel* find(const QString& channel) const;

    std::function<double()> m_now_s;
    std::map<LiveChannel, Channel> m_channels;
    std::set<std::string> m_checking;             ///< talkers that send checksums: a sentence of theirs without one is half a sentence
    std::map<std::string, NmeaSentence> m_newest; ///< of each sender and sentence that tells a variation, a place or a date
    double m_length_s = 5.0, m_mostSpread_deg = 1.0;
    int m_bad = 0, m_badHeadings = 0, m_sentences = 0;
};

} // namespace lubberline::ui
