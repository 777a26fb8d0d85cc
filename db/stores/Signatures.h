#pragma once
/// Private to db: the signatures of swings as rows.

#include <map>
#include <vector>

#include "core/record/Id.h"
#include "core/record/Signature.h"
#include "db/engine/Database.h"

namespace lubberline::db {

Result<std::vector<Signature>> signaturesOf(Database& database, SwingId swing); ///< in the order in which they were given
Result<std::map<SwingId, std::vector<Signature>>> allSignatures(Database& database);
std::vector<Message> damagedSignatures(Database& database); ///< for damagedRows()

/// What the audit trail says of a signature that is given here, that comes with an import, or that was there when the trail became a
/// chain. Each row has one such entry, and each entry a row.
inline constexpr const char* kSigned = "signed swing";
inline constexpr const char* kSignedElsewhere = "imported signature";
inline constexpr const char* kSignedBefore = "kept signature";
[[nodiscard]] std::string auditText(const Signature& signature);

/// In a query, of the swing s: that it is signed, and by somebody, or was so before signatures were kept. Of what was not checked: whether
/// signatures stand, only signedMark() tells (SwingMarks.h).
[[nodiscard]] QString somebodySigned();
/// With its entry `what` in the trail of the swing's `record`; inside the caller's transaction.
Result<void> addSignature(Database& database, SwingId swing, const RecordId& record, const Signature& signature, const char* what);

} // namespace lubberline::db
