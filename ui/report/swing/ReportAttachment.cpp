/// Reading the exchange JSON back out of a report.

#include <QFile>
#include <QFileInfo>

#include <qpdf/QPDF.hh>
#include <qpdf/QPDFEmbeddedFileDocumentHelper.hh>

#include <exception>

#include "core/base/WholeFile.h"
#include "ui/report/page/BoundedPdf.h"
#include "ui/report/page/Words.h"
#include "ui/report/swing/Report.h"

namespace lubberline::ui {

namespace {

constexpr char kEnding[] = ".lubberline.json";

Error formatError(const QString& message, const QString& path) { return {ErrorCode::Format, said(message), path.toStdString()}; }

bool hasEnding(const std::string& name) { return QString::fromStdString(name).endsWith(QLatin1String(kEnding), Qt::CaseInsensitive); }

/// The stream of the first attachment with our ending; null when there is none.
std::shared_ptr<Buffer> findAttachment(QPDF& pdf)
{
    QPDFEmbeddedFileDocumentHelper attachments(pdf);
    for (const auto& [name, file] : attachments.getEmbeddedFiles())
        if (hasEnding(name) || hasEnding(file->getFilename()))
            return file->getEmbeddedFileStream().getStreamData(qpdf_dl_generalized);
    return nullptr;
}

} // namespace

bool isPdf(std::string_view bytes)
{
    constexpr std::size_t kWhereReadersLook = 1024; // PDF Reference 1.7, appendix H, note 13
    return bytes.substr(0, kWhereReadersLook).find("%PDF-") != std::string_view::npos;
}

Result<std::string> exchangeInPdf(const std::string& bytes, const QString& name)
{
    if (!isPdf(bytes))
        return formatError(Words::tr("this is not a PDF; expected a report PDF of this program"), name);
    const PdfLimit limit(2 * kMaxWholeFileBytes); // the attachment, and what the file needs to find it
    const auto tooLarge = [&] {
        return formatError(
            Words::tr("this PDF unpacks to more than %1 MiB; expected a report PDF of this program").arg(kMaxWholeFileBytes >> 20), name);
    };
    try {
        QPDF pdf;
        pdf.setSuppressWarnings(true);
        pdf.processMemoryFile(name.toUtf8().constData(), bytes.data(), bytes.size());
        if (const auto data = findAttachment(pdf))
            return data->getSize() <= kMaxWholeFileBytes
                ? Result<std::string>(std::string(reinterpret_cast<const char*>(data->getBuffer()), data->getSize()))
                : tooLarge();
        if (limit.reached())
            return tooLarge();
    } catch (const std::exception& damage) {
        if (limit.reached())
            return tooLarge();
        return formatError(
            Words::tr("this PDF cannot be read (%1); expected a report PDF of this program").arg(QString::fromUtf8(damage.what())), name);
    }
    return formatError(
        Words::tr("this PDF carries no exchange data (%1); expected a report PDF of this program that is not an archive (PDF/A) copy")
            .arg(QLatin1String(kEnding)),
        name);
}

Result<std::string> exchangeInReport(const QString& path)
{
    QFile file(path);
    if (QFileInfo(path).isDir() || !file.open(QIODevice::ReadOnly)) {
        const QString why = QFileInfo(path).isDir() ? Words::tr("it is a folder") : file.errorString();
        return Error{ErrorCode::Io, said(Words::tr("cannot be read: %1; expected a report PDF").arg(why)), path.toStdString()};
    }
    if (file.size() > static_cast<qint64>(kMaxWholeFileBytes))
        return formatError(Words::tr("is larger than %1 MiB; expected a report PDF of this program").arg(kMaxWholeFileBytes >> 20), path);
    return exchangeInPdf(file.read(static_cast<qint64>(kMaxWholeFileBytes)).toStdString(), path);
}

} // namespace lubberline::ui
