#pragma once
/// The report as one self-contained XHTML file: the plots are inline SVG, nothing is fetched.

#include <QByteArray>

#include "ui/report/swing/ReportContent.h"

namespace lubberline::ui {

[[nodiscard]] QByteArray reportHtml(const ReportContent& content);

} // namespace lubberline::ui
