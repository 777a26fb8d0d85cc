#pragma once
/// What is known of a signature when somebody looks at it.

#include <vector>

#include "core/record/Signature.h"
#include "core/record/SigningKey.h"
#include "core/record/SwingDifferences.h"

namespace lubberline {

struct SignatureState {
    bool holds = false; ///< its hash is that of what the record says now
    /// What is printed otherwise today than when it was signed: by a change that the audit trail knows, while it holds.
    std::vector<SwingDifference> since = {};
    KeyVerdict key = {}; ///< of OpenPGP; NotChecked until somebody asked (SigningStore::verdicts())
    friend bool operator==(const SignatureState&, const SignatureState&) = default;
};

[[nodiscard]] inline std::vector<bool> holding(const std::vector<SignatureState>& states)
{
    std::vector<bool> hold;
    for (const auto& one : states)
        hold.push_back(one.holds && !isForged(one.key));
    return hold;
}

} // namespace lubberline
