#pragma once
/// What stands behind a signature with a key: judged by the station's list, as of when it was made.

#include <vector>

#include "core/record/Signature.h"
#include "core/record/SigningKey.h"
#include "db/openpgp/Gpg.h"

namespace lubberline::db {

/// A prepared signature with what its key makes of it. Errors: those of gpg.
Result<Signature> signedBy(Signature prepared, const std::string& content, const Progress& progress, const GpgOptions& options = {});

/// @param content  what it stands for (signedContent())
KeyVerdict verdictOn(const Signature& signature, const std::string& content, const std::vector<StationKey>& station,
    const Progress& progress, const GpgOptions& options = {});

} // namespace lubberline::db
