#pragma once
/// Reports that commands write as PDF.

#include "app/Outputs.h"
#include "ui/report/forms/ReferenceSheet.h"

namespace lubberline::app {

/// With the time at which it was made. @return the exit status.
int writeSheet(ui::ReferenceSheet sheet, const Output& output);

} // namespace lubberline::app
