// The preview of the desktop: pages are set beside the window, which goes on and can end it.

#include <QtTest>

#include <QPainter>
#include <QPrintPreviewDialog>
#include <QPrinter>
#include <QProgressDialog>
#include <QPushButton>
#include <QSemaphore>
#include <QSettings>
#include <QTemporaryDir>
#include <QThread>

#include "ui/kit/Dialogs.h"

namespace lubberline::ui {

class PrintPreviewTest : public QObject {
    Q_OBJECT

private slots:
    void theWindowLivesWhilePagesAreSet()
    {
        QSemaphore lives;
        QThread* painter = nullptr;
        QTimer::singleShot(0, this, [&lives] { lives.release(); });
        whenShown<QPrintPreviewDialog>([](QPrintPreviewDialog& preview) { preview.reject(); });
        const auto printed = dialogs().printPreview(nullptr, [&](QPrinter& printer, const Progress&) -> Result<void> {
            painter = QThread::currentThread();
            lives.acquire(); // what the window alone can give
            lives.release();
            QPainter(&printer).drawText(100, 100, QStringLiteral("page"));
            return {};
        });
        QVERIFY(printed.ok());
        QVERIFY(!*printed);
        QVERIFY(painter);
        QVERIFY(painter != thread());
    }

    void longPagesAreSeenAndCancelled()
    {
        bool told = false;
        whenShown<QProgressDialog>([](QProgressDialog& working) {
            QVERIFY(working.isModal()); // nothing else takes a click meanwhile
            working.findChild<QPushButton*>()->click();
        });
        const auto printed = dialogs().printPreview(nullptr, [&told](QPrinter&, const Progress& progress) -> Result<void> {
            while (progress(0.1))
                QThread::msleep(1);
            told = true;
            return Error{ErrorCode::Cancelled, {}};
        });
        QVERIFY(told);
        QVERIFY(printed.ok()); // who cancels knows it
        QVERIFY(!*printed);
    }

    void whatCannotBePaintedIsTold()
    {
        const auto printed = dialogs().printPreview(nullptr, [](QPrinter&, const Progress&) -> Result<void> {
            return Error{ErrorCode::Unsupported, Message::verbatim(std::string("no font"))};
        });
        QVERIFY(!printed.ok());
        QCOMPARE(describe(printed.error()), std::string("no font"));
    }

    void aWidgetIsPaintedWhereItLives()
    {
        QThread* painter = nullptr;
        whenShown<QPrintPreviewDialog>([](QPrintPreviewDialog& preview) { preview.reject(); });
        const auto printed = dialogs().printPreview(
            nullptr,
            [&painter](QPrinter&, const Progress&) -> Result<void> {
                painter = QThread::currentThread();
                return {};
            },
            Dialogs::Where::Window);
        QVERIFY(printed.ok());
        QCOMPARE(painter, thread());
    }

private:
    Dialogs& dialogs() { return m_dialogs; }

    template <class Dialog>
    void whenShown(std::function<void(Dialog&)> act)
    {
        QTimer::singleShot(5, this, [this, act] {
            for (QWidget* widget : QApplication::topLevelWidgets())
                if (auto* dialog = qobject_cast<Dialog*>(widget); dialog && dialog->isVisible()) {
                    act(*dialog);
                    return;
                }
            whenShown<Dialog>(act);
        });
    }

    QTemporaryDir m_folder;
    QSettings m_settings{m_folder.filePath("settings.ini"), QSettings::IniFormat};
    DesktopDialogs m_dialogs{m_settings};
};

} // namespace lubberline::ui

QTEST_MAIN(lubberline::ui::PrintPreviewTest)
#include "PrintPreviewTest.moc"
