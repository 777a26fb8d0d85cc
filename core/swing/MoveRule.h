#pragma once

#include <string>

#include "core/base/Result.h"
#include "core/record/Fleet.h"
#include "core/record/SwingJob.h"

namespace lubberline {

/// Whether a compass that was last swung at one base is to be swung again at another: by what its last swing predicts there
/// (core/swing/Prediction.h, swingAgainAfterMove). @param today UTC. @param job the guided swing
/// that the last one came from, or none.
/// @return the reason; empty: it is predicted to stay as it is.
/// Errors: InvalidInput: the new base has no position, or the last swing tells too little (says what).
Result<Message> whySwingAfterMove(const SwingRecord& last, const Site& base, Date today, const SwingJob* job = nullptr);

} // namespace lubberline
