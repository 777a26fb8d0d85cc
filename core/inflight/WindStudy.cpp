#include "core/inflight/WindStudy.h"

#include <bit>
#include <cmath>

#include <Eigen/Cholesky>

#include "core/angle/Angle.h"
#include "core/base/VectorClones.h"
#include "core/inflight/WindStudyParts.h"
#include "core/inflight/WindVector.h"

namespace lubberline {

namespace {

constexpr double kReferenceAirspeed_kt = 250.0; ///< weight 1
constexpr double kReferenceError_kt = 5.0;
constexpr double kOutside = 4.0; ///< standard deviations, beyond which a report counts less (Huber)
constexpr double kLeastSigma_deg = 1.25;
constexpr std::int64_t kFirstFit = 32;                                 ///< reports, before which legs are not told from errors
constexpr double kGapNamed_s = 6 * 3600.0, kGapNameless_s = 45 * 60.0; ///< a longer one begins another flight
constexpr double kNear_s = 120.0;

bool known(double value) { return value == value; }
bool hasWindOf(const WindReport& report) { return known(report.wind_kt) && (known(report.windFrom_deg) || report.wind_kt == 0); }

std::uint64_t fingerprintOf(const WindReport& r)
{
    std::uint64_t hash = 0xcbf29ce484222325ULL;
    for (const double one : {r.time_s, r.latitude_deg, r.longitude_deg, r.altitude_m, r.groundSpeed_kt, r.track_deg, r.wind_kt,
             r.windFrom_deg, r.reference_kt, r.referenceFrom_deg})
        hash = (std::rotl(hash, 23) ^ std::bit_cast<std::uint64_t>(one)) * 0x9E3779B97F4A7C15ULL;
    for (const char c : r.source)
        hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
    return hash | 1; // 0: none
}

LUBBERLINE_VECTOR_CLONES bool isAmong(const std::uint64_t* prints, std::size_t count, std::uint64_t print)
{
    std::uint64_t found = 0;
    for (std::size_t i = 0; i < count; ++i)
        found += prints[i] == print ? 1 : 0;
    return found > 0;
}

double yearAt(double time_s)
{
    constexpr double kYear_s = 365.2425 * 86400.0;
    return 1970.0 + time_s / kYear_s;
}

WindRow windRow(double sine, double cosine)
{
    WindRow row;
    row << 1.0, sine, cosine, 2.0 * sine * cosine, cosine * cosine - sine * sine;
    return row;
}

/// Ground velocity between two positions [kt], each component uncertain by their steps: even within a step, σ = step/√12 at both ends.
struct GroundByPositions {
    Eigen::Vector2d velocity_kt;
    double error_kt = 0;
};
constexpr double kShortestFix_s = 10, kLongestFix_s = 600;

std::optional<GroundByPositions> groundBetween(double latitude_deg, double longitude_deg, const WindReport& report, double seconds)
{
    if (!(std::abs(seconds) >= kShortestFix_s && std::abs(seconds) <= kLongestFix_s))
        return {};
    constexpr double kAxis_m = 6378137.0, kEccentricity2 = 0.00669437999014, kKnot_m_s = 1852.0 / 3600.0; // WGS84
    const double middle = toRadians((latitude_deg + report.latitude_deg) / 2), sine = std::sin(middle);
    const double root = std::sqrt(1 - kEccentricity2 * sine * sine);
    const double north_m = kAxis_m * (1 - kEccentricity2) / (root * root * root), east_m = kAxis_m / root * std::cos(middle);
    const double metresToKnots = 1 / (seconds * kKnot_m_s);
    GroundByPositions ground;
    ground.velocity_kt = {toRadians(wrap180(report.longitude_deg - longitude_deg)) * east_m * metresToKnots,
        toRadians(report.latitude_deg - latitude_deg) * north_m * metresToKnots};
    ground.error_kt = toRadians(report.positionStep_deg) * north_m * std::sqrt(2.0 / 12.0) * std::abs(metresToKnots);
    return ground;
}

/// The running fit of the first order; what the headings do not tell yet stays near 0.
template <class Sums>
WindRow runningFit(const Sums& sums)
{
    Eigen::Matrix3d normal = sums.normal.template selfadjointView<Eigen::Lower>();
    normal.diagonal().array() += 1e-3 * normal(0, 0) + 1e-9;
    WindRow row = WindRow::Zero();
    row.head<3>() = normal.ldlt().solve(sums.product);
    return row;
}

} // namespace

WindStudy::WindStudy(const WindOptions& options) : m_options(options), m_twin(std::make_unique<Twin>()), m_held(std::make_unique<Held>()) {}
WindStudy::~WindStudy() = default;

WindStudy::Aircraft& WindStudy::aircraftOf(std::string_view name)
{
    if (m_last && m_last->name == name)
        return *m_last;
    const auto [place, isNew] = m_byName.try_emplace(std::string(name), m_aircraft.size());
    if (isNew)
        m_aircraft.emplace_back().name = name;
    m_last = &m_aircraft[place->second];
    return *m_last;
}

/// A report out of order may close the gap between two flights that were taken for two.
void WindStudy::mergeInto(Flight& flight, Aircraft& aircraft, double gap_s)
{
    auto& places = aircraft.byName[flight.name];
    std::erase_if(places, [&](std::size_t place) {
        Flight& other = aircraft.flights[place];
        if (&other == &flight || !known(other.from_s) || other.from_s > flight.to_s + gap_s || other.to_s < flight.from_s - gap_s)
            return false;
        flight.sums += other.sums;
        flight.held.insert(flight.held.end(), other.held.begin(), other.held.end());
        other.held.clear();
        if (!(flight.latest_s > other.latest_s))
            flight.latest_s = other.latest_s;
        for (const auto& [band, forms] : other.forms)
            flight.formsOf(band) += forms;
        flight.from_s = std::min(flight.from_s, other.from_s);
        flight.to_s = std::max(flight.to_s, other.to_s);
        for (const std::uint64_t print : other.recent)
            if (print != 0)
                flight.recent[flight.recentNext++ % flight.recent.size()] = print;
        other.sums = {};
        other.forms.clear();
        other.from_s = other.to_s = kMissing;
        return true;
    });
}

WindStudy::Flight& WindStudy::flightOf(Aircraft& aircraft, const WindReport& report)
{
    const double gap_s = report.flight.empty() ? kGapNameless_s : kGapNamed_s;
    const bool timed = known(report.time_s);
    const auto holds = [&](const Flight& flight) {
        return !timed || !known(flight.from_s) || (report.time_s >= flight.from_s - gap_s && report.time_s <= flight.to_s + gap_s);
    };
    const auto extend = [&](Flight& flight) -> Flight& {
        if (timed) {
            flight.from_s = known(flight.from_s) ? std::min(flight.from_s, report.time_s) : report.time_s;
            flight.to_s = known(flight.to_s) ? std::max(flight.to_s, report.time_s) : report.time_s;
            if (report.time_s < aircraft.latest_s)
                mergeInto(flight, aircraft, gap_s);
            aircraft.latest_s = std::max(aircraft.latest_s, report.time_s);
        }
        aircraft.last = &flight;
        return flight;
    };
    if (aircraft.last && aircraft.last->name == report.flight && holds(*aircraft.last))
        return extend(*aircraft.last);
    auto& places = aircraft.byName[std::string(report.flight)];
    for (auto place = places.rbegin(); place != places.rend(); ++place)
        if (holds(aircraft.flights[*place]))
            return extend(aircraft.flights[*place]);
    places.push_back(aircraft.flights.size());
    aircraft.flights.emplace_back().name = report.flight;
    ++m_flights;
    return extend(aircraft.flights.back());
}

std::optional<LeftOut> WindStudy::filter(Flight& flight, const WindReport& report, const Use& use) const
{
    const double apart_s = std::abs(report.time_s - flight.last_s);
    const double track_deg = known(report.track_deg) ? report.track_deg : directionOf_deg(use.ground);
    std::optional<LeftOut> why;
    if (known(report.roll_deg) && std::abs(report.roll_deg) > m_options.mostRoll_deg)
        why = LeftOut::Rolling;
    else if (apart_s == 0)
        why = flight.lastLeftOut; // the same report against another source
    else if (apart_s <= kNear_s && std::abs(report.altitude_m - flight.lastAltitude_m) > m_options.mostClimb_m_s * apart_s)
        why = LeftOut::Climbing;
    else if (apart_s <= kNear_s && std::abs(quickWrap180(track_deg - flight.lastTrack_deg)) > m_options.mostTurn_deg_s * apart_s + 1.0)
        why = LeftOut::Turning;
    flight.last_s = report.time_s;
    flight.lastAltitude_m = report.altitude_m;
    flight.lastTrack_deg = track_deg;
    flight.lastLeftOut = why;
    if (why)
        return why;
    const double least = m_options.leastAirspeed_kt * m_options.leastAirspeed_kt;
    return use.air.squaredNorm() < least || use.airReference.squaredNorm() < least ? std::optional(LeftOut::Slow) : std::nullopt;
}

void WindStudy::tellSource(const Aircraft& aircraft, const WindReport& report, const Use& use, double error_deg)
{
    const double across = rightOf(use.airReference).normalized().dot(use.wind - use.reference);
    auto found = std::find_if(m_sources.begin(), m_sources.end(), [&](const Source& one) { return one.name == report.source; });
    constexpr std::size_t kMostSources = 64;
    if (found == m_sources.end()) {
        if (m_sources.size() == kMostSources)
            return;
        m_sources.push_back({std::string(report.source)});
        found = m_sources.end() - 1;
    }
    ++found->count;
    found->errors += error_deg;
    found->across += across * across;
    if (m_twin->aircraft == &aircraft && m_twin->time_s == report.time_s && m_twin->source != report.source) {
        m_apart += std::pow(m_twin->east - use.reference.x(), 2) + std::pow(m_twin->north - use.reference.y(), 2);
        ++m_apartCount;
    }
    *m_twin = {report.time_s, use.reference.x(), use.reference.y(), &aircraft, std::string(report.source)};
}

void WindStudy::sumUp(Aircraft& aircraft, Flight& flight, const WindReport& report, const Use& use)
{
    const double airspeed = use.air.norm();
    const double error_deg = aircraft.sideOf(turnBetween_deg(use.airReference, use.air)); // from the reference to the reading
    double sine = use.air.x() / airspeed, cosine = use.air.y() / airspeed;
    const Eigen::Vector2d right(cosine, -sine);
    // Ahead only: a deviation turns the air velocity, and is in what is across.
    const Eigen::Vector2d ahead = use.air / airspeed;
    const double wind = use.wind.dot(ahead), reference = use.reference.dot(ahead);
    constexpr double kWild = 4.0, kWild_kt = 10.0; // no unit makes so much of it
    if (std::abs(wind) < kWild * std::abs(reference) + kWild_kt) {
        flight.sums.windOnReference += wind * reference;
        flight.sums.referenceSquares += reference * reference;
    }
    FlightSums::Report one;
    const auto declination_deg = known(report.latitude_deg) && known(report.longitude_deg) && known(report.time_s)
        ? m_declination.at(report.latitude_deg, report.longitude_deg, yearAt(report.time_s))
        : std::nullopt;
    if (declination_deg) {
        const SineCosine turn = quickSineCosineOfDegrees(*declination_deg), heading{sine, cosine};
        sine = heading.sine * turn.cosine - heading.cosine * turn.sine; // of heading − D
        cosine = heading.cosine * turn.cosine + heading.sine * turn.sine;
        aircraft.declinations += *declination_deg;
        aircraft.declinationSquares += *declination_deg * *declination_deg;
        aircraft.declinationErrors += *declination_deg * error_deg;
        aircraft.errors += error_deg;
        ++aircraft.declined;
        flight.sums.declination += *declination_deg;
        ++flight.sums.declined;
    } else {
        ++flight.sums.withoutTold;
    }
    const WindRow row = windRow(sine, cosine);
    const double read_deg = directionNearly_deg(sine, cosine);
    WindSector& sector = aircraft.sectors[static_cast<std::size_t>(read_deg / 10.0) % aircraft.sectors.size()];
    ++sector.count;
    sector.heading_deg += read_deg;
    sector.error_deg += error_deg;
    aircraft.addDot({read_deg, error_deg});

    const double left = error_deg - row.dot(aircraft.running), sigma = std::max(kLeastSigma_deg, 1.4826 * aircraft.median_deg);
    constexpr double kAnyLeg_deg = 30.0;
    const double limit = aircraft.used < kFirstFit ? kAnyLeg_deg : kOutside * sigma;
    const double level = flight.levelled > 0 ? flight.level_deg : std::clamp(left, -limit, limit);
    const double off = left - level;
    const double robust = std::abs(off) > limit ? limit / std::abs(off) : 1.0;
    ++flight.levelled;
    flight.level_deg = level + std::clamp(off, -limit, limit) / static_cast<double>(flight.levelled);
    aircraft.moveMedian(std::abs(off));

    // A reference wind is wrong by some 5 kt: what positions add to that makes a report count less.
    const double share
        = kReferenceError_kt * kReferenceError_kt / (kReferenceError_kt * kReferenceError_kt + use.groundError_kt * use.groundError_kt);
    const double weight = robust * share * airspeed * airspeed / (kReferenceAirspeed_kt * kReferenceAirspeed_kt);
    const Eigen::Vector2d apart = use.wind - use.reference;
    const double ground = std::max(use.ground.norm(), 1e-9);
    const Eigen::Vector2d acrossTrack = rightOf(use.ground) / ground;
    const double along = right.dot(acrossTrack), across = apart.dot(acrossTrack);
    for (int column = 0; column < kWindColumns; ++column)
        one.row[static_cast<std::size_t>(column)] = row(column);
    one.weight = weight;
    one.error_deg = error_deg;
    // To the second order: the turned air velocity is shorter along its old direction.
    one.turned = airspeed * airspeed + apart.dot(use.air);
    one.turnedAcross = airspeed * along * airspeed * along + across * use.air.dot(acrossTrack);
    one.product = airspeed * right.dot(apart);
    one.productAcross = airspeed * along * across;
    one.squaredError = apart.squaredNorm();
    one.squaredAcross = across * across;
    one.airspeedOffset = (known(report.tas_kt) ? report.tas_kt : airspeed) - use.airReference.norm();
    one.airspeed = airspeed;
    flight.sums.add(one);
    constexpr double kHighest = kWindBands - 1;
    flight
        .formsOf(known(report.altitude_m) ? static_cast<std::size_t>(std::clamp(std::floor(report.altitude_m / kWindBand_m), 0.0, kHighest))
                                          : kWindBands)
        .add(one);
    aircraft.add(one);
    ++aircraft.used;
    if (aircraft.used == aircraft.refitAt) {
        aircraft.running = runningFit(aircraft);
        aircraft.refitAt += aircraft.refitAt;
    }
    if (!report.source.empty())
        tellSource(aircraft, report, use, error_deg);
    if (known(report.heading_deg)) {
        ++aircraft.headings;
        const double true_deg = directionOf_deg(use.air);
        aircraft.headingOff += std::pow(wrap180(report.heading_deg - true_deg), 2);
        aircraft.headingOffMagnetic += std::pow(wrap180(report.heading_deg + declination_deg.value_or(0.0) - true_deg), 2);
    }
}

void WindStudy::add(const WindReport& report)
{
    ++m_observations;
    Aircraft& aircraft = aircraftOf(report.aircraft);
    ++aircraft.observations;
    if (!known(report.reference_kt) || !(known(report.referenceFrom_deg) || report.reference_kt == 0))
        return aircraft.leave(LeftOut::NoReference);
    const bool hasGround = known(report.groundSpeed_kt) && known(report.track_deg);
    const bool hasFix = known(report.latitude_deg) && known(report.longitude_deg) && known(report.time_s);
    if ((!hasGround && !hasFix) || (!hasWindOf(report) && !(known(report.heading_deg) && known(report.tas_kt))))
        return aircraft.leave(LeftOut::NoWind);
    Flight& flight = flightOf(aircraft, report);
    if (!report.group.empty() && aircraft.group.empty())
        aircraft.group = report.group;
    if (known(report.time_s))
        m_held->hold(*this, aircraft, flight, report);
    else
        take(aircraft, flight, report);
}

void WindStudy::take(Aircraft& aircraft, Flight& flight, const WindReport& report)
{
    const bool hasWind = hasWindOf(report), hasGround = known(report.groundSpeed_kt) && known(report.track_deg);
    std::optional<GroundByPositions> between;
    if (!hasGround) {
        if (known(flight.lastFix_s))
            between = groundBetween(flight.lastLatitude_deg, flight.lastLongitude_deg, report, report.time_s - flight.lastFix_s);
        flight.lastLatitude_deg = report.latitude_deg;
        flight.lastLongitude_deg = report.longitude_deg;
        flight.lastFix_s = report.time_s;
        if (!between)
            return aircraft.leave(LeftOut::NoWind);
    }
    if (known(report.time_s) || known(report.latitude_deg)) {
        const std::uint64_t print = fingerprintOf(report);
        if (isAmong(flight.recent.data(), flight.recent.size(), print))
            return aircraft.leave(LeftOut::Duplicate);
        flight.recent[flight.recentNext++ % flight.recent.size()] = print;
    }
    Use use;
    use.ground = between ? between->velocity_kt : velocityOf(report.track_deg, report.groundSpeed_kt);
    if (between) {
        ++aircraft.fromPositions;
        aircraft.positionSquares += between->error_kt * between->error_kt;
        // Beside a wind of its own it turns both air velocities alike; of heading and airspeed it is the error itself.
        use.groundError_kt = hasWind ? 0 : between->error_kt;
    }
    use.reference = report.reference_kt == 0 ? Eigen::Vector2d(0, 0) : velocityOf(report.referenceFrom_deg, -report.reference_kt);
    use.wind = !hasWind       ? Eigen::Vector2d(use.ground - velocityOf(report.heading_deg, report.tas_kt))
        : report.wind_kt == 0 ? Eigen::Vector2d(0, 0)
                              : velocityOf(report.windFrom_deg, -report.wind_kt);
    use.air = use.ground - use.wind;
    use.airReference = use.ground - use.reference;
    if (hasWind && !aircraft.sense.full())
        aircraft.sense.take(report, use.ground.data(), use.wind.data(), use.reference.data());
    if (const auto why = filter(flight, report, use))
        return aircraft.leave(*why);
    sumUp(aircraft, flight, report, use);
}

} // namespace lubberline
