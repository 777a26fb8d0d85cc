/// Reading the exchange JSON back out of a report.

#include <QCryptographicHash>
#include <QFile>
#include <QFileInfo>

#include <qpdf/QPDF.hh>
#include <qpdf/QPDFEmbeddedFileDocumentHelper.hh>
#include <zlib.h>

#include <exception>
#include <vector>

#include "core/base/WholeFile.h"
#include "ui/report/page/BoundedPdf.h"
#include "ui/report/page/Words.h"
#include "ui/report/swing/Report.h"

namespace lubberline::ui {

namespace {

constexpr char kEnding[] = ".lubberline.json";

Error formatError(const QString& message, const QString& path) { return {ErrorCode::Format, said(message), path.toStdString()}; }

bool hasEnding(const std::string& name) { return QString::fromStdString(name).endsWith(QLatin1String(kEnding), Qt::CaseInsensitive); }

/// Whether packed data fit the check sum that zlib writes behind them. qpdf, like most readers of PDF, passes over one that does not fit; a
/// single bit that turned over would then make another figure.
bool fitsCheckSum(QPDFObjectHandle stream, const Buffer& unpacked)
{
    auto filter = stream.getDict().getKey("/Filter"); // its questions are not const
    if (filter.isArray() && filter.getArrayNItems() == 1)
        filter = filter.getArrayItem(0);
    if (!filter.isName() || filter.getName() != "/FlateDecode" || unpacked.getSize() == 0)
        return true;
    if (!stream.getDict().getKey("/DecodeParms").isNull()) // predictors: nothing of ours
        return true;
    const auto packed = stream.getRawStreamData();
    std::vector<Bytef> again(unpacked.getSize());
    uLongf size = again.size();
    uLong taken = packed->getSize();
    return uncompress2(again.data(), &size, packed->getBuffer(), &taken) == Z_OK && size == unpacked.getSize();
}

struct Attachment {
    std::shared_ptr<Buffer> data; ///< null: there is none
    bool whole = true;            ///< by its check sums
};

/// The first attachment with our ending.
Attachment findAttachment(QPDF& pdf)
{
    QPDFEmbeddedFileDocumentHelper attachments(pdf);
    for (const auto& [name, file] : attachments.getEmbeddedFiles()) {
        if (!hasEnding(name) && !hasEnding(file->getFilename()))
            continue;
        auto stream = file->getEmbeddedFileStream();
        auto data = stream.getStreamData(qpdf_dl_generalized);
        const std::string md5 = QPDFEFStreamObjectHelper(stream).getChecksum(); // may be there, of what is unpacked
        const auto bytes
            = QByteArray::fromRawData(reinterpret_cast<const char*>(data->getBuffer()), static_cast<qsizetype>(data->getSize()));
        const bool agrees = md5.empty() || QCryptographicHash::hash(bytes, QCryptographicHash::Md5).toStdString() == md5;
        return {data, agrees && fitsCheckSum(stream, *data)};
    }
    return {};
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
        const auto [data, whole] = findAttachment(pdf);
        if (data && !whole)
            return formatError(
                Words::tr("this PDF is damaged: its data do not fit their check sum; expected the report as it was written"), name);
        if (data)
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
