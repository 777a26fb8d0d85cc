#include "ui/plots/SwingPlot.h"

#include <QClipboard>
#include <QFileDialog>
#include <QGuiApplication>
#include <QImage>
#include <QPainter>

#include "ui/plots/PlotFile.h"

namespace lubberline::ui {

Result<void> SwingPlot::exportTo(const QString& path, QSize size_px) const
{
    return writePlotFile(path, size_px, name(), [this](QPainter& painter, const QRectF& target) { render(painter, target); });
}

void SwingPlot::exportInteractively()
{
    const QString path = QFileDialog::getSaveFileName(this, tr("Export the plot"), name().toLower() + ".png",
        tr("Image (*.png);;Drawing (*.svg);;PDF (*.pdf)"));
    if (path.isEmpty())
        return;
    const Result<void> written = exportTo(path);
    if (!written)
        emit exportFailed(QString::fromStdString(describe(written.error())));
}

void SwingPlot::copyToClipboard() const
{
    const QSize size = this->size().expandedTo({400, 300});
    QImage image(2 * size, QImage::Format_RGB32); // sharp in a document
    image.setDevicePixelRatio(2);
    image.fill(Qt::white);
    QPainter painter(&image);
    render(painter, QRectF(QPointF(), size));
    painter.end();
    QGuiApplication::clipboard()->setImage(image);
}

} // namespace lubberline::ui
