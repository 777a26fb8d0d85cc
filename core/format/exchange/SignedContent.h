#pragma once

#include <string>

#include "core/record/Fleet.h"

namespace lubberline {

/// What a signature stands for: the swing with its particulars, readings and guided swing, as exchange JSON, and by their
/// RecordIds the compass, the aircraft and the site. Its state and the signatures themselves are not part of it, nor are names
/// and limits, which may change without the swing being another. The hash of a signature is the SHA-256 of these bytes (UTF-8).
/// Versions: 1 is that JSON; 2 says first that it is signed content, and of which version, so that no other file is taken for it.
/// What was signed by an older version is verified by that version, for ever: the text of a version never changes.
inline constexpr int kSignedContents = 2; ///< what is signed today
[[nodiscard]] std::string signedContent(const SwingRecord& record, const std::optional<SwingJob>& job, int version = kSignedContents);

} // namespace lubberline
