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
    QFileDialog dialog(this, tr("Export the plot"));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setNameFilters({tr("Image (*.png)"), tr("Drawing (*.svg)"), tr("PDF (*.pdf)")});
    dialog.setDefaultSuffix("png");
    dialog.selectFile(name().toLower() + ".png");
    connect(&dialog, &QFileDialog::filterSelected, &dialog, [&dialog](const QString& filter) {
        dialog.setDefaultSuffix(filter.contains(".svg") ? "svg" : filter.contains(".pdf") ? "pdf" : "png");
    });
    if (dialog.exec() != QDialog::Accepted)
        return;
    const Result<void> written = exportTo(dialog.selectedFiles().constFirst());
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
