#include "app/SheetOutput.h"

#include "app/Console.h"
#include "app/Paths.h"
#include "app/QtSession.h"

namespace lubberline::app {

int writeSheet(ui::ReferenceSheet sheet, const Output& output)
{
    const auto session = makeDrawingSession();
    sheet.madeAtUtc = nowUtc();
    if (const auto written = ui::writeReferenceSheet(sheet, QString::fromStdString(output.path)); !written)
        return fail(written.error());
    sayWritten(output);
    return kDone;
}

} // namespace lubberline::app
