#pragma once
/// The one result of a recorded swing: page, card, report and command show the same figures with the same uncertainty.

#include "core/record/Fleet.h"
#include "core/record/SwingJob.h"
#include "core/swing/Analysis.h"

namespace lubberline {

/// Of the readings that count, as the compass stands since (core/swing/Observations.h). Standard errors always have the reading
/// error in them (core/swing/ReadingError.h), from the smallest division of the compass and, after a guided swing, of its datum:
/// readings that happen to lie on a curve are no surer than they were read. @param job the guided swing that it came from, or none.
/// Errors: those of analyse().
Result<Analysis> resultOf(const SwingRecord& record, const SwingJob* job = nullptr, const AnalysisOptions& options = {});

/// The division that a file's figures speak of, where nobody states it: the coarsest of 1°, 0.5°, 0.1° and 0.01° of which every
/// compass heading that was read is a multiple; 0.01 too where they are finer (computed figures). Of no readings: 1.
[[nodiscard]] double divisionOf_deg(const Swing& swing);

} // namespace lubberline
