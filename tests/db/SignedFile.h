#pragma once
/// A signed swing in a file that somebody writes into behind the program's back.

#include "tests/db/RawDatabase.h"
#include "tests/db/SwingStores.h"

namespace lubberline::test {

/// A database file with one swing that Ada performed and Ben inspected.
class SignedFile : public testing::Test {
protected:
    void SetUp() override
    {
        auto database = db::openDatabase(m_path, db::OpenMode::ReadWriteCreate);
        ASSERT_TRUE(database);
        const Stored stored = store(*database);
        m_swing = *save(db::SwingStore(*database), worksheetSwing(stored));
        db::SigningStore signing(*database);
        ASSERT_TRUE(signing.complete(m_swing));
        ASSERT_TRUE(signing.sign(m_swing, {SignatureRole::Performer, "Ada", "PL 12", "", ""}));
        ASSERT_TRUE(signing.sign(m_swing, {SignatureRole::Inspector, "Ben", "PL 7", "", ""}));
        ASSERT_THAT(db::verify(*database, {})->findings, testing::IsEmpty());
        m_head = signing.trailHead()->head;
    }

    /// Without any trigger in the way.
    void forge(const QStringList& statements)
    {
        RawDatabase raw(m_path);
        QStringList all;
        {
            auto database = db::openDatabase(m_path, db::OpenMode::ReadOnly);
            db::Statement triggers(*database, "SELECT name FROM sqlite_master WHERE type = 'trigger'");
            const auto names = db::rowsOf<std::string>(triggers, [](db::Statement& row) { return row.text(0); });
            for (const auto& name : *names)
                all += "DROP TRIGGER " + QString::fromStdString(name);
        }
        ASSERT_TRUE(raw.run(all + statements)) << statements.join("; ").toStdString();
    }
    std::vector<std::string> found(const std::vector<db::NotedHead>& heads = {})
    {
        auto database = db::openDatabase(m_path, db::OpenMode::ReadWriteCreate);
        EXPECT_TRUE(database) << describe(database.error());
        const auto report = db::verify(*database, {}, heads);
        EXPECT_TRUE(report) << describe(report.error());
        return inEnglish(report->findings);
    }
    std::vector<bool> holdNow()
    {
        auto database = db::openDatabase(m_path, db::OpenMode::ReadWriteCreate);
        return *db::SigningStore(*database).hold(m_swing);
    }
    bool standsNow()
    {
        auto database = db::openDatabase(m_path, db::OpenMode::ReadWriteCreate);
        db::SigningStore signing(*database);
        return *signing.stands(*db::SwingStore(*database).swing(m_swing), *signing.states(m_swing));
    }

    QTemporaryDir m_folder;
    QString m_path = m_folder.filePath("a.db");
    SwingId m_swing;
    std::string m_head;
};

} // namespace lubberline::test
