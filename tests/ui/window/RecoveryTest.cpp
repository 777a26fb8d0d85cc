// What cannot be stored is kept and put in later; a second writer of a reading is told.

#include <QDir>
#include <QPushButton>

#include <sys/stat.h>
#include <unistd.h>

#include "tests/ui/window/Fixture.h"
#include "ui/kit/Recovery.h"
#include "ui/swing/SwingEditor.h"

namespace lubberline::ui {

namespace {

LostEntry lostOf(SmallFleet& fleet, const SwingRecord& record, LostReading reading)
{
    return {fleet.stores.location().toStdString(), record.swing.id, record.swing.record, "3713", std::move(reading)};
}

} // namespace

class RecoveryTest : public QObject {
    Q_OBJECT

private slots:
    void whatAFullDriveRefusesIsKeptAndPutInLater()
    {
        QTemporaryDir folder;
        SmallFleet fleet;
        SmallFleet another;
        const SwingRecord record = *fleet.stores.swings.record(fleet.addSwing("2026-11-20", eightPoints()));
        // The first place cannot be written: a file stands where its folder should be.
        QFile blocked(folder.filePath("blocked"));
        QVERIFY(blocked.open(QIODevice::WriteOnly));
        const Recovery recovery({folder.filePath("blocked/a.jsonl"), folder.filePath("b.jsonl")});
        const Reading before = record.swing.readings[2];
        Reading wanted = before;
        wanted.compass = CompassHeading::fromDegrees(92.5);
        wanted.note = "typed while the drive was full";
        const LostEntry lost = lostOf(fleet, record, {2, wanted, before.id, before});
        QVERIFY(recovery.keep(fleet.stores, lost));
        QVERIFY(recovery.keep(another.stores, lost));
        QCOMPARE(recovery.entriesFor(fleet.stores).size(), 1u);
        fleet.stores.watch().refuseWrites = true;
        auto restored = recovery.restore(fleet.stores, recovery.entriesFor(fleet.stores));
        QCOMPARE(restored.done, 0);
        QCOMPARE(restored.failures.size(), 1);
        QCOMPARE(recovery.entriesFor(fleet.stores).size(), 1u); // it stays
        fleet.stores.watch().refuseWrites = false;
        restored = recovery.restore(fleet.stores, recovery.entriesFor(fleet.stores));
        QCOMPARE(restored.done, 1);
        QCOMPARE(fleet.stores.swings.record(record.swing.id)->swing.readings[2].compass->degrees(), 92.5);
        QVERIFY(recovery.entriesFor(fleet.stores).empty());
        QCOMPARE(recovery.entriesFor(another.stores).size(), 1u);
    }

    /// Rows in between, the same figure typed again, another typed since, the row gone, the swing completed: each alone, and in both orders.
    void whatHasBeenStoredSinceWins()
    {
        QTemporaryDir folder;
        SmallFleet fleet;
        const SwingId id = fleet.addSwing("2026-11-20", eightPoints());
        const Recovery recovery({folder.filePath("a.jsonl")});
        const auto now = [&] { return *fleet.stores.swings.record(id); };
        const auto keep = [&](int row, double compass_deg) {
            const Reading before = now().swing.readings[static_cast<std::size_t>(row)];
            Reading wanted = before;
            wanted.compass = CompassHeading::fromDegrees(compass_deg);
            QVERIFY(recovery.keep(fleet.stores, lostOf(fleet, now(), {row, wanted, before.id, before})));
        };
        const auto put = [&] { return recovery.restore(fleet.stores, recovery.entriesFor(fleet.stores)); };
        // A row is put in above: the figure goes to its reading, not to the number of its row.
        keep(2, 92.5);
        Reading above;
        above.magnetic = MagneticHeading::fromDegrees(10);
        QVERIFY(fleet.stores.swings.insertReading(id, 0, above));
        QCOMPARE(put().done, 1);
        QCOMPARE(now().swing.readings[3].compass->degrees(), 92.5);
        QVERIFY(!now().swing.readings[2].compass || now().swing.readings[2].compass->degrees() != 92.5);
        // Typed again and stored: nothing is left to offer.
        keep(3, 93);
        Reading again = now().swing.readings[3];
        again.compass = CompassHeading::fromDegrees(93);
        QVERIFY(fleet.stores.swings.changeReading(id, now().swing.readings[3], again));
        QVERIFY(recovery.entriesFor(fleet.stores).empty());
        // Another figure was stored since: it stays, and both are shown.
        keep(3, 94);
        again.compass = CompassHeading::fromDegrees(95);
        QVERIFY(fleet.stores.swings.changeReading(id, now().swing.readings[3], again));
        auto restored = put();
        QCOMPARE(restored.done, 0);
        QCOMPARE(restored.clashes.size(), 1);
        QVERIFY2(restored.clashes[0].contains("94") && restored.clashes[0].contains("95"), qPrintable(restored.clashes[0]));
        QCOMPARE(now().swing.readings[3].compass->degrees(), 95.0);
        QCOMPARE(recovery.entriesFor(fleet.stores).size(), 1u); // until the user forgets it
        recovery.forget(recovery.entriesFor(fleet.stores));
        QVERIFY(recovery.entriesFor(fleet.stores).empty());
        // Typed twice while nothing could be stored: the later one.
        keep(3, 96);
        keep(3, 97);
        QCOMPARE(put().done, 2);
        QCOMPARE(now().swing.readings[3].compass->degrees(), 97.0);
        // The last row is removed, and its number given to another heading.
        const int last = static_cast<int>(now().swing.readings.size()) - 1;
        keep(last, 300);
        QVERIFY(fleet.stores.swings.removeReading(id, now().swing.readings.back().id));
        Reading other;
        other.magnetic = MagneticHeading::fromDegrees(200);
        QVERIFY(fleet.stores.swings.insertReading(id, last, other));
        restored = put();
        QCOMPARE(restored.clashes.size(), 1);
        QVERIFY(!now().swing.readings.back().compass);
        recovery.forget(recovery.entriesFor(fleet.stores));
        // A new row, typed again in its place; and another heading there.
        for (const double magnetic_deg : {210.0, 220.0}) {
            Reading fresh;
            fresh.magnetic = MagneticHeading::fromDegrees(210);
            QVERIFY(recovery.keep(fleet.stores, lostOf(fleet, now(), {static_cast<int>(now().swing.readings.size()), fresh})));
            Reading since;
            since.magnetic = MagneticHeading::fromDegrees(magnetic_deg);
            QVERIFY(fleet.stores.swings.insertReading(id, static_cast<int>(now().swing.readings.size()), since));
            const auto count = now().swing.readings.size();
            QCOMPARE(put().clashes.size(), magnetic_deg == 210.0 ? 0 : 1);
            QCOMPARE(now().swing.readings.size(), count); // not twice
        }
        recovery.forget(recovery.entriesFor(fleet.stores));
        // Completed since: opened again first.
        keep(1, 50);
        Swing whole = now().swing;
        for (Reading& one : whole.readings)
            if (!one.compass)
                one.compass = CompassHeading::fromDegrees(one.magnetic ? one.magnetic->degrees() : 0);
        QVERIFY(fleet.stores.swings.replaceReadings(id, whole.readings));
        QVERIFY(fleet.stores.signing.complete(id));
        const auto complete = now().swing;
        restored = put();
        QCOMPARE(restored.done, 0);
        QCOMPARE(now().swing, complete);
    }

    /// However the database is named: a relative path, a link, another folder after it was moved.
    void itIsOfferedHoweverTheDatabaseIsNamed()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath("fleet.lubberline"), link = folder.filePath("link.lubberline");
        SwingId id;
        RecordId record;
        const Recovery recovery({folder.filePath("a.jsonl")});
        {
            auto stores = db::openStores(path, db::OpenMode::ReadWriteCreate);
            QVERIFY(stores);
            const auto type = (*stores)->fleet.add(AircraftType{{}, {}, "Su-22", "", ""});
            Aircraft aircraft;
            aircraft.type = *type;
            aircraft.registration = "3713";
            CompassSystem compass;
            compass.aircraft = *(*stores)->fleet.add(aircraft);
            compass.name = "standby";
            Swing swing;
            swing.compass = *(*stores)->fleet.add(compass);
            swing.date = "2026-11-20";
            id = *(*stores)->swings.add(swing);
            record = (*stores)->swings.swing(id)->record;
            Reading fresh;
            fresh.magnetic = MagneticHeading::fromDegrees(45);
            QVERIFY(recovery.keep(**stores, {path.toStdString(), id, record, "3713", LostReading{0, fresh}}));
        }
        QVERIFY(QFile::link(path, link));
        const QString here = QDir::currentPath();
        QVERIFY(QDir::setCurrent(folder.path()));
        for (const QString& name : {path, link, QStringLiteral("fleet.lubberline"), QStringLiteral("./link.lubberline")}) {
            auto stores = db::openStores(name, db::OpenMode::ReadWriteCreate);
            QVERIFY(stores);
            QCOMPARE(recovery.entriesFor(**stores).size(), 1u);
        }
        const QString copy = folder.filePath("copy.lubberline");
        QVERIFY(QFile::copy(path, copy));
        {
            auto stores = db::openStores(copy, db::OpenMode::ReadWriteCreate); // a backup has the same identity, and is another file
            QVERIFY(stores);
            QVERIFY(recovery.entriesFor(**stores).empty());
        }
        QVERIFY(QFile::rename(path, folder.filePath("moved.lubberline")));
        auto stores = db::openStores(folder.filePath("moved.lubberline"), db::OpenMode::ReadWriteCreate);
        QCOMPARE(recovery.restore(**stores, recovery.entriesFor(**stores)).done, 1);
        QCOMPARE((*stores)->swings.swing(id)->readings.size(), 1u);
        QDir::setCurrent(here);
    }

    /// A line that somebody else has put there, a pipe that never ends: neither is used, and the start goes on.
    void onlyAFileOfTheUsersOwnIsUsed()
    {
        QTemporaryDir folder;
        SmallFleet fleet;
        const SwingRecord record = *fleet.stores.swings.record(fleet.addSwing("2026-11-20", eightPoints()));
        Reading planted = record.swing.readings[2];
        planted.compass = CompassHeading::fromDegrees(1);
        const LostEntry lost = lostOf(fleet, record, {2, planted, planted.id, record.swing.readings[2]});
        const QString real = folder.filePath("real.jsonl");
        QVERIFY(Recovery({real}).keep(fleet.stores, lost));
        QCOMPARE(
            QFile::permissions(real) & (QFile::ReadGroup | QFile::WriteGroup | QFile::ReadOther | QFile::WriteOther), QFile::Permissions());
        const QString link = folder.filePath("link.jsonl"), pipe = folder.filePath("pipe.jsonl"), open = folder.filePath("open.jsonl");
        QVERIFY(QFile::link(real, link));
        QCOMPARE(::mkfifo(QFile::encodeName(pipe).constData(), 0600), 0);
        QVERIFY(QFile::copy(real, open));
        QCOMPARE(::chmod(QFile::encodeName(open).constData(), 0666), 0);
        QVERIFY(QDir(folder.path()).mkdir("shared"));
        const QString shared = folder.filePath("shared/a.jsonl");
        QVERIFY(QFile::copy(real, shared));
        QCOMPARE(::chmod(QFile::encodeName(folder.filePath("shared")).constData(), 0777), 0);
        for (const QString& path : {link, pipe, open, shared}) {
            const Recovery recovery({path});
            QVERIFY2(recovery.entriesFor(fleet.stores).empty(), qPrintable(path));
            QCOMPARE(recovery.refusals().size(), 1);
            QVERIFY2(!recovery.keep(fleet.stores, lost), qPrintable(path));
        }
        if (::geteuid() == 0) { // only then can another owner's be made
            const QString foreign = folder.filePath("foreign.jsonl");
            QVERIFY(QFile::copy(real, foreign));
            QCOMPARE(::chown(QFile::encodeName(foreign).constData(), 65534, 65534), 0);
            QVERIFY(Recovery({foreign}).entriesFor(fleet.stores).empty());
        }
        QCOMPARE(Recovery({real}).entriesFor(fleet.stores).size(), 1u);
    }

    /// A figure that is typed while somebody else writes for long is kept, and stored when that ends.
    void typingGoesOnWhileAnotherWrites()
    {
        SmallFleet fleet;
        QTemporaryDir folder;
        AnsweringDialogs dialogs;
        QSettings settings(folder.filePath("settings.ini"), QSettings::IniFormat);
        MainWindow window(fleet.stores, {dialogs, settings, {}, {}, {folder.filePath("recovery.jsonl")}});
        window.show();
        QCoreApplication::processEvents();
        window.go(fleet.swing);
        auto* page = window.findChild<SwingPage*>();
        auto importer = fleet.stores.another();
        {
            const auto writing = importer->begin();
            QVERIFY(writing);
            Reading typed;
            typed.magnetic = MagneticHeading::fromDegrees(45);
            QVERIFY(!page->editor().insertReadings(0, {typed}, "reading"));
            QVERIFY(page->editor().waits());
            typed.magnetic = MagneticHeading::fromDegrees(90);
            QVERIFY(!page->editor().insertReadings(1, {typed}, "reading"));
        }
        QTRY_COMPARE_WITH_TIMEOUT(fleet.stores.swings.record(fleet.swing)->swing.readings.size(), 2u, 10000);
        QCOMPARE(page->editor().readings().size(), 2u);
        QVERIFY(window.messages().messages().join(' ').contains("free again"));
        QVERIFY(!QFile::exists(folder.filePath("recovery.jsonl")));
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
