#include "core/record/Signature.h"

#include <algorithm>

namespace lubberline {

bool freezes(const std::vector<Signature>& signatures, const std::string& hash)
{
    const auto given = [&](SignatureRole role) {
        return std::any_of(
            signatures.begin(), signatures.end(), [&](const Signature& one) { return one.role == role && one.hash == hash; });
    };
    return given(SignatureRole::Performer) && (given(SignatureRole::Inspector) || given(SignatureRole::Authority));
}

} // namespace lubberline
