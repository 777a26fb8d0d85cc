#pragma once
/// Where swings stand: guided ones that were begun and not finished, for every place that offers to go on with one; and whether those that
/// say that they are signed are.

#include <QString>

#include <vector>

#include "core/record/SwingJob.h"
#include "db/stores/Stores.h"
#include "db/stores/SwingMarks.h"

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

/// "signed", and of one that says so alone that it is not: what every list and page says of a swing's state.
[[nodiscard]] QString stateWords(SwingState state, db::SignedMark mark);

/// Why a guided swing that a draft was begun with was abandoned; empty: it has none, or was not.
[[nodiscard]] QString abandonedWords(db::Stores& stores, SwingId swing);

} // namespace lubberline::ui
