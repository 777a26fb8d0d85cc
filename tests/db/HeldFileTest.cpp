// A file that is opened and closed on the way takes the locks of POSIX with it; another program must not take itself for the only one.

#include <gtest/gtest.h>

#include <QFile>
#include <QProcess>

#include <fcntl.h>
#include <sys/stat.h>

#include "db/engine/HeldFile.h"
#include "db/schema/Schema.h"
#include "tests/db/TestFleet.h"

namespace lubberline::test {

namespace {

ino_t inodeOf(const QString& path)
{
    struct stat found {};
    return ::stat(QFile::encodeName(path).constData(), &found) == 0 ? found.st_ino : 0;
}

class HeldFile : public testing::Test {
protected:
    /// As a dialog for files does, that tells icons by what is in the files.
    void lookIntoFiles()
    {
        for (const char* ending : {"", "-wal", "-shm"}) {
            QFile file(m_path + ending);
            ASSERT_TRUE(file.open(QIODevice::ReadOnly)) << ending;
            file.read(16);
        }
    }

    /// Another program, which closes the database as it should.
    void openElsewhere()
    {
        QProcess other;
        other.start(LUBBERLINE_READING_WRITER, {m_path, "open"});
        ASSERT_TRUE(other.waitForFinished(20000));
        ASSERT_TRUE(other.exitStatus() == QProcess::NormalExit && other.exitCode() == 0) << other.readAllStandardError().constData();
    }

    QTemporaryDir m_folder;
    QString m_path = m_folder.filePath("a.db");
};

} // namespace

#ifdef F_OFD_SETLK

TEST_F(HeldFile, theLogStaysWhereItIsWrittenTo)
{
    auto database = db::openDatabase(m_path, db::OpenMode::ReadWriteCreate);
    ASSERT_TRUE(database.ok());
    store(*database);
    const db::HeldFile held(m_path);
    const ino_t log = inodeOf(m_path + "-wal"), memory = inodeOf(m_path + "-shm");
    ASSERT_NE(log, ino_t{0});
    lookIntoFiles();
    openElsewhere();
    EXPECT_EQ(inodeOf(m_path + "-wal"), log);
    EXPECT_EQ(inodeOf(m_path + "-shm"), memory);
}

TEST_F(HeldFile, whoLeavesLastStillTidiesUp)
{
    {
        auto database = db::openDatabase(m_path, db::OpenMode::ReadWriteCreate);
        ASSERT_TRUE(database.ok());
        {
            const db::HeldFile held(m_path);
            store(*database);
            auto worker = db::openDatabase(m_path, db::OpenMode::ReadWriteCreate); // beside it, and gone before it
            ASSERT_TRUE(worker.ok());
        }
    }
    EXPECT_EQ(inodeOf(m_path + "-wal"), ino_t{0});
    auto again = db::openDatabase(m_path, db::OpenMode::ReadOnly);
    EXPECT_TRUE(again.ok());
}

#endif

} // namespace lubberline::test
