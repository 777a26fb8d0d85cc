// A whole guided swing by keyboard in the real window, killed at random moments and taken up again, ending with the card of
// worksheet example Q1 (Compass Compensation Worksheet): 001 043 089 137 181 223 269 317.

#include <gtest/gtest.h>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>

#include <random>
#include <thread>

#include "db/schema/Schema.h"
#include "db/stores/JobStore.h"
#include "db/transfer/Maintenance.h"
#include "tests/db/TestFleet.h"

namespace lubberline::test {

TEST(GuidedKill, aSwingKilledAtAnyStepEndsWithItsCard)
{
    const QTemporaryDir folder;
    const QString path = folder.filePath("a.lubberline");
    Stored stored;
    {
        auto database = db::openDatabase(path, db::OpenMode::ReadWriteCreate);
        stored = store(*database);
    }
    std::mt19937 random(20261123);
    qint64 swing = 0;
    int steps = 0, killed = 0;
    bool done = false;
    for (int round = 0; round < 40 && !done; ++round) {
        QProcess window;
        window.start(LUBBERLINE_GUIDED_CREW, {path, QString::number(stored.compass.value), QString::number(swing)});
        ASSERT_TRUE(window.waitForStarted());
        const int patience = std::uniform_int_distribution(1, 5)(random);
        QByteArray output;
        while (output.count("steps") < patience && !output.contains("done") && window.state() == QProcess::Running) {
            window.waitForReadyRead(60000);
            output += window.readAllStandardOutput();
        }
        std::this_thread::sleep_for(std::chrono::microseconds(std::uniform_int_distribution(0, 30000)(random)));
        window.kill(); // SIGKILL
        window.waitForFinished();
        output += window.readAllStandardOutput();
        done = output.contains("done");
        killed += window.exitStatus() == QProcess::CrashExit;
        for (const QByteArray& line : output.split('\n')) {
            if (line.startsWith("swing "))
                swing = line.mid(6).toLongLong();
            if (line.startsWith("steps "))
                steps = line.mid(6).toInt();
        }
        ASSERT_GT(swing, 0) << "the window did not begin: " << window.exitCode();
        auto database = db::openDatabase(path, db::OpenMode::ReadWriteCreate);
        ASSERT_TRUE(database) << describe(database.error());
        const auto job = db::JobStore(*database).jobOf(SwingId{swing});
        ASSERT_TRUE(job && *job);
        EXPECT_GE(static_cast<int>((*job)->job.events.size()), steps) << "a step that was said to be stored is lost";
        EXPECT_TRUE(db::verify(*database, {})->findings.empty());
        done = done || db::JobStore(*database).open()->empty(); // killed between the record and its word
    }
    ASSERT_TRUE(done);
    EXPECT_GE(killed, 3);

    RecordId record;
    {
        auto database = db::openDatabase(path, db::OpenMode::ReadWriteCreate);
        const auto made = db::SwingStore(*database).swing(SwingId{swing});
        ASSERT_EQ(made->readings.size(), 8u);
        EXPECT_EQ(made->indexRemoved_deg, 3.0);
        record = made->record;
        const auto rows = *db::SwingStore(*database).swingsOf(stored.compass);
        EXPECT_EQ(rows.size(), 2u); // as found, as left; not one of them twice
    }
    QProcess card;
    card.start(LUBBERLINE_PROGRAM, {"card", "--swing", QString::fromStdString(record), "--step", "45", "--json", "--db", path});
    ASSERT_TRUE(card.waitForFinished());
    const QJsonArray rows = QJsonDocument::fromJson(card.readAllStandardOutput()).object()["rows"].toArray();
    const std::array steer{1, 43, 89, 137, 181, 223, 269, 317};
    ASSERT_EQ(rows.size(), 8) << card.readAllStandardError().toStdString();
    for (qsizetype i = 0; i < rows.size(); ++i)
        EXPECT_EQ(rows[i].toObject()["steer_rounded_deg"].toInt(), steer[static_cast<std::size_t>(i)]) << i;
}

} // namespace lubberline::test
