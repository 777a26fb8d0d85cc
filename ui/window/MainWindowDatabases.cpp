// Which database the window is on, and copies of it; what is printed.

#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QMenu>
#include <QPainter>
#include <QPrinter>
#include <QSettings>

#include <algorithm>

#include "ui/kit/Words.h"
#include "ui/window/MainWindow.h"
#include "ui/window/PageStack.h"

namespace lubberline::ui {

namespace {

const QString kRecent = QStringLiteral("files/recent"), kOwn = QStringLiteral("files/own");
constexpr int kMostRecent = 8;

QString databases() { return MainWindow::tr("Lubberline databases (*.lubberline *.db);;All files (*)"); }

QString stemOf(const QString& database) { return QFileInfo(database).completeBaseName(); }

/// Backups of a database have its name and the moment; what is named otherwise is somebody else's file.
QStringList backupsIn(const QDir& folder, const QString& stem)
{
    return folder.entryList(
        {stem + QStringLiteral("-[0-9][0-9][0-9][0-9]-[0-9][0-9]-[0-9][0-9]-[0-9][0-9][0-9][0-9][0-9][0-9].lubberline")}, QDir::Files,
        QDir::Name);
}

/// As it is seen, in vector form, as large as the sheet lets it be.
void printPage(QWidget& page, QPrinter& printer)
{
    QPainter painter(&printer);
    const QRect sheet = printer.pageLayout().paintRectPixels(printer.resolution());
    const double scale = std::min(sheet.width() / static_cast<double>(page.width()), sheet.height() / static_cast<double>(page.height()));
    painter.scale(scale, scale);
    page.render(&painter, {}, {}, QWidget::DrawChildren);
}

} // namespace

std::vector<Command> MainWindow::databaseCommands()
{
    std::vector<Command> commands{{MenuId::File, 290, tr("&Print…"), QKeySequence::Print, "print", [this](Page&) { print(); }}};
    if (m_services.openDatabase) {
        commands.push_back({MenuId::File, 110, tr("New &database…"), {}, "newDatabase", [this](Page&) {
                                openAnother(
                                    m_services.dialogs.saveFile(this, tr("New database"), tr("fleet") + ".lubberline", databases()), true);
                            }});
        commands.push_back({MenuId::File, 120, tr("&Open a database…"), QKeySequence::Open, "openDatabase",
            [this](Page&) { openAnother(m_services.dialogs.openFile(this, tr("Open a database"), databases()), false); }});
    }
    if (m_services.demonstration)
        commands.push_back({MenuId::File, 140, tr("Back to &your own database"), {}, "backToOwn", [this](Page&) { goBackToOwn(); }});
    else
        commands.push_back(
            {MenuId::File, 140, tr("De&monstration fleet"), {}, "demonstration", [this](Page&) { m_services.openDemonstration(); }});
    if (m_services.backup) {
        commands.push_back({MenuId::File, 500, tr("&Save a copy of the database…"), {}, "saveCopy", [this](Page&) { saveCopy(); }});
        commands.push_back({MenuId::File, 510, tr("&Back up now"), tr("Ctrl+Shift+U"), "backup", [this](Page&) { backUp(); }});
    }
    if (m_services.restore)
        commands.push_back({MenuId::File, 520, tr("R&estore from a backup…"), {}, "restore", [this](Page&) { restore(); }, needsWriting});
    return commands;
}

void MainWindow::addRecent(QMenu& file)
{
    auto* before = findChild<QAction*>(QStringLiteral("openDatabase"));
    if (!before)
        return;
    auto* recent = new QMenu(tr("Open &recent"), &file);
    recent->setObjectName(QStringLiteral("recentDatabases"));
    const qsizetype place = file.actions().indexOf(before) + 1;
    file.insertMenu(file.actions().value(place), recent);
    const auto fill = [this, recent] {
        recent->clear();
        for (const QString& path : m_services.settings.value(kRecent).toStringList())
            if (path != m_stores.location() && QFileInfo::exists(path))
                connect(recent->addAction(QDir::toNativeSeparators(path)), &QAction::triggered, this,
                    [this, path] { openAnother(path, false); });
        if (recent->isEmpty())
            recent->addAction(tr("no other database has been open"))->setEnabled(false);
    };
    fill();
    connect(recent, &QMenu::aboutToShow, this, fill);
}

void MainWindow::rememberDatabase()
{
    const QString path = QFileInfo(m_stores.location()).absoluteFilePath();
    QStringList recent = m_services.settings.value(kRecent).toStringList();
    recent.removeAll(path);
    recent.prepend(path);
    m_services.settings.setValue(kRecent, QStringList(recent.mid(0, kMostRecent)));
    if (!m_services.demonstration)
        m_services.settings.setValue(kOwn, path);
}

/// The last that was no demonstration; that of a new user where there was none.
void MainWindow::goBackToOwn()
{
    const QString own = m_services.settings.value(kOwn).toString();
    if (const auto opened = m_services.openDatabase(QFileInfo::exists(own) ? own : QString(), true); !opened)
        fail(messageOf(opened.error()));
}

void MainWindow::openAnother(const QString& path, bool make)
{
    if (path.isEmpty())
        return;
    leaveField();
    if (m_transfer.running()) {
        fail(tr("A file is being read or written. Wait for it, or cancel it."));
        return;
    }
    m_asked.clear();
    if (make && QFileInfo::exists(path)) {
        fail(tr("%1: there is a file of this name already. Open it, or choose a new name for the new database.").arg(path));
        return;
    }
    if (const auto opened = m_services.openDatabase(path, make); !opened)
        fail(messageOf(opened.error()));
}

void MainWindow::tellWritten(const QString& message, const QString& path)
{
    const auto open = [this](const QString& what) {
        return [this, what] {
            if (!m_services.dialogs.openOutside(what))
                fail(tr("%1: nothing on this machine opens it.").arg(what));
        };
    };
    std::vector<MessagePanel::Answer> answers{{tr("Show in folder"), open(QFileInfo(path).absolutePath()), false}};
    if (QFileInfo(path).suffix() != QStringLiteral("lubberline")) // another database is opened from the menu
        answers.insert(answers.begin(), {tr("Open"), open(path), false});
    m_messages->add(MessagePanel::Kind::Information, message, answers);
}

void MainWindow::saveCopy()
{
    const QString path = askToSave(tr("Save a copy of the database"),
        QStringLiteral("%1-%2.lubberline").arg(stemOf(m_stores.location()), toText(m_stores.clock().today())), databases());
    if (!path.isEmpty())
        writeBackup(path);
}

void MainWindow::writeBackup(const QString& path, std::function<void()> then)
{
    write({path, [backup = m_services.backup, path](const Progress&) { return backup(path); }, tr("Backup written: %1").arg(path),
        std::move(then)});
}

/// Into the folder that was chosen for it, where the oldest beyond the number that is kept go; else a name is asked for.
void MainWindow::backUp()
{
    leaveField();
    const QDir folder(m_preferences.backupFolder());
    if (m_preferences.backupFolder().isEmpty()) {
        saveCopy();
        return;
    }
    if (!folder.exists()) {
        fail(tr("%1: the folder for backups is not there; choose another in the preferences.").arg(folder.path()));
        return;
    }
    const QString stem = stemOf(m_stores.location()), moment = QString::fromStdString(m_stores.clock().nowUtc());
    QString name = moment.left(19);
    name.replace(u'T', u'-').remove(u':');
    const QString path = folder.filePath(QStringLiteral("%1-%2.lubberline").arg(stem, name));
    writeBackup(path, [folder, stem, most = m_preferences.backupsKept()] {
        for (QStringList backups = backupsIn(folder, stem); backups.size() > most; backups.removeFirst())
            QFile::remove(folder.filePath(backups.front()));
    });
}

void MainWindow::restore()
{
    leaveField();
    if (m_transfer.running()) {
        fail(tr("A file is being read or written. Wait for it, or cancel it."));
        return;
    }
    const QString path = m_services.dialogs.openFile(this, tr("Restore from a backup"), databases());
    if (path.isEmpty())
        return;
    m_messages->add(MessagePanel::Kind::Information,
        tr("Put %1 in the place of this database? What is here now is kept beside it under the name of this moment.").arg(path),
        {{tr("Restore"), [this, path] {
              if (const auto done = m_services.restore(path); !done)
                  fail(messageOf(done.error()));
          }}});
}

void MainWindow::print()
{
    leaveField();
    if (const PageDescription* front = m_pages->description(); front && front->print)
        front->print(m_pages->current());
    else if (const auto printed = m_services.dialogs.printPreview(
                 this,
                 [&page = m_pages->current()](QPrinter& printer, const Progress&) -> Result<void> { // as long as it is asked, of this one
                     printer.setPageOrientation(page.width() > page.height() ? QPageLayout::Landscape : QPageLayout::Portrait);
                     printPage(page, printer);
                     return {};
                 },
                 Dialogs::Where::Window);
             !printed)
        fail(messageOf(printed.error()));
}

} // namespace lubberline::ui
