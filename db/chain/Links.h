#pragma once
/// The audit trail as a hash chain. Each entry has two links, SHA-256 in hexadecimal digits:
///   its record's: of the link before it on the same record, and of the entry itself, number and all;
///   its file's: of the link before it in the file (of the first: the file's own RecordId), and of the record's link.
/// So a changed entry contradicts its own link and no other, and one that was taken out, put in or moved leaves the file's without its
/// neighbour. The head of the file covers every record's.

#include <cstdint>
#include <string>

#include "db/engine/Database.h"

namespace lubberline::db {

struct ChainEntry {
    std::int64_t id = 0;
    std::string timeUtc, what, record, detail;
};

[[nodiscard]] std::string sha256(const std::string& text);
/// @param before of the same record; empty: this is its first
[[nodiscard]] std::string recordLink(const std::string& before, const ChainEntry& entry);
/// @param before of the file
[[nodiscard]] std::string fileLink(const std::string& before, const std::string& recordLink);

/// What the file says of its chain.
struct ChainHead {
    std::string file;         ///< RecordId of this database; its copies have the same
    std::int64_t entries = 0; ///< the number of the last
    std::string head;         ///< the last file link; the file's RecordId while there is none
    std::int64_t before = 0;  ///< so many entries were there when the chain began: what happened until then it does not tell
    std::string sinceUtc;     ///< when it began
};
/// Errors: Corrupt (no such row).
Result<ChainHead> chainHead(const Database& database);
/// The last link of a record; empty: it has no entry.
Result<std::string> recordHead(const Database& database, const std::string& record);

/// Chains what is in the audit trail already: for the migration that begins it.
Result<void> beginChain(const Database& database);

} // namespace lubberline::db
