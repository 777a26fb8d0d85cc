#include "ui/intake/LiveHeading.h"

#include <ctime>

#include "core/nmea/NmeaLog.h"

namespace lubberline::ui {

namespace {

constexpr std::size_t kMostChannels = 64;

/// Counts while the machine sleeps, too: what was heard before is old then.
double sinceBoot_s()
{
    std::timespec now = {};
    clock_gettime(CLOCK_BOOTTIME, &now);
    return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

/// Without a checksum only a sentence with all its fields is whole: a line cut short looks like a heading of fewer digits.
bool isWhole(const NmeaSentence& sentence)
{
    const std::size_t fields = sentence.type == "HDG"                                ? 5
        : sentence.type == "HDT" || sentence.type == "HDM" || sentence.type == "THS" ? 2
                                                                                     : 1;
    return sentence.hasChecksum || sentence.fields.size() >= fields;
}

} // namespace

LiveHeading::LiveHeading(std::function<double()> now_s, QObject* parent) : QObject(parent), m_now_s(std::move(now_s))
{
    if (!m_now_s)
        m_now_s = sinceBoot_s;
}

void LiveHeading::setWindow(double length_s, double mostSpread_deg)
{
    m_length_s = length_s;
    m_mostSpread_deg = mostSpread_deg;
    for (auto& [name, channel] : m_channels)
        channel.window = SettlingWindow(length_s, mostSpread_deg);
}

void LiveHeading::clear()
{
    m_channels.clear();
    m_checking.clear();
    m_newest.clear();
    m_bad = m_badHeadings = m_sentences = 0;
    emit changed();
}

void LiveHeading::add(const LiveChannel& name, bool compass, bool isTrue, double heading_deg)
{
    if (m_channels.size() >= kMostChannels && !m_channels.contains(name)) {
        ++m_bad; // nobody has so many instruments
        return;
    }
    const auto [found, isNew] = m_channels.try_emplace(name, Channel{compass, isTrue, SettlingWindow(m_length_s, m_mostSpread_deg)});
    found->second.window.add(m_now_s(), heading_deg);
}

void LiveHeading::takeLine(std::string_view line)
{
    for (const ParsedNmea& parsed : nmeaSentences(line))
        if (parsed.fault == NmeaFault::BadChecksum)
            ++m_bad;
        else if (parsed.fault == NmeaFault::None)
            takeSentence(parsed.sentence);
    emit changed();
}

void LiveHeading::takeSentence(const NmeaSentence& sentence)
{
    if (sentence.hasChecksum && m_checking.size() < kMostChannels)
        m_checking.insert(sentence.talker);
    if ((!sentence.hasChecksum && m_checking.contains(sentence.talker)) || !isWhole(sentence)) {
        ++m_bad;
        return;
    }
    ++m_sentences;
    const NmeaValue value = valueOf(sentence);
    if (const auto* compass = std::get_if<NmeaCompass>(&value)) {
        add(compass->talker + compass->type, true, false, compass->heading.degrees());
    } else if (const auto* heading = std::get_if<NmeaTrueHeading>(&value)) {
        add(heading->talker + heading->type, false, true, heading->heading.degrees());
    } else if (const auto* track = std::get_if<NmeaTrack>(&value)) {
        if (track->track)
            add(track->talker + track->type, false, true, track->track->degrees());
    } else if (const auto* water = std::get_if<NmeaWater>(&value)) {
        if (water->compass)
            add(water->talker + "VHW", true, false, water->compass->degrees());
    } else if (std::holds_alternative<NmeaBadHeading>(value)) {
        ++m_badHeadings;
    }
    for (const char* type : {"HDG", "RMC", "GGA", "ZDA"})
        if (sentence.type == type && (m_newest.size() < kMostChannels || m_newest.contains(sentence.talker + type)))
            m_newest.insert_or_assign(sentence.talker + type, sentence);
}

std::optional<ChosenVariation> LiveHeading::variation() const
{
    NmeaLog log;
    for (const auto& [name, sentence] : m_newest)
        log.take(sentence);
    auto chosen = chooseVariation(log, VariationFound{}, dateOfLog(log, {}, {}), 0.0);
    return chosen ? std::optional(std::move(chosen.value())) : std::nullopt;
}

QStringList LiveHeading::compassChannels() const
{
    QStringList names;
    for (const auto& [name, channel] : m_channels)
        if (channel.compass)
            names << QString::fromStdString(name);
    return names;
}

QStringList LiveHeading::referenceChannels() const
{
    QStringList names;
    for (const auto& [name, channel] : m_channels)
        names << QString::fromStdString(name);
    return names;
}

std::optional<SettledHeading> LiveHeading::heading(const QString& channel) const
{
    const auto found = m_channels.find(channel.toStdString());
    return found == m_channels.end() ? std::nullopt : found->second.window.at(m_now_s());
}

bool LiveHeading::isTrue(const QString& channel) const
{
    const auto found = m_channels.find(channel.toStdString());
    return found != m_channels.end() && found->second.isTrue;
}

} // namespace lubberline::ui
