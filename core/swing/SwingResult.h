#pragma once
/// The one result of a recorded swing: page, card, report and command show the same figures with the same uncertainty.

#include "core/record/Fleet.h"
#include "core/record/SwingJob.h"
#include "core/swing/Analysis.h"
#include "core/swing/SensorBench.h"

namespace lubberline {

/// The curve of coefficients that were kept as figures, as fitApproximate() gives them [deg]. An A beyond kLargeIndex_deg is that of a compass
/// that is far out as a whole: B to E are those of the compass turned right by its index, which is A to a degree or so. None: fewer than
/// five are known.
[[nodiscard]] std::optional<ApproximateSmith> smithOfKept(std::span<const std::optional<double>, kCoefficientCount> coefficient_deg);

/// How a compass is expected to deviate at a swing after another whose coefficients are known: as in curveAfter(); where it was compensated
/// in between (a correction swing, or one as found before one as left), A, B and C may be any.
[[nodiscard]] ExpectedCurve expectedAfter(const ApproximateSmith& last, SwingKind kindOfLast, SwingStage stageOfLast, const Swing& swing);

/// What a result is computed from: asked on one thread, it may be answered on another.
struct SwingQuestion {
    std::vector<Observation> readings; ///< those that count, as the compass stands since (core/swing/Observations.h)
    AnalysisOptions options;
    std::vector<Message> words = {}; ///< what the result says besides: the part of the sensor's bench in its errors
};

/// The options with the reading error (core/swing/ReadingError.h) of the smallest division of the compass and, after a guided swing, of
/// its datum: readings that happen to lie on a curve are no surer than they were read. The sensor's bench adds what the sensor itself leaves
/// uncertain in the field of the swing. @param job the guided swing that it came from, or none. @param bench of the sensor before the swing,
/// or none.
[[nodiscard]] SwingQuestion questionOf(const SwingRecord& record, const SwingJob* job = nullptr, const AnalysisOptions& options = {},
    const std::optional<SensorBench>& bench = {});
/// The analysis, with what the gaps between the readings leave unknown. Errors: those of analyse().
Result<Analysis> answerTo(const SwingQuestion& question, const Progress& progress = {});
/// Both at once.
Result<Analysis> resultOf(const SwingRecord& record, const SwingJob* job = nullptr, const AnalysisOptions& options = {},
    const std::optional<SensorBench>& bench = {});

/// The division that a file's figures speak of, where nobody states it: the coarsest of 1°, 0.5° and 0.1° of which every compass
/// heading that was read is a multiple; 0.1 too where they are finer: what was computed or sent with more decimals was not read better, and
/// a swing is as sure as its compass, not as its print. Of no readings: 1.
[[nodiscard]] double divisionOf_deg(const Swing& swing);

} // namespace lubberline
