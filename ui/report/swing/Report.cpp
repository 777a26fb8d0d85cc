#include "ui/report/swing/Report.h"

#include <QFileInfo>

#include "core/base/OutputFile.h"
#include "core/format/exchange/Exchange.h"
#include "ui/report/page/Words.h"
#include "ui/report/swing/ReportContent.h"
#include "ui/report/swing/ReportData.h"
#include "ui/report/swing/ReportHtml.h"
#include "ui/report/swing/ReportPdf.h"

namespace lubberline::ui {

namespace {

Result<QByteArray> reportAs(const QString& ending, const ReportInput& input, const QString& path, const Progress& progress)
{
    if (ending == "pdf")
        return reportPdf(input, progress);
    if (ending == "html")
        return reportHtml(contentOf(input));
    if (ending == "csv")
        return reportCsv(input);
    if (ending == "json")
        return reportJson(input);
    return Error{ErrorCode::InvalidInput,
        said(Words::tr("a report cannot be written under this name; expected one that ends in .pdf, .html, .csv or .json")),
        path.toStdString()};
}

} // namespace

Result<void> writeReport(const ReportInput& input, const QString& path, const QString& kind, const Progress& progress)
{
    const auto bytes = reportAs(kind.isEmpty() ? QFileInfo(path).suffix().toLower() : kind, input, path, progress);
    if (!bytes) {
        Error error = bytes.error();
        error.file = path.toStdString();
        return error;
    }
    return writeWholeFile(path.toStdString(), bytes->toStdString());
}

} // namespace lubberline::ui
