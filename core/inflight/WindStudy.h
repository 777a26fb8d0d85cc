#pragma once
/// Deviation from winds: an aircraft's wind is wrong across its track by airspeed times the error of its heading, so reports beside a
/// reference wind tell that error [M 1, 4–7]:
///   V_A = V_G − W;  e = dir(V_G − W reported) − dir(V_G − W reference) = read − true, wrapped;  e = c + a sin ψ' + b cos ψ' (+ 2ψ')
/// with ψ' the magnetic heading that was read (true where the declination is not known). Deviation is −e: A = −c, B = −a, C = −b.
/// A constant error of the reference wind is a sine of the heading, too: 1 m/s is 0.458° at 125 m/s. One aircraft cannot tell it from B and
/// C; what the fleet has in common is said.
/// Reports are streamed: memory grows with flights. Those of a flight are judged in order of time: some thousands are held for it.

#include <array>
#include <deque>
#include <map>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/base/Result.h"
#include "core/earth/DeclinationNodes.h"
#include "core/inflight/ClusteredFit.h"
#include "core/inflight/WindChange.h"
#include "core/inflight/WindReport.h"
#include "core/inflight/WindSense.h"

namespace lubberline {

/// The eight points of a table are joined by straight lines, which flattens a sine.
enum class TableFactor {
    Paper, ///< 1.05 [M 7]
    Exact, ///< (x/sin x)² = 1.0530 with x = 22.5°: the first harmonic of the joined lines is the sine
    None,  ///< 1: the points lie on the curve
};
inline constexpr std::array kTableFactors{TableFactor::Paper, TableFactor::Exact, TableFactor::None};
/// Of the sine of an order, at steps of 45°.
[[nodiscard]] double tableFactor(TableFactor which, int order = 1);

struct WindOptions {
    double mostRoll_deg = 10;
    double mostClimb_m_s = 2.5;   ///< 500 ft/min
    double mostTurn_deg_s = 0.5;  ///< of the track, between reports that are near in time
    double leastAirspeed_kt = 60; ///< below, a wind tells little of the heading
    TableFactor factor = TableFactor::Paper;
    bool removeCommon = false; ///< the fleet's mean sine is taken out of every aircraft
    /// A group (or an aircraft) whose headings are held to be right, as by laser gyros: what it shows is the reference's error. Winds of the
    /// others are told as multiples of its own, and the common sine is that of its aircraft. Empty: none.
    std::string control;
    /// What the file says of its winds is believed though the figures speak against it.
    bool believed = false;
};

/// A report as a dot of a scatter.
struct WindDot {
    double heading_deg = 0, error_deg = 0; ///< as read, and e
};

enum class LeftOut { NoReference, NoWind, Rolling, Climbing, Turning, Slow, Duplicate };
inline constexpr std::array kLeftOut{
    LeftOut::NoReference, LeftOut::NoWind, LeftOut::Rolling, LeftOut::Climbing, LeftOut::Turning, LeftOut::Slow, LeftOut::Duplicate};
[[nodiscard]] Message wordsFor(LeftOut why);

struct WindFit {
    ClusteredFit fit; ///< of e
    [[nodiscard]] std::optional<double> inPhase_deg() const { return of(1); }
    [[nodiscard]] std::optional<double> quadrature_deg() const { return of(2); }
    [[nodiscard]] std::optional<double> offset_deg() const { return of(0); }
    [[nodiscard]] std::optional<double> of(int column) const { return fit.told[column] ? std::optional(fit.value(column)) : std::nullopt; }
};

struct FoundChange {
    std::string afterFlight, beforeFlight;
    double p = 1;
    WindRow step_deg = WindRow::Zero(); ///< of e
};

/// Reports whose heading is within 10° together: what a scatter of them shows.
struct WindSector {
    std::int64_t count = 0;
    double heading_deg = 0, error_deg = 0; ///< means, of the heading read and of e
};

/// Of altitude; after: as far as aircraft have winds after.
struct WindBand {
    double from_m = 0, to_m = 0;
    WindSquares before, after;
};
inline constexpr std::size_t kWindBands = 16; ///< reports above the last one stand in it
inline constexpr double kWindBand_m = 1000.0;

struct AircraftWinds {
    std::string aircraft;
    int flights = 0, flightsFitted = 0; ///< fitted: since the last change
    std::int64_t observations = 0, used = 0;
    std::array<std::int64_t, kLeftOut.size()> leftOut{};
    std::int64_t late = 0; ///< that came after later ones of their flight, which were judged already
    bool fitted = false;
    WindFit fit;                  ///< of the flights since the last change
    bool secondOrderTold = false; ///< the headings tell it
    double secondOrderP = 1;      ///< the chance that it is not there; below 0.05 it is in the fit and the table
    ClusteredFit secondOrder;     ///< all five
    std::optional<double> airspeedOffset_kt, airspeedOffsetError_kt;
    std::string group;              ///< of its reports; empty: none stated
    std::int64_t fromPositions = 0; ///< reports whose ground velocity is that between positions
    double positionError_kt = 0;    ///< of these, rms, as far as the positions' steps make it
    WindSquares squaresBefore, squaresAfter;
    std::array<WindBand, kWindBands + 1> bands{}; ///< of them; the last: without an altitude
    std::vector<WindDot> dots;                    ///< some of its reports, spread over all
    WindRmse before;
    std::optional<WindRmse> after;    ///< each flight corrected by what the others tell; none of one flight
    std::vector<FoundChange> changes; ///< in order of time
    std::optional<ClusteredFit> beforeChange;
    double meanDeclination_deg = 0;
    bool declinationOut = false; ///< at all reports
    std::optional<double> sharedSine_deg;
    std::array<WindSector, 36> sectors{}; ///< of all reports that are used
    std::vector<Message> warnings;
    /// Largest indication error of the first order, √(a² + b²) + |c| [deg]
    [[nodiscard]] double size_deg() const;
    /// e at a heading that is read [deg].
    [[nodiscard]] double errorAt_deg(double heading_deg) const;
    /// Deviation to upload for eight headings, 0, 45, … [deg].
    [[nodiscard]] std::array<double, 8> table_deg(TableFactor factor) const;
    [[nodiscard]] bool secondOrderUsed() const { return secondOrderTold && secondOrderP < 0.05; }
};

/// The sine that all aircraft have.
struct CommonSine {
    int aircraft = 0;
    WindRow value_deg = WindRow::Zero(), standardError_deg = WindRow::Zero();
    double airspeed_kt = 0;
    bool takenOut = false;
    /// The error of the reference wind that would look the same [kt], and where it would blow from.
    [[nodiscard]] double asWind_kt() const;
};

/// Aircraft of one kind of heading source, as laser gyros beside flux valves.
struct WindGroup {
    std::string group;
    int aircraft = 0, corrected = 0; ///< corrected: that have winds after
    WindSquares before, after;
};

struct WindBin {
    double from_deg = 0, to_deg = 0; ///< of the size; the last has no end (infinite)
    int aircraft = 0;
};
struct WindSourceTold {
    std::string source;
    std::int64_t observations = 0;
    double meanError_deg = 0, transverse_kt = 0; ///< mean of e and rms across the track against this source
};

struct WindResult {
    std::vector<AircraftWinds> aircraft; ///< by name
    std::optional<CommonSine> common;
    std::vector<WindBin> bins;
    std::vector<std::size_t> outliers; ///< rows of aircraft
    std::vector<WindGroup> groups;     ///< where reports name one, by name
    std::optional<WindGroup> control;  ///< that was asked for and is there
    std::vector<WindBand> altitudes;
    std::vector<WindSourceTold> sources;
    std::optional<double> sourcesApart_kt; ///< rms between two sources of one report
    std::int64_t observations = 0, used = 0;
    std::vector<Message> warnings;
};

class WindStudy {
public:
    explicit WindStudy(const WindOptions& options);
    ~WindStudy();
    void add(const WindReport& report);
    [[nodiscard]] WindResult finish();
    [[nodiscard]] std::int64_t observations() const { return m_observations; }
    [[nodiscard]] std::size_t aircraft() const { return m_byName.size(); }
    [[nodiscard]] std::size_t flights() const { return m_flights; } ///< of all aircraft

private:
    struct Flight;
    struct Aircraft;
    struct Use;
    Aircraft& aircraftOf(std::string_view name);
    void groupUp(WindResult& result) const;
    Flight& flightOf(Aircraft& aircraft, const WindReport& report);
    static void mergeInto(Flight& flight, Aircraft& aircraft, double gap_s);
    std::optional<LeftOut> filter(Flight& flight, const WindReport& report, const Use& use) const;
    [[nodiscard]] static std::vector<const Flight*> inOrder(const Aircraft& aircraft);
    [[nodiscard]] std::vector<bool> changed(const std::vector<const Aircraft*>& all, const SharedError& shared) const;
    [[nodiscard]] AircraftWinds resultOf(const Aircraft& aircraft, const SharedError& shared, bool hasChanged) const;
    void sumUp(Aircraft& aircraft, Flight& flight, const WindReport& report, const Use& use);
    void take(Aircraft& aircraft, Flight& flight, const WindReport& report);
    void tellSource(const Aircraft& aircraft, const WindReport& report, const Use& use, double error_deg);

    WindOptions m_options;
    DeclinationNodes m_declination;
    std::deque<Aircraft> m_aircraft;
    std::unordered_map<std::string, std::size_t> m_byName;
    Aircraft* m_last = nullptr;
    std::int64_t m_observations = 0;
    std::size_t m_flights = 0;
    struct Source;
    std::vector<Source> m_sources;
    double m_apart = 0;
    std::int64_t m_apartCount = 0;
    struct Twin; ///< the report before, for another source of the same
    std::unique_ptr<Twin> m_twin;
    struct Held; ///< reports whose flight may have earlier ones still to come
    std::unique_ptr<Held> m_held;
};

} // namespace lubberline
