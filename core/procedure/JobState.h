#pragma once
/// Where a guided swing stands, and what is to be done now: computed from its events, never stored.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/Result.h"
#include "core/deviation/Smith.h"
#include "core/procedure/Plan.h"
#include "core/record/SwingJob.h"

namespace lubberline {

enum class JobPhase { Prepare, Stations, Index, Review, Card, Fault, Abandoned };

struct StationState {
    Station station;
    std::optional<Observation> reading; ///< that counts
    std::string skipped;                ///< why; empty: it is not
    std::size_t correctionsDone = 0;    ///< of station.corrections, made or refused
    bool voided = false;                ///< read before a later adjustment: to be read again
    [[nodiscard]] bool done() const { return (!skipped.empty() || (reading && correctionsDone == station.corrections.size())) && !voided; }
};

/// A control to be turned now.
struct MakeCompassRead {
    Control control = Control::NorthSouth;
    HowMuch removal = HowMuch::CoefficientPart;
    double coefficient_deg = 0; ///< A, B or C, or the whole or half deviation that is taken out; east positive
    double compassReads_deg = 0;
    double makeCompassRead_deg = 0;
};

struct JobState {
    JobPhase phase = JobPhase::Prepare;
    std::vector<StationState> stations;
    int current = -1;                       ///< station; −1: none
    std::vector<std::string> openItems;     ///< of the checklist
    std::optional<MakeCompassRead> turn;    ///< what to turn now; none: read, or nothing to turn
    Message whyNoTurn;                      ///< a correction stands here but cannot be computed (a cardinal was skipped)
    std::optional<double> index_deg;        ///< A of the check swing's cardinals (or of the mean); none before it is complete
    std::optional<double> indexRemoved_deg; ///< what was taken out by turning the compass after the check swing
    std::string indexLeft;                  ///< why it was left in
    std::string fault;
    std::string abandoned;      ///< why; empty: it is not, or nobody said
    DatumInstrument datum;      ///< that the next reading is made with
    std::vector<Message> notes; ///< what was voided by what
    [[nodiscard]] int done() const;
};

/// Errors: InvalidInput: an event that cannot have happened there (names it and its place in the list): a damaged or foreign
/// job.
Result<JobState> stateOf(const SwingJob& job);

/// What the events make of the job's readings. As found: the cardinals before any control was turned.
[[nodiscard]] Swing asFoundSwing(const SwingJob& job, const JobState& state);
/// The check swing as it was read; an index that was removed afterwards stands beside it (Swing::indexRemoved_deg).
[[nodiscard]] Swing asLeftSwing(const SwingJob& job, const JobState& state, int configuration = 0);
/// The swings that a guided swing makes besides its main one (as left): as found where something was corrected, and each further
/// configuration. What can be complete is: nothing is added to it any more. Their ids and records are not valid yet.
/// @param today ISO 8601.
[[nodiscard]] std::vector<Swing> furtherSwings(const SwingJob& job, const JobState& state, const Swing& main, Date today);

/// STEER = FOR − (deviation − A) at every check heading, as the worksheet has it.
struct ResidualRow {
    double nominal_deg = 0;
    double deviation_deg = 0; ///< as read
    double residual_deg = 0;  ///< deviation − the index that was removed
    double steer_deg = 0;     ///< of the nominal heading, [0, 360)
};
[[nodiscard]] std::vector<ResidualRow> residualsOf(const JobState& state, int configuration = 0);

} // namespace lubberline
