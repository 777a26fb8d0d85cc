#pragma once
/// Who answers for a swing. Signatures are only ever added.

#include <string>
#include <vector>

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
    friend bool operator==(const Signature&, const Signature&) = default;
};

/// Whether these signatures freeze a swing, of which those hold that `hold` says (in their order): two people stand over the same contents, one who did it and one
/// who answers for it having been checked (an inspector or the authority).
[[nodiscard]] bool freezes(const std::vector<Signature>& signatures, const std::vector<bool>& hold);

} // namespace lubberline
