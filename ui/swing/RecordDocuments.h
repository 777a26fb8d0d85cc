#pragma once
/// What the documents of a stored swing are made of: for the window, on a worker, and for the command line. Where a signature has a key, gpg is
/// asked, and `progress` with it: Cancelled when it says so.

#include "db/stores/Stores.h"
#include "ui/report/card/CardDocument.h"
#include "ui/report/forms/JobCard.h"
#include "ui/report/forms/StyleSheet1613.h"
#include "ui/report/swing/Report.h"

namespace lubberline::ui {

/// With last time's swing, the sensor models of the compass, the guided swing that made it, and what it amends.
/// Errors: those of the stores; InvalidInput when the readings allow no result: it says why.
Result<ReportInput> reportOf(db::Stores& stores, SwingId id, const QString& madeAtUtc, const Progress& progress = {});
/// Whether the signatures of a swing stand over what it says now, and whether a signed revision amends it.
struct SignedStanding {
    bool holds = false, superseded = false;
};
/// Asks no gpg. @param verdicts what is known of the keys: of none, of each.
Result<SignedStanding> standingOf(db::Stores& stores, const SwingRecord& record, const std::vector<KeyVerdict>& verdicts);
/// With a second STEER column where the compass was swung in the same week with the radio in the other state; with the day on
/// which the next swing falls due; of a signed swing whose card was written before as a reprint when `again`. Each column says whether its
/// own swing is signed.
Result<CardInput> cardOf(db::Stores& stores, SwingId id, const CardOptions& options, const QString& madeAtUtc, bool again = false,
    const Progress& progress = {});
/// Notes that the signed cards of it were written: the next ones are reprints.
Result<void> noteCards(db::Stores& stores, const CardInput& input);
/// The blank form of the guided swing, or of the usual procedure where it is none.
Result<JobCardInput> jobCardOf(db::Stores& stores, SwingId id, const QString& madeAtUtc);
/// With the compensating swing: that of the guided swing, else the last as-found swing of the compass in the week before.
Result<StyleSheet1613> sheet1613Of(db::Stores& stores, SwingId id, const QString& madeAtUtc, const Progress& progress = {});

} // namespace lubberline::ui
