// Tables of years into a database: all or nothing, what is known is left, a look stores nothing, undone in one step, suspect signs told.

#include <gmock/gmock.h>

#include <cmath>
#include <sstream>

#include "db/stores/FleetStore.h"
#include "db/stores/PopulationStore.h"
#include "db/stores/ResultStore.h"
#include "db/stores/SigningStore.h"
#include "db/transfer/Maintenance.h"
#include "db/transfer/Transfer.h"
#include "db/transfer/Years.h"
#include "tests/db/TestFleet.h"

namespace lubberline::test {

namespace {

constexpr Date kToday = "2026-11-27";

std::string rows(int aircraft, int years, double D_deg = -2.2, int from = 0)
{
    std::string text = "type,aircraft,compass,site,date,stage,0,45,90,135,180,225,270,315\n";
    for (int a = from; a < from + aircraft; ++a)
        for (int year = 0; year < years; ++year) {
            text += "Su-22,S" + std::to_string(a) + ",standby,Deblin," + std::to_string(2010 + year) + "-05-01,as_found";
            for (int heading = 0; heading < 360; heading += 45)
                text += "," + std::to_string(D_deg * std::sin(heading / 90.0 * 3.14159265358979) + 0.1 * ((a + year + heading / 45) % 3));
            text += "\n";
        }
    return text;
}

Result<db::YearsOutcome> import(
    db::Database& database, const std::string& text, db::YearsStep step = db::YearsStep::Store, const Progress& progress = {})
{
    std::istringstream input(text);
    YearsTable table;
    table.cells = YearsCells::Deviations;
    YearsReader reader(input, "years.csv", table, progress);
    return db::importYears(database, reader, step, kToday);
}

std::size_t swingsIn(db::Database& database) { return db::exportFleet(database, {}, {})->swings.size(); }

} // namespace

TEST(Years, oneAircraftInTwoWritingsOrOfTwoTypesIsDoubted)
{
    auto database = inMemory();
    const std::string header = "type,aircraft,compass,date,stage,0,90,180,270,360\n";
    const auto outcome = import(database,
        header + "Su-22,SP-A,standby,2019-05-01,as_found,1,2,-1,-2,1\nSu-22,sp-a,standby,2020-05-01,as_found,1,2,-,-2,5\n"
            + "Su-22,SPA,standby,2021-05-01,as_found,1,n/a,-1,-2,\nMi-2,SP-A,standby,2022-05-01,as_found,1,2,-1,-2,\n");
    ASSERT_TRUE(outcome) << outcome.error().message.english();
    const auto told = inEnglish(outcome->warnings);
    using testing::Contains;
    using testing::HasSubstr;
    EXPECT_THAT(told, Contains(HasSubstr("line 3: SP-A and sp-a are perhaps one aircraft")));
    EXPECT_THAT(told, Contains(HasSubstr("line 4: SP-A and SPA are perhaps one aircraft")));
    EXPECT_THAT(told, Contains(HasSubstr("line 5: SP-A is a Mi-2 here, and a Su-22 above")));
    EXPECT_THAT(told, Contains(HasSubstr("line 2 lists one heading, 000 and 360, with the same reading")));
    EXPECT_THAT(told, Contains(HasSubstr("line 3 lists one heading, 000 and 360, with different readings")));
    EXPECT_EQ(outcome->aircraft, 3);
    const auto again = import(database, header + "Su-22,S P-A,standby,2023-05-01,as_found,1,2,-1,-2,\n"); // one of the database
    EXPECT_THAT(inEnglish(again->warnings), Contains(HasSubstr("SP-A and S P-A are perhaps one aircraft")));
}

TEST(Years, comeInWholeAndCount)
{
    auto database = inMemory();
    const auto outcome = import(database, rows(6, 5));
    ASSERT_TRUE(outcome) << outcome.error().message.english();
    EXPECT_EQ(outcome->swings, 30);
    EXPECT_EQ(outcome->readings, 240);
    EXPECT_EQ(outcome->types, 1);
    EXPECT_EQ(outcome->aircraft, 6);
    EXPECT_EQ(outcome->compasses, 6);
    EXPECT_EQ(outcome->sites, 1);
    EXPECT_EQ(outcome->drafts, 0);
    EXPECT_TRUE(outcome->warnings.empty());
    EXPECT_TRUE(outcome->suspicions.empty());
    const auto fleet = db::PopulationStore(database).columns({});
    EXPECT_EQ(fleet->swings.size(), 30u);                    // complete ones: drafts are left out of statistics
    EXPECT_TRUE(db::verify(database, {})->findings.empty()); // what is kept beside the readings is what they give
    const auto audit = db::SigningStore(database).auditOf(db::exportFleet(database, {}, {})->swings.front().record);
    ASSERT_EQ(audit->size(), 1u);
    EXPECT_EQ(audit->front().detail, "years.csv, line 6: a record of years on paper"); // the newest of the first aircraft
    const auto again = import(database, rows(6, 6));                                   // a year later
    EXPECT_EQ(again->swings, 6);
    EXPECT_EQ(again->alreadyThere, 30);
    EXPECT_EQ(again->aircraft, 0);
}

TEST(Years, areAllThereOrNone)
{
    auto database = inMemory();
    const auto broken = import(database, rows(3, 3) + "Su-22,S9,standby,Deblin,2011-13-01,as_found,1,1,1,1,1,1,1,1\n");
    ASSERT_FALSE(broken);
    EXPECT_EQ(broken.error().file, "years.csv");
    EXPECT_EQ(broken.error().line, 11);
    EXPECT_EQ(swingsIn(database), 0u);
    EXPECT_TRUE(db::FleetStore(database).types()->empty());
    const auto cancelled = import(database, rows(3, 3), db::YearsStep::Store, [](double) { return false; });
    EXPECT_EQ(cancelled.error().code, ErrorCode::Cancelled);
    EXPECT_EQ(swingsIn(database), 0u);
}

TEST(Years, aLookStoresNothingAndTellsTheSame)
{
    auto database = inMemory();
    ASSERT_TRUE(import(database, rows(2, 2)));
    const auto look = import(database, rows(6, 5), db::YearsStep::Look);
    ASSERT_TRUE(look);
    EXPECT_EQ(swingsIn(database), 4u);
    const auto stored = import(database, rows(6, 5));
    for (const auto& outcome : {*look, *stored}) {
        EXPECT_EQ(outcome.swings, 26);
        EXPECT_EQ(outcome.alreadyThere, 4);
        EXPECT_EQ(outcome.aircraft, 4);
        EXPECT_EQ(outcome.compasses, 4);
        EXPECT_EQ(outcome.types, 0);
    }
}

TEST(Years, areUndoneInOneStep)
{
    auto database = inMemory();
    const auto stored = store(database);
    ASSERT_TRUE(save(db::SwingStore(database), swingOf(stored, "2024-05-01")));
    const Fleet before = *db::exportFleet(database, {}, {});
    const auto outcome = import(database, rows(4, 3));
    ASSERT_TRUE(outcome);
    const auto undone = db::undoYears(database, outcome->made);
    ASSERT_TRUE(undone) << undone.error().message.english();
    EXPECT_EQ(*undone, 12);
    EXPECT_EQ(*db::exportFleet(database, {}, {}), before);
    EXPECT_EQ(import(database, rows(4, 3))->swings, 12); // and done again
}

TEST(Years, whatWasChangedSinceIsNotUndone)
{
    auto database = inMemory();
    const auto outcome = import(database, rows(4, 3));
    ASSERT_TRUE(db::SigningStore(database).reopen(SwingId{outcome->made.swings.last}, "a slip of the pen"));
    const auto undone = db::undoYears(database, outcome->made);
    ASSERT_FALSE(undone);
    EXPECT_EQ(undone.error().code, ErrorCode::Conflict);
    EXPECT_THAT(undone.error().message.english(), testing::HasSubstr("S3, 2012-05-01"));
    EXPECT_EQ(swingsIn(database), 12u);
}

TEST(Years, suspectSignsAreToldAndNotTurned)
{
    auto database = inMemory();
    ASSERT_TRUE(import(database, rows(6, 4)));
    const auto outcome = import(database, rows(2, 3, +2.2, 10)); // of two more, written the other way round
    ASSERT_TRUE(outcome);
    ASSERT_EQ(outcome->suspicions.size(), 2u);
    EXPECT_THAT(outcome->suspicions[0].english(),
        testing::AllOf(
            testing::StartsWith(
                "S10 \u00B7 standby: D is +2.2\u00B0 in 3 of 3 swings (the first in line 2) where its siblings have \u22122.2\u00B0"),
            testing::EndsWith("nothing is turned")));
    const auto all = db::exportFleet(database, {}, {}); // outlives the loop
    ASSERT_TRUE(all);
    for (const auto& swing : all->swings)
        EXPECT_EQ(swing.readings.size(), 8u);
    EXPECT_TRUE(import(database, rows(2, 3, +2.2, 10))->suspicions.empty()); // there already: the fleet report tells of them
}

TEST(Years, aTypesSoftIronIsTakenWhereFourHeadingsDoNotTellIt)
{
    auto database = inMemory();
    ASSERT_TRUE(import(database, rows(6, 4)));
    SwingRecord record;
    record.type.name = "Su-22";
    record.compass.name = "standby";
    Site site;
    site.name = "Deblin";
    site.latitude_deg = 51.55;
    site.longitude_deg = 21.89;
    record.site = site;
    record.swing.date = "2024-05-01";
    for (int heading = 0; heading < 360; heading += 90) {
        Reading reading;
        reading.magnetic = MagneticHeading::fromDegrees(heading);
        reading.compass = CompassHeading::fromDegrees(heading == 90 ? 88 : heading == 270 ? 272 : heading);
        record.swing.readings.push_back(reading);
    }
    const auto place = db::ResultStore(database).placeOf(record);
    ASSERT_TRUE(place) << place.error().message.english();
    EXPECT_NEAR(place->exact.D, std::sin(toRadians(-2.2)), toRadians(0.1));
    EXPECT_GT(place->standardError.D, 0);
    EXPECT_NEAR(place->exact.B, std::sin(toRadians(2)), toRadians(0.2));
    EXPECT_THAT(place->taken.english(), testing::HasSubstr("do not tell D: its type's is taken (D \u22122."));
    record.type.name = "Mi-17"; // of which nothing is known
    EXPECT_FALSE(db::ResultStore(database).placeOf(record));
}

TEST(Years, whatIsNotWholeComesInAsADraft)
{
    auto database = inMemory();
    const std::string few = "type,aircraft,date,0,45,90\nSu-22,A,2020-05-01,1,1,1\nSu-22,A,2030-05-01,1,1,1\n";
    const auto outcome = import(database, few);
    ASSERT_TRUE(outcome);
    EXPECT_EQ(outcome->drafts, 2);
    ASSERT_EQ(outcome->warnings.size(), 1u);
    EXPECT_EQ(outcome->warnings[0].english(), "2 swings in draft, the first in line 2: it has 3 readings that count; expected at least 4");
}

} // namespace lubberline::test
