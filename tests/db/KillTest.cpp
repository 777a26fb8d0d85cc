// Pulls the plug on a writing program, at random moments: what it said to be stored must be there.

#include <gtest/gtest.h>

#include <QProcess>
#include <QTemporaryDir>

#include <random>
#include <set>
#include <thread>

#include "db/Maintenance.h"
#include "tests/db/TestFleet.h"

namespace lubberline::test {

TEST(Kill, losesNothingThatWasSaidToBeStored)
{
    const QTemporaryDir folder;
    const QString path = folder.filePath("a.db");
    SwingId swing;
    {
        auto database = db::Database::open(path, db::OpenMode::ReadWriteCreate);
        Swing empty = swingOf(store(*database));
        empty.readings.clear();
        swing = *db::SwingRepository(*database).save(empty);
    }
    std::mt19937 random(20261123);
    std::set<std::int64_t> acknowledged;
    for (int round = 0; round < 30; ++round) {
        QProcess writer;
        writer.start(LUBBERLINE_READING_WRITER, {path, QString::number(swing.value)});
        ASSERT_TRUE(writer.waitForStarted());
        std::this_thread::sleep_for(std::chrono::milliseconds(std::uniform_int_distribution(5, 90)(random)));
        writer.kill(); // SIGKILL
        writer.waitForFinished();
        for (const QByteArray& line : writer.readAllStandardOutput().split('\n'))
            if (line.size() > 0)
                acknowledged.insert(line.toLongLong());

        auto database = db::Database::open(path, db::OpenMode::ReadWriteCreate);
        ASSERT_TRUE(database) << describe(database.error());
        std::set<std::int64_t> stored;
        const auto whole = db::SwingRepository(*database).swing(swing);
        ASSERT_TRUE(whole);
        for (const auto& one : whole->readings)
            stored.insert(one.id.value);
        for (const auto id : acknowledged)
            ASSERT_TRUE(stored.contains(id)) << "reading " << id << " was said to be stored and is lost";
        EXPECT_LE(stored.size(), acknowledged.size() + static_cast<std::size_t>(round) + 1); // one in flight a kill
        const auto report = db::verify(*database, {});
        ASSERT_TRUE(report);
        EXPECT_TRUE(report->findings.empty()) << report->findings.front();
    }
    EXPECT_GT(acknowledged.size(), 0u); // a busy machine may write little in the time
}

} // namespace lubberline::test
