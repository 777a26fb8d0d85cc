#include <gmock/gmock.h>

#include <QDir>

#include "core/format/exchange/SignedContent.h"
#include "db/engine/Statement.h"
#include "db/schema/Schema.h"
#include "db/stores/JobStore.h"
#include "db/stores/ResultCache.h"
#include "db/stores/SensorStore.h"
#include "db/stores/SigningStore.h"
#include "db/stores/SiteStore.h"
#include "db/stores/SwingStore.h"
#include "db/transfer/Maintenance.h"
#include "db/transfer/Transfer.h"
#include "tests/db/RawDatabase.h"
#include "tests/db/TestFleet.h"

namespace lubberline::test {

using db::Database;
using db::OpenMode;

namespace {

/// A database of an old schema as it was written then.
bool restoreSchema(int schema, const QString& path)
{
    QFile file(QStringLiteral(LUBBERLINE_DB_FIXTURES "/schema%1.sql").arg(schema));
    if (!file.open(QIODevice::ReadOnly))
        return false;
    const QStringList statements = QString::fromUtf8(file.readAll()).split('\n', Qt::SkipEmptyParts).filter(";"); // the comment has none
    return statements.size() > 50 && RawDatabase(path).run(statements);
}

std::int64_t version(const Database& database) { return db::number(database, "PRAGMA user_version").value(); }

} // namespace

class OldDatabase : public testing::TestWithParam<int> {
protected:
    void SetUp() override { ASSERT_TRUE(restoreSchema(GetParam(), m_path)); }

    QTemporaryDir m_folder;
    QString m_path = m_folder.filePath("old.db");
};

TEST_P(OldDatabase, isBroughtUpToDateWithAllThatIsInIt)
{
    auto database = openDatabase(m_path, OpenMode::ReadWriteCreate);
    ASSERT_TRUE(database) << describe(database.error());
    EXPECT_EQ(version(*database), db::schemaVersion());
    db::FleetStore fleet(*database);
    db::SwingStore swings(*database);
    EXPECT_EQ(fleet.types()->front().name, "Su-22");
    EXPECT_EQ(fleet.types()->front().status, Status::OutOfLimits);
    EXPECT_EQ(fleet.eventsOf(AircraftId{1})->front().kind, "lightning strike");
    const auto rows = *swings.swingsOf(CompassId{1});
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_EQ(rows[0].maxAbsDeviation_deg, 17.0);
    EXPECT_EQ(rows[1].state, SwingState::Signed);
    const auto draft = *swings.swing(rows[0].id);
    EXPECT_EQ(draft.readings[1].extra.front().second, "12");
    EXPECT_EQ(draft.readings[2].exclusion->reason, "misread");
    const auto report = db::verify(*database, {});
    ASSERT_TRUE(report);
    EXPECT_THAT(report->findings, testing::IsEmpty());
    EXPECT_EQ(report->readings, 16);
    EXPECT_TRUE(save(swings, swingOf({{}, {}, {}, SiteId{1}, CompassId{1}})));
}

TEST_P(OldDatabase, thatIsOnlyReadIsReadAsACopyAndLeftAlone)
{
    const QByteArray before = contents(m_path);
    auto database = openDatabase(m_path, OpenMode::ReadOnly);
    ASSERT_TRUE(database) << describe(database.error());
    EXPECT_TRUE(database->readAsCopy() && database->readOnly());
    EXPECT_EQ(database->fileSchema(), GetParam());
    EXPECT_THAT(inEnglish(database->told()), testing::ElementsAre(testing::HasSubstr("schema " + std::to_string(GetParam()))));
    EXPECT_EQ(db::FleetStore(*database).types()->front().name, "Su-22");
    EXPECT_FALSE(save(db::SiteStore(*database), Site{{}, {}, "Mielec", {}, {}, {}, {}, {}, {}}));
    const auto report = db::verify(*database, {});
    ASSERT_TRUE(report) << describe(report.error());
    EXPECT_THAT(report->findings, testing::IsEmpty());
    EXPECT_THAT(inEnglish(report->notes), testing::Contains(testing::HasSubstr("old schema " + std::to_string(GetParam()))));
    EXPECT_EQ(db::exportFleet(*database, {}, {})->swings.size(), 2u);
    EXPECT_EQ(db::status(*database)->schema, GetParam());
    const QString copy = m_folder.filePath("backup.db");
    ASSERT_TRUE(db::backup(*database, copy));
    EXPECT_EQ(Database::openAsItIs(copy)->fileSchema(), GetParam()); // as it is, not brought up to date
    EXPECT_EQ(contents(m_path), before);
}

TEST_P(OldDatabase, isCopiedBesideBeforeItIsBroughtUpToDate)
{
    const QStringList before = QDir(m_folder.path()).entryList(QDir::Files);
    {
        auto database = openDatabase(m_path, OpenMode::ReadWriteCreate);
        ASSERT_TRUE(database) << describe(database.error());
        const auto head = db::SigningStore(*database).trailHead();
        ASSERT_TRUE(head);
        EXPECT_GT(head->before, 0); // what was there before is said
        EXPECT_THAT(inEnglish(db::verify(*database, {})->notes), testing::Contains(testing::HasSubstr("chained from")));
        const QStringList copies = QDir(m_folder.path()).entryList({"old.db.schema-*.backup"}, QDir::Files);
        ASSERT_EQ(copies.size(), 1);
        EXPECT_THAT(inEnglish(database->told()), testing::ElementsAre(testing::HasSubstr(m_folder.filePath(copies[0]).toStdString())));
        EXPECT_EQ(Database::openAsItIs(m_folder.filePath(copies[0]))->fileSchema(), GetParam());
    }
    EXPECT_TRUE(openDatabase(m_path, OpenMode::ReadWriteCreate)->told().empty()); // once
    EXPECT_EQ(QDir(m_folder.path()).entryList(QDir::Files).size(), before.size() + 1);
}

TEST_P(OldDatabase, isLeftAsItWasWhenAStepFails)
{
    auto steps = db::migrations();
    steps.push_back({db::schemaVersion() + 1, "a step that breaks half-way",
        {"CREATE TABLE half (id INTEGER)", "DELETE FROM event", "CREATE TABLE half (id INTEGER)"}});
    const auto broken = Database::open(m_path, OpenMode::ReadWriteCreate, steps);
    ASSERT_FALSE(broken);
    EXPECT_THAT(broken.error().message.english(), testing::HasSubstr("a step that breaks half-way"));
    auto again = openDatabase(m_path, OpenMode::ReadWriteCreate);
    ASSERT_TRUE(again);
    EXPECT_EQ(version(*again), db::schemaVersion()); // the steps before the broken one are whole
    EXPECT_EQ(db::number(*again, "SELECT COUNT(*) FROM sqlite_master WHERE name = 'half'").value(), 0);
    EXPECT_EQ(db::FleetStore(*again).eventsOf(AircraftId{1})->size(), 1u);
}

TEST_P(OldDatabase, keepsItsSwingsWithoutAFieldAndTakesOneForTheDraft)
{
    auto database = openDatabase(m_path, OpenMode::ReadWriteCreate);
    ASSERT_TRUE(database) << describe(database.error());
    db::SwingStore swings(*database);
    Swing draft = *swings.swing(SwingId{2});
    const Swing signedOne = *swings.swing(SwingId{1});
    EXPECT_FALSE(draft.indexRemoved_deg || signedOne.field || signedOne.indexRemoved_deg);
    EXPECT_EQ(draft.field.has_value(), GetParam() >= 3); // the fixture of schema 3 has one
    draft.field = FieldStamp{"WMM2025", {51.55, 21.89, 117}, "2026-11-20", {18900, 2300, 46500}};
    ASSERT_TRUE(save(swings, draft));
    EXPECT_EQ(swings.swing(SwingId{2})->field, draft.field);
    EXPECT_EQ(db::execute(*database, "UPDATE swing SET index_removed_deg = 1 WHERE id = 1").error().code, ErrorCode::Frozen);
    EXPECT_EQ(db::SensorStore(*database).of(CompassId{1})->empty(), GetParam() < 3);
    EXPECT_THAT(db::verify(*database, {})->findings, testing::IsEmpty());
}

TEST_P(OldDatabase, hasNoJobsAndSignaturesAndTakesThem)
{
    auto database = openDatabase(m_path, OpenMode::ReadWriteCreate);
    ASSERT_TRUE(database) << describe(database.error());
    db::SwingStore swings(*database);
    const Swing signedOne = *swings.swing(SwingId{1});
    EXPECT_EQ(signedOne.revision, 1);
    EXPECT_EQ(signedOne.signatures.size(), GetParam() < 4 ? 0u : 2u); // signed before signatures were kept: it stays frozen all the same
    EXPECT_FALSE(*db::JobStore(*database).jobOf(SwingId{1}));
    db::SigningStore signing(*database);
    EXPECT_TRUE(*signing.stands(signedOne, *signing.states(SwingId{1})));
    const auto made = signing.amend(SwingId{1}, "wrong site");
    ASSERT_TRUE(made) << describe(made.error());
    EXPECT_EQ(swings.swing(*made)->supersedes, signedOne.record);
    ASSERT_TRUE(signing.complete(*made));
    ASSERT_TRUE(signing.sign(*made, {SignatureRole::Performer, "Ada", "", "", ""}));
    ASSERT_TRUE(signing.sign(*made, {SignatureRole::Inspector, "Ben", "PL 1", "", ""}));
    EXPECT_EQ(swings.swing(*made)->state, SwingState::Signed);
    EXPECT_EQ(db::execute(*database, "UPDATE swing SET amendment = 'x' WHERE id = " + QString::number(made->value)).error().code,
        ErrorCode::Frozen);
    EXPECT_THAT(db::verify(*database, {})->findings, testing::IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(EverySchema, OldDatabase, testing::Range(1, db::schemaVersion()),
    [](const auto& test) { return "schema" + std::to_string(test.param); });

/// Its B to E were by the heading as read, and are those of the compass mounted right since.
TEST(Migration, whatWasKeptOfACompassFarOutIsComputedAnew)
{
    const QTemporaryDir folder;
    const QString path = folder.filePath("old.db");
    ASSERT_TRUE(restoreSchema(10, path));
    ASSERT_TRUE(RawDatabase(path).run({"UPDATE swing SET a_deg = -178.5, b_deg = 15 WHERE state = 0"}));
    auto database = openDatabase(path, OpenMode::ReadWriteCreate);
    ASSERT_TRUE(database) << describe(database.error());
    EXPECT_EQ(db::number(*database, "SELECT count(*) FROM swing WHERE results_behind > 0 AND b_deg IS NULL").value(), 1);
    EXPECT_EQ(db::number(*database, "SELECT count(*) FROM swing WHERE b_deg = 15 OR a_deg < -45").value(), 0);
    ASSERT_TRUE(db::refreshBehind(*database));
    EXPECT_EQ(db::number(*database, "SELECT count(*) FROM swing WHERE results_behind > 0 OR a_deg IS NULL").value(), 0);
    EXPECT_THAT(db::verify(*database, {})->findings, testing::IsEmpty());
}

/// Up to schema 11 a list over half the circle was in limits; what is in limits is judged anew, figures stay.
TEST(Migration, whatWasReadInPartIsInLimitsNoMore)
{
    const QTemporaryDir folder;
    const QString path = folder.filePath("old.db");
    ASSERT_TRUE(restoreSchema(11, path));
    ASSERT_TRUE(RawDatabase(path).run(
        {"UPDATE limits_profile SET max_deviation_deg = 30", "DELETE FROM reading WHERE swing_id = 2 AND magnetic_heading_deg > 150",
            "UPDATE swing SET status = 1, reading_count = (SELECT count(*) FROM reading WHERE swing_id = 2) WHERE id = 2"}));
    auto database = openDatabase(path, OpenMode::ReadWriteCreate);
    ASSERT_TRUE(database) << describe(database.error());
    ASSERT_TRUE(db::refreshBehind(*database));
    EXPECT_EQ(db::number(*database, "SELECT status FROM swing WHERE id = 2").value(), 0); // not known
    EXPECT_EQ(db::number(*database, "SELECT status FROM swing WHERE id = 1").value(), 1); // all around, as it was
    EXPECT_EQ(db::number(*database, "SELECT status FROM compass").value(), 0);
}

/// The signatures of schema4.sql were made by the program of then, over version 1 of the signed content.
TEST(Migration, whatWasSignedBeforeHoldsUnderItsOwnVersion)
{
    const QTemporaryDir folder;
    const QString path = folder.filePath("old.db");
    ASSERT_TRUE(restoreSchema(4, path));
    auto database = openDatabase(path, OpenMode::ReadWriteCreate);
    ASSERT_TRUE(database) << describe(database.error());
    const auto swing = db::SwingStore(*database).swing(SwingId{1});
    ASSERT_TRUE(swing);
    ASSERT_EQ(swing->signatures.size(), 2u);
    EXPECT_EQ(swing->signatures[0].contents, 1);
    db::SigningStore signing(*database);
    EXPECT_EQ(*signing.hold(SwingId{1}), (std::vector<bool>{true, true}));
    // One of today stands beside them, over the same figures by today's version.
    ASSERT_TRUE(signing.sign(SwingId{1}, {SignatureRole::Authority, "Eva", "", "", ""}));
    const auto after = db::SwingStore(*database).swing(SwingId{1});
    EXPECT_EQ(after->signatures[2].contents, kSignedContents);
    EXPECT_NE(after->signatures[2].hash, after->signatures[0].hash);
    EXPECT_EQ(*signing.hold(SwingId{1}), (std::vector<bool>{true, true, true}));
    EXPECT_THAT(db::verify(*database, {})->findings, testing::IsEmpty());
    // A figure changed behind the program's back: none of the three holds.
    database = Error{};
    ASSERT_TRUE(RawDatabase(path).run({"DROP TRIGGER signed_readings_no_update",
        "UPDATE reading SET compass_heading_deg = compass_heading_deg + 1 WHERE swing_id = 1 AND position = 2"}));
    database = openDatabase(path, OpenMode::ReadWriteCreate);
    ASSERT_TRUE(database) << describe(database.error());
    EXPECT_EQ(*db::SigningStore(*database).hold(SwingId{1}), (std::vector<bool>{false, false, false}));
    EXPECT_THAT(inEnglish(db::verify(*database, {})->findings), testing::Contains(testing::HasSubstr("is not what was signed")));
}

TEST(Migration, ofANewerProgramIsRefusedByName)
{
    const QTemporaryDir folder;
    const QString path = folder.filePath("a.db");
    ASSERT_TRUE(openDatabase(path, OpenMode::ReadWriteCreate));
    ASSERT_TRUE(RawDatabase(path).run({"PRAGMA user_version = 999"}));
    for (const auto mode : {OpenMode::ReadWriteCreate, OpenMode::ReadOnly}) {
        const auto database = openDatabase(path, mode);
        ASSERT_FALSE(database);
        EXPECT_EQ(database.error().code, ErrorCode::NewerSchema);
        EXPECT_THAT(describe(database.error()),
            testing::AllOf(
                testing::HasSubstr("a.db"), testing::HasSubstr("999"), testing::HasSubstr("up to " + std::to_string(db::schemaVersion()))));
    }
}

TEST(Migration, stepsAreNumberedAndDescribed)
{
    int expected = 1;
    for (const auto& step : db::migrations()) {
        EXPECT_EQ(step.version, expected++);
        EXPECT_STRNE(step.description, "");
        EXPECT_FALSE(step.statements.empty());
    }
    EXPECT_EQ(db::schemaVersion(), expected - 1);
}

} // namespace lubberline::test
