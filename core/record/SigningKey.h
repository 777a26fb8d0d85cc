#pragma once
/// Keys that sign, as OpenPGP names them, and what is known of a signature that one of them made.

#include <string>

#include "core/base/Message.h"

namespace lubberline {

/// A key that the station knows: a signature by another is told as "key not known".
struct StationKey {
    std::string fingerprint; ///< capital hexadecimal digits, 40 or 64
    std::string holder;      ///< whose it is, as he signs
    std::string publicKey;   ///< in ASCII armour
    std::string addedUtc;    ///< ISO 8601
    friend bool operator==(const StationKey&, const StationKey&) = default;
};

enum class KeyState {
    NameOnly,    ///< no key: nobody has verified the name
    Good,        ///< a known key made it, and it was in force then
    NotKnown,    ///< whole, by a key that is not on the station's list
    OtherHolder, ///< whole, by the known key of somebody of another name
    Expired,     ///< the key was no longer in force when it was made
    Revoked,     ///< the key was revoked
    Bad,         ///< not over what the record says, or not by that key
    NotChecked,  ///< not looked at, or it could not be
};

/// What is known of the key behind a signature.
struct KeyVerdict {
    KeyState state = KeyState::NotChecked;
    Message words = {}; ///< for people, with the key and its holder
    friend bool operator==(const KeyVerdict&, const KeyVerdict&) = default;
};

/// Whether the name is verified: a known key that was in force, of somebody of that name.
[[nodiscard]] inline bool isVerified(const KeyVerdict& verdict) { return verdict.state == KeyState::Good; }
/// Whether it speaks against the signature itself.
[[nodiscard]] inline bool isForged(const KeyVerdict& verdict) { return verdict.state == KeyState::Bad; }

} // namespace lubberline
