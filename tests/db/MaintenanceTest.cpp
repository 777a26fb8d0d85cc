#include <gmock/gmock.h>

#include <QDir>
#include <QFile>

#include "db/engine/Statement.h"
#include "db/engine/Transaction.h"
#include "db/schema/Schema.h"
#include "db/transfer/Maintenance.h"
#include "tests/db/TestFleet.h"

namespace lubberline::test {

TEST(Maintenance, aBackupIsWholeWhileOthersWrite)
{
    const QTemporaryDir folder;
    auto database = db::openDatabase(folder.filePath("a.db"), db::OpenMode::ReadWriteCreate);
    const Stored stored = store(*database);
    ASSERT_TRUE(save(db::SwingStore(*database), swingOf(stored)));
    auto other = db::openDatabase(folder.filePath("a.db"), db::OpenMode::ReadOnly);
    const QString copy = folder.filePath("copy.db");
    ASSERT_TRUE(db::backup(*other, copy));
    EXPECT_EQ(db::backup(*other, copy).error().code, ErrorCode::Conflict);
    EXPECT_EQ(db::backup(*other, folder.filePath("no/copy.db")).error().code, ErrorCode::Io);
    auto restored = db::openDatabase(copy, db::OpenMode::ReadWriteCreate);
    ASSERT_TRUE(restored) << describe(restored.error());
    EXPECT_EQ(db::FleetStore(*restored).totals()->swings, 1);
    EXPECT_EQ(QDir(folder.path()).entryList({"*.partial"}).size(), 0);
}

TEST(Maintenance, aBackupIsRestoredAndWhatWasThereIsKept)
{
    const QTemporaryDir folder;
    const QString path = folder.filePath("a.db"), copy = folder.filePath("copy.db"), aside = folder.filePath("a before.db");
    const auto swingsIn = [](const QString& file) {
        auto database = db::openDatabase(file, db::OpenMode::ReadOnly);
        return database ? db::FleetStore(*database).totals()->swings : -1;
    };
    {
        auto database = db::openDatabase(path, db::OpenMode::ReadWriteCreate);
        const Stored stored = store(*database);
        ASSERT_TRUE(db::backup(*database, copy));
        ASSERT_TRUE(save(db::SwingStore(*database), swingOf(stored)));
        EXPECT_EQ(db::restore(copy, path, aside).error().code, ErrorCode::Locked); // it is open here
    }
    EXPECT_EQ(swingsIn(path), 1);
    EXPECT_EQ(db::restore(folder.filePath("none.db"), path, aside).error().code, ErrorCode::NotFound);
    EXPECT_EQ(db::restore(path, path, aside).error().code, ErrorCode::InvalidInput);
    const auto foreign = db::restore(__FILE__, path, aside);
    ASSERT_FALSE(foreign);
    EXPECT_EQ(foreign.error().file, __FILE__);
    EXPECT_EQ(swingsIn(path), 1);
    const auto restored = db::restore(copy, path, aside);
    ASSERT_TRUE(restored) << describe(restored.error());
    EXPECT_EQ(swingsIn(path), 0);
    EXPECT_EQ(swingsIn(aside), 1);
    EXPECT_EQ(db::restore(copy, path, aside).error().code, ErrorCode::Conflict);
    EXPECT_EQ(QDir(folder.path()).entryList({"*.partial*"}).size(), 0);
}

TEST(Maintenance, verifyFindsResultsThatAreNotThoseOfTheReadings)
{
    auto database = inMemory();
    const Stored stored = store(database);
    ASSERT_TRUE(save(db::SwingStore(database), swingOf(stored)));
    EXPECT_TRUE(db::verify(database, {})->findings.empty());
    EXPECT_EQ(db::verify(database, {})->readings, 8);
    ASSERT_TRUE(db::execute(database, "UPDATE swing SET max_abs_deviation_deg = 1"));
    const auto report = db::verify(database, {});
    ASSERT_EQ(report->findings.size(), 1u);
    EXPECT_THAT(report->findings.front().english(), testing::HasSubstr("2026-11-20"));
}

TEST(Maintenance, verifyNamesEachKindOfDamage)
{
    const std::pair<const char*, const char*> damages[] = {
        {"UPDATE compass SET status = 2", "3713, standby compass"},
        {"UPDATE site SET latitude_deg = 'north'", "site.latitude_deg"},
        {"UPDATE swing SET variation_deg = 9e999", "swing.variation_deg"},
        {"UPDATE swing SET index_removed_deg = 'two'", "swing.index_removed_deg"},
        {"UPDATE swing SET field_model = 'WMM', field_latitude_deg = 1, field_longitude_deg = 1, field_height_m = 0, field_date = '2026-01-01',"
         " field_north_nT = 'strong', field_east_nT = 1, field_down_nT = 1",
            "swing.field_north_nT"},
        {"INSERT INTO sensor_model (id, record, compass_id, name, origin, note, model_json, bench_json, states_json) VALUES (1, 'r', 1, 'bent', 0, '', '{\"soft_iron\": 7}', NULL, '{}')",
            "sensor model bent (record r): soft_iron"},
        {"INSERT INTO sensor_model (id, record, compass_id, name, origin, note, model_json, bench_json, states_json) VALUES (1, 'r', 1, 'bent', 3, '', '{}', '{\"parts\": []}', '{}')",
            "sensor_m: is missing"},
        {"INSERT INTO sensor_model (id, record, compass_id, name, origin, note, model_json, bench_json, states_json) VALUES (1, 'r', 1, 'bent', 3, '', '{}', NULL, 'up')",
            "states of its moving parts do not read"},
        {"UPDATE reading SET position = 3", "in one place"},
        {"UPDATE reading SET compass_heading_deg = compass_heading_deg + 0.001 WHERE position = 2", "2026-11-20"},
        {"DELETE FROM compass", "foreign key: a row of swing"},
    };
    for (const auto& [sql, words] : damages) {
        auto database = inMemory();
        ASSERT_TRUE(save(db::SwingStore(database), swingOf(store(database))));
        ASSERT_TRUE(db::execute(database, "PRAGMA foreign_keys = OFF"));
        ASSERT_TRUE(db::execute(database, sql)) << sql;
        const auto report = db::verify(database, {});
        ASSERT_TRUE(report) << describe(report.error());
        EXPECT_THAT(inEnglish(report->findings), testing::Contains(testing::HasSubstr(words))) << sql;
    }
}

TEST(Maintenance, verifyIsNotMisledByAWriter)
{
    const QTemporaryDir folder;
    auto writer = db::openDatabase(folder.filePath("a.db"), db::OpenMode::ReadWriteCreate);
    const Stored stored = store(*writer);
    {
        auto all = db::Transaction::begin(*writer);
        for (int i = 0; i < 130; ++i)
            ASSERT_TRUE(save(db::SwingStore(*writer), swingOf(stored)));
        ASSERT_TRUE(all->commit());
    }
    auto reader = db::openDatabase(folder.filePath("a.db"), db::OpenMode::ReadOnly);
    int written = 0;
    const auto report = db::verify(*reader, [&](double fraction) {
        Swing swing = swingOf(stored, "2027-01-01");
        swing.readings[0].compass = CompassHeading::fromDegrees(300);
        written += fraction < 1.0 && save(db::SwingStore(*writer), swing);
        return true;
    });
    ASSERT_TRUE(report);
    EXPECT_GT(written, 0);
    EXPECT_THAT(report->findings, testing::IsEmpty());
    EXPECT_EQ(report->swings, 130);
}

TEST(Maintenance, verifyCanBeCancelled)
{
    auto database = inMemory();
    const Stored stored = store(database);
    for (int i = 0; i < 64; ++i)
        ASSERT_TRUE(save(db::SwingStore(database), swingOf(stored)));
    EXPECT_EQ(db::verify(database, [](double) { return false; }).error().code, ErrorCode::Cancelled);
}

TEST(Maintenance, statusCounts)
{
    const QTemporaryDir folder;
    auto database = db::openDatabase(folder.filePath("a.db"), db::OpenMode::ReadWriteCreate);
    ASSERT_TRUE(save(db::SwingStore(*database), swingOf(store(*database))));
    const auto status = db::status(*database);
    ASSERT_TRUE(status);
    EXPECT_EQ(status->schema, db::schemaVersion());
    EXPECT_EQ(status->journal, "wal");
    EXPECT_EQ(status->totals.swings, 1);
    EXPECT_EQ(status->readings, 8);
    EXPECT_EQ(status->sensorModels, 0);
    EXPECT_EQ(status->auditEntries, 6); // type, aircraft, limits, site, compass, swing
    EXPECT_GT(status->bytes, 0);
}

} // namespace lubberline::test
