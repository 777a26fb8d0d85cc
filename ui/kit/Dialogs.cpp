#include "ui/kit/Dialogs.h"

#include <QCoreApplication>
#include <QDesktopServices>
#include <QDir>
#include <QEventLoop>
#include <QFileDialog>
#include <QFileIconProvider>
#include <QFileInfo>
#include <QPrintPreviewDialog>
#include <QPrinter>
#include <QProgressDialog>
#include <QRegularExpression>
#include <QScreen>
#include <QSettings>
#include <QTimer>
#include <QUrl>

#include <limits>

#include "ui/kit/Worker.h"

namespace lubberline::ui {

namespace {

const QString kFolder = QStringLiteral("files/folder");

/// By the name alone: the usual ones open every file of the folder, and with that take the locks of a database that is open here
/// (db/engine/HeldFile.h).
class IconsByName : public QFileIconProvider {
public:
    using QFileIconProvider::icon;
    QIcon icon(const QFileInfo& file) const override { return icon(file.isDir() ? Folder : File); }
    QString type(const QFileInfo& file) const override { return file.isDir() ? QString() : file.suffix(); }
};

struct DialogWords {
    Q_DECLARE_TR_FUNCTIONS(lubberline::ui::Dialogs)
};

/// "lubberline.json" of "Exchange files (*.lubberline.json)".
QString endingOf(const QString& filter)
{
    static const QRegularExpression ending(QStringLiteral(R"(\*\.([\w.]+))"));
    return ending.match(filter).captured(1);
}

/// The preview wants its pages before it goes on: its window waits, and lives. What takes longer than a blink is seen, and can be ended.
Result<void> paintOnWorker(QPrinter& target, const Dialogs::PaintPages& paint, QWidget* parent)
{
    constexpr int kBlink_ms = 300;
    QProgressDialog working(DialogWords::tr("Setting the pages…"), DialogWords::tr("Cancel"), 0, 100, parent);
    working.setWindowModality(Qt::ApplicationModal);
    working.setMinimumDuration(std::numeric_limits<int>::max()); // it is shown beneath
    QEventLoop waiting;
    Result<void> done;
    Worker<bool> worker(
        [&](const Result<bool>& painted) {
            if (!painted)
                done = painted.error();
            waiting.quit();
        },
        [&working](int percent) { working.setValue(percent); });
    QObject::connect(&working, &QProgressDialog::canceled, &waiting, [&worker] { worker.cancel(); });
    worker.start([&](const Progress& progress) -> Result<bool> {
        const auto painted = paint(target, progress);
        return painted ? Result<bool>(true) : painted.error();
    });
    QTimer::singleShot(kBlink_ms, &waiting, &QEventLoop::quit);
    waiting.exec(QEventLoop::ExcludeUserInputEvents); // until something in front can take them
    if (worker.running()) {
        working.show();
        waiting.exec();
    }
    return done;
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
    static auto* const icons = new IconsByName; // a dialog asks it to its end
    dialog.setIconProvider(icons);
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

Result<bool> DesktopDialogs::printPreview(QWidget* parent, const PaintPages& paint, Where where)
{
    QPrinter printer(QPrinter::HighResolution);
    printer.setPageSize(QPageSize(QPageSize::A4));
    QPrintPreviewDialog preview(&printer, parent);
    Result<void> painted;
    QObject::connect(&preview, &QPrintPreviewDialog::paintRequested, &preview, [&](QPrinter* target) {
        painted = where == Where::Worker ? paintOnWorker(*target, paint, preview.isVisible() ? &preview : parent) : paint(*target, {});
        if (!painted)
            QMetaObject::invokeMethod(&preview, &QDialog::reject, Qt::QueuedConnection);
    });
    preview.resize(QSize(900, 700).boundedTo(preview.screen()->availableSize() - QSize(20, 60))); // with a frame, on a small screen, too
    const bool accepted = preview.exec() == QDialog::Accepted;                                    // it closes itself when it has printed
    if (!painted && painted.error().code != ErrorCode::Cancelled)
        return painted.error();
    return accepted && painted;
}

} // namespace lubberline::ui
