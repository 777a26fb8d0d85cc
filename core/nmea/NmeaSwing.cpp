#include "core/nmea/NmeaSwing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "core/base/FileText.h"
#include "core/earth/FieldModel.h"
#include "core/nmea/NmeaLines.h"
#include "core/nmea/NmeaLog.h"
#include "core/nmea/NmeaTurn.h"

namespace lubberline {

namespace {

/// A corrected HDM beside an uncorrected HDG differs by more than their rounding.
constexpr double kSameCompass_deg = 0.6;

std::string listed(const NmeaLog& log)
{
    std::string text;
    for (std::size_t i = 0; i < log.sources().size(); ++i)
        text += (i ? ", " : "") + log.sources()[i].talker + log.sources()[i].type + " ("
            + std::to_string(log.headingsOf(static_cast<int>(i))) + ")";
    return text;
}

/// Makes a swing of a log that has been read.
class SwingOfLog {
public:
    SwingOfLog(const NmeaLog& log, const NmeaOptions& options, const std::string& name) : m_log(log), m_options(options), m_name(name) {}
    Result<NmeaSwing> make();

private:
    Error wrong(const Message& message) const { return {ErrorCode::InvalidInput, message, m_name}; }
    Result<void> chooseTalker();
    Result<void> chooseVariation();
    Result<Variation> variationOfModel();
    bool usesCompass(const NmeaSource& source) const;
    void dropCorrectedHeadings();
    void pickCompass();
    std::optional<MagneticHeading> referenceOf(const NmeaHeadingEvent& event) const;
    void makePairs();
    Result<void> checkPairs() const;
    bool withinLimits(const NmeaPair& pair) const;

    const NmeaLog& m_log;
    const NmeaOptions& m_options;
    const std::string& m_name;
    NmeaSwing m_swing;
    std::string m_onlyType; ///< of the compass talker's sentences; empty: both
    bool m_variationOfLog = false;
    std::vector<NmeaHeadingEvent> m_compass;            ///< the headings of the compass
    std::vector<std::optional<CompassHeading>> m_other; ///< the newest of the other instrument at each, with Magnetic
};

Result<void> SwingOfLog::chooseTalker()
{
    std::vector<std::string> talkers;
    for (const auto& source : m_log.sources())
        if (std::find(talkers.begin(), talkers.end(), source.talker) == talkers.end())
            talkers.push_back(source.talker);
    const auto sends = [&](const std::string& talker) { return std::find(talkers.begin(), talkers.end(), talker) != talkers.end(); };
    if (!m_options.compassTalker.empty()) {
        if (!sends(m_options.compassTalker))
            return wrong({MARKED("core", "the talker %1 sends no HDG or HDM; these do: %2"), m_options.compassTalker, listed(m_log)});
        m_swing.compassTalker = m_options.compassTalker;
    } else if (talkers.size() == 1) {
        m_swing.compassTalker = talkers.front();
    } else if (sends("HC")) { // the standard's mnemonic of a magnetic compass
        m_swing.compassTalker = "HC";
        if (m_options.reference != NmeaReference::Magnetic)
            m_swing.warnings.push_back({MARKED("core", "several talkers send headings: %1; HC is taken as the compass"), listed(m_log)});
    } else {
        return wrong({MARKED("core", "several talkers send headings: %1; say which is the compass"), listed(m_log)});
    }
    return {};
}

bool SwingOfLog::usesCompass(const NmeaSource& source) const
{
    return source.talker == m_swing.compassTalker && (m_onlyType.empty() || source.type == m_onlyType);
}

/// One instrument that sends both HDG and HDM sends one heading twice, unless HDM is corrected by a deviation table already.
void SwingOfLog::dropCorrectedHeadings()
{
    double sum = 0.0;
    int count = 0;
    std::optional<CompassHeading> sensor;
    for (const auto& event : m_log.headings()) {
        const NmeaSource& source = m_log.sources()[event.source];
        if (source.talker != m_swing.compassTalker)
            continue;
        if (source.type == "HDG")
            sensor = event.heading;
        else if (sensor)
            sum += std::abs(wrap180(event.heading.degrees() - sensor->degrees())), ++count;
    }
    if (m_options.reference == NmeaReference::Magnetic && count > 0 && m_log.sources().size() == 2) {
        m_onlyType = "HDG"; // HDM of the same instrument is the reference
        return;
    }
    if (count == 0 || sum / count <= kSameCompass_deg)
        return;
    m_onlyType = "HDG";
    m_swing.warnings.push_back(MARKED("core", "HDM differs from HDG of the same talker, so it is corrected already; HDG alone is used"));
}

void SwingOfLog::pickCompass()
{
    std::optional<CompassHeading> other;
    for (const auto& event : m_log.headings()) {
        if (!usesCompass(m_log.sources()[event.source])) {
            other = event.heading;
            continue;
        }
        m_compass.push_back(event);
        m_other.push_back(other);
    }
}

Result<Variation> SwingOfLog::variationOfModel()
{
    if (!m_log.latitude_deg || m_log.firstDate.empty())
        return wrong(MARKED(
            "core", "the log tells no position with a date (RMC), so no model can give the variation; expected it stated in degrees"));
    const auto place = makePlace(*m_log.latitude_deg, *m_log.longitude_deg, m_log.altitude_m.value_or(0.0));
    if (!place)
        return place.error();
    const auto year = decimalYear(m_log.firstDate);
    if (!year)
        return year.error();
    const auto model = defaultFieldModel(*year);
    if (!model)
        return model.error();
    const auto answer = fieldForCompass(*model, *place, *year);
    if (!answer)
        return answer.error();
    std::array<char, 96> where{};
    std::snprintf(where.data(), where.size(), " at %.2f° %c, %.2f° %c on ", std::abs(place->latitude_deg),
        place->latitude_deg < 0 ? 'S' : 'N', std::abs(place->longitude_deg), place->longitude_deg < 0 ? 'W' : 'E');
    m_swing.variationSource = answer->model + where.data() + m_log.firstDate;
    return answer->field.variation();
}

Result<void> SwingOfLog::chooseVariation()
{
    if (m_options.reference == NmeaReference::Magnetic)
        return {};
    if (const auto* stated = std::get_if<Variation>(&m_options.variation)) {
        m_swing.variation = *stated;
        m_swing.variationSource = "stated";
        return {};
    }
    const bool inLog = std::any_of(m_compass.begin(), m_compass.end(), [](const auto& event) { return event.variation.has_value(); });
    const bool ofModel = std::holds_alternative<VariationOfModel>(m_options.variation);
    if (inLog && !ofModel) {
        m_variationOfLog = true;
        m_swing.variationSource = "log";
        return {};
    }
    if (std::holds_alternative<VariationOfLog>(m_options.variation))
        return wrong(
            MARKED("core", "neither RMC nor HDG of the log tells the variation; expected it stated in degrees, or taken from a model"));
    const auto variation = variationOfModel();
    if (!variation)
        return variation.error();
    m_swing.variation = *variation;
    return {};
}

std::optional<MagneticHeading> SwingOfLog::referenceOf(const NmeaHeadingEvent& event) const
{
    const auto heading = m_options.reference == NmeaReference::Track ? event.track : event.trueHeading;
    const auto variation = m_variationOfLog ? event.variation : m_swing.variation;
    if (!heading || !variation)
        return {};
    return toMagnetic(*heading, *variation);
}

bool SwingOfLog::withinLimits(const NmeaPair& pair) const
{
    // A track without a speed is no track: nothing says that the aircraft moved.
    if (m_options.reference == NmeaReference::Track && pair.speed_kt.value_or(0.0) < m_options.minSpeed_kt)
        return false;
    return !pair.turnRate_deg_s || std::abs(*pair.turnRate_deg_s) <= m_options.maxTurnRate_deg_s;
}

std::string utcOf(const NmeaHeadingEvent& event)
{
    if (event.date.empty() || !event.seconds)
        return {};
    const auto thousandths = static_cast<int>(std::fmod(*event.seconds, 86400.0) * 1000.0 + 0.5) % 86'400'000;
    const int whole = thousandths / 1000;
    std::array<char, 48> time{};
    std::snprintf(time.data(), time.size(), "T%02d:%02d:%02d.%03dZ", whole / 3600, whole / 60 % 60, whole % 60, thousandths % 1000);
    return event.date + time.data();
}

void SwingOfLog::makePairs()
{
    const auto rates = turnRates(m_compass);
    bool untimed = false;
    for (std::size_t i = 0; i < m_compass.size(); ++i) {
        const auto& event = m_compass[i];
        std::optional<MagneticHeading> reference;
        if (m_options.reference != NmeaReference::Magnetic)
            reference = referenceOf(event);
        else if (m_other[i])
            reference = MagneticHeading::fromDegrees(m_other[i]->degrees()); // the other instrument is the datum here
        if (!reference)
            continue;
        NmeaPair pair{event.heading, *reference, event.speed_kt, rates[i], utcOf(event), false};
        pair.used = withinLimits(pair);
        untimed = untimed || !pair.turnRate_deg_s;
        m_swing.used += pair.used ? 1 : 0;
        if (m_variationOfLog)
            m_swing.variation = event.variation;
        m_swing.pairs.push_back(std::move(pair));
    }
    if (untimed)
        m_swing.warnings.push_back(MARKED("core", "some headings have no time near them: their turn rate is not known and not limited"));
}

Result<void> SwingOfLog::checkPairs() const
{
    static constexpr std::array kMissing{MARKED("core", "a valid track (RMC or VTG)"), MARKED("core", "a true heading (HDT)"),
        MARKED("core", "a second magnetic heading (another talker's HDG or HDM)")};
    if (m_swing.pairs.empty())
        return wrong({MARKED("core", "no compass heading stands behind %1; expected a log that holds both"),
            kMissing[static_cast<std::size_t>(m_options.reference)]});
    return {};
}

Result<NmeaSwing> SwingOfLog::make()
{
    m_swing.lines = m_log.lines;
    m_swing.sentences = m_log.sentences;
    m_swing.badChecksums = m_log.badChecksums;
    m_swing.withoutChecksum = m_log.withoutChecksum;
    m_swing.otherLines = m_log.otherLines;
    m_swing.date = m_log.firstDate;
    if (m_log.sentences == 0)
        return wrong(m_log.badChecksums ? MARKED("core", "holds no NMEA 0183 sentence ($ talker, type, fields): every checksum is wrong")
                                        : MARKED("core", "holds no NMEA 0183 sentence ($ talker, type, fields)"));
    if (m_log.headings().empty())
        return wrong(MARKED("core", "holds no compass heading; expected HDG or HDM sentences"));
    if (const auto chosen = chooseTalker(); !chosen)
        return chosen.error();
    dropCorrectedHeadings();
    pickCompass();
    if (const auto chosen = chooseVariation(); !chosen)
        return chosen.error();
    makePairs();
    if (const auto checked = checkPairs(); !checked)
        return checked.error();
    if (m_swing.badChecksums > 0)
        m_swing.warnings.push_back(
            {MARKED_N("core", "%n sentence(s) with a wrong checksum left out"), static_cast<std::size_t>(m_swing.badChecksums)});
    if (m_swing.withoutChecksum > 0)
        m_swing.warnings.push_back({MARKED_N("core", "%n sentence(s) without a checksum: what was damaged on the way cannot be told"),
            static_cast<std::size_t>(m_swing.withoutChecksum)});
    return std::move(m_swing);
}

} // namespace

Result<NmeaSwing> readNmeaSwing(std::istream& input, const std::string& name, const NmeaOptions& options, const Progress& progress)
{
    NmeaLog log;
    NmeaLines lines;
    const auto take = [&log](std::string_view line) { log.take(line); };
    std::vector<char> buffer(std::size_t{1} << 16);
    while (input) {
        if (progress && !progress(0.0))
            return Error{ErrorCode::Cancelled, MARKED("core", "reading was cancelled"), name};
        input.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
        lines.feed({buffer.data(), static_cast<std::size_t>(input.gcount())}, take);
        if (log.headings().size() > kMaxReadings)
            return Error{ErrorCode::InvalidInput,
                {MARKED("core", "there are more than %1 headings; expected the log of one swing"), kMaxReadings}, name};
    }
    if (input.bad())
        return Error{ErrorCode::Io, MARKED("core", "cannot be read to its end"), name};
    lines.finish(take);
    return SwingOfLog(log, options, name).make();
}

Result<NmeaSwing> readNmeaSwingFile(const std::string& path, const NmeaOptions& options, const Progress& progress)
{
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored))
        return Error{ErrorCode::Io, MARKED("core", "is a folder; expected an NMEA log"), path};
    std::ifstream file(path, std::ios::binary);
    if (!file)
        return Error{ErrorCode::Io, MARKED("core", "cannot be opened; expected an NMEA log that exists and may be read"), path};
    return readNmeaSwing(file, path, options, progress);
}

Swing toSwing(const NmeaSwing& nmea)
{
    Swing swing;
    swing.date = nmea.date;
    swing.kind = SwingKind::Calibration;
    swing.datum.instrument = "NMEA 0183 log";
    if (nmea.variation)
        swing.variation_deg = nmea.variation->degrees();
    for (const auto& pair : nmea.pairs) {
        if (!pair.used)
            continue;
        Reading reading;
        reading.magnetic = pair.magnetic;
        reading.compass = pair.compass;
        reading.note = pair.timeUtc;
        swing.readings.push_back(std::move(reading));
    }
    return swing;
}

} // namespace lubberline
