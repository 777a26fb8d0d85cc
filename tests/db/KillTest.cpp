// Pulls the plug on a writing program, at random moments: what it said to be stored must be there.

#include <gmock/gmock.h>

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>

#include <random>
#include <set>
#include <thread>

#include "db/schema/Schema.h"
#include "db/stores/SigningStore.h"
#include "db/transfer/Maintenance.h"
#include "tests/db/RawDatabase.h"
#include "tests/db/TestFleet.h"

namespace lubberline::test {

namespace {

class Kill : public testing::Test {
protected:
    void SetUp() override
    {
        auto database = db::openDatabase(m_path, db::OpenMode::ReadWriteCreate);
        m_swing = *save(db::SwingStore(*database), swingOf(store(*database)));
    }

    /// Starts the writer and kills it some time later: mostly in the middle of writing, now and then while it opens the
    /// database.
    /// @return the numbers that it said.
    std::vector<std::int64_t> writeAndKill(const QString& what, bool whileOpening)
    {
        QProcess writer;
        writer.start(LUBBERLINE_READING_WRITER, {m_path, what});
        EXPECT_TRUE(writer.waitForStarted());
        EXPECT_TRUE(whileOpening || writer.waitForReadyRead(20000)) << "the writer says nothing";
        std::this_thread::sleep_for(std::chrono::microseconds(std::uniform_int_distribution(0, 40000)(m_random)));
        writer.kill(); // SIGKILL
        writer.waitForFinished();
        EXPECT_EQ(writer.exitStatus(), QProcess::CrashExit) << "it ended by itself";
        std::vector<std::int64_t> said;
        const QByteArray output = writer.readAllStandardOutput();
        for (const QByteArray& line : output.left(output.lastIndexOf('\n') + 1).split('\n'))
            if (!line.isEmpty())
                said.push_back(line.toLongLong());
        return said;
    }

    QTemporaryDir m_folder;
    QString m_path = m_folder.filePath("a.db");
    SwingId m_swing;
    std::mt19937 m_random{20261123};
};

} // namespace

TEST_F(Kill, losesNoReadingThatWasSaidToBeStored)
{
    std::set<std::int64_t> acknowledged;
    for (int round = 0; round < 30; ++round) {
        for (const auto id : writeAndKill(QString::number(m_swing.value), round % 5 == 4))
            acknowledged.insert(id);
        auto database = db::openDatabase(m_path, db::OpenMode::ReadWriteCreate);
        ASSERT_TRUE(database) << describe(database.error());
        std::set<std::int64_t> stored;
        const auto whole = db::SwingStore(*database).swing(m_swing);
        ASSERT_TRUE(whole);
        for (const auto& one : whole->readings)
            stored.insert(one.id.value);
        for (const auto id : acknowledged)
            ASSERT_TRUE(stored.contains(id)) << "reading " << id << " was said to be stored and is lost";
        EXPECT_LE(stored.size(), 8 + acknowledged.size() + static_cast<std::size_t>(round) + 1); // one in flight a kill
        const auto report = db::verify(*database, {});
        ASSERT_TRUE(report);
        EXPECT_THAT(report->findings, testing::IsEmpty());
    }
    EXPECT_GE(acknowledged.size(), 24u); // one at least of each round that got into writing, however slow the machine
}

TEST_F(Kill, leavesNoFleetHalfImported)
{
    std::int64_t acknowledged = 0;
    for (int round = 0; round < 15; ++round) {
        for (const auto swings : writeAndKill("import", false))
            acknowledged = std::max(acknowledged, swings);
        auto database = db::openDatabase(m_path, db::OpenMode::ReadWriteCreate);
        ASSERT_TRUE(database) << describe(database.error());
        const auto swings = db::FleetStore(*database).totals()->swings;
        EXPECT_EQ((swings - 1) % kSwingsAtOnce, 0) << "a part of a fleet is stored";
        EXPECT_GE(swings, acknowledged);
        const auto report = db::verify(*database, {});
        ASSERT_TRUE(report);
        EXPECT_THAT(report->findings, testing::IsEmpty());
    }
    EXPECT_GT(acknowledged, 15 * kSwingsAtOnce);
}

/// Each swing that was said to be signed is, whole and frozen; one in flight is somewhere on its way, and no trail is broken.
TEST_F(Kill, leavesNoSignatureHalfGiven)
{
    std::int64_t acknowledged = 0;
    for (int round = 0; round < 15; ++round) {
        for (const auto id : writeAndKill("sign", false))
            acknowledged = std::max(acknowledged, id);
        auto database = db::openDatabase(m_path, db::OpenMode::ReadWriteCreate);
        ASSERT_TRUE(database) << describe(database.error());
        const auto last = db::SwingStore(*database).swing(SwingId{acknowledged});
        ASSERT_TRUE(last);
        EXPECT_EQ(last->state, SwingState::Signed);
        EXPECT_EQ(*db::SigningStore(*database).hold(last->id), (std::vector<bool>{true, true}));
        const auto report = db::verify(*database, {});
        ASSERT_TRUE(report);
        EXPECT_THAT(report->findings, testing::IsEmpty());
    }
    EXPECT_GT(acknowledged, 15);
}

/// Killed while it copies and migrates: the file is of the old schema or of the new, whole, its copy is whole or not there, and the next
/// start leaves nothing lying about.
TEST(KillMigration, leavesTheOldOrTheNewAndNothingElse)
{
    const QTemporaryDir folder;
    const QString original = folder.filePath("old.db");
    {
        QFile file(QStringLiteral(LUBBERLINE_DB_FIXTURES "/schema6.sql"));
        ASSERT_TRUE(file.open(QIODevice::ReadOnly));
        ASSERT_TRUE(RawDatabase(original).run(QString::fromUtf8(file.readAll()).split('\n', Qt::SkipEmptyParts).filter(";")));
    }
    std::mt19937 random(20261127);
    int before = 0, after = 0;
    for (int round = 0; round < 30; ++round) {
        const QTemporaryDir place;
        const QString path = place.filePath("a.db");
        ASSERT_TRUE(QFile::copy(original, path));
        QProcess writer;
        writer.start(LUBBERLINE_READING_WRITER, {path, "open"});
        ASSERT_TRUE(writer.waitForStarted());
        std::this_thread::sleep_for(std::chrono::milliseconds(std::uniform_int_distribution(0, 200)(random)));
        writer.kill();
        writer.waitForFinished();
        const auto found = db::Database::openAsItIs(path);
        ASSERT_TRUE(found) << describe(found.error());
        EXPECT_TRUE(found->fileSchema() >= 6 && found->fileSchema() <= db::schemaVersion());
        ++(found->fileSchema() == 6 ? before : after);
        {
            auto database = db::openDatabase(path, db::OpenMode::ReadWriteCreate);
            ASSERT_TRUE(database) << describe(database.error());
            EXPECT_THAT(db::verify(*database, {})->findings, testing::IsEmpty());
        }
        const QDir there(place.path());
        for (const QString& copy : there.entryList({"a.db.schema-*.backup"}, QDir::Files))
            EXPECT_GE(db::Database::openAsItIs(there.filePath(copy))->fileSchema(), 6);
        EXPECT_GE(there.entryList({"a.db.schema-6.*.backup"}, QDir::Files).size(), 1);
        EXPECT_EQ(there.entryList({"*.partial*", ".*.partial*"}, QDir::Files | QDir::Hidden).size(), 0);
    }
    EXPECT_GT(before + after, 29);
}

} // namespace lubberline::test
