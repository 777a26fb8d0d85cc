#include "ui/report/Report.h"

#include <QCryptographicHash>
#include <QFileInfo>

#include "core/format/Exchange.h"
#include "ui/report/DocumentFile.h"
#include "ui/report/ReportContent.h"
#include "ui/report/ReportData.h"
#include "ui/report/ReportHtml.h"
#include "ui/report/ReportPdf.h"
#include "ui/report/Words.h"

namespace lubberline::ui {

namespace {

Result<QByteArray> reportAs(const QString& ending, const ReportInput& input, const QString& path)
{
    if (ending == "pdf")
        return reportPdf(input);
    if (ending == "html")
        return reportHtml(contentOf(input));
    if (ending == "csv")
        return reportCsv(input);
    if (ending == "json")
        return reportJson(input);
    return Error{ErrorCode::InvalidInput,
        Words::tr("a report cannot be written under this name; expected one that ends in .pdf, .html, .csv or .json").toStdString(), path.toStdString()};
}

} // namespace

QString dataHash(const SwingRecord& record)
{
    return hashOfText(writeExchange(toFleet(record)));
}

QString hashOfText(const std::string& text)
{
    return QString::fromLatin1(QCryptographicHash::hash(QByteArray::fromStdString(text), QCryptographicHash::Sha256).toHex());
}

Result<void> writeReport(const ReportInput& input, const QString& path)
{
    const auto bytes = reportAs(QFileInfo(path).suffix().toLower(), input, path);
    if (!bytes) {
        Error error = bytes.error();
        error.file = path.toStdString();
        return error;
    }
    return writeDocument(path, *bytes);
}

} // namespace lubberline::ui
