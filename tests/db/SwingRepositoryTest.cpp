#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "db/engine/Changes.h"
#include "db/engine/Statement.h"
#include "db/engine/Transaction.h"
#include "db/stores/ResultCache.h"
#include "db/transfer/Maintenance.h"
#include "tests/db/TestFleet.h"

namespace lubberline::test {

class Swings : public testing::Test {
protected:
    db::Database m_database = inMemory();
    Stored m_stored = store(m_database);
    db::SwingStore m_swings{m_database};
    db::FleetStore m_fleet{m_database};

    [[nodiscard]] Status compassStatus() { return m_fleet.compassesOf(m_stored.aircraft)->front().status; }
    [[nodiscard]] std::string lastEntry()
    {
        db::Statement last(m_database, "SELECT what || ' ' || record || ' ' || detail FROM audit_entry ORDER BY id DESC LIMIT 1");
        return last.run() && last.next() ? last.text(0) : "";
    }
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
    swing.sharedErrors.of_deg = {0.6, 0.125, 0, 0, 0};
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
    const auto id = save(m_swings, swing);
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
    ASSERT_TRUE(m_swings.forEach([&](const Swing& one) {
        ++visited;
        EXPECT_EQ(one, swing);
        return true;
    }));
    EXPECT_EQ(visited, 1);
}

TEST_F(Swings, keepTheirResultsBesideThem)
{
    const auto id = save(m_swings, swingOf(m_stored));
    auto row = m_swings.swingsOf(m_stored.compass)->front();
    EXPECT_EQ(row.readings, 8);
    EXPECT_NEAR(*row.maxAbsDeviation_deg, 5.0, 1e-9);
    EXPECT_EQ(row.status, Status::InLimits);
    EXPECT_EQ(compassStatus(), Status::InLimits);

    auto swing = m_swings.swing(*id);
    auto before = swing->readings[0];
    swing->readings[0].compass = CompassHeading::fromDegrees(300); // 17° of deviation
    ASSERT_TRUE(m_swings.changeReading(*id, before, swing->readings[0]));
    EXPECT_EQ(compassStatus(), Status::OutOfLimits);
    EXPECT_EQ(m_fleet.types()->front().status, Status::OutOfLimits);
    before = swing->readings[0];
    swing->readings[0].exclusion = Exclusion{"misread"};
    ASSERT_TRUE(m_swings.changeReading(*id, before, swing->readings[0]));
    EXPECT_EQ(compassStatus(), Status::InLimits);
}

TEST_F(Swings, resultsOfAChangedReadingAreThoseOfTheWholeSwing)
{
    Swing swing = swingOf(m_stored);
    swing.indexRemoved_deg = 1.5;
    swing.readings[1].exclusion = Exclusion{"misread"};
    swing.readings[2].compass.reset();
    swing.readings.push_back({}); // being entered
    const auto id = save(m_swings, swing);
    ASSERT_TRUE(id);
    auto known = m_swings.swing(*id)->readings[0];
    Reading turned = known;
    turned.magnetic = MagneticHeading::fromDegrees(20);
    turned.compass = CompassHeading::fromDegrees(10); // 10° of deviation when it was read, 8.5° since the compass was turned
    ASSERT_TRUE(m_swings.changeReading(*id, known, turned));
    const auto row = m_swings.swingsOf(m_stored.compass)->front();
    EXPECT_EQ(row.readings, 7);
    EXPECT_NEAR(*row.maxAbsDeviation_deg, 8.5, 1e-9);
    const auto whole = db::resultOf(*m_swings.swing(*id), db::SiteStore(m_database).limitsOf(m_stored.compass).value());
    EXPECT_EQ(row.coefficient_deg, whole.coefficient_deg);
    EXPECT_EQ(row.maxAbsDeviation_deg, whole.maxAbsDeviation_deg);
    EXPECT_EQ(row.status, whole.status);
}

TEST_F(Swings, theLatestWithAResultDecidesTheStatus)
{
    Swing bad = swingOf(m_stored, "2025-01-01");
    bad.readings[0].compass = CompassHeading::fromDegrees(300);
    ASSERT_TRUE(save(m_swings, bad));
    EXPECT_EQ(compassStatus(), Status::OutOfLimits);
    ASSERT_TRUE(save(m_swings, swingOf(m_stored, "2026-01-01")));
    EXPECT_EQ(compassStatus(), Status::InLimits);
    Swing empty = swingOf(m_stored, "2026-06-01");
    empty.readings.clear();
    const auto draft = save(m_swings, empty);
    EXPECT_EQ(compassStatus(), Status::InLimits);
    EXPECT_EQ(m_swings.previous(*draft)->value().date, Date("2026-01-01"));
}

TEST_F(Swings, changedLimitsChangeTheStatus)
{
    ASSERT_TRUE(save(m_swings, swingOf(m_stored)));
    auto profile = db::SiteStore(m_database).limitsProfiles()->front();
    profile.maxDeviation_deg = 4.0;
    ASSERT_TRUE(save(db::SiteStore(m_database), profile));
    EXPECT_EQ(compassStatus(), Status::OutOfLimits);
}

TEST_F(Swings, whoFollowsIsToldWhichReadingAloneHasChanged)
{
    const SwingId id = *save(m_swings, swingOf(m_stored));
    std::vector<std::pair<SwingId, ReadingId>> told;
    QObject::connect(&m_database.changes(), &db::Changes::swingChanged, &m_database.changes(),
        [&told](SwingId swing, ReadingId only) { told.emplace_back(swing, only); });
    const Swing swing = *m_swings.swing(id);
    const auto change = [&](std::size_t place, const char* note) {
        const Reading known = *m_swings.reading(id, swing.readings[place].id);
        Reading after = known;
        after.note = note;
        return m_swings.changeReading(id, known, after).ok();
    };
    ASSERT_TRUE(change(1, "gust"));
    ASSERT_EQ(told.size(), 1u);
    EXPECT_EQ(told.back(), std::pair(id, swing.readings[1].id));
    EXPECT_EQ(m_swings.reading(id, swing.readings[1].id)->note, "gust");
    {
        auto both = db::Transaction::begin(m_database);
        ASSERT_TRUE(both && change(1, "calm") && change(2, "gust") && both->commit());
    }
    ASSERT_EQ(told.size(), 2u);
    EXPECT_EQ(told.back(), std::pair(id, ReadingId())); // more than one: the whole swing
    ASSERT_TRUE(m_swings.removeReading(id, swing.readings[0].id));
    EXPECT_EQ(told.back(), std::pair(id, ReadingId()));
    EXPECT_FALSE(m_swings.reading(id, swing.readings[0].id));
}

TEST_F(Swings, readingsAreInsertedSavedAndRemovedInOrder)
{
    Swing swing = swingOf(m_stored);
    swing.readings.resize(3);
    const auto id = *save(m_swings, swing);
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

/// A pasted block is one change: one entry in the trail, results computed once, places without a gap, and whole or not at all.
TEST_F(Swings, manyReadingsAreOneChange)
{
    Swing swing = swingOf(m_stored);
    swing.readings.resize(3);
    const auto id = *save(m_swings, swing);
    const auto entries = [&] {
        db::Statement count(m_database, "SELECT COUNT(*) FROM audit_entry");
        return count.run() && count.next() ? count.integer(0) : -1;
    };
    const auto before = entries();
    std::vector<Reading> block;
    for (int i = 0; i < 500; ++i)
        block.push_back(reading(i % 360, (i + 1) % 360));
    const auto ids = m_swings.insertReadings(id, 1, block);
    ASSERT_TRUE(ids);
    EXPECT_EQ(ids->size(), 500u);
    EXPECT_EQ(entries(), before + 1);
    auto readings = m_swings.swing(id)->readings;
    ASSERT_EQ(readings.size(), 503u);
    EXPECT_EQ(readings[1].id, ids->front());
    EXPECT_EQ(readings[500].id, ids->back());
    std::vector<db::ReadingChange> changes;
    for (std::size_t i = 1; i <= 500; ++i) {
        changes.push_back({readings[i], readings[i]});
        changes.back().reading.note = "again";
    }
    ASSERT_TRUE(m_swings.changeReadings(id, changes));
    EXPECT_EQ(entries(), before + 2);
    changes[7].known.note = "never so"; // one of them is another by now: none is stored
    for (auto& change : changes)
        change.reading.note = "a third time";
    EXPECT_EQ(m_swings.changeReadings(id, changes).error().code, ErrorCode::Conflict);
    EXPECT_EQ(m_swings.swing(id)->readings[1].note, "again");
    ASSERT_TRUE(m_swings.removeReadings(id, *ids));
    EXPECT_EQ(entries(), before + 3);
    readings = m_swings.swing(id)->readings;
    ASSERT_EQ(readings.size(), 3u);
    const auto added = m_swings.insertReading(id, 3, reading(10, 11)); // places are 0, 1 and 2 again
    ASSERT_TRUE(added);
    EXPECT_EQ(m_swings.swing(id)->readings.back().id, *added);
}

TEST_F(Swings, aNumberThatIsNotFiniteIsRefused)
{
    Swing swing = swingOf(m_stored);
    swing.readings[0].pitch_deg = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(save(m_swings, swing).error().code, ErrorCode::InvalidInput);
    EXPECT_EQ(m_fleet.totals()->swings, 0);
}

TEST_F(Swings, whatIsSignedIsFrozenAlsoForRawSql)
{
    Swing swing = swingOf(m_stored);
    swing.state = SwingState::Signed;
    const auto id = save(m_swings, swing);
    ASSERT_TRUE(id) << describe(id.error());
    const auto stored = *m_swings.swing(*id);
    EXPECT_EQ(stored.state, SwingState::Signed);
    Swing changed = stored;
    changed.date = "2020-01-01";
    EXPECT_EQ(save(m_swings, changed).error().code, ErrorCode::Frozen);
    EXPECT_EQ(m_swings.changeReading(*id, stored.readings[0], stored.readings[0]).error().code, ErrorCode::Frozen);
    EXPECT_EQ(m_swings.insertReading(*id, 0, {}).error().code, ErrorCode::Frozen);
    EXPECT_EQ(m_swings.removeReading(*id, stored.readings[0].id).error().code, ErrorCode::Frozen);
    EXPECT_EQ(m_swings.remove(*id).error().code, ErrorCode::Frozen);
    for (const char* sql : {"UPDATE swing SET date = '2020-01-01'", "UPDATE swing SET state = 0", "DELETE FROM swing",
             "DELETE FROM reading", "UPDATE reading SET compass_heading_deg = 1",
             "INSERT INTO reading (swing_id, position, note, extra_json) VALUES (1, 99, '', '[]')"})
        EXPECT_FALSE(raw(sql)) << sql;
    EXPECT_EQ(*m_swings.swing(*id), stored);
}

TEST_F(Swings, whatIsSignedIsNotReplacedEither)
{
    Swing swing = swingOf(m_stored);
    swing.state = SwingState::Signed;
    const auto id = *save(m_swings, swing);                // swing 1 with readings 1 … 8
    const auto draft = *save(m_swings, swingOf(m_stored)); // swing 2 with readings 9 … 16
    const auto stored = *m_swings.swing(id);
    const auto trail = db::number(m_database, "SELECT COUNT(*) FROM audit_entry").value();
    ASSERT_TRUE(raw("CREATE TABLE copy AS SELECT * FROM swing WHERE id = 2") && raw("UPDATE copy SET id = 1, record = 'x'"));
    ASSERT_EQ(draft.value, 2);
    for (const char* sql :
        {"INSERT OR REPLACE INTO swing SELECT * FROM copy", "INSERT OR REPLACE INTO swing SELECT * FROM (SELECT * FROM swing WHERE id = 1)",
            "INSERT OR REPLACE INTO reading (id, swing_id, position, note, extra_json) VALUES (1, 2, 0, '', '[]')",
            "UPDATE OR REPLACE reading SET id = 1 WHERE id = 9", "UPDATE OR REPLACE reading SET rowid = 1 WHERE id = 9",
            "UPDATE OR REPLACE swing SET id = 1 WHERE id = 2", "UPDATE OR REPLACE swing SET rowid = 1 WHERE id = 2",
            "UPDATE OR REPLACE swing SET record = (SELECT record FROM swing WHERE id = 1) WHERE id = 2",
            "UPDATE swing SET rowid = 77 WHERE id = 1", "UPDATE reading SET swing_id = 1 WHERE id = 9",
            "UPDATE reading SET swing_id = 2 WHERE id = 1", "INSERT OR REPLACE INTO audit_entry VALUES (1, '', '', '', '')"})
        EXPECT_FALSE(raw(sql)) << sql;
    EXPECT_EQ(*m_swings.swing(id), stored);
    EXPECT_EQ(m_swings.swing(draft)->readings.size(), 8u);
    EXPECT_EQ(db::number(m_database, "SELECT COUNT(*) FROM audit_entry").value(), trail);
}

TEST_F(Swings, aDraftIsCompletedAndSigned)
{
    const auto id = *save(m_swings, swingOf(m_stored));
    auto swing = *m_swings.swing(id);
    for (const auto state : {SwingState::Complete, SwingState::Draft, SwingState::Signed}) {
        swing.state = state;
        ASSERT_TRUE(save(m_swings, swing));
        EXPECT_EQ(m_swings.swing(id)->state, state);
    }
    swing.state = SwingState::Draft;
    EXPECT_EQ(save(m_swings, swing).error().code, ErrorCode::Frozen);
}

TEST_F(Swings, movedToAnotherCompassLeavesNoStatusBehind)
{
    const auto id = *save(m_swings, swingOf(m_stored));
    CompassSystem other;
    other.aircraft = m_stored.aircraft;
    other.name = "remote compass";
    auto swing = *m_swings.swing(id);
    swing.compass = *save(m_fleet, other);
    ASSERT_TRUE(save(m_swings, swing));
    const auto rows = *m_fleet.compassesOf(m_stored.aircraft); // by name: remote, standby
    EXPECT_EQ(rows[1].swings, 0);
    EXPECT_EQ(rows[1].status, Status::NotKnown);
    EXPECT_EQ(rows[0].status, Status::NotKnown); // no limits are set there
}

TEST_F(Swings, figuresOutsideTheirRangeAreRefused)
{
    Swing swing = swingOf(m_stored);
    swing.readings[0].pitch_deg = 91.0;
    const auto pitch = save(m_swings, swing);
    EXPECT_EQ(pitch.error().code, ErrorCode::InvalidInput);
    EXPECT_THAT(pitch.error().message.english(), testing::HasSubstr("pitch_deg"));
    swing.readings[0].pitch_deg.reset();
    swing.readings[0].nominal_deg = 360.0;
    EXPECT_EQ(save(m_swings, swing).error().code, ErrorCode::InvalidInput);
    swing.readings[0].nominal_deg = std::numeric_limits<double>::infinity();
    EXPECT_EQ(save(m_swings, swing).error().code, ErrorCode::InvalidInput);
    swing.readings[0].nominal_deg.reset();
    swing.readings[0].exclusion = Exclusion{};
    EXPECT_EQ(save(m_swings, swing).error().code, ErrorCode::InvalidInput);
    swing.readings[0].exclusion.reset();
    swing.compass = {};
    EXPECT_EQ(save(m_swings, swing).error().code, ErrorCode::InvalidInput);
    swing.compass = CompassId{99};
    EXPECT_EQ(save(m_swings, swing).error().code, ErrorCode::Conflict);
    EXPECT_EQ(m_fleet.totals()->swings, 0);
    EXPECT_EQ(db::number(m_database, "SELECT COUNT(*) FROM reading").value(), 0);
}

TEST_F(Swings, everyChangeIsInTheAuditTrailForEver)
{
    const auto id = *save(m_swings, swingOf(m_stored));
    auto one = m_swings.swing(id)->readings[0];
    auto before = one;
    one.compass = CompassHeading::fromDegrees(315.5);
    ASSERT_TRUE(m_swings.changeReading(id, before, one));
    db::Statement last(m_database, "SELECT what, detail FROM audit_entry ORDER BY id DESC LIMIT 1");
    ASSERT_TRUE(last.run() && last.next());
    EXPECT_EQ(last.text(0), "changed reading");
    EXPECT_THAT(last.text(1), testing::AllOf(testing::HasSubstr("compass 316"), testing::HasSubstr("compass 315.5")));
    before = one;
    one.roll_deg = -1.5;
    ASSERT_TRUE(m_swings.changeReading(id, before, one));
    EXPECT_THAT(lastEntry(), testing::HasSubstr("roll -1.5"));
    const auto entries = db::number(m_database, "SELECT COUNT(*) FROM audit_entry").value();
    ASSERT_TRUE(m_swings.changeReading(id, one, one)); // nothing changed
    EXPECT_EQ(db::number(m_database, "SELECT COUNT(*) FROM audit_entry").value(), entries);
    auto swing = *m_swings.swing(id);
    swing.people.inspector = "Dora";
    swing.variation_deg = 6.25;
    ASSERT_TRUE(save(m_swings, swing));
    EXPECT_EQ(lastEntry(), "changed swing " + swing.record + " inspector: Dora; variation_deg: 6.25");
    auto site = db::SiteStore(m_database).sites()->front();
    site.name = "Deblin North";
    ASSERT_TRUE(save(db::SiteStore(m_database), site));
    EXPECT_EQ(lastEntry(), "changed site " + site.record + " name: Deblin -> Deblin North");
    EXPECT_FALSE(raw("DELETE FROM audit_entry"));
    EXPECT_FALSE(raw("UPDATE audit_entry SET what = ''"));
}

TEST_F(Swings, onlyDraftsAreRemovedAndStayReadableInTheTrail)
{
    const auto id = *save(m_swings, swingOf(m_stored));
    ASSERT_TRUE(m_swings.remove(id));
    EXPECT_EQ(m_fleet.totals()->swings, 0);
    EXPECT_EQ(db::number(m_database, "SELECT COUNT(*) FROM reading").value(), 0);
    EXPECT_EQ(
        db::number(m_database, "SELECT COUNT(*) FROM audit_entry WHERE what = 'removed swing' AND detail LIKE '%compass 316%'").value(), 1);
    EXPECT_EQ(compassStatus(), Status::NotKnown);
    Swing complete = swingOf(m_stored);
    complete.state = SwingState::Complete;
    EXPECT_EQ(m_swings.remove(*save(m_swings, complete)).error().code, ErrorCode::Frozen);
}

TEST_F(Swings, areFoundByWordsAndByRecord)
{
    const auto id = *save(m_swings, swingOf(m_stored));
    const auto hits = m_fleet.search("3713 deblin 2026", 10);
    ASSERT_TRUE(hits);
    ASSERT_EQ(hits->size(), 1u);
    EXPECT_EQ(hits->front().swing, id);
    EXPECT_TRUE(m_fleet.search("100%", 10)->empty());
    EXPECT_EQ(m_fleet.search("su-22", 10)->size(), 3u); // aircraft, compass, swing
    EXPECT_EQ(m_fleet.search("su-22", 2)->size(), 2u);
    EXPECT_TRUE(m_fleet.search("  ", 10)->empty());
    Swing second = swingOf(m_stored, "2027-01-02");
    second.people = {"Ann", "Bob", "Cid", "Dora"};
    second.note = "100% sure_";
    const auto newer = *save(m_swings, second);
    for (const char* words : {"ann", "bob 3713", "cid standby", "DORA", "100%", "sure_", "2027-01 deblin ann"}) {
        const auto found = *m_fleet.search(words, 10);
        ASSERT_EQ(found.size(), 1u) << words;
        EXPECT_EQ(found.front().swing, newer) << words;
        EXPECT_EQ(found.front().text, "Su-22 · 3713 · standby compass · 2027-01-02 · Deblin");
    }
    EXPECT_TRUE(m_fleet.search("ann nobody", 10)->empty());
    EXPECT_TRUE(m_fleet.search("3_13", 10)->empty());
    EXPECT_EQ(m_fleet.search("deblin", 10)->at(1).swing, id); // newest first
    const auto record = m_swings.swing(id)->record;
    EXPECT_EQ(*m_swings.named(record.substr(0, 6)), id);
    EXPECT_EQ(m_swings.named("zz").error().code, ErrorCode::InvalidInput);
    const std::string others = std::string{record[0], m_swings.swing(newer)->record[0]};
    const auto unused = std::string("012").find_first_not_of(others);
    EXPECT_EQ(m_swings.named(std::string(1, "012"[unused])).error().code, ErrorCode::NotFound);
}

TEST_F(Swings, twoRecordsOfOneNameAreAConflict)
{
    const auto type = save(m_fleet, AircraftType{{}, {}, "Su-22", "", ""});
    EXPECT_EQ(type.error().code, ErrorCode::Conflict);
    EXPECT_EQ(type.error().message.english(), "there is an aircraft type of this name already; expected another");
    CompassSystem compass = *m_fleet.compass(m_stored.compass);
    compass.id = {};
    compass.record.clear();
    EXPECT_EQ(
        save(m_fleet, compass).error().message.english(), "there is a compass of this name on this aircraft already; expected another");
    EXPECT_EQ(save(m_fleet, AircraftType{AircraftTypeId{99}, {}, "An-2", "", ""}).error().code, ErrorCode::NotFound);
    EXPECT_EQ(save(m_fleet, AircraftType{}).error().code, ErrorCode::InvalidInput);
}

/// What still shows a removed record, or can undo something of it, must not meet another one under its number.
TEST_F(Swings, getNoNumberThatWasGivenBefore)
{
    const SwingId first = *save(m_swings, swingOf(m_stored)), second = *save(m_swings, swingOf(m_stored));
    const ReadingId last = m_swings.swing(second)->readings.back().id;
    ASSERT_TRUE(m_swings.remove(second));
    ASSERT_TRUE(m_swings.remove(first));
    const SwingId third = *save(m_swings, swingOf(m_stored));
    EXPECT_EQ(third.value, second.value + 1);
    EXPECT_EQ(m_swings.swing(third)->readings.front().id.value, last.value + 1);
    ASSERT_TRUE(m_swings.replaceReadings(third, swingOf(m_stored).readings));
    EXPECT_GT(m_swings.swing(third)->readings.front().id.value, last.value + 8);
    EXPECT_THAT(db::verify(m_database, {})->findings, testing::IsEmpty());
}

} // namespace lubberline::test
