#pragma once

#include <string>

#include "core/record/Fleet.h"

namespace lubberline {

/// What a signature stands for: the swing with its particulars, readings and guided swing, as exchange JSON, and by their
/// RecordIds the compass, the aircraft and the site. Its state and the signatures themselves are not part of it, nor are names
/// and limits, which may change without the swing being another. The hash of a signature is the SHA-256 of these bytes (UTF-8).
[[nodiscard]] std::string signedContent(const SwingRecord& record, const std::optional<SwingJob>& job);

} // namespace lubberline
