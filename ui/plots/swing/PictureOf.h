#pragma once
/// The picture of a swing from its record and its results: the same for the window and for paper.

#include "core/record/Fleet.h"
#include "core/swing/Observations.h"
#include "ui/plots/swing/SwingPicture.h"

namespace lubberline::ui {

/// @param analysis of the record's used readings in their order (observationsOf()); null when they allow none, and
///        `whyNoAnalysis` then says why. An analysis of other readings is a broken contract.
/// @param previous results of the last swing of the same compass, null without one; `previousLabel` is its date.
/// Complete readings only: what is still being entered is not drawn. Excluded ones are, and are never suspect.
[[nodiscard]] SwingPicture pictureOf(const SwingRecord& record, std::shared_ptr<const Analysis> analysis, const QString& whyNoAnalysis,
    std::shared_ptr<const Analysis> previous, const QString& previousLabel, AngleStyle style);

} // namespace lubberline::ui
