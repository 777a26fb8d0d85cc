#pragma once
/// What the help tells, as HTML: a topic of each page, and those of the whole program.

#include <QString>

#include <vector>

#include "ui/kit/PageContext.h"

namespace lubberline::ui {

struct HelpTopic {
    QString id; ///< of a page: PageDescription::id
    QString title;
    QString html;
};

/// Those of the program first, then one for each page.
[[nodiscard]] std::vector<HelpTopic> helpTopics(const PageContext& context);

/// What whoever mends the program needs to know, without anything of a record.
[[nodiscard]] QString problemReport(const PageContext& context);

} // namespace lubberline::ui
