#pragma once
/// The pages that there are. No other file of the window includes one.

#include "ui/kit/PageDescription.h"

namespace lubberline::ui {

/// The context must outlive what is returned, and the pages made by it.
[[nodiscard]] std::vector<PageDescription> allPages(PageContext& context);

} // namespace lubberline::ui
