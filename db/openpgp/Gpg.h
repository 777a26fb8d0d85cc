#pragma once
/// OpenPGP through the program gpg, which knows cards, agents and pass phrases. Each call runs it and waits: on a worker, not on the
/// window's thread. `progress` is asked ten times a second; it cancels by saying false.

#include <QString>
#include <QStringList>

#include <optional>
#include <string>
#include <vector>

#include "core/base/Progress.h"
#include "core/base/Result.h"

namespace lubberline::db {

struct OpenPgpKey {
    std::string fingerprint; ///< of the primary key
    std::string userId;      ///< "Ada <ada@station.example>"
    bool revoked = false;
    std::optional<std::int64_t> expires_s; ///< of the primary key; seconds of Unix time
};

struct GpgOptions {
    QString program = "gpg";
    int timeout_ms = 120000; ///< somebody may have to type a pass phrase or find his card
};

/// Those of the user's own key ring that can sign. Errors: NotFound (no gpg), Io (it failed: its words), Cancelled, Locked (time out).
Result<std::vector<OpenPgpKey>> secretKeys(const Progress& progress, const GpgOptions& options = {});
/// In ASCII armour. Errors: besides those, NotFound (no such key).
Result<std::string> publicKeyOf(const std::string& fingerprint, const Progress& progress, const GpgOptions& options = {});
/// A detached signature over the text, in ASCII armour. Errors: those above.
Result<std::string> signDetached(
    const std::string& text, const std::string& fingerprint, const Progress& progress, const GpgOptions& options = {});

/// The primary keys in a file of public keys. Errors: Format (none).
Result<std::vector<OpenPgpKey>> keysIn(const std::string& publicKeys, const Progress& progress, const GpgOptions& options = {});

/// What gpg says of a signature, with these public keys and no others.
struct OpenPgpCheck {
    enum class State { Whole, Bad, NoKey };
    State state = State::Bad;
    std::string fingerprint; ///< of the primary key that made it
    std::string userId;
    std::int64_t made_s = 0;               ///< when, by the clock of who made it; seconds of Unix time
    bool revoked = false;                  ///< that key, or the subkey that signed
    std::optional<std::int64_t> expires_s; ///< likewise, the earlier of both
};
/// Errors: those of running gpg.
Result<OpenPgpCheck> verifyDetached(const std::string& text, const std::string& signature, const std::string& publicKeys,
    const Progress& progress, const GpgOptions& options = {});

} // namespace lubberline::db
