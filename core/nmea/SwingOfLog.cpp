#include "core/nmea/SwingOfLog.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/angle/PrintedHeading.h"
#include "core/base/Number.h"
#include "core/nmea/HeadingLine.h"
#include "core/nmea/NmeaAgreement.h"
#include "core/nmea/NmeaSources.h"
#include "core/nmea/NmeaStands.h"
#include "core/nmea/NmeaTimes.h"
#include "core/nmea/NmeaTurns.h"

namespace lubberline {

namespace {

/// Wind that turns a track by less is not worth a word.
constexpr double kLeastDrift_deg = 0.3;
/// Wind that is not known within this leaves the track as it is.
constexpr double kMostDriftError_deg = 3.0;
/// Standard deviation of each component of a wind of which nothing is known.
constexpr double kUsualWind_kt = 10.0;

/// Makes a swing of a log that has been read.
class SwingOfLog {
public:
    SwingOfLog(const NmeaLog& log, const NmeaOptions& options) : m_log(log), m_options(options) {}
    Result<NmeaSwing> make();

private:
    void takeCounts();
    void tell(Message message) { m_swing.warnings.push_back(std::move(message)); }
    void tellLimit(const Message& message)
    {
        tell(message);
        m_swing.limits.push_back(message);
    }
    void tellLimits(const std::vector<Message>& messages)
    {
        for (const auto& message : messages)
            tellLimit(message);
    }
    Result<void> findVariation();
    void placeInTime();
    void tellJumps(const NmeaJumps& jumps);
    void findWind();
    void leaveWindOpen(double speed_kt);
    void bringToTrue();
    void makePairs(double delay_s);
    [[nodiscard]] bool withinLimits(const NmeaPair& pair) const;
    void tellUnused();
    void findDelay();
    void tellDelay();
    void compareDirections();
    void addDoubts();
    void doubtReference();
    void addWindDoubts(const std::vector<TimedHeading>& used);
    [[nodiscard]] std::vector<TimedHeading> usedHeadings() const;

    const NmeaLog& m_log;
    const NmeaOptions& m_options;
    NmeaSwing m_swing;
    NmeaSources m_sources;
    std::optional<NmeaTimes> m_times;
    int m_repeated = 0; ///< readings of a standing aircraft that are left out
    double m_variationError_deg = 0;
    std::optional<NmeaWind> m_windOpen;  ///< what of it is left in the readings
    std::vector<TimedHeading> m_compass; ///< in order of time
    std::vector<std::optional<double>> m_rates;
    HeadingLine m_sent{{}};      ///< the reference as it was sent
    HeadingLine m_speeds{{}};    ///< a track, for its speeds
    HeadingLine m_reference{{}}; ///< magnetic
};

/// How long a step of a log without times is, if the turn was made at a degree a second as turns for a log are.
double stepOf_s(const HeadingLine& steps)
{
    return std::clamp(turnOfStep_deg(steps), 0.01, kMostApart_s); // as many seconds as degrees
}

void SwingOfLog::takeCounts()
{
    m_swing.lines = m_log.lines;
    m_swing.sentences = m_log.sentences;
    m_swing.badChecksums = m_log.badChecksums;
    m_swing.withoutChecksum = m_log.withoutChecksum;
    m_swing.otherLines = m_log.otherLines;
    m_swing.badHeadings = m_log.badHeadings;
    m_swing.latitude_deg = m_log.latitude_deg;
    m_swing.longitude_deg = m_log.longitude_deg;
    m_swing.compassTalker = m_sources.compass->source.talker;
    m_swing.referenceSource = nameOf(m_sources.reference->source);
    m_swing.warnings = m_sources.warnings;
}

Result<void> SwingOfLog::findVariation()
{
    const NmeaDate date = dateOfLog(m_log, m_options.date, m_options.today);
    m_swing.date = date.date;
    tellLimits(date.doubts);
    if (m_options.reference == NmeaReference::Magnetic)
        return {};
    auto chosen = chooseVariation(m_log, m_options.variation, date, m_options.variationError_deg);
    if (!chosen && !date.doubts.empty())
        return Error{chosen.error().code, together({chosen.error().message, date.doubts.front()})};
    if (!chosen)
        return chosen.error();
    m_swing.variation = chosen->variation;
    m_swing.variationSource = chosen->source;
    m_swing.variationOfModel_deg = chosen->model_deg;
    m_variationError_deg = chosen->standardError_deg;
    tellLimits(chosen->warnings);
    return {};
}

void SwingOfLog::placeInTime()
{
    m_times.emplace(m_log, *m_sources.reference);
    m_swing.timesTold = m_times->told();
    if (!m_times->told())
        m_times->stretch(m_swing.step_s = stepOf_s(HeadingLine(inTime(*m_sources.reference, *m_times))));
    m_compass = inTime(*m_sources.compass, *m_times);
    auto sent = inTime(*m_sources.reference, *m_times);
    if (m_options.reference == NmeaReference::Track)
        tellJumps(takeOutJumps(sent, m_compass));
    m_sent = HeadingLine(std::move(sent));
    m_rates = m_times->told() ? turnRates(m_compass) : std::vector<std::optional<double>>(m_compass.size());
    m_speeds = m_sent;
    if (m_options.reference == NmeaReference::Track)
        return;
    for (const auto& stream : m_log.streams())
        if (stream.north == NmeaNorth::Track)
            m_speeds = HeadingLine(inTime(stream, *m_times));
}

void SwingOfLog::tellJumps(const NmeaJumps& jumps)
{
    if (jumps.away > 0)
        tell({MARKED_N("core", "%n track(s) left out that jump away from the compass for a moment, as a receiver's do near walls"),
            jumps.away});
    if (jumps.backwards > 0)
        tell({MARKED_N("core", "%n track(s) left out that go backwards: the aircraft was pushed, and its track is not its heading"),
            jumps.backwards});
}

void SwingOfLog::findWind()
{
    if (m_options.reference != NmeaReference::Track || m_options.wind == NmeaWindChoice::Leave)
        return;
    std::vector<TimedHeading> tracks;
    for (const auto& track : m_sent.headings())
        if (track.heading_deg && track.speed_kt.value_or(0.0) >= std::max(m_options.minSpeed_kt, 1e-3))
            tracks.push_back(track);
    if (tracks.empty())
        return;
    double mean_kt = 0.0;
    for (const auto& track : tracks)
        mean_kt += *track.speed_kt / static_cast<double>(tracks.size());
    const bool flies = mean_kt >= kFlies_kt || m_options.wind == NmeaWindChoice::TakeOut;
    auto wind = windOf(tracks);
    const double error_deg = wind ? toDegrees(wind->standardError_kt() / wind->airspeed_kt) : 0.0;
    if (!wind || error_deg > kMostDriftError_deg) {
        if (flies)
            leaveWindOpen(mean_kt);
        return;
    }
    const bool shows = wind->speed_kt() > 2.0 * wind->standardError_kt() && wind->drift_deg() >= kLeastDrift_deg;
    wind->takenOut = shows && flies;
    if (wind->takenOut)
        tellLimit({MARKED("core", "wind from %1° true at %2 kt (standard error %3 kt), airspeed %4 kt, is taken out of the tracks"),
            figureText(printedHeading_deg(wind->from_deg(), 0), 0), figureText(wind->speed_kt(), 1),
            figureText(wind->standardError_kt(), 1), figureText(wind->airspeed_kt, 1)});
    else if (shows)
        tellLimit({MARKED("core",
                       "the ground speed varies with the track, as if wind or current of %1 kt carried it: on wheels that is the driver; "
                       "otherwise B and C are out by up to %2°; it can be taken out"),
            figureText(wind->speed_kt(), 1), figureText(wind->drift_deg(), 1)});
    m_swing.wind = *wind;
    m_windOpen = *wind;
}

void SwingOfLog::leaveWindOpen(double speed_kt)
{
    tellLimit(
        {MARKED("core",
             "the tracks do not tell the wind (three directions at one airspeed would): each knot of it across turns the track from the "
             "heading by %1°, into A, B and C; their errors allow for %2 kt of it"),
            figureText(toDegrees(1.0 / speed_kt), 1), figureText(kUsualWind_kt, 0)});
    m_windOpen.emplace();
    m_windOpen->airspeed_kt = speed_kt;
    m_windOpen->covariance = Eigen::Matrix2d::Identity() * kUsualWind_kt * kUsualWind_kt;
}

/// The reference's magnetic headings, from what was sent.
void SwingOfLog::bringToTrue()
{
    std::vector<TimedHeading> headings = m_sent.headings();
    for (auto& heading : headings) {
        if (!heading.heading_deg)
            continue;
        if (m_swing.wind && m_swing.wind->takenOut && heading.speed_kt)
            heading.heading_deg = headingInWind_deg(*m_swing.wind, *heading.heading_deg, *heading.speed_kt);
        if (m_swing.variation)
            heading.heading_deg = wrap360(*heading.heading_deg - m_swing.variation->degrees());
    }
    m_reference = HeadingLine(std::move(headings));
}

bool SwingOfLog::withinLimits(const NmeaPair& pair) const
{
    // A track without a speed is no track: nothing says that the aircraft moved.
    if (m_options.reference == NmeaReference::Track && pair.speed_kt.value_or(0.0) < m_options.minSpeed_kt)
        return false;
    return !pair.turnRate_deg_s || std::abs(*pair.turnRate_deg_s) <= m_options.maxTurnRate_deg_s;
}

void SwingOfLog::makePairs(double delay_s)
{
    m_swing.pairs.clear();
    for (std::size_t i = 0; i < m_compass.size(); ++i) {
        const auto reference = m_reference.at(m_compass[i].seconds + delay_s);
        if (!reference)
            continue;
        const auto speed = m_speeds.at(m_compass[i].seconds + delay_s);
        NmeaPair pair{CompassHeading::fromDegrees(*m_compass[i].heading_deg), MagneticHeading::fromDegrees(*reference->heading_deg),
            m_compass[i].seconds, speed ? speed->speed_kt : std::nullopt, m_rates[i], m_times->utc(m_compass[i].seconds), false};
        pair.used = withinLimits(pair);
        m_swing.pairs.push_back(std::move(pair));
    }
    const auto rates = referenceRates(usedHeadings(), m_reference, delay_s);
    m_repeated = leaveOutStands(m_swing.pairs, rates, m_times->spacing_s(*m_sources.compass));
    m_swing.used = static_cast<std::size_t>(std::ranges::count_if(m_swing.pairs, &NmeaPair::used));
}

/// Why nothing is left.
void SwingOfLog::tellUnused()
{
    if (m_swing.used > 0 || m_swing.pairs.empty())
        return;
    double fastest_kt = 0.0;
    for (const auto& pair : m_swing.pairs)
        fastest_kt = std::max(fastest_kt, pair.speed_kt.value_or(0.0));
    if (m_options.reference == NmeaReference::Track && fastest_kt < m_options.minSpeed_kt)
        tell({MARKED("core",
                  "the log never moves faster than %1 kt, and a track counts from %2 kt on: below, it is the noise of the receiver"),
            figureText(fastest_kt, 1), figureText(m_options.minSpeed_kt, 1)});
    else
        tell({MARKED("core", "all of the turn is faster than %1°/s, and slower ones count only: a compass lags"),
            figureText(m_options.maxTurnRate_deg_s, 1)});
}

std::vector<TimedHeading> SwingOfLog::usedHeadings() const
{
    std::vector<TimedHeading> used;
    for (const auto& pair : m_swing.pairs)
        if (pair.used)
            used.push_back({pair.seconds, pair.compass.degrees(), {}});
    return used;
}

void SwingOfLog::findDelay()
{
    const double spacing_s = std::min(m_times->spacing_s(*m_sources.compass), m_times->spacing_s(*m_sources.reference));
    m_swing.delay = delayOf(usedHeadings(), m_reference, spacing_s);
    if (m_swing.delay.seconds)
        makePairs(*m_swing.delay.seconds);
    if (m_repeated)
        tell({MARKED_N("core", "%n reading(s) of a standing aircraft left out: they repeat what it read at the end of its stand"),
            m_repeated});
    tellDelay();
}

void SwingOfLog::tellDelay()
{
    const NmeaDelay& delay = m_swing.delay;
    const std::string degrees = figureText(std::abs(delay.A_degPerSecond), 1);
    if (!m_times->told())
        tellLimit(MARKED("core", "the log tells no time: its turn is taken as one of 1°/s"));
    if (delay.told == DelayTold::OneWay && std::abs(delay.A_degPerSecond) >= 0.05)
        tellLimit(
            {MARKED("core",
                 "the turn goes one way at about one rate: A and a delay between heading and reference cannot be told apart, each second of "
                 "delay is %1° of A; what is not known of it gives A a standard error of %2° (a turn the other way would tell)"),
                degrees, figureText(std::abs(delay.A_degPerSecond) * delay.standardError_s, 1)});
    else if (delay.told == DelayTold::TooNoisy && std::abs(delay.A_degPerSecond) >= 0.05)
        tellLimit(
            {MARKED("core", "the headings are too uneven to tell the delay between heading and reference: each second of it is %1° of A"),
                degrees});
    else if (delay.seconds)
        tellLimit({*delay.seconds < 0.0
                ? MARKED("core", "the reference is %1 s newer than the heading beside it (standard error %2 s); that is taken out")
                : MARKED("core", "the reference is %1 s older than the heading beside it (standard error %2 s); that is taken out"),
            figureText(std::abs(*delay.seconds), 2), figureText(delay.standardError_s, 2)});
    int turning = 0, fast = 0;
    for (const auto& pair : m_swing.pairs)
        if (pair.used && pair.turnRate_deg_s && std::abs(*pair.turnRate_deg_s) >= kSlowestTurn_deg_s)
            ++turning, fast += std::abs(*pair.turnRate_deg_s) > 1.1 * kFastestTurn_deg_s ? 1 : 0;
    if (2 * fast > turning)
        tell({MARKED("core", "most of the turn is faster than %1°/s: a card in its liquid lags; %2 to %1°/s tells more"),
            figureText(kFastestTurn_deg_s, 1), figureText(kSlowestTurn_deg_s, 1)});
}

void SwingOfLog::compareDirections()
{
    const auto rates = referenceRates(usedHeadings(), m_reference, m_swing.delay.seconds.value_or(0.0));
    m_swing.directions = directionsOf(m_swing.pairs, rates);
    if (m_swing.directions)
        tell({MARKED("core", "clockwise A is %1°, counter-clockwise %2°; the two curves differ by up to %3°"),
            signedFigureText(m_swing.directions->clockwiseA_deg, 2), signedFigureText(m_swing.directions->counterClockwiseA_deg, 2),
            figureText(m_swing.directions->largestDifference_deg, 1)});
}

void SwingOfLog::addWindDoubts(const std::vector<TimedHeading>& used)
{
    if (!m_windOpen)
        return;
    NmeaWind applied = *m_windOpen;
    Eigen::Matrix2d open = applied.covariance;
    if (!applied.takenOut) { // all of it is in the readings
        open += applied.toward_kt * applied.toward_kt.transpose();
        applied.toward_kt.setZero();
    }
    const Eigen::Matrix2d half = open.llt().matrixL();
    std::array<SharedDoubt, 2> doubts;
    for (const auto& heading : used) {
        const auto sent = m_sent.at(heading.seconds + m_swing.delay.seconds.value_or(0.0));
        const Eigen::Vector2d turned = sent && sent->speed_kt
            ? Eigen::Vector2d(half.transpose() * turnedByWind_deg(applied, *sent->heading_deg, *sent->speed_kt))
            : Eigen::Vector2d(0.0, 0.0);
        doubts[0].push_back(turned.x());
        doubts[1].push_back(turned.y());
    }
    m_swing.doubts.insert(m_swing.doubts.end(), doubts.begin(), doubts.end());
}

void SwingOfLog::addDoubts()
{
    const auto used = usedHeadings();
    SharedDoubt delay = referenceRates(used, m_reference, m_swing.delay.seconds.value_or(0.0));
    for (double& turned : delay)
        turned *= -m_swing.delay.standardError_s;
    m_swing.doubts.push_back(std::move(delay));
    addWindDoubts(used);
    if (m_variationError_deg > 0.0)
        m_swing.doubts.emplace_back(used.size(), m_variationError_deg);
}

void SwingOfLog::doubtReference()
{
    const NmeaStream &reference = *m_sources.reference, &compass = *m_sources.compass;
    for (const auto& one : contradictionsOf(m_log, reference, compass, *m_times, m_options.minSpeed_kt)) {
        tellLimit(one.told);
        m_swing.doubts.emplace_back(m_swing.used, one.ofA_deg);
    }
    if (const auto doubt = doubtOfRepetition(reference, compass, m_swing.pairs))
        tellLimit(*doubt);
}

Result<NmeaSwing> SwingOfLog::make()
{
    auto sources = chooseSources(m_log, m_options);
    if (!sources)
        return sources.error();
    m_sources = std::move(sources.value());
    takeCounts();
    if (const auto found = findVariation(); !found)
        return found.error();
    placeInTime();
    findWind();
    bringToTrue();
    makePairs(0.0);
    tellUnused();
    if (m_swing.pairs.empty())
        return Error{ErrorCode::InvalidInput,
            {MARKED("core", "no compass heading of %1 has a reference (%2) near its time"), nameOf(m_sources.compass->source),
                nameOf(m_sources.reference->source)}};
    findDelay();
    compareDirections();
    addDoubts();
    doubtReference();
    if (std::any_of(m_swing.pairs.begin(), m_swing.pairs.end(), [](const NmeaPair& pair) { return !pair.turnRate_deg_s; }))
        tell(MARKED("core", "some headings have no time near them: their turn rate is not known and not limited"));
    const auto told = toldOfLog(m_log);
    m_swing.warnings.insert(m_swing.warnings.end(), told.begin(), told.end());
    return std::move(m_swing);
}

} // namespace

Result<NmeaSwing> makeSwing(const NmeaLog& log, const NmeaOptions& options) { return SwingOfLog(log, options).make(); }

} // namespace lubberline
