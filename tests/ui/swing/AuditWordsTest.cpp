// The audit trail in words: what, from, to, by whom, to the second.

#include <QTest>

#include "tests/ui/window/Fixture.h"
#include "ui/audit/AuditWords.h"

using namespace lubberline;
using namespace lubberline::ui;

class AuditWordsTest : public QObject {
    Q_OBJECT

private slots:
    void aChangedReadingNamesTheFigure()
    {
        const auto lines = auditLines({"2026-11-27T10:20:30.456Z", "changed reading",
            "nominal 90, magnetic 90.5, compass 88 -> nominal 90, magnetic 90.5, compass 89, note: gust, strong"});
        QCOMPARE(lines.size(), std::size_t{2});
        QCOMPARE(lines[0].when, QString("2026-11-27 10:20:30"));
        QCOMPARE(lines[0].what, QString("compass heading of the reading on 90°"));
        QCOMPARE(lines[0].before, QString("88°"));
        QCOMPARE(lines[0].after, QString("89°"));
        QCOMPARE(lines[1].after, QString("gust, strong"));
    }
    void changedParticularsAreWords()
    {
        const auto lines
            = auditLines({"2026-11-27T10:20:30Z", "changed swing", "kind: 0 -> 1; engines: running; variation_deg: 6.5 -> 6.7"});
        QCOMPARE(lines.size(), std::size_t{3});
        QCOMPARE(lines[0].what, QString("kind"));
        QVERIFY(lines[0].before != "0" && !lines[0].before.isEmpty() && lines[0].before != lines[0].after);
        QCOMPARE(lines[1].after, QString("running"));
        QCOMPARE(lines[2].what, QString("variation (°, E +)"));
    }
    void aSignatureNamesWhoSigned()
    {
        const auto lines = auditLines({"2026-11-27T10:20:30Z", "signed swing", "inspector: Ada Lovelace PL.66.123, hash 0011"});
        QCOMPARE(lines.size(), std::size_t{1});
        QCOMPARE(lines[0].what, QString("signed"));
        QCOMPARE(lines[0].who, QString("Ada Lovelace PL.66.123"));
        QVERIFY(!lines[0].after.contains("hash"));
    }
    void whatIsNotKnownStays()
    {
        const auto lines = auditLines({"2030-01-01T00:00:00Z", "teleported swing", "to: the moon"});
        QCOMPARE(lines.size(), std::size_t{1});
        QCOMPARE(lines[0].what, QString("teleported swing"));
        QCOMPARE(lines[0].after, QString("to: the moon"));
    }
    /// Every entry that a swing's life makes.
    void noCodeOfStorageIsLeft()
    {
        SmallFleet fleet;
        const SwingId id = fleet.addSwing("2026-11-20", eightPoints());
        Swing swing = *fleet.stores.swings.swing(id);
        Reading changed = swing.readings[1];
        changed.compass = CompassHeading::fromDegrees(44);
        QVERIFY(fleet.stores.swings.changeReading(id, swing.readings[1], changed));
        Swing after = *fleet.stores.swings.swing(id);
        after.configuration.engines = "running";
        QVERIFY(fleet.stores.swings.change(*fleet.stores.swings.swing(id), after));
        QVERIFY(fleet.stores.signing.complete(id));
        QVERIFY(fleet.stores.signing.reopen(id, "looked again"));
        const auto rows = fleet.stores.signing.auditOf(swing.record);
        QVERIFY(rows && rows->size() >= 5);
        for (const AuditRow& row : *rows)
            for (const AuditLine& line : auditLines(row)) {
                const QString all = line.what + line.before + line.after;
                QVERIFY2(!all.contains("_") && !all.contains("->"), qPrintable(all));
                QVERIFY(QString::fromStdString(row.what) != line.what);
                QCOMPARE(line.when.size(), 19);
            }
    }
};

QTEST_MAIN(AuditWordsTest)
#include "AuditWordsTest.moc"
