#include <gmock/gmock.h>

#include "db/engine/Statement.h"
#include "db/stores/SigningStore.h"
#include "db/transfer/Maintenance.h"
#include "db/transfer/Removal.h"
#include "db/transfer/Transfer.h"
#include "tests/db/TestFleet.h"

namespace lubberline::test {

namespace {

std::vector<std::string> allRows(const db::Database& database)
{
    std::vector<std::string> rows;
    for (const char* table : {"aircraft_type", "aircraft", "compass", "event", "swing", "reading", "sensor_model"}) {
        db::Statement columns(database, "SELECT group_concat('quote(' || name || ')', ' || '','' || ') FROM pragma_table_info(?)");
        columns << table;
        const auto list = db::firstOf<std::string>(columns, [](db::Statement& row) { return row.text(0); });
        db::Statement statement(
            database, QStringLiteral("SELECT %1 FROM %2 ORDER BY id").arg(QString::fromStdString(list->value()), QLatin1String(table)));
        const auto found = db::rowsOf<std::string>(statement, [](db::Statement& one) { return one.text(0); });
        for (const std::string& row : *found)
            rows.push_back(std::string(table) + " " + row);
    }
    return rows;
}

} // namespace

TEST(Removal, anAircraftGoesWithAllThatIsItsAndComesBackAsItWas)
{
    auto database = inMemory();
    const Stored stored = store(database);
    ASSERT_TRUE(save(db::SwingStore(database), swingOf(stored)));
    Event event;
    event.aircraft = stored.aircraft;
    event.date = "2026-10-01";
    event.kind = "lightning strike";
    ASSERT_TRUE(db::FleetStore(database).add(event));
    const auto before = allRows(database);
    const auto removed = db::Removal(database).remove(stored.aircraft);
    ASSERT_TRUE(removed) << describe(removed.error());
    EXPECT_EQ(db::FleetStore(database).totals()->aircraft, 0);
    EXPECT_EQ(db::FleetStore(database).totals()->types, 1);
    EXPECT_EQ(db::FleetStore(database).totals()->swings, 0);
    EXPECT_TRUE(db::verify(database, {})->findings.empty());
    ASSERT_TRUE(db::Removal(database).putBack(*removed));
    EXPECT_EQ(allRows(database), before);
    EXPECT_TRUE(db::verify(database, {})->findings.empty());
    EXPECT_EQ(db::number(database, "SELECT COUNT(*) FROM audit_entry WHERE what = 'removed aircraft'").value(), 1);
}

TEST(Removal, aTypeGoesWithItsAircraft)
{
    auto database = inMemory();
    const Stored stored = store(database);
    const auto before = allRows(database);
    const auto removed = db::Removal(database).remove(stored.type);
    ASSERT_TRUE(removed) << describe(removed.error());
    EXPECT_TRUE(allRows(database).empty());
    ASSERT_TRUE(db::Removal(database).putBack(*removed));
    EXPECT_EQ(allRows(database), before);
}

TEST(Removal, whatIsCompleteOrSignedStays)
{
    auto database = inMemory();
    const Stored stored = store(database);
    const auto swing = save(db::SwingStore(database), swingOf(stored));
    ASSERT_TRUE(swing);
    ASSERT_TRUE(db::SigningStore(database).complete(*swing));
    const auto before = allRows(database);
    const auto refused = db::Removal(database).remove(stored.compass);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::Frozen);
    EXPECT_THAT(refused.error().message.english(), testing::HasSubstr("2026-11-20"));
    EXPECT_EQ(allRows(database), before);
}

TEST(Removal, aNameThatWasTakenSinceIsAConflictThatChangesNothing)
{
    auto database = inMemory();
    const Stored stored = store(database);
    const auto removed = db::Removal(database).remove(stored.aircraft);
    ASSERT_TRUE(removed);
    Aircraft other;
    other.type = stored.type;
    other.registration = "3713";
    ASSERT_TRUE(db::FleetStore(database).add(other));
    const auto before = allRows(database);
    EXPECT_FALSE(db::Removal(database).putBack(*removed));
    EXPECT_EQ(allRows(database), before);
}

} // namespace lubberline::test
