#pragma once
/// A signed swing in a file that somebody writes into behind the program's back.

#include <algorithm>

#include "db/stores/DueStore.h"
#include "db/stores/SwingMarks.h"
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
    /// What lists say, and whether what is due counts it: the same as its page and paper.
    void expectListsFollow()
    {
        const bool holds = standsNow();
        auto database = db::openDatabase(m_path, db::OpenMode::ReadWriteCreate);
        db::SwingStore swings(*database);
        const Swing swing = *swings.swing(m_swing);
        const bool frozen = swing.state == SwingState::Signed, stands = frozen && holds;
        const auto mark = stands ? db::SignedMark::Stands : frozen ? db::SignedMark::ByStateAlone : db::SignedMark::No;
        EXPECT_EQ(db::signedMark(*database, m_swing, swing.state), mark);
        EXPECT_THAT(*db::signedMarks(*database, *swings.swingsOf(swing.compass)), testing::ElementsAre(mark));
        const auto due = db::DueStore(*database).compasses();
        ASSERT_TRUE(due) << describe(due.error());
        const auto of = std::find_if(due->begin(), due->end(), [&](const DueCompass& one) { return one.compass == swing.compass; });
        ASSERT_NE(of, due->end());
        EXPECT_EQ(of->signedSwings, stands ? std::vector<Date>{swing.date} : std::vector<Date>{});
        for (const LimitsFinding& finding : of->findings)
            EXPECT_EQ(finding.isSigned, stands);
    }

    QTemporaryDir m_folder;
    QString m_path = m_folder.filePath("a.db");
    SwingId m_swing;
    std::string m_head;
};

} // namespace lubberline::test
