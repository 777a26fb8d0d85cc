#include <gmock/gmock.h>

#include <QDir>
#include <QFile>

#include "db/Maintenance.h"
#include "db/Statement.h"
#include "db/Transfer.h"
#include "tests/db/TestFleet.h"

namespace lubberline::test {

namespace {

Fleet exported(db::Database& database)
{
    return std::move(db::exportFleet(database, {}, {}).value());
}

} // namespace

TEST(Transfer, aFleetComesBackWhole)
{
    auto first = inMemory();
    const Stored stored = store(first);
    Event event;
    event.aircraft = stored.aircraft;
    event.date = "2026-05-01";
    event.kind = "lightning";
    ASSERT_TRUE(db::FleetRepository(first).save(event));
    for (const char* date : {"2024-05-01", "2025-05-01", "2026-05-01"})
        ASSERT_TRUE(db::SwingRepository(first).save(swingOf(stored, date)));
    const Fleet fleet = exported(first);
    auto second = inMemory();
    const auto imported = db::importFleet(second, fleet, {});
    ASSERT_TRUE(imported) << describe(imported.error());
    EXPECT_EQ(imported->swings, 3);
    EXPECT_EQ(imported->aircraft, 1);
    const auto again = db::importFleet(second, fleet, {});
    ASSERT_TRUE(again);
    EXPECT_EQ(again->swings, 0);
    EXPECT_EQ(again->alreadyThere, 3);
    EXPECT_EQ(db::FleetRepository(second).totals()->swings, 3);
    EXPECT_EQ(db::FleetRepository(second).types()->front().status, Status::InLimits);
    const Fleet round = exported(second);
    ASSERT_EQ(round.swings.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(round.swings[i].record, fleet.swings[i].record);
        EXPECT_EQ(round.swings[i].readings.size(), 8u);
    }
    EXPECT_EQ(round.events.front().kind, "lightning");
}

TEST(Transfer, anotherContentUnderTheSameRecordIsAConflictAndStoresNothing)
{
    auto database = inMemory();
    const Stored stored = store(database);
    ASSERT_TRUE(db::SwingRepository(database).save(swingOf(stored)));
    Fleet fleet = exported(database);
    Swing fresh = fleet.swings[0];
    fresh.record = newRecordId();
    fleet.swings[0].readings[0].compass = CompassHeading::fromDegrees(1);
    fleet.swings.insert(fleet.swings.begin(), fresh);
    const auto refused = db::importFleet(database, fleet, {});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::Conflict);
    EXPECT_THAT(refused.error().message, testing::AllOf(testing::HasSubstr("3713"), testing::HasSubstr("2026-11-20")));
    EXPECT_EQ(db::FleetRepository(database).totals()->swings, 1);
}

TEST(Transfer, recordsOfOtherIdentityAreKnownByTheirNames)
{
    auto database = inMemory();
    const Stored stored = store(database);
    Fleet fleet = exported(database);
    Swing swing = swingOf(stored);
    swing.record = newRecordId();
    fleet.swings = {swing};
    fleet.types[0].record = fleet.aircraft[0].record = fleet.compasses[0].record = fleet.sites[0].record = fleet.limits[0].record = newRecordId();
    ASSERT_TRUE(db::importFleet(database, fleet, {}));
    const auto totals = *db::FleetRepository(database).totals();
    EXPECT_EQ(totals.types, 1);
    EXPECT_EQ(totals.aircraft, 1);
    EXPECT_EQ(totals.compasses, 1);
    EXPECT_EQ(totals.swings, 1);
}

TEST(Transfer, canBeCancelledAndThenStoresNothing)
{
    auto database = inMemory();
    const Stored stored = store(database);
    Fleet fleet = exported(database);
    for (int i = 0; i < 200; ++i) {
        fleet.swings.push_back(swingOf(stored));
        fleet.swings.back().record = newRecordId();
    }
    const auto cancelled = db::importFleet(database, fleet, [](double fraction) { return fraction < 0.5; });
    ASSERT_FALSE(cancelled);
    EXPECT_EQ(cancelled.error().code, ErrorCode::Cancelled);
    EXPECT_EQ(db::FleetRepository(database).totals()->swings, 0);
}

TEST(Maintenance, aBackupIsWholeWhileOthersWrite)
{
    const QTemporaryDir folder;
    auto database = db::Database::open(folder.filePath("a.db"), db::OpenMode::ReadWriteCreate);
    const Stored stored = store(*database);
    ASSERT_TRUE(db::SwingRepository(*database).save(swingOf(stored)));
    auto other = db::Database::open(folder.filePath("a.db"), db::OpenMode::ReadOnly);
    const QString copy = folder.filePath("copy.db");
    ASSERT_TRUE(db::backup(*other, copy));
    EXPECT_EQ(db::backup(*other, copy).error().code, ErrorCode::Conflict);
    EXPECT_EQ(db::backup(*other, folder.filePath("no/copy.db")).error().code, ErrorCode::Io);
    auto restored = db::Database::open(copy, db::OpenMode::ReadWriteCreate);
    ASSERT_TRUE(restored) << describe(restored.error());
    EXPECT_EQ(db::FleetRepository(*restored).totals()->swings, 1);
    EXPECT_EQ(QDir(folder.path()).entryList({"*.partial"}).size(), 0);
}

TEST(Maintenance, verifyFindsResultsThatAreNotThoseOfTheReadings)
{
    auto database = inMemory();
    const Stored stored = store(database);
    ASSERT_TRUE(db::SwingRepository(database).save(swingOf(stored)));
    EXPECT_TRUE(db::verify(database, {})->findings.empty());
    EXPECT_EQ(db::verify(database, {})->readings, 8);
    ASSERT_TRUE(db::execute(database, "UPDATE swing SET max_abs_deviation_deg = 1"));
    const auto report = db::verify(database, {});
    ASSERT_EQ(report->findings.size(), 1u);
    EXPECT_THAT(report->findings.front(), testing::HasSubstr("2026-11-20"));
}

} // namespace lubberline::test
