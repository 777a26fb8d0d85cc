#pragma once
/// The keys that the station knows. Whose key it is says who adds it, having seen the person; the audit trail keeps that.

#include <vector>

#include "core/record/SigningKey.h"
#include "db/engine/Database.h"

namespace lubberline::db {

/// 40 or 64 capital hexadecimal digits.
[[nodiscard]] bool isFingerprint(const std::string& text);

class KeyStore {
public:
    explicit KeyStore(Database& database) : m_database(database) {}

    Result<std::vector<StationKey>> all(); ///< by their holders
    /// A key that is known already is replaced: its newer copy may say that it was revoked. Time is made here.
    /// Errors: InvalidInput (no holder, a fingerprint that is none), Conflict (the key is another's).
    Result<void> put(StationKey key);
    /// By its fingerprint or the end of it, eight digits or more. Errors: NotFound, Conflict (several).
    Result<StationKey> remove(const std::string& fingerprint);

private:
    Database& m_database;
};

} // namespace lubberline::db
