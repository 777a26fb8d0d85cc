#include "core/record/Signature.h"

#include "core/base/Contract.h"

namespace lubberline {

bool freezes(const std::vector<Signature>& signatures, const std::vector<bool>& hold)
{
    LUBBERLINE_EXPECT(signatures.size() == hold.size(), "each signature holds or does not");
    const auto given = [&](SignatureRole role) {
        for (std::size_t i = 0; i < signatures.size(); ++i)
            if (signatures[i].role == role && hold[i])
                return true;
        return false;
    };
    return given(SignatureRole::Performer) && (given(SignatureRole::Inspector) || given(SignatureRole::Authority));
}

} // namespace lubberline
