#include <gmock/gmock.h>

#include "core/format/exchange/Exchange.h"
#include "core/swing/SwingField.h"
#include "db/transfer/Transfer.h"
#include "tests/db/TestFleet.h"

namespace lubberline::test {

namespace {

Fleet exported(db::Database& database) { return std::move(db::exportFleet(database, {}, {}).value()); }

} // namespace

TEST(Transfer, aFleetComesBackWhole)
{
    auto first = inMemory();
    const Stored stored = store(first);
    Event event;
    event.aircraft = stored.aircraft;
    event.date = "2026-05-01";
    event.kind = "lightning";
    ASSERT_TRUE(save(db::FleetStore(first), event));
    for (const Date date : {Date("2024-05-01"), Date("2025-05-01"), Date("2026-05-01")})
        ASSERT_TRUE(save(db::SwingStore(first), swingOf(stored, date)));
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
    EXPECT_EQ(db::FleetStore(second).totals()->swings, 3);
    EXPECT_EQ(db::FleetStore(second).types()->front().status, Status::InLimits);
    const Fleet round = exported(second);
    ASSERT_EQ(round.swings.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(round.swings[i].record, fleet.swings[i].record);
        EXPECT_EQ(round.swings[i].readings.size(), 8u);
    }
    EXPECT_EQ(round.events.front().kind, "lightning");
}

TEST(Transfer, exchangeFilesAreTheSameAfterARoundThroughADatabase)
{
    auto first = inMemory();
    const Stored stored = store(first);
    Swing swing = swingOf(stored);
    swing.state = SwingState::Signed;
    swing.readings[1].extra = {{"temperature", "12"}};
    swing.readings[2].exclusion = Exclusion{"misread"};
    swing.readings[3].magnetic = MagneticHeading::fromDegrees(0.1 + 0.2); // no digit is lost
    swing.readings[4].trueHeading = TrueHeading::fromDegrees(100.0 / 3.0);
    ASSERT_TRUE(save(db::SwingStore(first), swing));
    ASSERT_TRUE(save(db::SwingStore(first), swingOf(stored, "2025-01-01")));
    const std::string written = writeExchange(exported(first));
    const auto read = readExchange(written, "a.lubberline.json");
    ASSERT_TRUE(read) << describe(read.error());
    auto second = inMemory();
    ASSERT_TRUE(db::importFleet(second, *read, {}));
    EXPECT_EQ(writeExchange(exported(second)), written);
    const auto again = db::importFleet(first, *read, {}); // into the database that it came from
    ASSERT_TRUE(again) << describe(again.error());
    EXPECT_EQ(again->alreadyThere, 2);
}

TEST(Transfer, sensorModelsAndFieldStampsComeAlongByteForByte)
{
    auto first = inMemory();
    const Stored stored = store(first);
    Swing swing = swingOf(stored);
    swing.state = SwingState::Signed;
    swing.field = stampOf("2026-11-20");
    swing.indexRemoved_deg = 1.5;
    ASSERT_TRUE(save(db::SwingStore(first), swing));
    ASSERT_TRUE(save(db::SensorStore(first), sensorOf(stored)));
    const std::string written = writeExchange(exported(first));
    EXPECT_THAT(written, testing::HasSubstr("\"version\": 2"));
    const auto read = readExchange(written, "a.lubberline.json");
    ASSERT_TRUE(read) << describe(read.error());
    auto second = inMemory();
    ASSERT_TRUE(db::importFleet(second, *read, {}));
    EXPECT_EQ(writeExchange(exported(second)), written);
    const auto again = db::importFleet(second, *read, {});
    ASSERT_TRUE(again) << describe(again.error());
    EXPECT_EQ(again->alreadyThere, 1);
    EXPECT_EQ(exported(second).sensors.size(), 1u);
}

TEST(Transfer, newSwingsAreStampedAndTheSameFileIsStillTheSameAfterwards)
{
    auto database = inMemory();
    const Stored stored = store(database);
    Site placed = **db::SiteStore(database).site(stored.site);
    placed.latitude_deg = 51.55;
    placed.longitude_deg = 21.89;
    ASSERT_TRUE(save(db::SiteStore(database), placed));
    Fleet fleet = exported(database);
    Swing swing = swingOf(stored);
    swing.record = newRecordId();
    fleet.swings = {swing};
    const auto imported = db::importFleet(database, fleet, {});
    ASSERT_TRUE(imported);
    const auto site = *db::SiteStore(database).site(stored.site);
    const auto expected = stampFor(swing, site);
    ASSERT_TRUE(expected) << "the site of the test has a place";
    EXPECT_EQ(db::SwingStore(database).swing(imported->swingIds.front())->field, expected);
    EXPECT_EQ(db::importFleet(database, fleet, {})->alreadyThere, 1);
    fleet.swings[0].field = expected; // by another model: the same place and day
    fleet.swings[0].field->field.north_nT += 10;
    EXPECT_EQ(db::importFleet(database, fleet, {})->alreadyThere, 1);
    fleet.swings[0].field->place.latitude_deg += 1;
    EXPECT_EQ(db::importFleet(database, fleet, {}).error().code, ErrorCode::Conflict);
}

TEST(Transfer, chosenAircraftTakeAlongWhatTheyReferToAndNoMore)
{
    auto database = inMemory();
    const Stored stored = store(database);
    ASSERT_TRUE(save(db::SwingStore(database), swingOf(stored)));
    Aircraft other;
    other.type = *save(db::FleetStore(database), AircraftType{{}, {}, "An-2", "", ""});
    other.registration = "SP-ANT";
    const auto bare = *save(db::FleetStore(database), other);
    const auto fleet = db::exportFleet(database, {stored.aircraft}, {});
    ASSERT_TRUE(fleet);
    EXPECT_EQ(fleet->aircraft.size(), 1u);
    EXPECT_EQ(fleet->types.front().name, "Su-22");
    EXPECT_EQ(fleet->sites.size(), 1u);
    const auto nothing = db::exportFleet(database, {bare}, {});
    ASSERT_TRUE(nothing);
    EXPECT_EQ(nothing->aircraft.front().registration, "SP-ANT");
    EXPECT_TRUE(nothing->swings.empty() && nothing->sites.empty() && nothing->limits.empty() && nothing->compasses.empty());
    EXPECT_EQ(db::exportFleet(database, {AircraftId{99}}, {}).error().code, ErrorCode::NotFound);
    EXPECT_EQ(db::exportFleet(database, {}, [](double) { return false; }).error().code, ErrorCode::Cancelled);
}

TEST(Transfer, anotherContentUnderTheSameRecordIsAConflictAndStoresNothing)
{
    auto database = inMemory();
    const Stored stored = store(database);
    ASSERT_TRUE(save(db::SwingStore(database), swingOf(stored)));
    Fleet fleet = exported(database);
    Swing fresh = fleet.swings[0];
    fresh.record = newRecordId();
    fleet.swings[0].readings[0].compass = CompassHeading::fromDegrees(1);
    fleet.swings.insert(fleet.swings.begin(), fresh);
    const auto refused = db::importFleet(database, fleet, {});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::Conflict);
    EXPECT_THAT(refused.error().message.english(), testing::AllOf(testing::HasSubstr("3713"), testing::HasSubstr("2026-11-20")));
    EXPECT_EQ(db::FleetStore(database).totals()->swings, 1);
}

TEST(Transfer, recordsOfOtherIdentityAreKnownByTheirNames)
{
    auto database = inMemory();
    const Stored stored = store(database);
    Fleet fleet = exported(database);
    Swing swing = swingOf(stored);
    swing.record = newRecordId();
    fleet.swings = {swing};
    fleet.types[0].record = fleet.aircraft[0].record = fleet.compasses[0].record = fleet.sites[0].record = fleet.limits[0].record
        = newRecordId();
    ASSERT_TRUE(db::importFleet(database, fleet, {}));
    const auto totals = *db::FleetStore(database).totals();
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
    EXPECT_EQ(db::FleetStore(database).totals()->swings, 0);
}

} // namespace lubberline::test
