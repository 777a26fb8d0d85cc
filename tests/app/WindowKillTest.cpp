// Kills the window in the middle of entry, many times, at random moments: on restart all but the cell being typed is there.

#include <gtest/gtest.h>

#include <QProcess>
#include <QTemporaryDir>

#include <map>
#include <random>
#include <thread>

#include "db/engine/Transaction.h"
#include "db/schema/Schema.h"
#include "db/transfer/Maintenance.h"
#include "tests/db/TestFleet.h"

namespace lubberline::test {

namespace {

struct Typed {
    std::map<int, double> magnetic, compass; ///< by row, as the window said it had left the cell
};

void collect(Typed& typed, const QByteArray& output)
{
    for (const QByteArray& line : output.split('\n')) {
        const auto words = line.split(' ');
        if (words.size() == 3)
            (words[0] == "magnetic" ? typed.magnetic : typed.compass)[words[1].toInt()] = words[2].toDouble();
    }
}

} // namespace

TEST(WindowKill, losesAtMostTheCellBeingTyped)
{
    const QTemporaryDir folder;
    const QString path = folder.filePath("a.lubberline");
    SwingId swing;
    {
        auto database = db::openDatabase(path, db::OpenMode::ReadWriteCreate);
        Swing empty = swingOf(store(*database));
        empty.readings.clear();
        swing = *db::SwingStore(*database).add(empty);
    }
    std::mt19937 random(20261123);
    Typed typed;
    int rows = 0, killedInEntry = 0;
    for (int round = 0; round < 12; ++round) {
        QProcess window;
        window.start(LUBBERLINE_WINDOW_TYPIST, {path, QString::number(swing.value), QString::number(rows)});
        ASSERT_TRUE(window.waitForStarted());
        // A random number of cells, then a random moment: on a busy machine too, each round gets into the entry.
        QByteArray output;
        const auto cells = std::uniform_int_distribution(1, 12)(random);
        while (output.count('\n') < cells) {
            ASSERT_TRUE(window.waitForReadyRead(60000)) << "the window types nothing";
            output += window.readAllStandardOutput();
        }
        std::this_thread::sleep_for(std::chrono::microseconds(std::uniform_int_distribution(0, 20000)(random)));
        window.kill(); // SIGKILL
        window.waitForFinished();
        killedInEntry += window.exitStatus() == QProcess::CrashExit;
        collect(typed, output + window.readAllStandardOutput());

        auto database = db::openDatabase(path, db::OpenMode::ReadWriteCreate);
        ASSERT_TRUE(database) << describe(database.error());
        const auto whole = db::SwingStore(*database).swing(swing);
        ASSERT_TRUE(whole);
        const auto& readings = whole->readings;
        for (const auto& [row, figure] : typed.magnetic) {
            ASSERT_LT(static_cast<std::size_t>(row), readings.size()) << "row " << row << " is lost";
            EXPECT_EQ(readings[static_cast<std::size_t>(row)].magnetic, MagneticHeading::fromDegrees(figure)) << "row " << row;
        }
        for (const auto& [row, figure] : typed.compass) {
            ASSERT_LT(static_cast<std::size_t>(row), readings.size()) << "row " << row << " is lost";
            EXPECT_EQ(readings[static_cast<std::size_t>(row)].compass, CompassHeading::fromDegrees(figure)) << "row " << row;
        }
        EXPECT_TRUE(db::verify(*database, {})->findings.empty());
        rows = static_cast<int>(readings.size());
    }
    EXPECT_EQ(killedInEntry, 12);
    EXPECT_GE(typed.magnetic.size(), 12u);
}

/// Somebody imports for long; the crew types on, the machine loses power, and what was typed is offered after the restart.
TEST(WindowKill, losesNothingThatWaitsForAnotherWriter)
{
    const QTemporaryDir folder;
    const QString path = folder.filePath("a.lubberline");
    SwingId swing;
    auto importer = db::openDatabase(path, db::OpenMode::ReadWriteCreate);
    swing = *db::SwingStore(*importer).add(swingOf(store(*importer)));
    const auto before = db::SwingStore(*importer).swing(swing)->readings;
    {
        const auto importing = db::Transaction::begin(*importer);
        ASSERT_TRUE(importing) << describe(importing.error());
        QProcess window;
        window.start(LUBBERLINE_WINDOW_TYPIST, {path, QString::number(swing.value), "over"});
        QByteArray output;
        while (output.count('\n') < static_cast<qsizetype>(before.size())) {
            ASSERT_TRUE(window.waitForReadyRead(60000)) << "the window types nothing";
            output += window.readAllStandardOutput();
        }
        window.kill();
        window.waitForFinished();
        EXPECT_EQ(db::SwingStore(*importer).swing(swing)->readings, before); // nothing came in behind the importer's back
    }
    QProcess window;
    window.start(LUBBERLINE_WINDOW_TYPIST, {path, QString::number(swing.value), "put"});
    ASSERT_TRUE(window.waitForFinished(60000));
    EXPECT_EQ(window.exitCode(), 0) << "nothing is offered";
    const auto readings = db::SwingStore(*importer).swing(swing)->readings;
    ASSERT_EQ(readings.size(), before.size());
    for (std::size_t row = 0; row < readings.size(); ++row)
        EXPECT_EQ(readings[row].compass, CompassHeading::fromDegrees(45.0 * static_cast<double>(row) + 7)) << "row " << row;
    EXPECT_FALSE(QFile::exists(path + ".recovery"));
}

} // namespace lubberline::test
