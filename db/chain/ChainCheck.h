#pragma once
/// Whether the audit trail is what was written: each break is named.

#include <vector>

#include "db/chain/Links.h"

namespace lubberline::db {

/// A file link that somebody has noted, and where: the trail must hold it.
struct NotedHead {
    std::string head; ///< or its first digits, twelve or more
    Message where;    ///< "the signature of Ada"
};

struct ChainReport {
    std::vector<Message> findings; ///< entries that were changed, taken out, put in or moved; heads that are not there
    std::vector<Message> notes;    ///< what is no fault: a clock that was set back, where the chain begins
};

/// Of the whole file. Errors: those of a damaged file.
Result<ChainReport> checkChain(const Database& database, const std::vector<NotedHead>& noted);
/// Of one record's entries alone: quick enough for a page.
Result<std::vector<Message>> checkRecordChain(const Database& database, const std::string& record);

} // namespace lubberline::db
