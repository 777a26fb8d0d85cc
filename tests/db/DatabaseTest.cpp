#include <gmock/gmock.h>

#include <QFile>
#include <QProcess>
#include <QSqlDatabase>

#include "db/Maintenance.h"
#include "db/Statement.h"
#include "db/Transaction.h"
#include "tests/db/TestFleet.h"

namespace lubberline::test {

using db::Database;
using db::OpenMode;

namespace {

std::int64_t pragma(const Database& database, const char* name)
{
    return db::number(database, QStringLiteral("PRAGMA ") + name).value();
}

QByteArray contents(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void write(const QString& path, const QByteArray& bytes)
{
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(bytes);
}

} // namespace

TEST(Database, loosesNothingByItsSettings)
{
    const QTemporaryDir folder;
    const auto database = Database::open(folder.filePath("a.db"), OpenMode::ReadWriteCreate);
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
    const QString text = folder.filePath("letter.db");
    write(text, QByteArray("not a database ").repeated(200));
    const QByteArray before = contents(text);
    const auto letter = Database::open(text, OpenMode::ReadWriteCreate);
    ASSERT_FALSE(letter);
    EXPECT_EQ(letter.error().code, ErrorCode::Format);
    EXPECT_THAT(describe(letter.error()), testing::HasSubstr("letter.db"));
    EXPECT_EQ(contents(text), before);

    const QString foreign = folder.filePath("foreign.db");
    ASSERT_EQ(QProcess::execute("sqlite3", {foreign, "CREATE TABLE song (title TEXT);"}), 0);
    const QByteArray songs = contents(foreign);
    const auto other = Database::open(foreign, OpenMode::ReadWriteCreate);
    ASSERT_FALSE(other);
    EXPECT_EQ(other.error().code, ErrorCode::Format);
    EXPECT_EQ(contents(foreign), songs);
}

TEST(Database, refusesANewerSchemaByName)
{
    const QTemporaryDir folder;
    const QString path = folder.filePath("a.db");
    ASSERT_TRUE(Database::open(path, OpenMode::ReadWriteCreate));
    ASSERT_EQ(QProcess::execute("sqlite3", {path, "PRAGMA user_version = 999;"}), 0);
    const auto database = Database::open(path, OpenMode::ReadWriteCreate);
    ASSERT_FALSE(database);
    EXPECT_EQ(database.error().code, ErrorCode::NewerSchema);
    EXPECT_THAT(database.error().message, testing::AllOf(testing::HasSubstr("999"), testing::HasSubstr(std::to_string(db::schemaVersion()))));
}

TEST(Database, namesMissingFilesAndFolders)
{
    const QTemporaryDir folder;
    EXPECT_EQ(Database::open(folder.filePath("none.db"), OpenMode::ReadOnly).error().code, ErrorCode::NotFound);
    EXPECT_FALSE(QFile::exists(folder.filePath("none.db")));
    const auto nowhere = Database::open(folder.filePath("no/a.db"), OpenMode::ReadWriteCreate);
    ASSERT_FALSE(nowhere);
    EXPECT_EQ(nowhere.error().code, ErrorCode::Io);
    EXPECT_EQ(Database::open(folder.path(), OpenMode::ReadWriteCreate).error().code, ErrorCode::Io);
}

TEST(Database, aDamagedFileIsSaidToBe)
{
    const QTemporaryDir folder;
    const QString path = folder.filePath("a.db");
    {
        auto database = Database::open(path, OpenMode::ReadWriteCreate);
        const Stored stored = store(*database);
        for (int i = 0; i < 200; ++i)
            ASSERT_TRUE(db::SwingRepository(*database).save(swingOf(stored)));
    }
    QByteArray bytes = contents(path);
    for (qsizetype i = 8192; i + 600 < bytes.size(); i += 1500)
        bytes.replace(i, 600, QByteArray(600, '\x5a'));
    write(path, bytes);
    auto database = Database::open(path, OpenMode::ReadOnly);
    if (database) {
        const auto report = db::verify(*database, {});
        EXPECT_TRUE(!report || !report->findings.empty());
    } else {
        EXPECT_THAT(database.error().code, testing::AnyOf(ErrorCode::Corrupt, ErrorCode::Format, ErrorCode::Io));
    }
}

TEST(Database, readsWhatMayOnlyBeReadAndSaysSoOnWriting)
{
    const QTemporaryDir folder;
    const QString path = folder.filePath("a.db");
    Stored stored;
    {
        auto database = Database::open(path, OpenMode::ReadWriteCreate);
        stored = store(*database);
    }
    auto database = Database::open(path, OpenMode::ReadOnly);
    ASSERT_TRUE(database) << describe(database.error());
    EXPECT_TRUE(database->readOnly());
    EXPECT_EQ(db::FleetRepository(*database).totals()->aircraft, 1);
    const auto refused = db::SwingRepository(*database).save(swingOf(stored));
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::ReadOnly);
}

TEST(Database, aWriterElsewhereIsWaitedForThenNamed)
{
    const QTemporaryDir folder;
    const QString path = folder.filePath("a.db");
    auto first = Database::open(path, OpenMode::ReadWriteCreate);
    const Stored stored = store(*first);
    auto second = Database::open(path, OpenMode::ReadWriteCreate);
    ASSERT_TRUE(second);
    {
        const auto held = db::Transaction::begin(*first);
        ASSERT_TRUE(held);
        EXPECT_TRUE(db::FleetRepository(*second).totals()); // readers are not kept out
        const auto refused = db::SwingRepository(*second).save(swingOf(stored));
        ASSERT_FALSE(refused);
        EXPECT_EQ(refused.error().code, ErrorCode::Locked);
    }
    EXPECT_TRUE(db::SwingRepository(*second).save(swingOf(stored)));
}

TEST(Database, aFullDriveKeepsWhatWasThere)
{
    const QTemporaryDir folder;
    auto database = Database::open(folder.filePath("a.db"), OpenMode::ReadWriteCreate);
    const Stored stored = store(*database);
    db::SwingRepository swings(*database);
    ASSERT_TRUE(swings.save(swingOf(stored)));
    const auto pages = pragma(*database, "page_count");
    ASSERT_TRUE(db::execute(*database, QStringLiteral("PRAGMA max_page_count = %1").arg(pages + 4)));
    Result<SwingId> last = SwingId{1};
    int kept = 1;
    for (; last && kept < 500; ++kept)
        last = swings.save(swingOf(stored));
    ASSERT_FALSE(last);
    EXPECT_EQ(last.error().code, ErrorCode::Full);
    EXPECT_EQ(db::FleetRepository(*database).totals()->swings, kept - 1);
    EXPECT_TRUE(db::verify(*database, {})->findings.empty());
}

TEST(Migration, thatFailsLeavesTheFileAsItWas)
{
    const QTemporaryDir folder;
    const QString path = folder.filePath("a.db");
    {
        auto database = Database::open(path, OpenMode::ReadWriteCreate);
        store(*database);
    }
    auto steps = db::migrations();
    steps.push_back({db::schemaVersion() + 1, "a step that breaks half-way", {"CREATE TABLE half (id INTEGER)", "CREATE TABLE half (id INTEGER)"}});
    const auto broken = Database::open(path, OpenMode::ReadWriteCreate, steps);
    ASSERT_FALSE(broken);
    EXPECT_THAT(broken.error().message, testing::HasSubstr("a step that breaks half-way"));
    auto again = Database::open(path, OpenMode::ReadWriteCreate);
    ASSERT_TRUE(again);
    EXPECT_EQ(pragma(*again, "user_version"), db::schemaVersion());
    EXPECT_EQ(db::number(*again, "SELECT COUNT(*) FROM sqlite_master WHERE name = 'half'").value(), 0);
    EXPECT_EQ(db::FleetRepository(*again).totals()->aircraft, 1);
}

TEST(Transaction, thatIsNotCommittedIsRolledBackWithAllInsideIt)
{
    auto database = inMemory();
    {
        auto outer = db::Transaction::begin(database);
        ASSERT_TRUE(outer);
        store(database);
    }
    EXPECT_EQ(db::FleetRepository(database).totals()->aircraft, 0);
}

} // namespace lubberline::test
