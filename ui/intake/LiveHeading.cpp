#include "ui/intake/LiveHeading.h"

#include <algorithm>
#include <ctime>

#include "core/nmea/NmeaSources.h"
#include "core/nmea/NmeaSwing.h"

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

/// A receiver that stands still sends a track, too: the last one, or noise.
bool tellsHeading(const LiveSource& source)
{
    return source.north != NmeaNorth::Track || (source.speed_kt && *source.speed_kt >= NmeaOptions().minSpeed_kt);
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

void LiveHeading::add(const LiveSource& source, double heading_deg)
{
    const LiveChannel name = nameOf(source.source);
    if (m_channels.size() >= kMostChannels && !m_channels.contains(name)) {
        ++m_bad; // nobody has so many instruments
        return;
    }
    Channel& channel = m_channels.try_emplace(name, Channel{source, SettlingWindow(m_length_s, m_mostSpread_deg)}).first->second;
    channel.source = source;
    if (tellsHeading(source))
        channel.window.add(m_now_s(), heading_deg);
    else
        channel.window.clear(); // where it went before it stood still is not where it points now
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
        add({{compass->talker, compass->type}, NmeaNorth::Compass, {}}, compass->heading.degrees());
    } else if (const auto* heading = std::get_if<NmeaTrueHeading>(&value)) {
        add({{heading->talker, heading->type}, NmeaNorth::True, {}}, heading->heading.degrees());
    } else if (const auto* track = std::get_if<NmeaTrack>(&value)) {
        if (track->track)
            add({{track->talker, track->type}, NmeaNorth::Track, track->speed_kt}, track->track->degrees());
    } else if (const auto* water = std::get_if<NmeaWater>(&value)) {
        if (water->compass)
            add({{water->talker, "VHW"}, NmeaNorth::Compass, {}}, water->compass->degrees());
    } else if (std::holds_alternative<NmeaBadHeading>(value)) {
        ++m_badHeadings;
    }
    for (const char* type : {"HDG", "RMC", "GGA", "ZDA"})
        if (sentence.type == type && (m_newest.size() < kMostChannels || m_newest.contains(sentence.talker + type)))
            m_newest.insert_or_assign(sentence.talker + type, sentence);
}

std::optional<ChosenVariation> LiveHeading::variation(std::optional<double> stated_deg) const
{
    NmeaLog log;
    for (const auto& [name, sentence] : m_newest)
        log.take(sentence);
    const NmeaVariation wanted = stated_deg ? NmeaVariation(Variation::fromDegrees(*stated_deg)) : VariationFound{};
    auto chosen = chooseVariation(log, wanted, dateOfLog(log, {}, {}), 0.0);
    return chosen ? std::optional(std::move(chosen.value())) : std::nullopt;
}

QStringList LiveHeading::compassChannels() const
{
    std::vector<NmeaSource> sources;
    for (const auto& [name, channel] : m_channels)
        if (channel.source.north == NmeaNorth::Compass)
            sources.push_back(channel.source.source);
    std::sort(sources.begin(), sources.end(), likelierCompass);
    QStringList names;
    for (const auto& source : sources)
        names << QString::fromStdString(nameOf(source));
    return names;
}

QStringList LiveHeading::referenceChannels(const QString& compass) const
{
    QStringList names;
    for (const NmeaNorth north : {NmeaNorth::True, NmeaNorth::Track, NmeaNorth::Compass})
        for (const auto& [name, channel] : m_channels)
            if (channel.source.north == north && QString::fromStdString(name) != compass)
                names << QString::fromStdString(name);
    return names;
}

bool LiveHeading::standsAlone(const QString& reference, const QString& compass) const
{
    const Channel *one = find(reference), *other = find(compass);
    return one && !doubtOfReference(one->source.source, one->source.north, other ? other->source.source : NmeaSource())
        && one->source.north != NmeaNorth::Compass;
}

const LiveHeading::Channel* LiveHeading::find(const QString& channel) const
{
    const auto found = m_channels.find(channel.toStdString());
    return found == m_channels.end() ? nullptr : &found->second;
}

std::optional<SettledHeading> LiveHeading::heading(const QString& channel) const
{
    const Channel* found = find(channel);
    return found ? found->window.at(m_now_s()) : std::nullopt;
}

std::optional<LiveSource> LiveHeading::source(const QString& channel) const
{
    const Channel* found = find(channel);
    return found ? std::optional(found->source) : std::nullopt;
}

bool LiveHeading::isTrue(const QString& channel) const
{
    const Channel* found = find(channel);
    return found && found->source.north != NmeaNorth::Compass;
}

} // namespace lubberline::ui
