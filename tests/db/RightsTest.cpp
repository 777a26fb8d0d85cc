// Files and folders that may not be written. A test run as root may write everything, so what is tried here is tried in a child
// process that has given its rights away.

#include <gmock/gmock.h>

#include <QDir>

#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <functional>

#include "db/schema/Schema.h"
#include "db/transfer/Maintenance.h"
#include "tests/db/RawDatabase.h"
#include "tests/db/TestFleet.h"

namespace lubberline::test {

using db::Database;
using db::OpenMode;

namespace {

/// What `work` answers when it is run by a user without rights: "" when all is as it should be.
std::string asNobody(const std::function<std::string()>& work)
{
    int pipe[2];
    if (::pipe(pipe) != 0)
        return "no pipe";
    const pid_t child = ::fork();
    if (child == 0) {
        constexpr uid_t kNobody = 65534;
        const bool dropped
            = ::geteuid() != 0 || (::setresgid(kNobody, kNobody, kNobody) == 0 && ::setresuid(kNobody, kNobody, kNobody) == 0);
        const std::string text = dropped ? work() : "rights cannot be given away";
        const bool written = ::write(pipe[1], text.data(), text.size()) == static_cast<ssize_t>(text.size());
        ::_exit(written ? 0 : 1);
    }
    ::close(pipe[1]);
    std::string answer(4096, '\0');
    const ssize_t size = ::read(pipe[0], answer.data(), answer.size());
    ::close(pipe[0]);
    int status = 0;
    ::waitpid(child, &status, 0);
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
        return "the child died";
    answer.resize(static_cast<std::size_t>(std::max<ssize_t>(size, 0)));
    return answer;
}

/// "" when the result is an error of this code whose description has these words in it.
template <class T>
std::string expectError(const Result<T>& result, ErrorCode code, const std::string& words)
{
    if (result)
        return "it succeeded";
    const std::string said = describe(result.error());
    return result.error().code == code && said.find(words) != std::string::npos ? "" : said;
}

} // namespace

class Rights : public testing::Test {
protected:
    void SetUp() override
    {
        auto database = openDatabase(m_path, OpenMode::ReadWriteCreate);
        m_stored = store(*database);
        ASSERT_TRUE(save(db::SwingStore(*database), swingOf(m_stored)));
    }
    void TearDown() override { mode(m_folder.path(), 0700); }
    static void mode(const QString& path, mode_t mode) { ASSERT_EQ(::chmod(QFile::encodeName(path).constData(), mode), 0); }
    void protect()
    {
        mode(m_path, 0444);
        mode(m_folder.path(), 0555);
    }

    QTemporaryDir m_folder;
    QString m_path = m_folder.filePath("a.db");
    Stored m_stored;
};

TEST_F(Rights, aProtectedFolderIsReadAndNeverWritten)
{
    protect();
    for (const auto mode : {OpenMode::ReadWriteCreate, OpenMode::ReadOnly})
        EXPECT_EQ(asNobody([&]() -> std::string {
            auto database = openDatabase(m_path, mode);
            if (!database)
                return describe(database.error());
            if (!database->readOnly())
                return "it is not said to be for reading only";
            const auto report = db::verify(*database, {});
            if (!report || report->swings != 1 || !report->findings.empty())
                return "it cannot be read whole";
            return expectError(save(db::SwingStore(*database), swingOf(m_stored)), ErrorCode::ReadOnly, "a.db");
        }),
            "");
    EXPECT_EQ(QDir(m_folder.path()).entryList(QDir::Files), QStringList{"a.db"});
}

TEST_F(Rights, aProtectedFolderTakesNoNewDatabaseAndNoBackup)
{
    protect();
    const std::string folder = m_folder.path().toStdString();
    EXPECT_EQ(
        asNobody([&] { return expectError(openDatabase(m_folder.filePath("new.db"), OpenMode::ReadWriteCreate), ErrorCode::Io, folder); }),
        "");
    EXPECT_EQ(asNobody([&] {
        auto database = openDatabase(m_path, OpenMode::ReadOnly);
        return expectError(db::backup(*database, m_folder.filePath("copy.db")), ErrorCode::Io, folder);
    }),
        "");
    EXPECT_EQ(QDir(m_folder.path()).entryList(QDir::Files), QStringList{"a.db"});
}

TEST_F(Rights, aProtectedFileInAnOpenFolderIsRead)
{
    mode(m_path, 0444);
    mode(m_folder.path(), 0777);
    EXPECT_EQ(asNobody([&]() -> std::string {
        auto database = openDatabase(m_path, OpenMode::ReadWriteCreate);
        if (!database)
            return describe(database.error());
        return expectError(save(db::SwingStore(*database), swingOf(m_stored)), ErrorCode::ReadOnly, "a.db");
    }),
        "");
}

TEST_F(Rights, aFileThatMayNotBeReadIsSaidToBe)
{
    mode(m_path, 0);
    mode(m_folder.path(), 0755);
    EXPECT_EQ(asNobody([&] { return expectError(openDatabase(m_path, OpenMode::ReadOnly), ErrorCode::Io, "a.db"); }), "");
}

TEST_F(Rights, whatWasStoredLastIsNotLeftOutSilently)
{
    const QTemporaryDir other; // a database whose last writer was killed: its log is there and was not folded in
    {
        auto database = openDatabase(m_path, OpenMode::ReadWriteCreate);
        ASSERT_TRUE(save(db::SwingStore(*database), swingOf(m_stored)));
        for (const char* name : {"a.db", "a.db-wal"})
            ASSERT_TRUE(QFile::copy(m_folder.filePath(name), other.filePath(name)));
    }
    ASSERT_GT(QFile(other.filePath("a.db-wal")).size(), 0);
    mode(other.path(), 0555);
    EXPECT_EQ(asNobody([&] {
        return expectError(openDatabase(other.filePath("a.db"), OpenMode::ReadOnly), ErrorCode::Io, "not closed properly");
    }),
        "");
    mode(other.path(), 0777);
    EXPECT_EQ(asNobody([&]() -> std::string {
        auto database = openDatabase(other.filePath("a.db"), OpenMode::ReadOnly);
        if (!database)
            return describe(database.error());
        return db::FleetStore(*database).totals()->swings == 2 ? "" : "the last swing is missing";
    }),
        "");
    mode(other.path(), 0700);
}

} // namespace lubberline::test
