#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/Result.h"
#include "core/record/Fleet.h"
#include "core/record/SwingDifferences.h"

namespace lubberline {

/// What a signature stands for, as text; its hash is the SHA-256 of these bytes (UTF-8), and an OpenPGP signature is made over them.
/// Versions: 1 is the swing with its readings and guided swing as exchange JSON, and by their RecordIds the compass, the aircraft and
/// the site; 2 says first that it is signed content, and of which version. 3 covers all that is printed: who signs, as what, when
/// and with which key; every signature given before it; the heads of the audit trail; type, aircraft, compass, site and limits as
/// they were then. The state of the swing is part of none.
/// What was signed by an older version is verified by that version, for ever: the text of a version never changes.
inline constexpr int kSignedContents = 3; ///< what is signed today

/// By the signature's own version. @param before those given before it on the same swing, in their order.
[[nodiscard]] std::string signedContent(
    const SwingRecord& record, const std::optional<SwingJob>& job, const Signature& signature, std::span<const Signature> before);

/// Of version 1 or 2, which do not depend on who signs.
[[nodiscard]] std::string signedContent(const SwingRecord& record, const std::optional<SwingJob>& job, int version = 2);

/// Who signed such a text of version 3, as it says itself. Errors: Format (another text).
[[nodiscard]] Result<Signature> signerIn(const std::string& content, const std::string& name);

/// What is printed beside a swing: exchange JSON without swings. A signature keeps it, so that what was signed can be said again when
/// the aircraft has another registration.
[[nodiscard]] std::string signedParticulars(const SwingRecord& record);

/// What of it is printed otherwise today; RecordIds and notes do not count.
[[nodiscard]] std::vector<SwingDifference> changedSince(const std::string& particulars, const SwingRecord& now);

} // namespace lubberline
