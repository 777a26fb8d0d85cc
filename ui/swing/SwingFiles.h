#pragma once
/// What is written and printed of the swing on a page: report, cards, forms.

#include "core/swing/Card.h"

namespace lubberline::ui {

struct PageContext;
class SwingPage;

void writeReportFile(PageContext& context, SwingPage& page);
void previewReport(PageContext& context, SwingPage& page);
void writeCardFile(PageContext& context, SwingPage& page, const CardOptions& options);
void previewCard(PageContext& context, SwingPage& page);
void writeJobCardFile(PageContext& context, SwingPage& page);
void write1613File(PageContext& context, SwingPage& page);

} // namespace lubberline::ui
