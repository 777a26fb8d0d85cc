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

#include "core/nmea/NmeaValues.h"
#include "core/nmea/NmeaVariation.h"
#include "core/nmea/SettlingWindow.h"

namespace lubberline::ui {

/// A heading that is sent: whose, by which sentence. "HCHDG", "GPHDT", "GPRMC" (track).
using LiveChannel = std::string;

class LiveHeading : public QObject {
    Q_OBJECT

public:
    /// @param now_s seconds of a clock that does not jump and counts while the machine sleeps; empty: the machine's own. Tests
    /// give theirs.
    explicit LiveHeading(std::function<double()> now_s = {}, QObject* parent = nullptr);

    void setWindow(double length_s, double mostSpread_deg);
    void takeLine(std::string_view line);
    void clear();

    /// Those that were heard, in order of their names; two talkers are two channels, and nobody chooses between them but the
    /// user.
    [[nodiscard]] QStringList compassChannels() const;   ///< HDG, HDM
    [[nodiscard]] QStringList referenceChannels() const; ///< HDT, tracks, and all of the above
    [[nodiscard]] std::optional<SettledHeading> heading(const QString& channel) const;
    [[nodiscard]] bool isTrue(const QString& channel) const; ///< from true north
    /// Of what was sent last: the variation that was told, held against the model where a place and a date were told, too; else the model's.
    /// None where neither is there.
    [[nodiscard]] std::optional<ChosenVariation> variation() const;

    [[nodiscard]] int badChecksums() const { return m_bad; }
    [[nodiscard]] int badHeadings() const { return m_badHeadings; } ///< negative, or beyond 360
    [[nodiscard]] int sentences() const { return m_sentences; }

signals:
    void changed();

private:
    struct Channel {
        bool compass = false, isTrue = false;
        SettlingWindow window;
    };
    void takeSentence(const NmeaSentence& sentence);
    void add(const LiveChannel& name, bool compass, bool isTrue, double heading_deg);

    std::function<double()> m_now_s;
    std::map<LiveChannel, Channel> m_channels;
    std::set<std::string> m_checking;             ///< talkers that send checksums: a sentence of theirs without one is half a sentence
    std::map<std::string, NmeaSentence> m_newest; ///< of each sender and sentence that tells a variation, a place or a date
    double m_length_s = 5.0, m_mostSpread_deg = 1.0;
    int m_bad = 0, m_badHeadings = 0, m_sentences = 0;
};

} // namespace lubberline::ui
