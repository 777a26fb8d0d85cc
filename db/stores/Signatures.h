#pragma once
/// Private to db: the signatures of swings.

#include <map>
#include <vector>

#include "core/record/Id.h"
#include "core/record/Signature.h"
#include "db/engine/Database.h"

namespace lubberline::db {

Result<std::vector<Signature>> signaturesOf(Database& database, SwingId swing); ///< in the order in which they were given
Result<std::map<SwingId, std::vector<Signature>>> allSignatures(Database& database);
Result<void> addSignature(Database& database, SwingId swing, const Signature& signature); ///< inside the caller's transaction

} // namespace lubberline::db
