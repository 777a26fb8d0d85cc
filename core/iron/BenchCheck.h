#pragma once
/// Whether a bench can be computed, and where its moving parts are.

#include <cmath>
#include <string>
#include <vector>

#include "core/base/Result.h"
#include "core/iron/FerrousPart.h"

namespace lubberline {

/// Nearer than this to a wire the field is that of the wire's own thickness, which nobody has told [m].
inline constexpr double kLeastWireDistance_m = 1e-3;
/// More slender or flatter bodies are no solid parts.
inline constexpr double kMostSlender = 1e4;
/// Everything is within this of the datum point [m].
inline constexpr double kBenchReach_m = 1e3;

/// Each part's own values, whatever the states; the name of the part is in the message.
/// Errors: InvalidInput (no name, sizes ≤ 0 or too unequal, χ < 0, no placement, states of a group doubled or unnamed, not
/// finite).
Result<void> checkPart(const FerrousPart& part);
/// Errors: InvalidInput (no name, no conductor, normal of no length, turns < 1, a path of one point, not finite).
Result<void> checkCircuit(const BenchCircuit& circuit);
/// All parts and circuits, and that the parts of a group have all its states.
Result<void> checkBench(const IronBench& bench);

/// The placement of each part in the chosen states. @pre checkBench(). Errors: InvalidInput (no such group or state: names
/// those that there are).
Result<std::vector<Placement>> placementsIn(const IronBench& bench, const BenchStates& states);

} // namespace lubberline
