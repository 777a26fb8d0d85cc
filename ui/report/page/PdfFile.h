#pragma once
/// How every PDF of ours is made.

#include <QByteArray>
#include <QString>

#include <functional>

#include "core/base/Result.h"

class QPagedPaintDevice;

namespace lubberline::ui {

/// The name of the exchange JSON inside the PDF; exchangeInReport() takes the attachment with this ending.
inline constexpr char kAttachmentName[] = "swing.lubberline.json";

/// A4 without margins of its own, and the settings that all our PDFs share; painted by `paint`.
struct PdfKind {
    QString title;
    bool archive = false;       ///< PDF/A-1b, else PDF 1.6
    QByteArray attachment = {}; ///< the exchange JSON; empty: none, and never in an archive PDF
};
Result<QByteArray> makePdf(const PdfKind& kind, const std::function<Result<void>(QPagedPaintDevice&)>& paint);

} // namespace lubberline::ui
