// What cannot be stored is kept and put in later; a second writer of a reading is told.

#include <QPushButton>

#include "tests/ui/window/Fixture.h"
#include "ui/kit/Recovery.h"
#include "ui/swing/SwingEditor.h"

namespace lubberline::ui {

class RecoveryTest : public QObject {
    Q_OBJECT

private slots:
    void whatAFullDriveRefusesIsKeptAndPutInLater()
    {
        QTemporaryDir folder;
        SmallFleet fleet;
        const SwingRecord record = *fleet.stores.swings.record(fleet.addSwing("2026-11-20", eightPoints()));
        // The first place cannot be written: a file stands where its folder should be.
        QFile blocked(folder.filePath("blocked"));
        QVERIFY(blocked.open(QIODevice::WriteOnly));
        const Recovery recovery({folder.filePath("blocked/a.jsonl"), folder.filePath("b.jsonl")});
        Reading wanted = record.swing.readings[2];
        wanted.compass = CompassHeading::fromDegrees(92.5);
        wanted.note = "typed while the drive was full";
        const LostEntry lost{fleet.stores.location().toStdString(), record.swing.id, record.swing.record, "3713", LostReading{2, wanted}};
        QVERIFY(recovery.keep(lost));
        QVERIFY(recovery.keep({"another.lubberline", record.swing.id, record.swing.record, "x", LostReading{0, wanted}}));
        QCOMPARE(recovery.entriesFor(fleet.stores.location()).size(), 1u);
        fleet.stores.watch().refuseWrites = true;
        auto restored = recovery.restore(fleet.stores);
        QCOMPARE(restored.done, 0);
        QCOMPARE(restored.failures.size(), 1);
        QCOMPARE(recovery.entriesFor(fleet.stores.location()).size(), 1u); // it stays
        fleet.stores.watch().refuseWrites = false;
        restored = recovery.restore(fleet.stores);
        QCOMPARE(restored.done, 1);
        QCOMPARE(fleet.stores.swings.record(record.swing.id)->swing.readings[2].compass->degrees(), 92.5);
        QVERIFY(recovery.entriesFor(fleet.stores.location()).empty());
        QCOMPARE(recovery.entriesFor("another.lubberline").size(), 1u);
    }

    void theWindowKeepsWhatItCannotStoreAndOffersIt()
    {
        SmallFleet fleet;
        QTemporaryDir folder;
        AnsweringDialogs dialogs;
        QSettings settings(folder.filePath("settings.ini"), QSettings::IniFormat);
        const QString file = folder.filePath("recovery.jsonl");
        {
            MainWindow window(fleet.stores, {dialogs, settings, {}, {}, {file}});
            window.show();
            QCoreApplication::processEvents();
            window.go(fleet.swing);
            fleet.stores.watch().refuseWrites = true;
            auto* page = window.findChild<SwingPage*>();
            Reading typed;
            typed.magnetic = MagneticHeading::fromDegrees(45);
            QVERIFY(!page->editor().insertReadings(0, {typed}, "reading"));
            QVERIFY(QFile::exists(file));
        }
        fleet.stores.watch().refuseWrites = false;
        MainWindow window(fleet.stores, {dialogs, settings, {}, {}, {file}});
        window.show();
        QCoreApplication::processEvents();
        QCoreApplication::processEvents();
        QPushButton* answer = nullptr;
        for (auto* button : window.findChildren<QPushButton*>())
            if (button->text() == "Put them in")
                answer = button;
        QVERIFY(answer);
        answer->click();
        QCOMPARE(fleet.stores.swings.record(fleet.swing)->swing.readings.size(), 1u);
        QVERIFY(!QFile::exists(file));
    }

    void aSecondWriterOfTheSameReadingIsTold()
    {
        SmallFleet fleet;
        const SwingId id = fleet.addSwing("2026-11-20", eightPoints());
        OpenWindow open(fleet.stores);
        open.window.go(id);
        auto& editor = open.window.findChild<SwingPage*>()->editor();
        Reading mine = editor.readings()[0];
        Reading theirs = mine;
        theirs.compass = CompassHeading::fromDegrees(300);
        QVERIFY(fleet.stores.another()->swings.changeReading(id, mine, theirs));
        mine.compass = CompassHeading::fromDegrees(310);
        QVERIFY(!editor.changeReading(0, mine, "compass"));
        QVERIFY(open.window.messages().messages().join(' ').contains("changed elsewhere"));
        QCOMPARE(editor.readings()[0].compass->degrees(), 300.0); // theirs is shown
    }
};

} // namespace lubberline::ui

QTEST_MAIN(lubberline::ui::RecoveryTest)
#include "RecoveryTest.moc"
