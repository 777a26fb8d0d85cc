// A program that is killed at any call that changes a file while it keeps what could not be stored, puts it in or forgets it: what was said
// to be kept is in the file or in the database, and whole.

#include <QDir>
#include <QProcess>
#include <QTest>

#include <set>

#include "db/transfer/Maintenance.h"
#include "tests/db/TestFleet.h"
#include "ui/kit/Recovery.h"

namespace lubberline::ui {

namespace {

struct Ended {
    bool killed = false;
    QList<int> said;
};

Ended runUntilCall(int call, const QStringList& arguments)
{
    QProcess writer;
    auto environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("LUBBERLINE_KILL_AT"), QString::number(call));
    writer.setProcessEnvironment(environment);
    writer.start(QStringLiteral(LUBBERLINE_RECOVERY_WRITER), arguments);
    if (!writer.waitForFinished(60'000))
        return {};
    Ended ended{writer.exitStatus() == QProcess::CrashExit, {}};
    const QByteArray output = writer.readAllStandardOutput();
    for (const QByteArray& line : output.left(output.lastIndexOf('\n') + 1).split('\n'))
        if (!line.isEmpty())
            ended.said.push_back(line.toInt());
    return ended;
}

} // namespace

class KillAtRecoveryTest : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        const auto stores = db::openStores(path(), db::OpenMode::ReadWriteCreate);
        QVERIFY(stores);
        QVERIFY(test::save((*stores)->swings, test::swingOf(test::store((*stores)->database()))));
    }

    void whatWasSaidToBeKeptIsInTheFile()
    {
        bool ended = false;
        for (int call = 1; !ended && call < 400; ++call) {
            QFile::remove(lines());
            const Ended run = runUntilCall(call, {path(), lines(), QStringLiteral("keep")});
            ended = !run.killed;
            const auto kept = rowsOffered();
            for (const int row : run.said)
                QVERIFY2(kept.contains(row), qPrintable(QStringLiteral("call %1: row %2 was said to be kept").arg(call).arg(row)));
            QVERIFY(kept.size() <= static_cast<std::size_t>(run.said.size()) + 1);
            // A line that was cut short does not spoil the next.
            QVERIFY(!runUntilCall(0, {path(), lines(), QStringLiteral("keep")}).killed);
            QCOMPARE(rowsOffered().size(), kRows);
        }
        QVERIFY(ended);
    }

    void whatIsPutInIsNeverInNeither()
    {
        bool ended = false;
        for (int call = 1; !ended && call < 2000; call += 7) { // a prime: it falls on each kind of call
            QFile::remove(lines());
            init();
            QVERIFY(!runUntilCall(0, {path(), lines(), QStringLiteral("keep")}).killed);
            ended = !runUntilCall(call, {path(), lines(), QStringLiteral("restore")}).killed;
            auto found = rowsOffered();
            for (const int row : rowsStored())
                found.insert(row);
            QVERIFY2(found.size() == kRows, qPrintable(QStringLiteral("call %1: %2 rows").arg(call).arg(found.size())));
            QVERIFY(!runUntilCall(0, {path(), lines(), QStringLiteral("restore")}).killed);
            QCOMPARE(rowsStored().size(), kRows);
            QVERIFY(rowsOffered().empty());
            auto stores = db::openStores(path(), db::OpenMode::ReadOnly);
            QVERIFY(stores && db::verify((*stores)->database(), {})->findings.empty());
        }
        QVERIFY(ended);
    }

    void forgettingTakesAllOrNothing()
    {
        bool ended = false;
        for (int call = 1; !ended && call < 400; ++call) {
            QFile::remove(lines());
            QVERIFY(!runUntilCall(0, {path(), lines(), QStringLiteral("keep")}).killed);
            ended = !runUntilCall(call, {path(), lines(), QStringLiteral("forget")}).killed;
            const auto left = rowsOffered().size();
            QVERIFY2(left == 0 || left == kRows, qPrintable(QStringLiteral("call %1: %2 rows are left").arg(call).arg(left)));
        }
        QVERIFY(ended);
    }

private:
    static constexpr std::size_t kRows = 8;
    [[nodiscard]] QString path() const { return m_folder->filePath(QStringLiteral("a.lubberline")); }
    [[nodiscard]] QString lines() const { return m_folder->filePath(QStringLiteral("kept/lost.jsonl")); }

    std::set<int> rowsOffered() const
    {
        std::set<int> rows;
        const auto stores = db::openStores(path(), db::OpenMode::ReadWriteCreate);
        for (const LostEntry& entry : Recovery({lines()}).entriesFor(**stores))
            rows.insert(std::get<LostReading>(entry.what).row);
        return rows;
    }
    std::set<int> rowsStored() const
    {
        std::set<int> rows;
        const auto stores = db::openStores(path(), db::OpenMode::ReadOnly);
        const auto& readings = (*stores)->swings.swing(SwingId{1})->readings;
        for (int row = 0; row < static_cast<int>(readings.size()); ++row)
            if (readings[static_cast<std::size_t>(row)].compass == CompassHeading::fromDegrees(100 + row))
                rows.insert(row);
        return rows;
    }

    std::unique_ptr<QTemporaryDir> m_folder;
};

} // namespace lubberline::ui

QTEST_GUILESS_MAIN(lubberline::ui::KillAtRecoveryTest)
#include "KillAtRecoveryTest.moc"
