#include <gmock/gmock.h>

#include <QDir>

#include <thread>

#include "db/engine/Statement.h"
#include "db/engine/Transaction.h"
#include "db/schema/Schema.h"
#include "db/transfer/Maintenance.h"
#include "tests/db/RawDatabase.h"
#include "tests/db/TestFleet.h"

namespace lubberline::test {

using db::Database;
using db::OpenMode;

namespace {

std::int64_t pragma(const Database& database, const char* name) { return db::number(database, QStringLiteral("PRAGMA ") + name).value(); }

} // namespace

TEST(Database, losesNothingByItsSettings)
{
    const QTemporaryDir folder;
    const auto database = openDatabase(folder.filePath("a.db"), OpenMode::ReadWriteCreate);
    ASSERT_TRUE(database) << describe(database.error());
    EXPECT_EQ(pragma(*database, "foreign_keys"), 1);
    EXPECT_EQ(pragma(*database, "synchronous"), 2); // FULL
    EXPECT_EQ(pragma(*database, "application_id"), 0x4C554242);
    EXPECT_EQ(pragma(*database, "user_version"), db::schemaVersion());
    db::Statement journal(*database, "PRAGMA journal_mode");
    ASSERT_TRUE(journal.run() && journal.next());
    EXPECT_EQ(journal.text(0), "wal");
}

TEST(Database, refusesWhatIsNotOursAndLeavesItAlone)
{
    const QTemporaryDir folder;
    const QString path = folder.filePath("letter.db");
    for (const QByteArray& bytes : {QByteArray("hello"), QByteArray("not a database ").repeated(200), QByteArray("SQLite format 3\0", 16),
             QByteArray(1000, '\0'), QByteArray("%PDF-1.6\n\x80\xff\x00\x01", 13).repeated(99)}) {
        ASSERT_TRUE(write(path, bytes));
        for (const auto mode : {OpenMode::ReadWriteCreate, OpenMode::ReadOnly}) {
            const auto letter = openDatabase(path, mode);
            ASSERT_FALSE(letter) << bytes.left(16).constData();
            EXPECT_EQ(letter.error().code, ErrorCode::Format);
            EXPECT_THAT(describe(letter.error()), testing::HasSubstr("letter.db"));
        }
        EXPECT_EQ(contents(path), bytes);
    }
    const QString foreign = folder.filePath("foreign.db");
    ASSERT_TRUE(RawDatabase(foreign).run({"CREATE TABLE song (title TEXT)"}));
    const QByteArray songs = contents(foreign);
    const auto other = openDatabase(foreign, OpenMode::ReadWriteCreate);
    ASSERT_FALSE(other);
    EXPECT_EQ(other.error().code, ErrorCode::Format);
    EXPECT_EQ(contents(foreign), songs);
}

TEST(Database, anEmptyFileBecomesOneButCannotBeRead)
{
    const QTemporaryDir folder;
    const QString path = folder.filePath("empty.db");
    ASSERT_TRUE(write(path, {}));
    EXPECT_EQ(openDatabase(path, OpenMode::ReadOnly).error().code, ErrorCode::Format);
    EXPECT_EQ(contents(path).size(), 0);
    EXPECT_TRUE(openDatabase(path, OpenMode::ReadWriteCreate));
    EXPECT_TRUE(openDatabase(path, OpenMode::ReadOnly));
}

TEST(Database, namesMissingFilesAndFolders)
{
    const QTemporaryDir folder;
    EXPECT_EQ(openDatabase(folder.filePath("none.db"), OpenMode::ReadOnly).error().code, ErrorCode::NotFound);
    EXPECT_FALSE(QFile::exists(folder.filePath("none.db")));
    const auto nowhere = openDatabase(folder.filePath("no/a.db"), OpenMode::ReadWriteCreate);
    ASSERT_FALSE(nowhere);
    EXPECT_EQ(nowhere.error().code, ErrorCode::Io);
    EXPECT_THAT(nowhere.error().message.english(), testing::HasSubstr(folder.filePath("no").toStdString()));
    EXPECT_EQ(openDatabase(folder.path(), OpenMode::ReadWriteCreate).error().code, ErrorCode::Io);
}

TEST(Database, aDamagedFileIsSaidToBeAndNotReadInPart)
{
    const QTemporaryDir folder;
    const QString path = folder.filePath("a.db");
    {
        auto database = openDatabase(path, OpenMode::ReadWriteCreate);
        const Stored stored = store(*database);
        auto all = db::Transaction::begin(*database);
        for (int i = 0; i < 200; ++i)
            ASSERT_TRUE(save(db::SwingStore(*database), swingOf(stored)));
        ASSERT_TRUE(all->commit());
    }
    const QByteArray whole = contents(path);
    QByteArray bytes = whole;
    const qsizetype third = bytes.size() / 3 / 4096 * 4096; // whole pages; the schema is among the first
    bytes.replace(bytes.size() - third, third, QByteArray(third, '\x5a'));
    ASSERT_TRUE(write(path, bytes));
    auto database = openDatabase(path, OpenMode::ReadOnly);
    ASSERT_TRUE(database) << describe(database.error()); // the first page is whole
    int visited = 0;
    const auto read = db::SwingStore(*database).forEach([&](const Swing&) { return ++visited > 0; });
    ASSERT_FALSE(read) << visited << " swings were read as if they were all";
    EXPECT_EQ(read.error().code, ErrorCode::Corrupt);
    EXPECT_THAT(describe(read.error()), testing::AllOf(testing::HasSubstr("a.db"), testing::HasSubstr("backup")));
    const auto report = db::verify(*database, {});
    EXPECT_TRUE(!report || !report->findings.empty());

    for (const qsizetype size : {whole.size() / 2, qsizetype{4096}, qsizetype{100}}) { // cut off
        ASSERT_TRUE(write(path, whole.left(size)));
        auto cut = openDatabase(path, OpenMode::ReadOnly);
        const auto found = cut ? db::verify(*cut, {}) : Result<db::VerifyReport>(cut.error());
        EXPECT_TRUE(!found || !found->findings.empty()) << size;
        if (!found) {
            EXPECT_THAT(found.error().code, testing::AnyOf(ErrorCode::Corrupt, ErrorCode::Format)) << describe(found.error());
        }
    }
}

TEST(Database, readsWhatMayOnlyBeReadAndSaysSoOnWriting)
{
    const QTemporaryDir folder;
    const QString path = folder.filePath("a.db");
    Stored stored;
    {
        auto database = openDatabase(path, OpenMode::ReadWriteCreate);
        stored = store(*database);
    }
    auto database = openDatabase(path, OpenMode::ReadOnly);
    ASSERT_TRUE(database) << describe(database.error());
    EXPECT_TRUE(database->readOnly());
    EXPECT_EQ(db::FleetStore(*database).totals()->aircraft, 1);
    const auto refused = save(db::SwingStore(*database), swingOf(stored));
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::ReadOnly);
    EXPECT_FALSE(db::execute(*database, "DELETE FROM event"));
    ASSERT_TRUE(db::backup(*database, folder.filePath("copy.db")));
    EXPECT_FALSE(db::execute(*database, "DELETE FROM event"));               // still
    database = openDatabase(folder.filePath("copy.db"), OpenMode::ReadOnly); // closes the first
    ASSERT_TRUE(database);
    database = Error{};
    EXPECT_EQ(QDir(folder.path()).entryList(QDir::Files), (QStringList{"a.db", "copy.db"})); // nothing is left beside them
}

TEST(Database, aWriterElsewhereIsWaitedForThenNamed)
{
    const QTemporaryDir folder;
    const QString path = folder.filePath("a.db");
    auto first = openDatabase(path, OpenMode::ReadWriteCreate);
    const Stored stored = store(*first);
    auto second = openDatabase(path, OpenMode::ReadWriteCreate);
    ASSERT_TRUE(second);
    {
        const auto held = db::Transaction::begin(*first);
        ASSERT_TRUE(held);
        EXPECT_TRUE(db::FleetStore(*second).totals()); // readers are not kept out
        const auto refused = save(db::SwingStore(*second), swingOf(stored));
        ASSERT_FALSE(refused);
        EXPECT_EQ(refused.error().code, ErrorCode::Locked);
    }
    EXPECT_TRUE(save(db::SwingStore(*second), swingOf(stored)));
}

TEST(Database, aFullDriveKeepsWhatWasThere)
{
    const QTemporaryDir folder;
    auto database = openDatabase(folder.filePath("a.db"), OpenMode::ReadWriteCreate);
    const Stored stored = store(*database);
    db::SwingStore swings(*database);
    ASSERT_TRUE(save(swings, swingOf(stored)));
    const auto pages = pragma(*database, "page_count");
    ASSERT_TRUE(db::execute(*database, QStringLiteral("PRAGMA max_page_count = %1").arg(pages + 4)));
    Result<SwingId> last = SwingId{1};
    int kept = 1;
    for (; last && kept < 500; ++kept)
        last = save(swings, swingOf(stored));
    ASSERT_FALSE(last);
    EXPECT_EQ(last.error().code, ErrorCode::Full);
    EXPECT_EQ(db::FleetStore(*database).totals()->swings, kept - 1);
    EXPECT_TRUE(db::verify(*database, {})->findings.empty());
}

TEST(Database, oneThatIsHeldForItselfIsLockedAndSaysWhatToDo)
{
    const QTemporaryDir folder;
    const QString path = folder.filePath("a.db");
    ASSERT_TRUE(openDatabase(path, OpenMode::ReadWriteCreate));
    RawDatabase greedy(path);
    ASSERT_TRUE(greedy.run({"PRAGMA locking_mode = EXCLUSIVE", "BEGIN EXCLUSIVE"}));
    const auto refused = openDatabase(path, OpenMode::ReadWriteCreate);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::Locked);
    EXPECT_THAT(describe(refused.error()), testing::AllOf(testing::HasSubstr("a.db"), testing::HasSubstr("close the other program")));
}

TEST(Database, aNewOneMayBeOpenedByManyAtOnce)
{
    for (int round = 0; round < 10; ++round) {
        const QTemporaryDir folder;
        const QString path = folder.filePath("a.db");
        std::array<std::string, 6> outcome;
        {
            std::vector<std::jthread> threads;
            for (auto& text : outcome)
                threads.emplace_back([&text, path] {
                    const auto database = openDatabase(path, OpenMode::ReadWriteCreate);
                    text = database ? "" : describe(database.error());
                });
        }
        EXPECT_THAT(outcome, testing::Each(""));
    }
}

TEST(Transaction, thatIsNotCommittedIsRolledBackWithAllInsideIt)
{
    auto database = inMemory();
    {
        auto outer = db::Transaction::begin(database);
        ASSERT_TRUE(outer);
        store(database);
    }
    EXPECT_EQ(db::FleetStore(database).totals()->aircraft, 0);
}

TEST(Transaction, cannotBeCommittedWhenAPartOfItWasNot)
{
    auto database = inMemory();
    {
        auto outer = db::Transaction::begin(database);
        store(database);
        {
            const auto inner = db::Transaction::begin(database);
        }
        ASSERT_TRUE(save(db::FleetStore(database), AircraftType{{}, {}, "afterwards", "", ""}).error().code == ErrorCode::Conflict);
        EXPECT_FALSE(outer->commit());
    }
    EXPECT_EQ(db::FleetStore(database).totals()->types, 0);
    EXPECT_TRUE(save(db::FleetStore(database), AircraftType{{}, {}, "next", "", ""})); // the next one is not broken
    EXPECT_EQ(db::FleetStore(database).totals()->types, 1);
}

TEST(Transaction, forReadingSeesOneMoment)
{
    const QTemporaryDir folder;
    auto writer = openDatabase(folder.filePath("a.db"), OpenMode::ReadWriteCreate);
    const Stored stored = store(*writer);
    auto reader = openDatabase(folder.filePath("a.db"), OpenMode::ReadWriteCreate);
    {
        const auto moment = db::Transaction::beginReading(*reader);
        EXPECT_EQ(db::FleetStore(*reader).totals()->swings, 0);
        ASSERT_TRUE(save(db::SwingStore(*writer), swingOf(stored)));
        EXPECT_EQ(db::FleetStore(*reader).totals()->swings, 0);
    }
    EXPECT_EQ(db::FleetStore(*reader).totals()->swings, 1);
}

} // namespace lubberline::test
