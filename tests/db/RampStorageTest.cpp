// What the ramp keeps: guided swings that only grow, signatures over what was signed, amendments, waivers, and a second writer
// told.

#include <gmock/gmock.h>

#include "db/engine/Statement.h"
#include "db/stores/DueStore.h"
#include "db/stores/ElectricalStore.h"
#include "db/stores/JobStore.h"
#include "db/stores/SigningStore.h"
#include "db/stores/SiteStore.h"
#include "db/transfer/Maintenance.h"
#include "db/transfer/Transfer.h"
#include "tests/db/TestFleet.h"

namespace lubberline::test {

namespace {

Swing worksheetSwing(const Stored& stored)
{
    Swing swing = swingOf(stored);
    swing.readings = worksheetReadings();
    return swing;
}

SwingJob smallJob()
{
    SwingJob job;
    job.plan.kind = ProcedureKind::CheckOnly;
    job.checklist = {"tools"};
    job.datum.name = "B-16";
    job.events = {{"2026-11-23T09:00:00Z", job::Ticked{"tools"}}};
    return job;
}

JobEvent prepared() { return {"2026-11-23T09:01:00Z", job::Prepared{}}; }
JobEvent taken(int station)
{
    return {
        "2026-11-23T09:02:00Z", job::ReadingTaken{station, {{45.0 * station}, {}, {45.0 * station}}, 45.0 * station, 45.0 * station, {}}};
}

} // namespace

class Ramp : public testing::Test {
protected:
    SwingId draft()
    {
        Swing swing = swingOf(m_stored);
        swing.readings.clear();
        return *save(m_swings, swing);
    }
    SwingId guided()
    {
        const SwingId id = draft();
        EXPECT_TRUE(m_jobs.add(id, smallJob(), false));
        return id;
    }
    SwingId completed()
    {
        const SwingId id = *save(m_swings, worksheetSwing(m_stored));
        EXPECT_TRUE(m_signing.complete(id));
        return id;
    }

    db::Database m_database = inMemory();
    Stored m_stored = store(m_database);
    db::SwingStore m_swings{m_database};
    db::FleetStore m_fleet{m_database};
    db::JobStore m_jobs{m_database};
    db::SigningStore m_signing{m_database};
};

TEST_F(Ramp, aGuidedSwingOnlyGrowsAndASecondWriterIsTold)
{
    const SwingId id = guided();
    ASSERT_TRUE(m_jobs.append(id, 1, prepared()));
    ASSERT_TRUE(m_jobs.append(id, 2, taken(0)));
    const auto late = m_jobs.append(id, 2, taken(1)); // somebody who does not know of the last step
    ASSERT_FALSE(late);
    EXPECT_EQ(late.error().code, ErrorCode::Conflict);
    EXPECT_THAT(late.error().message, testing::HasSubstr("3 steps there, 2 known here"));
    const auto job = m_jobs.jobOf(id);
    ASSERT_TRUE(job && *job);
    EXPECT_EQ((*job)->job.events.size(), 3u);
    EXPECT_EQ((*job)->job.datum.name, "B-16");
    EXPECT_EQ((*job)->job.particulars.date, m_swings.swing(id)->date);
    EXPECT_EQ(m_jobs.open()->front().events, 3);
    EXPECT_FALSE(db::execute(m_database, "UPDATE job_event SET event_json = '{}'"));
    EXPECT_FALSE(db::execute(m_database, "INSERT OR REPLACE INTO job_event SELECT * FROM job_event"));
    ASSERT_TRUE(m_jobs.close(id, true));
    EXPECT_TRUE(m_jobs.open()->empty());
    EXPECT_EQ(m_jobs.append(id, 3, taken(1)).error().code, ErrorCode::Frozen);
}

TEST_F(Ramp, aJobIsTakenUpOnAnotherMachineAndComesBack)
{
    const SwingId id = guided();
    ASSERT_TRUE(m_jobs.append(id, 1, prepared()));
    const Fleet sent = *db::exportFleet(m_database, {m_stored.aircraft}, {});
    ASSERT_EQ(sent.jobs.size(), 1u);

    db::Database elsewhere = inMemory();
    const auto there = db::importFleet(elsewhere, sent, {});
    ASSERT_TRUE(there) << describe(there.error());
    db::JobStore jobsThere(elsewhere);
    const SwingId swingThere = there->swingIds.back();
    ASSERT_EQ(jobsThere.open()->size(), 1u);
    ASSERT_TRUE(jobsThere.append(swingThere, 2, taken(0)));
    const Fleet back = *db::exportFleet(elsewhere, {}, {});
    const auto again = db::importFleet(m_database, back, {});
    ASSERT_TRUE(again) << describe(again.error());
    EXPECT_EQ(m_jobs.jobOf(id)->value().job.events.size(), 3u);
    ASSERT_TRUE(db::importFleet(m_database, sent, {})); // an older state changes nothing
    EXPECT_EQ(m_jobs.jobOf(id)->value().job.events.size(), 3u);

    // Both go on: the second is told, and nothing is stored.
    ASSERT_TRUE(m_jobs.append(id, 3, taken(1)));
    ASSERT_TRUE(jobsThere.append(swingThere, 3, taken(2)));
    const auto clash = db::importFleet(m_database, *db::exportFleet(elsewhere, {}, {}), {});
    ASSERT_FALSE(clash);
    EXPECT_EQ(clash.error().code, ErrorCode::Conflict);
    EXPECT_EQ(m_jobs.jobOf(id)->value().job.events.size(), 4u);
}

TEST_F(Ramp, aJobThatIsFinishedAndSignedElsewhereComesBackSigned)
{
    const SwingId id = guided();
    db::Database elsewhere = inMemory();
    const auto there = db::importFleet(elsewhere, *db::exportFleet(m_database, {}, {}), {});
    ASSERT_TRUE(there) << describe(there.error());
    const SwingId swingThere = there->swingIds.back();
    ASSERT_TRUE(db::JobStore(elsewhere).append(swingThere, 1, prepared()));
    ASSERT_TRUE(db::SwingStore(elsewhere).replaceReadings(swingThere, worksheetReadings()));
    ASSERT_TRUE(db::JobStore(elsewhere).close(swingThere, true));
    db::SigningStore signing(elsewhere);
    ASSERT_TRUE(signing.complete(swingThere));
    ASSERT_TRUE(signing.sign(swingThere, {SignatureRole::Performer, "Ada", "", "", ""}));
    ASSERT_TRUE(signing.sign(swingThere, {SignatureRole::Inspector, "Ben", "", "", ""}));
    const auto back = db::importFleet(m_database, *db::exportFleet(elsewhere, {}, {}), {});
    ASSERT_TRUE(back) << describe(back.error());
    const Swing here = *m_swings.swing(id);
    EXPECT_EQ(here.state, SwingState::Signed);
    EXPECT_EQ(here.readings.size(), 8u);
    EXPECT_EQ(*m_signing.hold(id), (std::vector<bool>{true, true}));
    EXPECT_TRUE(m_jobs.open()->empty());
    EXPECT_THAT(db::verify(m_database, {})->findings, testing::IsEmpty());
}

TEST_F(Ramp, twoWritersOfOneReading)
{
    const SwingId id = *save(m_swings, worksheetSwing(m_stored));
    const Reading known = m_swings.swing(id)->readings[0];
    Reading mine = known, theirs = known;
    theirs.compass = CompassHeading::fromDegrees(300);
    ASSERT_TRUE(m_swings.changeReading(id, known, theirs));
    mine.compass = CompassHeading::fromDegrees(310);
    const auto second = m_swings.changeReading(id, known, mine);
    ASSERT_FALSE(second);
    EXPECT_EQ(second.error().code, ErrorCode::Conflict);
    EXPECT_THAT(second.error().message, testing::HasSubstr("compass 300"));
    EXPECT_EQ(m_swings.swing(id)->readings[0].compass->degrees(), 300);
    EXPECT_TRUE(m_swings.changeReading(id, known, theirs)); // the same twice is no conflict

    Swing before = *m_swings.swing(id);
    Swing first = before, other = before;
    first.note = "mine";
    ASSERT_TRUE(m_swings.change(before, first));
    other.note = "yours";
    EXPECT_EQ(m_swings.change(before, other).error().code, ErrorCode::Conflict);
    EXPECT_EQ(m_swings.swing(id)->note, "mine");
}

TEST_F(Ramp, rawFiguresAndTimesAreKept)
{
    Swing swing = worksheetSwing(m_stored);
    swing.readings[0].raw = {{317, 316.5, 317}, {137}, {316}};
    swing.readings[0].timeUtc = "2026-11-23T09:00:00Z";
    swing.startUtc = "2026-11-23T08:00:00Z";
    swing.siteOverride = "expired: only base";
    const auto stored = *m_swings.swing(*save(m_swings, swing));
    EXPECT_EQ(stored.readings[0].raw, swing.readings[0].raw);
    EXPECT_EQ(stored.readings[0].timeUtc, swing.readings[0].timeUtc);
    EXPECT_TRUE(stored.readings[1].raw.empty());
    EXPECT_EQ(stored.startUtc, swing.startUtc);
    EXPECT_EQ(stored.siteOverride, swing.siteOverride);
}

TEST_F(Ramp, twoPeopleFreezeASwing)
{
    const SwingId id = completed();
    EXPECT_EQ(m_signing.sign(draft(), {SignatureRole::Performer, "Ada", "", "", ""}).error().code, ErrorCode::InvalidInput);
    EXPECT_EQ(m_signing.sign(id, {SignatureRole::Performer, " ", "", "", ""}).error().code, ErrorCode::InvalidInput);
    ASSERT_TRUE(m_signing.sign(id, {SignatureRole::Performer, "Ada", "PL 12", "", ""}));
    EXPECT_EQ(m_swings.swing(id)->state, SwingState::Complete);
    ASSERT_TRUE(m_signing.sign(id, {SignatureRole::Inspector, "Ben", "PL 7", "", ""}));
    const Swing signedOne = *m_swings.swing(id);
    EXPECT_EQ(signedOne.state, SwingState::Signed);
    ASSERT_EQ(signedOne.signatures.size(), 2u);
    EXPECT_EQ(signedOne.signatures[0].hash, signedOne.signatures[1].hash);
    EXPECT_EQ(signedOne.signatures[0].hash.size(), 64u);
    EXPECT_EQ(*m_signing.hold(id), (std::vector<bool>{true, true}));
    ASSERT_TRUE(m_signing.sign(id, {SignatureRole::Authority, "Cleo", "", "", ""})); // releases it later
    EXPECT_EQ(m_signing.reopen(id, "oops").error().code, ErrorCode::Frozen);
    EXPECT_EQ(m_swings.changeReading(id, signedOne.readings[0], {}).error().code, ErrorCode::Frozen);
    EXPECT_FALSE(db::execute(m_database, "UPDATE signature SET name = 'x'"));
    EXPECT_FALSE(db::execute(m_database, "DELETE FROM signature"));
    EXPECT_THAT(db::verify(m_database, {})->findings, testing::IsEmpty());
    // Renaming an aircraft is no change of what was signed.
    Aircraft renamed = *m_fleet.aircraft(m_stored.aircraft);
    renamed.registration = "3713A";
    ASSERT_TRUE(save(m_fleet, renamed));
    EXPECT_EQ((*m_signing.hold(id))[0], true);
}

TEST_F(Ramp, aSignatureNoLongerHoldsOnceTheSwingIsChanged)
{
    const SwingId id = completed();
    ASSERT_TRUE(m_signing.sign(id, {SignatureRole::Performer, "Ada", "", "", ""}));
    EXPECT_EQ(m_signing.reopen(id, "").error().code, ErrorCode::InvalidInput);
    ASSERT_TRUE(m_signing.reopen(id, "NW was misread"));
    const Reading known = m_swings.swing(id)->readings[0];
    Reading changed = known;
    changed.compass = CompassHeading::fromDegrees(315);
    ASSERT_TRUE(m_swings.changeReading(id, known, changed));
    EXPECT_EQ(*m_signing.hold(id), std::vector<bool>{false});
    ASSERT_TRUE(m_signing.complete(id));
    ASSERT_TRUE(m_signing.sign(id, {SignatureRole::Inspector, "Ben", "", "", ""}));
    EXPECT_EQ(m_swings.swing(id)->state, SwingState::Complete); // Ada signed something else
    ASSERT_TRUE(m_signing.sign(id, {SignatureRole::Performer, "Ada", "", "", ""}));
    EXPECT_EQ(m_swings.swing(id)->state, SwingState::Signed);
    EXPECT_EQ(m_swings.remove(id).error().code, ErrorCode::Frozen);
}

TEST_F(Ramp, whatTheDatabaseIsMadeToSayBehindItsBackIsFound)
{
    const SwingId id = completed();
    ASSERT_TRUE(m_signing.sign(id, {SignatureRole::Performer, "Ada", "", "", ""}));
    ASSERT_TRUE(m_signing.sign(id, {SignatureRole::Inspector, "Ben", "", "", ""}));
    for (const char* sql : {"DROP TRIGGER signed_readings_no_update", "UPDATE reading SET compass_heading_deg = 315 WHERE position = 0"})
        ASSERT_TRUE(db::execute(m_database, sql));
    EXPECT_THAT(db::verify(m_database, {})->findings, testing::Contains(testing::HasSubstr("is not what was signed")));
}

TEST_F(Ramp, anAmendmentIsANewRevision)
{
    const SwingId id = completed();
    EXPECT_EQ(m_signing.amend(id, "x").error().code, ErrorCode::InvalidInput); // not signed yet
    ASSERT_TRUE(m_signing.sign(id, {SignatureRole::Performer, "Ada", "", "", ""}));
    ASSERT_TRUE(m_signing.sign(id, {SignatureRole::Inspector, "Ben", "", "", ""}));
    EXPECT_EQ(m_signing.amend(id, " ").error().code, ErrorCode::InvalidInput);
    const auto second = m_signing.amend(id, "the date was wrong");
    ASSERT_TRUE(second) << describe(second.error());
    const Swing amended = *m_swings.swing(*second), original = *m_swings.swing(id);
    EXPECT_EQ(amended.revision, 2);
    EXPECT_EQ(amended.supersedes, original.record);
    EXPECT_EQ(amended.amendment, "the date was wrong");
    EXPECT_EQ(amended.state, SwingState::Draft);
    EXPECT_TRUE(amended.signatures.empty());
    EXPECT_EQ(amended.readings.size(), original.readings.size());
    EXPECT_EQ(m_signing.amend(id, "again").error().code, ErrorCode::Conflict);
    EXPECT_FALSE(*m_swings.previous(*second)); // what it amends is not "last time"
    const auto rows = *m_swings.swingsOf(m_stored.compass);
    EXPECT_TRUE(std::any_of(rows.begin(), rows.end(), [&](const SwingRow& row) { return row.id == id && row.superseded; }));
    const auto trail = *m_signing.auditOf(original.record);
    EXPECT_EQ(trail.front().what, "added swing");
    EXPECT_EQ(trail.back().what, "amended swing");
}

TEST_F(Ramp, aSwingIsCompleteOnlyWhenItIs)
{
    Swing swing = worksheetSwing(m_stored);
    swing.readings[2].compass.reset();
    const SwingId half = *save(m_swings, swing);
    EXPECT_THAT(m_signing.complete(half).error().message, testing::HasSubstr("reading 3 has no compass heading"));
    swing = worksheetSwing(m_stored);
    swing.record.clear();
    swing.readings.resize(3);
    EXPECT_THAT(m_signing.complete(*save(m_swings, swing)).error().message, testing::HasSubstr("3 readings"));
    swing.readings = worksheetReadings();
    swing.date.clear();
    EXPECT_THAT(m_signing.complete(*save(m_swings, swing)).error().message, testing::HasSubstr("date"));
}

TEST_F(Ramp, lastTimeIsAsItWasLeft)
{
    Swing found = worksheetSwing(m_stored), left = found;
    found.date = left.date = "2025-05-05";
    left.stage = SwingStage::AsLeft;
    const SwingId leftId = *save(m_swings, left); // stored first, as a guided swing does
    found.stage = SwingStage::AsFound;
    const SwingId foundId = *save(m_swings, found);
    Swing now = worksheetSwing(m_stored);
    now.date = "2026-05-05";
    EXPECT_EQ(m_swings.previous(*save(m_swings, now))->value().id, leftId);
    EXPECT_EQ(m_swings.previous(leftId)->value().id, foundId); // nothing older: as it was found that day
}

TEST_F(Ramp, instrumentsRulesWaiversAndElectricalSwings)
{
    db::SiteStore instruments(m_database);
    DatumInstrument instrument;
    instrument.name = "B-16";
    instrument.zero_deg = 0.3;
    ASSERT_TRUE(save(instruments, instrument));
    auto stored = instruments.instruments()->front();
    stored.ahead = SightingDirection::Reciprocal;
    ASSERT_TRUE(save(instruments, stored));
    EXPECT_EQ(*instruments.instruments(), std::vector{stored});
    EXPECT_EQ(save(instruments, instrument).error().code, ErrorCode::Conflict); // the name
    ASSERT_TRUE(instruments.removeInstrument(stored.record));
    EXPECT_EQ(instruments.removeInstrument(stored.record).error().code, ErrorCode::NotFound);

    db::DueStore due(m_database);
    ASSERT_TRUE(save(due, DueRule{{}, "two years", 24, 0, 30, "", "", {}}));
    Event event;
    event.aircraft = m_stored.aircraft;
    event.date = "2026-10-01";
    event.cause = DueCause::Lightning;
    ASSERT_TRUE(save(m_fleet, event));
    const RecordId struck = m_fleet.eventsOf(m_stored.aircraft)->front().record;
    EXPECT_EQ(save(due, Waiver{{}, struck, "2026-10-02", "", "Dora"}).error().code, ErrorCode::InvalidInput);
    EXPECT_EQ(save(due, Waiver{{}, newRecordId(), "2026-10-02", "no change", "Dora"}).error().code, ErrorCode::NotFound);
    ASSERT_TRUE(save(due, Waiver{{}, struck, "2026-10-02", "no change", "Dora"}));
    EXPECT_FALSE(db::execute(m_database, "DELETE FROM waiver"));
    const auto all = *due.compasses();
    ASSERT_EQ(all.size(), 1u);
    EXPECT_EQ(all[0].registration, "3713");
    EXPECT_EQ(all[0].events.size(), 1u);
    EXPECT_EQ(all[0].waivers.size(), 1u);
    EXPECT_TRUE(all[0].signedSwings.empty());

    db::ElectricalStore electrical(m_database);
    ElectricalSwing swing;
    swing.date = "2026-11-23";
    swing.before.indicated_deg[2] = 180.6;
    ASSERT_TRUE(save(electrical, m_stored.compass, swing));
    auto again = electrical.of(m_stored.compass)->front();
    EXPECT_EQ(again.before, swing.before);
    again.note = "repeated";
    ASSERT_TRUE(save(electrical, m_stored.compass, again));
    EXPECT_EQ(electrical.of(m_stored.compass)->size(), 1u);
}

TEST_F(Ramp, aWholeFleetGoesToAnotherDatabaseAndBackTheSame)
{
    const SwingId id = guided();
    ASSERT_TRUE(m_jobs.append(id, 1, prepared()));
    const SwingId done = completed();
    ASSERT_TRUE(m_signing.sign(done, {SignatureRole::Performer, "Ada", "", "", ""}));
    ASSERT_TRUE(m_signing.sign(done, {SignatureRole::Inspector, "Ben", "", "", ""}));
    DatumInstrument instrument;
    instrument.name = "B-16";
    ASSERT_TRUE(save(db::SiteStore(m_database), instrument));
    Site site = db::SiteStore(m_database).sites()->front();
    site.siteClass = SiteClass::Class1;
    site.survey = {{1, 2, 1.5, 6.25, {}}};
    ASSERT_TRUE(save(db::SiteStore(m_database), site));
    const Fleet all = *db::exportFleet(m_database, {}, {});
    db::Database elsewhere = inMemory();
    ASSERT_TRUE(db::importFleet(elsewhere, all, {}));
    const Fleet there = *db::exportFleet(elsewhere, {}, {});
    EXPECT_EQ(there.swings.size(), all.swings.size());
    EXPECT_EQ(there.sites.front().survey, site.survey);
    EXPECT_EQ(there.instruments, all.instruments);
    EXPECT_EQ(there.jobs.front().job, all.jobs.front().job);
    const auto frozen
        = std::find_if(there.swings.begin(), there.swings.end(), [](const Swing& one) { return one.state == SwingState::Signed; });
    ASSERT_NE(frozen, there.swings.end());
    EXPECT_EQ(frozen->signatures.size(), 2u);
    EXPECT_THAT(db::verify(elsewhere, {})->findings, testing::IsEmpty()); // its signatures hold there, too
}

} // namespace lubberline::test
