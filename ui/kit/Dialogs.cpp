#include "ui/kit/Dialogs.h"

#include <QFileDialog>
#include <QPrintPreviewDialog>
#include <QPrinter>
#include <QRegularExpression>

namespace lubberline::ui {

QString DesktopDialogs::openFile(QWidget* parent, const QString& title, const QString& filter)
{
    return QFileDialog::getOpenFileName(parent, title, {}, filter);
}

QString DesktopDialogs::saveFile(QWidget* parent, const QString& title, const QString& suggestion, const QString& filter)
{
    QString chosenFilter;
    const QString path = QFileDialog::getSaveFileName(parent, title, suggestion, filter, &chosenFilter);
    if (path.isEmpty() || !QFileInfo(path).suffix().isEmpty())
        return path;
    static const QRegularExpression ending(QStringLiteral(R"(\*(\.[\w.]+))"));
    return path + ending.match(chosenFilter).captured(1);
}

void DesktopDialogs::printPreview(QWidget* parent, const std::function<void(QPrinter&)>& paint)
{
    QPrinter printer(QPrinter::HighResolution);
    printer.setPageSize(QPageSize(QPageSize::A4));
    QPrintPreviewDialog preview(&printer, parent);
    QObject::connect(&preview, &QPrintPreviewDialog::paintRequested, &preview, [&paint](QPrinter* target) { paint(*target); });
    preview.resize(900, 700);
    preview.exec();
}

} // namespace lubberline::ui
