#include "core/procedure/JobState.h"

#include <algorithm>
#include <cmath>

#include "core/base/Number.h"
#include "core/procedure/StationCoefficients.h"

namespace lubberline {

namespace {

/// Adds up the events of a job, one after the other.
class Fold {
public:
    explicit Fold(const SwingJob& job);
    Result<JobState> run();

private:
    using Fault = std::optional<Message>; ///< why an event cannot have happened; none: it did

    Fault take(const job::Ticked& event);
    Fault take(const job::InterferenceRead&) { return {}; }
    Fault take(const job::Prepared& event);
    Fault take(const job::ReadingTaken& event);
    Fault take(const job::ReadingRejected& event);
    Fault take(const job::StationSkipped& event);
    Fault take(const job::Adjusted& event);
    Fault take(const job::NotAdjusted& event);
    Fault take(const job::IndexRemoved& event);
    Fault take(const job::IndexLeft& event);
    Fault take(const job::Accepted& event);
    Fault take(const job::Faulted& event);
    Fault take(const job::Mended& event);
    Fault take(const job::Abandoned& event);
    Fault take(const job::DatumChanged& event);

    Fault checkStation(int station) const;
    Fault takeUpSkipped(StationState& station);
    void voidCheckSwing(Control control);
    void findPhase();
    void findTurn();
    [[nodiscard]] bool checkComplete() const;

    const SwingJob& m_job;
    JobState m_state;
    std::vector<double> m_compassNow_deg; ///< what the compass was last made to read at a station
    bool m_prepared = false, m_accepted = false, m_abandoned = false, m_turned = false;
};

Fold::Fold(const SwingJob& job) : m_job(job)
{
    for (auto& station : planOf(job.plan))
        m_state.stations.push_back({std::move(station), {}, {}, 0, false});
    m_compassNow_deg.resize(m_state.stations.size());
    m_state.openItems = job.checklist;
    m_state.datum = job.datum;
}

Result<JobState> Fold::run()
{
    for (std::size_t i = 0; i < m_job.events.size(); ++i) {
        const auto fault = m_abandoned ? Fault(MARKED("core", "the job was abandoned before"))
                                       : std::visit([this](const auto& event) { return take(event); }, m_job.events[i].what);
        if (fault)
            return Error{
                ErrorCode::InvalidInput, {MARKED("core", "step %1 of the guided swing cannot have happened there: %2"), i + 1, *fault}};
    }
    if (checkComplete())
        m_state.index_deg = checkIndex_deg(m_state.stations);
    findPhase();
    findTurn();
    return std::move(m_state);
}

Fold::Fault Fold::checkStation(int station) const
{
    if (!m_prepared)
        return MARKED("core", "the preparation is not finished");
    if (!m_state.fault.empty())
        return MARKED("core", "the fault is not mended");
    if (station < 0 || station >= static_cast<int>(m_state.stations.size()))
        return Message{MARKED("core", "there is no station %1"), station + 1};
    return {};
}

Fold::Fault Fold::take(const job::Ticked& event)
{
    const auto listed = std::find(m_job.checklist.begin(), m_job.checklist.end(), event.item);
    if (listed == m_job.checklist.end())
        return Message{MARKED("core", "\"%1\" is not on the checklist"), event.item};
    std::erase(m_state.openItems, event.item);
    if (!event.done)
        m_state.openItems.push_back(event.item);
    return {};
}

Fold::Fault Fold::take(const job::Prepared&)
{
    if (!m_state.openItems.empty())
        return Message{MARKED("core", "\"%1\" is not ticked"), m_state.openItems.front()};
    m_prepared = true;
    return {};
}

Fold::Fault Fold::take(const job::ReadingTaken& event)
{
    if (const auto fault = checkStation(event.station))
        return fault;
    auto& station = m_state.stations[event.station];
    if (station.reading && !station.voided)
        return MARKED("core", "the station has a reading that was not put aside");
    double compass_deg = event.compass_deg;
    if (station.station.phase == StationPhase::Check && m_state.indexRemoved_deg) {
        // The compass has been turned in its mount since the others were read: they are of one compass again without that.
        compass_deg = wrap360(compass_deg - *m_state.indexRemoved_deg);
        m_state.notes.push_back(
            {MARKED("core", "%1° was read after the compass was turned by %2° in its mount: that is taken off what it read"),
                figureText(station.station.nominal_deg, 0), signedFigureText(*m_state.indexRemoved_deg, 1)});
    }
    station.reading = Observation{MagneticHeading::fromDegrees(event.magnetic_deg), CompassHeading::fromDegrees(compass_deg)};
    station.voided = false;
    station.skipped.clear();
    m_compassNow_deg[event.station] = event.compass_deg;
    m_accepted = false;
    if (station.station.phase == StationPhase::Check)
        m_state.indexLeft.clear(); // A is of the whole check swing
    return {};
}

Fold::Fault Fold::take(const job::ReadingRejected& event)
{
    if (const auto fault = checkStation(event.station))
        return fault;
    auto& station = m_state.stations[event.station];
    if (!station.skipped.empty())
        return takeUpSkipped(station);
    if (!station.reading)
        return MARKED("core", "the station has no reading");
    if (station.correctionsDone > 0)
        return MARKED("core", "a control was turned on this reading");
    station.reading.reset();
    station.voided = false;
    m_accepted = false;
    return {};
}

/// What the compass read before a control was turned nobody can read after that.
Fold::Fault Fold::takeUpSkipped(StationState& station)
{
    const bool beforeTurning = station.station.phase == StationPhase::AsFound || station.station.phase == StationPhase::Correct;
    if (beforeTurning && m_turned)
        return MARKED("core",
            "a control was turned since this heading was skipped, so that it cannot be read as it was found; the check swing reads it");
    station.skipped.clear();
    station.correctionsDone = 0;
    m_accepted = false;
    return {};
}

Fold::Fault Fold::take(const job::StationSkipped& event)
{
    if (const auto fault = checkStation(event.station))
        return fault;
    if (event.reason.empty())
        return MARKED("core", "a station is skipped only with a reason");
    auto& station = m_state.stations[event.station];
    if (station.reading && !station.voided)
        return MARKED("core", "the station has a reading");
    station.reading.reset();
    station.voided = false;
    station.skipped = event.reason;
    return {};
}

/// `%n`: the readings that this made void.
Pattern controlTurned(Control control)
{
    switch (control) {
    case Control::NorthSouth:
        return MARKED_N("core", "the N\u2013S control was turned after %n reading(s) of the check swing: void, and to be read again");
    case Control::EastWest:
        return MARKED_N("core", "the E\u2013W control was turned after %n reading(s) of the check swing: void, and to be read again");
    case Control::Index: break;
    }
    return MARKED_N("core", "the index control was turned after %n reading(s) of the check swing: void, and to be read again");
}

/// What was read before is no longer what the compass does.
void Fold::voidCheckSwing(Control control)
{
    int voided = 0;
    for (auto& station : m_state.stations)
        if ((station.station.phase == StationPhase::Check || station.station.phase == StationPhase::Configuration) && station.reading
            && !station.voided) {
            station.voided = true;
            ++voided;
        }
    if (voided > 0)
        m_state.notes.push_back({controlTurned(control), voided});
    m_state.indexRemoved_deg.reset();
    m_state.indexLeft.clear();
    m_accepted = false;
}

Fold::Fault Fold::take(const job::Adjusted& event)
{
    if (const auto fault = checkStation(event.station))
        return fault;
    auto& station = m_state.stations[event.station];
    if (!station.reading)
        return MARKED("core", "a control is turned only on a station that was read");
    const auto& corrections = station.station.corrections;
    if (station.correctionsDone < corrections.size() && corrections[station.correctionsDone].control == event.control)
        ++station.correctionsDone;
    m_turned = true;
    m_compassNow_deg[event.station] = event.after_deg;
    voidCheckSwing(event.control);
    return {};
}

Fold::Fault Fold::take(const job::NotAdjusted& event)
{
    if (const auto fault = checkStation(event.station))
        return fault;
    auto& station = m_state.stations[event.station];
    if (event.reason.empty())
        return MARKED("core", "a correction is left out only with a reason");
    if (station.correctionsDone == station.station.corrections.size()
        || station.station.corrections[station.correctionsDone].control != event.control)
        return MARKED("core", "this correction does not stand here");
    ++station.correctionsDone;
    return {};
}

bool Fold::checkComplete() const
{
    return std::all_of(m_state.stations.begin(), m_state.stations.end(),
        [](const StationState& station) { return station.station.phase == StationPhase::Configuration || station.done(); });
}

Fold::Fault Fold::take(const job::IndexRemoved& event)
{
    if (!checkComplete())
        return MARKED("core", "the check swing is not complete");
    m_state.indexRemoved_deg = wrap180(event.after_deg - event.before_deg);
    m_accepted = false;
    return {};
}

Fold::Fault Fold::take(const job::IndexLeft& event)
{
    if (event.reason.empty())
        return MARKED("core", "the index is left in only with a reason");
    m_state.indexLeft = event.reason;
    return {};
}

Fold::Fault Fold::take(const job::Accepted&)
{
    findPhase();
    if (m_state.phase != JobPhase::Review && m_state.phase != JobPhase::Card)
        return MARKED("core", "the swing is not complete");
    m_accepted = true;
    return {};
}

Fold::Fault Fold::take(const job::Faulted& event)
{
    if (event.cause.empty())
        return MARKED("core", "a fault has a cause");
    m_state.fault = event.cause;
    return {};
}

Fold::Fault Fold::take(const job::Mended&)
{
    if (m_state.fault.empty())
        return MARKED("core", "there is no fault");
    m_state.fault.clear();
    return {};
}

Fold::Fault Fold::take(const job::Abandoned& event)
{
    m_abandoned = true;
    m_state.abandoned = event.reason;
    return {};
}

Fold::Fault Fold::take(const job::DatumChanged& event)
{
    m_state.datum = event.datum;
    return {};
}

void Fold::findPhase()
{
    m_state.current = -1;
    for (std::size_t i = 0; i < m_state.stations.size() && m_state.current < 0; ++i)
        if (!m_state.stations[i].done())
            m_state.current = static_cast<int>(i);
    const bool indexOpen = indexAfterCheck(m_job.plan.kind) && checkComplete() && !m_state.indexRemoved_deg && m_state.indexLeft.empty();
    if (m_abandoned)
        m_state.phase = JobPhase::Abandoned;
    else if (!m_state.fault.empty())
        m_state.phase = JobPhase::Fault;
    else if (!m_prepared)
        m_state.phase = JobPhase::Prepare;
    else if (indexOpen)
        m_state.phase = JobPhase::Index; // before the further configurations: they are read with the compass as it stays
    else if (m_state.current >= 0)
        m_state.phase = JobPhase::Stations;
    else
        m_state.phase = m_accepted ? JobPhase::Card : JobPhase::Review;
}

/// To take a term T of the deviation out on this heading, the compass is made to read C + T.
void Fold::findTurn()
{
    if (m_state.phase == JobPhase::Index) {
        const auto last = std::find_if(m_state.stations.rbegin(), m_state.stations.rend(),
            [](const StationState& station) { return station.station.phase == StationPhase::Check && station.reading; });
        if (m_state.index_deg && last != m_state.stations.rend()) {
            const double reads = last->reading->compass.degrees();
            m_state.turn
                = MakeCompassRead{Control::Index, HowMuch::CoefficientPart, *m_state.index_deg, reads, wrap360(reads + *m_state.index_deg)};
        } else {
            m_state.whyNoTurn = MARKED("core", "the check swing has too few readings to tell A");
        }
        return;
    }
    if (m_state.phase != JobPhase::Stations)
        return;
    const StationState& here = m_state.stations[m_state.current];
    if (!here.reading || here.voided || here.correctionsDone == here.station.corrections.size())
        return;
    const Turn& turn = here.station.corrections[here.correctionsDone];
    const double reads = m_compassNow_deg[m_state.current];
    if (turn.removal != HowMuch::CoefficientPart) {
        const double part
            = deviationOf(here.reading->magnetic, here.reading->compass).degrees() * (turn.removal == HowMuch::Half ? 0.5 : 1.0);
        m_state.turn = MakeCompassRead{turn.control, turn.removal, part, reads, wrap360(reads + part)};
        return;
    }
    const auto coefficient = classicalCoefficient_deg(m_state.stations, turn.control);
    if (!coefficient) {
        m_state.whyNoTurn = MARKED("core", "a cardinal heading was skipped, so that the coefficient cannot be told by the classical rule");
        return;
    }
    const double nominal = toRadians(here.station.nominal_deg);
    const double share
        = turn.control == Control::Index ? 1.0 : std::round(turn.control == Control::NorthSouth ? std::cos(nominal) : std::sin(nominal));
    m_state.turn = MakeCompassRead{turn.control, turn.removal, *coefficient, reads, wrap360(reads + *coefficient * share)};
}

} // namespace

int JobState::done() const
{
    return static_cast<int>(std::count_if(stations.begin(), stations.end(), [](const StationState& station) { return station.done(); }));
}

Result<JobState> stateOf(const SwingJob& job) { return Fold(job).run(); }

} // namespace lubberline
