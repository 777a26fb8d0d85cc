#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "db/Statement.h"
#include "tests/db/TestFleet.h"

namespace lubberline::test {

class Swings : public testing::Test {
protected:
    db::Database m_database = inMemory();
    Stored m_stored = store(m_database);
    db::SwingRepository m_swings{m_database};
    db::FleetRepository m_fleet{m_database};

    [[nodiscard]] Status compassStatus() { return m_fleet.compassesOf(m_stored.aircraft)->front().status; }
    bool raw(const char* sql) { return db::execute(m_database, sql).ok(); }
};

TEST_F(Swings, comeBackAsTheyWereStored)
{
    Swing swing = swingOf(m_stored);
    swing.kind = SwingKind::Correction;
    swing.stage = SwingStage::AsLeft;
    swing.configuration = {RadioState::Off, "running", "landing light on", "flaps up"};
    swing.datum = {"sighting compass", "B-16", "2027-01-31"};
    swing.people = {"Ann", "Bob", "Cid", "Dora"};
    swing.variation_deg = 6.25;
    swing.procedure = "worksheet";
    swing.workOrder = "WO 7";
    swing.reason = "yearly";
    swing.note = "two\nlines, ä";
    swing.readings[2].nominal_deg = 45.0;
    swing.readings[2].pitch_deg = -2.5;
    swing.readings[2].roll_deg = 0.5;
    swing.readings[2].note = "gust";
    swing.readings[2].exclusion = Exclusion{"misread"};
    swing.readings[2].extra = {{"temperature", "12"}, {"quote\"", ""}};
    swing.readings[3].trueHeading = TrueHeading::fromDegrees(99.25);
    swing.readings.push_back({}); // an empty row, being entered
    const auto id = m_swings.save(swing);
    ASSERT_TRUE(id) << describe(id.error());
    auto read = m_swings.swing(*id);
    ASSERT_TRUE(read);
    EXPECT_TRUE(isRecordId(read->record));
    swing.id = *id;
    swing.record = read->record;
    for (std::size_t i = 0; i < swing.readings.size(); ++i)
        swing.readings[i].id = read->readings.at(i).id;
    EXPECT_EQ(*read, swing);
    int visited = 0;
    ASSERT_TRUE(m_swings.forEach([&](const Swing& one) { ++visited; EXPECT_EQ(one, swing); return true; }));
    EXPECT_EQ(visited, 1);
}

TEST_F(Swings, keepTheirResultsBesideThem)
{
    const auto id = m_swings.save(swingOf(m_stored));
    auto row = m_swings.swingsOf(m_stored.compass)->front();
    EXPECT_EQ(row.readings, 8);
    EXPECT_NEAR(*row.maxAbsDeviation_deg, 5.0, 1e-9);
    EXPECT_EQ(row.status, Status::InLimits);
    EXPECT_EQ(compassStatus(), Status::InLimits);

    auto swing = m_swings.swing(*id);
    swing->readings[0].compass = CompassHeading::fromDegrees(300); // 17° of deviation
    ASSERT_TRUE(m_swings.saveReading(*id, swing->readings[0]));
    EXPECT_EQ(compassStatus(), Status::OutOfLimits);
    EXPECT_EQ(m_fleet.types()->front().status, Status::OutOfLimits);
    swing->readings[0].exclusion = Exclusion{"misread"};
    ASSERT_TRUE(m_swings.saveReading(*id, swing->readings[0]));
    EXPECT_EQ(compassStatus(), Status::InLimits);
}

TEST_F(Swings, theLatestWithAResultDecidesTheStatus)
{
    Swing bad = swingOf(m_stored, "2025-01-01");
    bad.readings[0].compass = CompassHeading::fromDegrees(300);
    ASSERT_TRUE(m_swings.save(bad));
    EXPECT_EQ(compassStatus(), Status::OutOfLimits);
    ASSERT_TRUE(m_swings.save(swingOf(m_stored, "2026-01-01")));
    EXPECT_EQ(compassStatus(), Status::InLimits);
    Swing empty = swingOf(m_stored, "2026-06-01");
    empty.readings.clear();
    const auto draft = m_swings.save(empty);
    EXPECT_EQ(compassStatus(), Status::InLimits);
    EXPECT_EQ(m_swings.previous(*draft)->value().date, "2026-01-01");
}

TEST_F(Swings, changedLimitsChangeTheStatus)
{
    ASSERT_TRUE(m_swings.save(swingOf(m_stored)));
    auto profile = db::SiteRepository(m_database).limitsProfiles()->front();
    profile.maxDeviation_deg = 4.0;
    ASSERT_TRUE(db::SiteRepository(m_database).save(profile));
    EXPECT_EQ(compassStatus(), Status::OutOfLimits);
}

TEST_F(Swings, readingsAreInsertedSavedAndRemovedInOrder)
{
    Swing swing = swingOf(m_stored);
    swing.readings.resize(3);
    const auto id = *m_swings.save(swing);
    const auto inserted = m_swings.insertReading(id, 1, reading(22, 21));
    ASSERT_TRUE(inserted);
    auto readings = m_swings.swing(id)->readings;
    ASSERT_EQ(readings.size(), 4u);
    EXPECT_EQ(readings[1].magnetic->degrees(), 22);
    EXPECT_EQ(readings[2].magnetic->degrees(), 0);
    ASSERT_TRUE(m_swings.removeReading(id, readings[0].id));
    EXPECT_EQ(m_swings.swing(id)->readings.front().magnetic->degrees(), 22);
    EXPECT_EQ(m_swings.removeReading(id, ReadingId{9999}).error().code, ErrorCode::NotFound);
}

TEST_F(Swings, aNumberThatIsNotFiniteIsRefused)
{
    Swing swing = swingOf(m_stored);
    swing.readings[0].pitch_deg = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(m_swings.save(swing).error().code, ErrorCode::InvalidInput);
    EXPECT_EQ(m_fleet.totals()->swings, 0);
}

TEST_F(Swings, whatIsSignedIsFrozenAlsoForRawSql)
{
    Swing swing = swingOf(m_stored);
    swing.state = SwingState::Signed;
    const auto id = m_swings.save(swing);
    ASSERT_TRUE(id) << describe(id.error());
    const auto stored = *m_swings.swing(*id);
    EXPECT_EQ(stored.state, SwingState::Signed);
    Swing changed = stored;
    changed.date = "2020-01-01";
    EXPECT_EQ(m_swings.save(changed).error().code, ErrorCode::Frozen);
    EXPECT_EQ(m_swings.saveReading(*id, stored.readings[0]).error().code, ErrorCode::Frozen);
    EXPECT_EQ(m_swings.insertReading(*id, 0, {}).error().code, ErrorCode::Frozen);
    EXPECT_EQ(m_swings.removeReading(*id, stored.readings[0].id).error().code, ErrorCode::Frozen);
    EXPECT_EQ(m_swings.remove(*id).error().code, ErrorCode::Frozen);
    for (const char* sql : {"UPDATE swing SET date = '2020-01-01'", "UPDATE swing SET state = 0", "DELETE FROM swing", "DELETE FROM reading",
             "UPDATE reading SET compass_heading_deg = 1", "INSERT INTO reading (swing_id, position, note, extra_json) VALUES (1, 99, '', '[]')"})
        EXPECT_FALSE(raw(sql)) << sql;
    EXPECT_EQ(*m_swings.swing(*id), stored);
}

TEST_F(Swings, everyChangeIsInTheAuditTrailForEver)
{
    const auto id = *m_swings.save(swingOf(m_stored));
    auto one = m_swings.swing(id)->readings[0];
    one.compass = CompassHeading::fromDegrees(315.5);
    ASSERT_TRUE(m_swings.saveReading(id, one));
    db::Statement last(m_database, "SELECT what, detail FROM audit_entry ORDER BY id DESC LIMIT 1");
    ASSERT_TRUE(last.run() && last.next());
    EXPECT_EQ(last.text(0), "changed reading");
    EXPECT_THAT(last.text(1), testing::AllOf(testing::HasSubstr("compass 316"), testing::HasSubstr("compass 315.5")));
    EXPECT_FALSE(raw("DELETE FROM audit_entry"));
    EXPECT_FALSE(raw("UPDATE audit_entry SET what = ''"));
}

TEST_F(Swings, onlyDraftsAreRemovedAndStayReadableInTheTrail)
{
    const auto id = *m_swings.save(swingOf(m_stored));
    ASSERT_TRUE(m_swings.remove(id));
    EXPECT_EQ(m_fleet.totals()->swings, 0);
    EXPECT_EQ(db::number(m_database, "SELECT COUNT(*) FROM reading").value(), 0);
    EXPECT_EQ(db::number(m_database, "SELECT COUNT(*) FROM audit_entry WHERE what = 'removed swing' AND detail LIKE '%compass 316%'").value(), 1);
    EXPECT_EQ(compassStatus(), Status::NotKnown);
    Swing complete = swingOf(m_stored);
    complete.state = SwingState::Complete;
    EXPECT_EQ(m_swings.remove(*m_swings.save(complete)).error().code, ErrorCode::Frozen);
}

TEST_F(Swings, areFoundByWordsAndByRecord)
{
    const auto id = *m_swings.save(swingOf(m_stored));
    const auto hits = m_fleet.search("3713 deblin 2026", 10);
    ASSERT_TRUE(hits);
    ASSERT_EQ(hits->size(), 1u);
    EXPECT_EQ(hits->front().swing, id);
    EXPECT_TRUE(m_fleet.search("100%", 10)->empty());
    EXPECT_EQ(m_fleet.search("su-22", 10)->size(), 3u); // aircraft, compass, swing
    const auto record = m_swings.swing(id)->record;
    EXPECT_EQ(*m_swings.named(record.substr(0, 6)), id);
    EXPECT_EQ(m_swings.named("zz").error().code, ErrorCode::InvalidInput);
    EXPECT_EQ(m_swings.named(record[0] == '0' ? "1" : "0").error().code, ErrorCode::NotFound);
}

TEST_F(Swings, twoRecordsOfOneNameAreAConflict)
{
    EXPECT_EQ(m_fleet.save(AircraftType{{}, {}, "Su-22", "", ""}).error().code, ErrorCode::Conflict);
    EXPECT_EQ(m_fleet.save(AircraftType{}).error().code, ErrorCode::InvalidInput);
}

} // namespace lubberline::test
