#pragma once
/// What is written and printed of the swing on a page: report, cards, forms.

namespace lubberline::ui {

struct PageContext;
class SwingPage;

void writeReportFile(PageContext& context, SwingPage& page);
void previewReport(PageContext& context, SwingPage& page);
void writeCardFile(PageContext& context, SwingPage& page, int step_deg);
void previewCard(PageContext& context, SwingPage& page);
void writeJobCardFile(PageContext& context, SwingPage& page);
void write1613File(PageContext& context, SwingPage& page);

} // namespace lubberline::ui
