#include "ui/kit/Dialogs.h"

#include <QDesktopServices>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QPrintPreviewDialog>
#include <QPrinter>
#include <QRegularExpression>
#include <QSettings>
#include <QUrl>

namespace lubberline::ui {

namespace {

const QString kFolder = QStringLiteral("files/folder");

/// "lubberline.json" of "Exchange files (*.lubberline.json)".
QString endingOf(const QString& filter)
{
    static const QRegularExpression ending(QStringLiteral(R"(\*\.([\w.]+))"));
    return ending.match(filter).captured(1);
}

} // namespace

QString DesktopDialogs::openFile(QWidget* parent, const QString& title, const QString& filter)
{
    QFileDialog dialog(parent, title);
    dialog.setFileMode(QFileDialog::ExistingFile);
    dialog.setNameFilters(filter.split(QStringLiteral(";;")));
    return ask(dialog);
}

QString DesktopDialogs::saveFile(QWidget* parent, const QString& title, const QString& suggestion, const QString& filter)
{
    const QStringList filters = filter.split(QStringLiteral(";;"));
    QFileDialog dialog(parent, title);
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setNameFilters(filters);
    dialog.setDefaultSuffix(endingOf(filters.constFirst()));
    QObject::connect(
        &dialog, &QFileDialog::filterSelected, &dialog, [&dialog](const QString& chosen) { dialog.setDefaultSuffix(endingOf(chosen)); });
    dialog.selectFile(suggestion);
    return ask(dialog);
}

QString DesktopDialogs::ask(QFileDialog& dialog)
{
    const QString before = m_settings.value(kFolder).toString();
    dialog.setDirectory(QFileInfo(before).isDir() ? before : QDir::homePath());
    if (dialog.exec() != QDialog::Accepted)
        return {};
    const QString path = dialog.selectedFiles().constFirst();
    m_settings.setValue(kFolder, QFileInfo(path).absolutePath());
    return path;
}

QString DesktopDialogs::chooseFolder(QWidget* parent, const QString& title, const QString& before)
{
    return QFileDialog::getExistingDirectory(parent, title, QFileInfo(before).isDir() ? before : QDir::homePath());
}

bool DesktopDialogs::openOutside(const QString& path) { return QDesktopServices::openUrl(QUrl::fromLocalFile(path)); }

bool DesktopDialogs::printPreview(QWidget* parent, const std::function<void(QPrinter&)>& paint)
{
    QPrinter printer(QPrinter::HighResolution);
    printer.setPageSize(QPageSize(QPageSize::A4));
    QPrintPreviewDialog preview(&printer, parent);
    QObject::connect(&preview, &QPrintPreviewDialog::paintRequested, &preview, [&paint](QPrinter* target) { paint(*target); });
    preview.resize(900, 700);
    return preview.exec() == QDialog::Accepted; // it closes itself when it has printed
}

} // namespace lubberline::ui
