#pragma once
/// Private to db: whether signatures stand over what is stored.

#include "core/base/Progress.h"
#include "core/record/Fleet.h"
#include "core/record/SignatureState.h"
#include "db/chain/ChainCheck.h"

namespace lubberline::db {

/// Of each signature of the record, in their order: its hash alone, without the audit trail. What is printed otherwise than it was
/// signed stands in `since`, and does not count.
[[nodiscard]] std::vector<SignatureState> statesBy(const SwingRecord& record, const std::optional<SwingJob>& job);

/// Likewise of a stored one; what is printed otherwise must be a change that the trail knows, or the signature does not hold.
Result<std::vector<SignatureState>> statesIn(Database& database, const SwingRecord& record, const std::optional<SwingJob>& job);

/// Whether a swing that has no signatures was signed before signatures were kept: an entry from before the trail's chain says that it was
/// frozen, and none names a signature. Of any other such swing nobody knows who signed it, if anybody did.
Result<bool> signedBeforeSignatures(Database& database, const RecordId& record);

/// Signatures and the trail, held against each other for all swings. @return what is wrong; adds the heads that signatures given
/// in this file name, and to `notes` what is no fault: keys that the station does not know.
Result<std::vector<Message>> signatureFaults(
    Database& database, std::vector<NotedHead>& heads, std::vector<Message>& notes, const Progress& progress);

} // namespace lubberline::db
