#include "ui/plots/base/PlotFile.h"

#include "ui/text/Translated.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QFileInfo>
#include <QFontInfo>
#include <QGuiApplication>
#include <QImage>
#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>
#include <QSvgGenerator>

#include "core/base/OutputFile.h"

namespace lubberline::ui {

namespace {

constexpr int kUnitsPerInch = 96;

struct Words {
    Q_DECLARE_TR_FUNCTIONS(lubberline::ui::PlotFile)
};

Error failure(ErrorCode code, const QString& message, const QString& path) { return {code, said(message), path.toStdString()}; }

void paintImage(QIODevice& device, QSize size_px, const PaintPlot& paint)
{
    QImage image(size_px, QImage::Format_RGB32);
    const int dotsPerMetre = qRound(kUnitsPerInch / 0.0254);
    image.setDotsPerMeterX(dotsPerMetre);
    image.setDotsPerMeterY(dotsPerMetre);
    image.fill(Qt::white);
    QPainter painter(&image);
    paint(painter, QRectF(QPointF(), size_px));
    painter.end();
    image.save(&device, "PNG");
}

void paintSvg(QIODevice& device, QSize size_px, const QString& title, const PaintPlot& paint)
{
    QSvgGenerator generator;
    generator.setOutputDevice(&device);
    generator.setResolution(kUnitsPerInch);
    generator.setSize(size_px);
    generator.setViewBox(QRect(QPoint(), size_px));
    generator.setTitle(title);
    QPainter painter(&generator);
    paint(painter, QRectF(QPointF(), size_px));
}

void paintPdf(QIODevice& device, QSize size_px, const QString& title, const PaintPlot& paint)
{
    QPdfWriter writer(&device);
    const QSizeF size_pt = QSizeF(size_px) * 72.0 / kUnitsPerInch;
    writer.setResolution(600);
    writer.setPageSize(QPageSize(size_pt, QPageSize::Point, title, QPageSize::ExactMatch));
    writer.setPageMargins(QMarginsF());
    writer.setTitle(title);
    QPainter painter(&writer);
    paint(painter, QRectF(0, 0, writer.width(), writer.height()));
}

} // namespace

Result<void> writePlotFile(const QString& path, QSize size_px, const QString& title, const PaintPlot& paint, const QString& kind)
{
    const QFileInfo file(path);
    const QString ending = kind.isEmpty() ? file.suffix().toLower() : kind;
    if (ending != "png" && ending != "svg" && ending != "pdf") {
        return failure(
            ErrorCode::InvalidInput, Words::tr("a plot can be written as .png, .svg or .pdf, not as \"%1\"").arg(file.fileName()), path);
    }
    if (size_px.width() < 1 || size_px.height() < 1)
        return failure(ErrorCode::InvalidInput, Words::tr("a plot needs a width and a height of at least 1 pixel"), path);
    if (QFontInfo(QGuiApplication::font()).family().isEmpty()) {
        return failure(ErrorCode::Unsupported,
            Words::tr("no font is installed, so the plot would have no text; install one (fonts-dejavu-core)"), path);
    }
    if (const auto allowed = checkOutput(path.toStdString()); !allowed)
        return allowed; // before anything is drawn

    QBuffer drawn;
    drawn.open(QIODevice::WriteOnly);
    if (ending == "png")
        paintImage(drawn, size_px, paint);
    else if (ending == "svg")
        paintSvg(drawn, size_px, title, paint);
    else
        paintPdf(drawn, size_px, title, paint);

    return writeWholeFile(path.toStdString(), drawn.data().toStdString());
}

} // namespace lubberline::ui
