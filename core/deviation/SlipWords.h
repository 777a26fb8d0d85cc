#pragma once
/// The usual slips in words, for window and commands alike, and their codes in files.

#include "core/base/Message.h"
#include "core/deviation/SlipCheck.h"

namespace lubberline {

[[nodiscard]] Message wordFor(Slip slip);
[[nodiscard]] const char* codeOf(Slip slip);
/// What is kept with a reading that looked wrong and was kept all the same: codes and figures, whatever the window's language.
/// "kept as read: ten_degrees 185 (0.93)"
[[nodiscard]] std::string keptAsRead(const SlipJudgement& judgement);

} // namespace lubberline
