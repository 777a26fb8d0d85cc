#pragma once
/// The result object that every page, card, report and command shows.

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/Progress.h"
#include "core/deviation/Harmonics.h"
#include "core/deviation/PointRules.h"
#include "core/deviation/SmithFit.h"
#include "core/deviation/SwingSlips.h"
#include "core/record/SharedErrors.h"
#include "core/record/Site.h"

namespace lubberline {

struct AnalysedReading {
    MagneticHeading magnetic;
    CompassHeading compass;
    Deviation deviation;
    std::optional<double> residualApproximate_rad;
    std::optional<double> residualExact_rad;
    std::optional<double> studentised; ///< external, of the approximate fit
    bool suspect = false;              ///< among the slips that were found; never dropped by itself
};

/// Whether it is the result of a reading with these headings, and not of what stood in its place before.
[[nodiscard]] bool isOf(const AnalysedReading& analysed, const Observation& reading);

struct Summary {
    double maxAbsDeviation_rad = 0;
    double largestDeviation_rad = 0; ///< the same with its sign
    MagneticHeading maxAbsDeviationAt;
    double rmsDeviation_rad = 0;
    double minDeviation_rad = 0; ///< signed; of a compass far out as a whole about its index, also beyond half a turn
    double maxDeviation_rad = 0;
    double unread_deg = 360; ///< the widest arc of magnetic heading on which nothing was read
    [[nodiscard]] double spread_rad() const { return maxDeviation_rad - minDeviation_rad; }
};

struct Analysis {
    std::vector<AnalysedReading> readings; ///< in the order given
    ApproximateFit approximate;
    ExactFit exact;
    std::optional<PointRules> pointRules;
    Harmonics harmonics;
    Summary summary;
    SlipSearch slips;              ///< which readings were probably misread; the rest of Analysis takes them as they were read
    SharedErrors shared;           ///< what is in the standard errors besides the scatter
    std::vector<Message> warnings; ///< what the readings cannot tell, in words
};

struct AnalysisOptions {
    int maxOrder = -1;                         ///< highest harmonic wanted; negative: all that the headings resolve
    double resolution_deg = 1.0;               ///< smallest division of the compass
    double readingError_rad = 0;               ///< of one deviation (core/swing/ReadingError.h): what a fit cannot be surer than
    SharedErrors shared = {};                  ///< what no scatter of the readings shows
    bool findSlips = true;                     ///< whether misread figures are looked for
    std::optional<ExpectedCurve> history = {}; ///< of the compass by its last swing: what misread figures are told by besides
};

/// Errors: InvalidInput (fewer than 3 readings; fewer than 3 distinct headings; a compass that is stuck or runs backwards); Cancelled.
Result<Analysis> analyse(std::span<const Observation> readings, const AnalysisOptions& options = {}, const Progress& progress = {});

/// What is kept beside a stored swing: of an Analysis the figures that trees and histories show, without errors, spectrum and slips,
/// which cost nearly all of its time.
struct SwingOutline {
    std::array<std::optional<double>, kCoefficientCount> approximate_rad;
    Summary summary;
};
/// Errors: those of analyse().
Result<SwingOutline> outlineOf(std::span<const Observation> readings);

enum class Verdict { InLimits, OutOfLimits, NotKnown };
/// Four cardinals, each with the aircraft within some degrees of them, judge a compass; a wider arc without a reading may hide anything.
inline constexpr double kMostUnread_deg = 110;

struct Judgement {
    Verdict verdict = Verdict::NotKnown; ///< not known: no limits, or within them where it was read, and not read all around
    bool partlyRead = false;             ///< the latter
    double maxAbsDeviation_deg = 0;
    double spread_deg = 0;
};

/// Holds what was read against a limits profile; NotKnown without a profile or when it sets no limit.
[[nodiscard]] Judgement judge(const Summary& summary, const std::optional<LimitsProfile>& limits);

} // namespace lubberline
