#pragma once
/// The order of a swing on the ramp: where to turn to, and what to do there.
///   coefficient method [worksheet to CAP 562]: N, E, S (C is removed there), W (B is removed there), then the check swing from
///   NW on half-error method [Barfield 56-101-01200]: N and E: all is removed; S and W: half; then the check swing index first
///   [procedures 3.5]: N, E, S, W; the mount is turned by the mean; W: B, N: C; then the check swing flux valve [Duncan
///   Aviation, MIL-STD-765A practice]: N, E, S, W untouched; the valve is turned by the mean; N: C, E: B; check swing check
///   only: the check swing alone; nothing is touched

#include <vector>

#include "core/record/SwingPlan.h"

namespace lubberline {

enum class StationPhase { AsFound, Correct, Check, Configuration };

/// One stop of the aircraft.
struct Station {
    StationPhase phase = StationPhase::AsFound;
    double nominal_deg = 0;        ///< magnetic
    std::vector<Turn> corrections; ///< in the order in which they are made here
    int configuration = 0;         ///< 0: the main one; else of PlanOptions::configurations
    friend bool operator==(const Station&, const Station&) = default;
};

/// The stations in their order. After the last correction the check swing begins one step clockwise of it, so that no leg is
/// towed twice.
[[nodiscard]] std::vector<Station> planOf(const PlanOptions& options);

/// Whether the index (A) is removed after the check swing; index-first and flux valve have done it before.
[[nodiscard]] bool indexAfterCheck(ProcedureKind kind);

/// How far from its nominal heading an aircraft may stand and still be read there: half of the step between check points [deg]. Beyond,
/// it is the neighbouring station's reading.
[[nodiscard]] double reachOfStation_deg(const PlanOptions& options);

} // namespace lubberline
