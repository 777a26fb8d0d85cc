#include "core/nmea/NmeaSources.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "core/base/Number.h"

namespace lubberline {

namespace {

/// A corrected HDM beside an uncorrected HDG differs by more than their rounding.
constexpr double kSameCompass_deg = 0.6;

using Streams = std::vector<const NmeaStream*>;

Error wrongLog(const Message& message) { return {ErrorCode::InvalidInput, message}; }

std::string listed(const Streams& streams)
{
    std::string text;
    for (const auto* stream : streams)
        text += (text.empty() ? "" : ", ") + nameOf(stream->source) + " (" + std::to_string(stream->sent.size()) + ")";
    return text;
}

/// A speed log's heading is some compass's: it counts where nobody else sends one.
Streams compassesOf(const NmeaLog& log)
{
    Streams compasses, water;
    for (const auto& stream : log.streams())
        if (stream.north == NmeaNorth::Compass)
            (stream.source.type == "VHW" ? water : compasses).push_back(&stream);
    return compasses.empty() ? water : compasses;
}

const NmeaStream* longest(const Streams& streams)
{
    const auto most
        = std::max_element(streams.begin(), streams.end(), [](const auto* a, const auto* b) { return a->sent.size() < b->sent.size(); });
    return most == streams.end() ? nullptr : *most;
}

Streams ofTalker(const Streams& streams, const std::string& talker)
{
    Streams found;
    std::copy_if(streams.begin(), streams.end(), std::back_inserter(found), [&](const auto* one) { return one->source.talker == talker; });
    return found;
}

Result<std::string> chooseTalker(const Streams& compasses, const NmeaOptions& options, std::vector<Message>& warnings)
{
    const auto sends = [&](const std::string& talker) { return !ofTalker(compasses, talker).empty(); };
    const std::string& first = compasses.front()->source.talker;
    if (!options.compassTalker.empty()) {
        if (!sends(options.compassTalker))
            return wrongLog({MARKED("core", "the talker %1 sends no HDG or HDM; these do: %2"), options.compassTalker, listed(compasses)});
        return options.compassTalker;
    }
    if (ofTalker(compasses, first).size() == compasses.size())
        return first;
    if (!sends("HC"))
        return wrongLog({MARKED("core", "several talkers send headings: %1; say which is the compass"), listed(compasses)});
    if (options.reference != NmeaReference::Magnetic)
        warnings.push_back({MARKED("core", "several talkers send headings: %1; HC is taken as the compass"), listed(compasses)});
    return std::string("HC"); // the standard's mnemonic of a magnetic compass
}

/// Mean difference of two streams, each sentence of one with the newest of the other [deg]; none where they do not meet.
std::optional<double> meanApart_deg(const NmeaStream& one, const NmeaStream& other)
{
    double sum = 0.0;
    std::size_t count = 0, next = 0;
    for (const auto& sent : one.sent) {
        while (next < other.sent.size() && other.sent[next].place < sent.place)
            ++next;
        if (next > 0)
            sum += std::abs(wrap180(*sent.angle_deg - *other.sent[next - 1].angle_deg)), ++count;
    }
    return count ? std::optional(sum / static_cast<double>(count)) : std::nullopt;
}

/// One instrument that sends both HDG and HDM sends one heading twice, unless HDM is corrected by a deviation table already.
const NmeaStream* compassOf(const Streams& own, std::vector<Message>& warnings)
{
    const auto* compass = *std::min_element(
        own.begin(), own.end(), [](const auto* one, const auto* other) { return likelierCompass(one->source, other->source); });
    for (const auto* other : own)
        if (other != compass && meanApart_deg(*other, *compass).value_or(0.0) > kSameCompass_deg)
            warnings.push_back(MARKED("core", "HDM differs from HDG of the same talker, so it is corrected already; HDG alone is used"));
    return compass;
}

/// Of the tracks the stream with the most of them that have a speed; of the true headings those of an instrument before a speed log's.
const NmeaStream* referenceOf(const NmeaLog& log, NmeaNorth north)
{
    const NmeaStream* best = nullptr;
    const auto worth = [north](const NmeaStream& stream) {
        const auto known = std::count_if(stream.sent.begin(), stream.sent.end(),
            [north](const NmeaSent& sent) { return sent.angle_deg && (north == NmeaNorth::True || sent.speed_kt); });
        return std::tuple(stream.source.type != "VHW T", known, stream.source.type == "RMC");
    };
    for (const auto& stream : log.streams())
        if (stream.north == north && std::get<1>(worth(stream)) > 0 && (!best || worth(stream) > worth(*best)))
            best = &stream;
    return best;
}

const NmeaStream* otherCompass(const Streams& compasses, const NmeaStream& compass)
{
    Streams others, own;
    for (const auto* stream : compasses)
        if (stream != &compass)
            (stream->source.talker == compass.source.talker ? own : others).push_back(stream);
    return longest(others.empty() ? own : others);
}

Error noReference(const NmeaLog& log, NmeaReference wanted)
{
    static constexpr std::array kMissing{MARKED("core", "a valid track (RMC or VTG)"), MARKED("core", "a true heading (HDT or THS)"),
        MARKED("core", "a second magnetic heading (another talker's HDG or HDM)")};
    if (wanted == NmeaReference::Track && log.noFixes > 0 && log.fixes == 0)
        return wrongLog({MARKED_N("core",
                             "no fix: the receiver says so in all %n of its RMC and VTG (status V, mode N), so there is no track to "
                             "hold the compass against"),
            static_cast<std::size_t>(log.noFixes)});
    if (wanted == NmeaReference::Track && log.fixes > 0)
        return wrongLog(MARKED("core", "the RMC and VTG of the log hold no track with a speed; expected an aircraft that moves"));
    if (wanted == NmeaReference::HeadingTrue && log.noHeadings > 0)
        return wrongLog({MARKED_N("core", "no true heading: the instrument says so in all %n of its THS (mode V)"),
            static_cast<std::size_t>(log.noHeadings)});
    return wrongLog({MARKED("core", "no compass heading stands beside %1; expected a log that holds both"),
        kMissing[static_cast<std::size_t>(wanted)]});
}

} // namespace

std::string nameOf(const NmeaSource& source) { return source.talker + source.type; }

bool likelierCompass(const NmeaSource& one, const NmeaSource& other)
{
    const auto rank = [](const NmeaSource& source) {
        return std::tuple(source.type == "VHW", source.talker != "HC", source.type != "HDG", std::tie(source.talker, source.type));
    };
    return rank(one) < rank(other);
}

std::optional<Message> doubtOfReference(const NmeaSource& reference, NmeaNorth north, const NmeaSource& compass)
{
    if (reference.type == "VHW T")
        return Message(MARKED("core",
            "the true heading is a speed log's (VHW), which mostly is the compass's own with the variation added: such a "
            "reference shows no deviation"));
    if (north == NmeaNorth::True && reference.talker == "HC")
        return Message{MARKED("core", "the true heading %1 is sent by a magnetic compass: it is no reference for one"), nameOf(reference)};
    if (north != NmeaNorth::Track && reference.talker == compass.talker)
        return Message{
            MARKED("core", "%1 and the compass %2 have one talker: if the one is made of the other, it shows no deviation of that compass"),
            nameOf(reference), nameOf(compass)};
    return {};
}

Result<NmeaSources> chooseSources(const NmeaLog& log, const NmeaOptions& options)
{
    const Streams compasses = compassesOf(log);
    if (compasses.empty())
        return wrongLog(log.badHeadings ? MARKED("core", "holds no compass heading: all are negative or beyond 360")
                                        : MARKED("core", "holds no compass heading; expected HDG or HDM sentences"));
    NmeaSources sources;
    const auto talker = chooseTalker(compasses, options, sources.warnings);
    if (!talker)
        return talker.error();
    std::vector<Message> ofCompass;
    sources.compass = compassOf(ofTalker(compasses, *talker), ofCompass);
    if (options.reference == NmeaReference::Magnetic)
        sources.reference = otherCompass(compasses, *sources.compass);
    else
        sources.reference = referenceOf(log, options.reference == NmeaReference::Track ? NmeaNorth::Track : NmeaNorth::True);
    if (!sources.reference)
        return noReference(log, options.reference);
    if (sources.reference->source.talker != *talker || sources.reference->north != NmeaNorth::Compass)
        sources.warnings.insert(sources.warnings.end(), ofCompass.begin(), ofCompass.end());
    if (auto doubt = doubtOfReference(sources.reference->source, sources.reference->north, sources.compass->source))
        sources.warnings.push_back(std::move(*doubt));
    return sources;
}

std::vector<Message> toldOfLog(const NmeaLog& log)
{
    std::vector<Message> told;
    const auto tell = [&told](std::int64_t count, Pattern pattern) {
        if (count > 0)
            told.push_back({pattern, static_cast<std::size_t>(count)});
    };
    const auto ofMode = [&log](NmeaMode mode) { return log.ofMode[static_cast<std::size_t>(mode)]; };
    tell(log.badChecksums, MARKED_N("core", "%n sentence(s) with a wrong checksum left out"));
    tell(log.withoutChecksum, MARKED_N("core", "%n sentence(s) without a checksum: what was damaged on the way cannot be told"));
    tell(log.badHeadings, MARKED_N("core", "%n heading(s) left out, negative or beyond 360"));
    tell(log.fixes > 0 ? log.noFixes : 0, MARKED_N("core", "%n time(s) the receiver had no fix (status V, mode N)"));
    tell(log.noHeadings, MARKED_N("core", "%n time(s) the true heading was not valid (THS mode V)"));
    tell(ofMode(NmeaMode::Estimated),
        MARKED_N("core", "%n estimated track(s) or heading(s) (mode E, dead reckoning): perhaps from the very compass that is swung"));
    tell(ofMode(NmeaMode::Manual), MARKED_N("core", "%n track(s) or heading(s) typed in (mode M)"));
    tell(ofMode(NmeaMode::Simulated), MARKED_N("core", "%n track(s) or heading(s) from a simulator (mode S)"));
    const auto tellWritten = [&told](std::int64_t count, Pattern pattern, const std::string& first) {
        if (count > 0)
            told.push_back({pattern, static_cast<std::size_t>(count), first});
    };
    tellWritten(log.unreadTimes, MARKED_N("core", "%n time(s) left out, no time of the day: '%1'; expected hhmmss"), log.firstUnreads.time);
    tellWritten(log.unreadDates, MARKED_N("core", "%n date(s) left out, no day of the calendar: '%1'"), log.firstUnreads.date);
    tellWritten(log.unreadPlaces, MARKED_N("core", "%n position(s) left out, no place on the Earth: '%1'"), log.firstUnreads.place);
    if (log.unreadAngles > 0)
        told.push_back({MARKED_N("core",
                            "%n variation(s) or deviation(s) left out, written without a side as '%1'; expected a size "
                            "without a sign, and E or W"),
            static_cast<std::size_t>(log.unreadAngles), log.firstUnread});
    if (log.deviations > 0)
        told.push_back(
            {MARKED_N("core",
                 "%n HDG sentence(s) with a deviation of their own (up to %1°, east +), which is not applied: the heading beside it is the "
                 "sensor's before it; an instrument that has applied it already must be swung with it cleared"),
                static_cast<std::size_t>(log.deviations), signedFigureText(log.largestDeviation->degrees(), 1)});
    return told;
}

} // namespace lubberline
