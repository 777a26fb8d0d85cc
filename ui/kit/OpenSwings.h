#pragma once
/// Guided swings that were begun and not finished, and where each stands: for every place that offers to go on with one.

#include <QString>

#include <vector>

#include "core/record/SwingJob.h"
#include "db/stores/Stores.h"

namespace lubberline::ui {

struct OpenSwing {
    SwingId swing;
    CompassId compass;
    QString whose; ///< "7904 · standby"
    QString words; ///< "7904 standby stands at step 8 of 12: go on"
};

/// Newest first. Errors: those of the store; one that does not read is offered all the same: its page says what is wrong.
Result<std::vector<OpenSwing>> openSwings(db::Stores& stores);

/// Whether it is one of them.
[[nodiscard]] bool isOpenJob(db::Stores& stores, SwingId swing);

/// "step 8 of 12", "its preparation"; of an abandoned one with the reason.
[[nodiscard]] QString standingWords(const SwingJob& job);

/// Why a guided swing that a draft was begun with was abandoned; empty: it has none, or was not.
[[nodiscard]] QString abandonedWords(db::Stores& stores, SwingId swing);

} // namespace lubberline::ui
