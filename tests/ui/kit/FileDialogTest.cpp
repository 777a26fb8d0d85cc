// How the desktop is asked for files: the folder that is remembered, the ending, and the question before a file is replaced.

#include <QtTest>

#include <QAbstractButton>
#include <QApplication>
#include <QFileDialog>
#include <QLineEdit>
#include <QMessageBox>
#include <QSettings>
#include <QTemporaryDir>

#include "ui/kit/Dialogs.h"

namespace lubberline::ui {

class FileDialogTest : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        QVERIFY(m_folder.isValid());
        m_settings.clear();
    }

    void remembersTheFolder()
    {
        DesktopDialogs dialogs(m_settings);
        QDir(m_folder.path()).mkdir("reports");
        answer([this](QFileDialog& dialog) {
            QCOMPARE(dialog.directory(), QDir::home());
            type(dialog, m_folder.filePath("reports/first.pdf"));
        });
        QCOMPARE(dialogs.saveFile(nullptr, "Save", "first.pdf", "PDF (*.pdf)"), m_folder.filePath("reports/first.pdf"));
        DesktopDialogs later(m_settings);
        touch("reports/log.nmea");
        answer([this](QFileDialog& dialog) {
            QCOMPARE(dialog.directory().path(), m_folder.filePath("reports"));
            type(dialog, "log.nmea");
        });
        QCOMPARE(later.openFile(nullptr, "Open", "Logs (*.nmea);;All files (*)"), m_folder.filePath("reports/log.nmea"));
    }

    void suggestsANameAndAddsTheEndingOfTheKind()
    {
        DesktopDialogs dialogs(m_settings);
        m_settings.setValue("files/folder", m_folder.path());
        answer([](QFileDialog& dialog) { QVERIFY(dialog.selectedFiles().constFirst().endsWith("/fleet.lubberline.json")); });
        const QString exchange = "Exchange files (*.lubberline.json)";
        QCOMPARE(dialogs.saveFile(nullptr, "Export", "fleet.lubberline.json", exchange), m_folder.filePath("fleet.lubberline.json"));
        answer([](QFileDialog& dialog) { type(dialog, "mine"); });
        QCOMPARE(dialogs.saveFile(nullptr, "Export", "fleet", exchange), m_folder.filePath("mine.lubberline.json"));
        answer([](QFileDialog& dialog) {
            dialog.selectNameFilter("Drawing (*.svg)");
            emit dialog.filterSelected("Drawing (*.svg)"); // as the box does for a hand
            type(dialog, "curve");
        });
        QCOMPARE(dialogs.saveFile(nullptr, "Plot", "polar", "Image (*.png);;Drawing (*.svg)"), m_folder.filePath("curve.svg"));
    }

    void asksBeforeAFileIsReplacedWhoseEndingItAdds()
    {
        DesktopDialogs dialogs(m_settings);
        m_settings.setValue("files/folder", m_folder.path());
        touch("card.pdf");
        int asked = 0;
        answer([&asked](QFileDialog& dialog) {
            type(dialog, "card");
            QTimer::singleShot(100, &dialog, [&asked, &dialog] {
                auto* question = dialog.findChild<QMessageBox*>();
                asked += question && question->isVisible();
                if (question)
                    question->button(QMessageBox::No)->click();
                dialog.reject();
            });
        });
        QCOMPARE(dialogs.saveFile(nullptr, "Card", "card", "PDF (*.pdf)"), QString());
        QCOMPARE(asked, 1);
        QVERIFY(!m_settings.value("files/folder").toString().isEmpty()); // a question that was given up changes nothing
    }

private:
    static void type(QFileDialog& dialog, const QString& name) { dialog.findChild<QLineEdit*>("fileNameEdit")->setText(name); }
    void touch(const QString& name)
    {
        QFile file(m_folder.filePath(name));
        QVERIFY(file.open(QIODevice::WriteOnly));
    }
    /// When the dialog has opened: acts in it and presses Save.
    static void answer(const std::function<void(QFileDialog&)>& act)
    {
        QTimer::singleShot(50, qApp, [act] {
            auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
            QVERIFY(dialog);
            act(*dialog);
            QMetaObject::invokeMethod(dialog, "accept");
        });
    }

    QTemporaryDir m_folder;
    QSettings m_settings{m_folder.filePath("settings.ini"), QSettings::IniFormat};
};

} // namespace lubberline::ui

QTEST_MAIN(lubberline::ui::FileDialogTest)
#include "FileDialogTest.moc"
