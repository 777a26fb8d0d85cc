// How the window reaches the calibration from logs.

#include "ui/calibration/CalibrationPage.h"
#include "ui/kit/PageDescription.h"

namespace lubberline::ui {

PageDescription CalibrationPage::description(PageContext& context)
{
    PageDescription page{QStringLiteral("calibration"), [&context] { return new CalibrationPage(context.settings, context.files); }};
    page.commands = {{MenuId::Model, 115, tr("&Calibration from a log…"), tr("Ctrl+Alt+G"), "calibration",
        [&context](Page&) { context.go({"calibration"}); }}};
    page.help = tr(
        "Open a log of a magnetometer that was turned through all attitudes: its hard and soft iron, how sure they are, why no surer and what to do for "
        "better. Zoom into the log to use a part of it; Directions shows where no sample is; the model is saved as JSON or as a C header.");
    return page;
}

} // namespace lubberline::ui
