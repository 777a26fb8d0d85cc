#pragma once
/// Who answers for a swing. Signatures are only ever added.

#include <string>
#include <vector>

#include "core/base/Message.h"

namespace lubberline {

enum class SignatureRole {
    Performer, ///< swung and adjusted the compass
    Inspector, ///< checked the work independently
    Authority, ///< released the card (an airworthiness or plant authority, where one asks for it)
};

struct Signature {
    SignatureRole role = SignatureRole::Performer;
    std::string name;    ///< never empty
    std::string licence; ///< licence, stamp or service number
    std::string timeUtc; ///< ISO 8601
    std::string hash;    ///< SHA-256 of what was signed (core/format/exchange/SignedContent.h), 64 hexadecimal digits
    int contents = 1;    ///< by which version of that
    // From version 3 of the contents on; an older signature has none of them.
    std::string file = {};        ///< RecordId of the database in which it was given
    std::string fileHead = {};    ///< of that database's audit trail just before, 64 hexadecimal digits
    std::string recordHead = {};  ///< likewise of the swing's own
    std::string particulars = {}; ///< exchange JSON of what is printed beside the swing, as it was then (signedParticulars())
    std::string key = {};         ///< OpenPGP fingerprint, capital hexadecimal digits; empty: a name that nobody has verified
    std::string publicKey = {};   ///< that key, in ASCII armour
    std::string openPgp = {};     ///< detached signature over the signed content, in ASCII armour
    /// Whether there is something for OpenPGP to verify.
    [[nodiscard]] bool hasKey() const { return !key.empty() || !openPgp.empty(); }
    friend bool operator==(const Signature&, const Signature&) = default;
};

/// Whether these signatures freeze a swing, of which those hold that `hold` says (in their order): two people stand over the same contents, one who did it and one
/// who answers for it having been checked (an inspector or the authority).
[[nodiscard]] bool freezes(const std::vector<Signature>& signatures, const std::vector<bool>& hold);

/// Whether two names are one person's: the same letters and figures, whatever their case, spaces and points.
[[nodiscard]] bool samePerson(const std::string& one, const std::string& other);

/// Why this one may not be given beside those that hold: nobody answers for work that he did himself. The performer is another
/// person than the inspector and the authority, by name, by licence and by key, and so are the adjuster and the inspector whom the swing
/// names. Empty: it may.
[[nodiscard]] Message whyNotSign(const Signature& signature, const std::vector<Signature>& signatures, const std::vector<bool>& hold,
    const std::string& adjuster, const std::string& inspector);

} // namespace lubberline
