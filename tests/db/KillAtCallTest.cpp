// Killed at a certain call that changes a file, one after the other (KillAtCall.cpp). KillTest does it at random moments.

#include <gmock/gmock.h>

#include <QDir>
#include <QProcess>

#include "db/schema/Schema.h"
#include "db/stores/SigningStore.h"
#include "db/transfer/Maintenance.h"
#include "tests/db/RawDatabase.h"
#include "tests/db/TestFleet.h"

namespace lubberline::test {

namespace {

/// Each of the 155 calls from schema 6 on was tried: that takes a minute. A prime, so that the step falls on each kind of call.
constexpr int kStep = 11;

struct Ended {
    bool killed = false;
    std::vector<std::int64_t> said;
};

Ended runUntilCall(int call, const QStringList& arguments)
{
    QProcess writer;
    auto environment = QProcessEnvironment::systemEnvironment();
    environment.insert("LUBBERLINE_KILL_AT", QString::number(call));
    writer.setProcessEnvironment(environment);
    writer.start(LUBBERLINE_READING_WRITER, arguments);
    EXPECT_TRUE(writer.waitForFinished(60'000));
    Ended ended{writer.exitStatus() == QProcess::CrashExit, {}};
    const QByteArray output = writer.readAllStandardOutput();
    for (const QByteArray& line : output.left(output.lastIndexOf('\n') + 1).split('\n'))
        if (!line.isEmpty())
            ended.said.push_back(line.toLongLong());
    return ended;
}

QStringList leftoversIn(const QDir& folder)
{
    QStringList left;
    for (const QString& name : folder.entryList(QDir::Files | QDir::Hidden))
        if (name.contains("partial") || name.endsWith("-journal") || name.endsWith("-wal") || name.endsWith("-shm"))
            left += name;
    return left;
}

} // namespace

class KillAtCall : public testing::TestWithParam<int> {};

TEST_P(KillAtCall, ofAMigrationLeavesAWholeFileOfOneSchemaAndNothingElse)
{
    const QTemporaryDir folder;
    const QString original = folder.filePath("old.db");
    const QString fixture = QString::fromUtf8(contents(QStringLiteral(LUBBERLINE_DB_FIXTURES "/schema%1.sql").arg(GetParam())));
    ASSERT_TRUE(RawDatabase(original).run(fixture.split('\n', Qt::SkipEmptyParts).filter(";")));
    int killed = 0;
    for (int call = 1;; call += kStep) {
        SCOPED_TRACE(call);
        const QTemporaryDir place;
        const QDir there(place.path());
        const QString path = there.filePath("a.db");
        ASSERT_TRUE(QFile::copy(original, path));
        const Ended ended = runUntilCall(call, {path, "open"});
        if (!ended.killed) {
            EXPECT_THAT(ended.said, testing::ElementsAre(1));
            break;
        }
        ++killed;
        {
            const auto found = db::Database::openAsItIs(path);
            ASSERT_TRUE(found) << describe(found.error());
            EXPECT_TRUE(found->fileSchema() >= GetParam() && found->fileSchema() <= db::schemaVersion()) << found->fileSchema();
            EXPECT_TRUE(ended.said.empty() || found->fileSchema() == db::schemaVersion()) << "it said that the database is open";
        }
        {
            auto database = db::openDatabase(path, db::OpenMode::ReadWriteCreate);
            ASSERT_TRUE(database) << describe(database.error());
            const auto report = db::verify(*database, {});
            EXPECT_THAT(inEnglish(report->findings), testing::IsEmpty());
            EXPECT_EQ(report->readings, 16);
        }
        EXPECT_THAT(leftoversIn(there), testing::IsEmpty());
        EXPECT_GE(there.entryList({QStringLiteral("a.db.schema-%1.*.backup").arg(GetParam())}, QDir::Files).size(), 1);
        for (const QString& copy : there.entryList({"a.db.schema-*.backup"}, QDir::Files)) {
            const auto copied = db::Database::openAsItIs(there.filePath(copy));
            ASSERT_TRUE(copied) << describe(copied.error());
            EXPECT_TRUE(copy.startsWith(QStringLiteral("a.db.schema-%1.").arg(copied->fileSchema()))) << copy.toStdString();
        }
    }
    EXPECT_GE(killed, 5);
}

INSTANTIATE_TEST_SUITE_P(FromSchema, KillAtCall, testing::Values(1, 6));

TEST(KillAtCallOfSigning, losesNoSignatureThatWasSaidToBeGiven)
{
    const QTemporaryDir folder;
    const QString original = folder.filePath("old.db");
    {
        auto database = db::openDatabase(original, db::OpenMode::ReadWriteCreate);
        ASSERT_TRUE(save(db::SwingStore(*database), swingOf(store(*database))));
    }
    std::size_t signedOnes = 0;
    for (int call = 1; call < 20 * kStep; call += kStep) { // some three swings from draft to frozen
        SCOPED_TRACE(call);
        const QTemporaryDir place;
        const QDir there(place.path());
        const QString path = there.filePath("a.db");
        ASSERT_TRUE(QFile::copy(original, path));
        const Ended ended = runUntilCall(call, {path, "sign"});
        ASSERT_TRUE(ended.killed);
        {
            auto database = db::openDatabase(path, db::OpenMode::ReadWriteCreate);
            ASSERT_TRUE(database) << describe(database.error());
            db::SigningStore signing(*database);
            for (const auto id : ended.said)
                EXPECT_EQ(*signing.hold(SwingId{id}), (std::vector<bool>{true, true})) << id << " was said to be signed";
            EXPECT_THAT(inEnglish(db::verify(*database, {})->findings), testing::IsEmpty());
            signedOnes = std::max(signedOnes, ended.said.size());
        }
        EXPECT_THAT(leftoversIn(there), testing::IsEmpty());
    }
    EXPECT_GE(signedOnes, 1u);
}

} // namespace lubberline::test
