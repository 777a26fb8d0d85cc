// Signatures over what was signed, amendments, and what holds no longer.

#include "tests/db/SwingStores.h"

namespace lubberline::test {

class SigningStore : public SwingStores {};

TEST_F(SigningStore, twoPeopleFreezeASwing)
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
    EXPECT_NE(signedOne.signatures[0].hash, signedOne.signatures[1].hash); // each covers who gave it, and those before
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

TEST_F(SigningStore, performerAndInspectorAreTwoPeople)
{
    const SwingId id = completed();
    ASSERT_TRUE(m_signing.sign(id, {SignatureRole::Performer, "Ada", "PL 12", "", ""}));
    for (const auto role : {SignatureRole::Inspector, SignatureRole::Authority})
        EXPECT_EQ(m_signing.sign(id, {role, " ada", "", "", ""}).error().code, ErrorCode::InvalidInput);
    EXPECT_EQ(m_swings.swing(id)->signatures.size(), 1u);
    EXPECT_EQ(m_swings.swing(id)->state, SwingState::Complete);
    ASSERT_TRUE(m_signing.sign(id, {SignatureRole::Inspector, "Ben", "PL 7", "", ""}));
    EXPECT_EQ(m_signing.sign(id, {SignatureRole::Performer, "Ben", "", "", ""}).error().code, ErrorCode::InvalidInput);
    EXPECT_EQ(m_swings.swing(id)->state, SwingState::Signed);
}

TEST_F(SigningStore, whatNobodyStatedStaysSo)
{
    Swing swing = *m_swings.swing(draft());
    swing.kind = SwingKind::NotStated;
    swing.stage = SwingStage::NotStated;
    ASSERT_TRUE(save(m_swings, swing));
    EXPECT_EQ(m_swings.swing(swing.id)->kind, SwingKind::NotStated);
    EXPECT_EQ(m_swings.swing(swing.id)->stage, SwingStage::NotStated);
    const auto rows = *m_swings.swingsOf(swing.compass);
    EXPECT_TRUE(std::any_of(
        rows.begin(), rows.end(), [&](const SwingRow& row) { return row.id == swing.id && row.stage == SwingStage::NotStated; }));
    CompassSystem compass = *m_fleet.compass(swing.compass);
    compass.kind = CompassKind::NotStated;
    compass.resolutionStated = false;
    ASSERT_TRUE(save(m_fleet, compass));
    EXPECT_EQ(*m_fleet.compass(compass.id), compass);
}

TEST_F(SigningStore, timesAreThoseOfTheClockThatTheDatabaseWasGiven)
{
    using namespace std::chrono;
    m_database.setClock({[] { return Clock::Time(sys_days(2026y / December / 31) + hours(23) + minutes(30)); }});
    const SwingId id = completed();
    ASSERT_TRUE(m_signing.sign(id, {SignatureRole::Performer, "Ada", "", "", ""}));
    EXPECT_EQ(m_swings.swing(id)->signatures[0].timeUtc, "2026-12-31T23:30:00Z");
    EXPECT_EQ(m_signing.auditOf(m_swings.swing(id)->record)->back().timeUtc, "2026-12-31T23:30:00.000Z");
}

TEST_F(SigningStore, aSignatureNoLongerHoldsOnceTheSwingIsChanged)
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

TEST_F(SigningStore, whatTheDatabaseIsMadeToSayBehindItsBackIsFound)
{
    const SwingId id = completed();
    ASSERT_TRUE(m_signing.sign(id, {SignatureRole::Performer, "Ada", "", "", ""}));
    ASSERT_TRUE(m_signing.sign(id, {SignatureRole::Inspector, "Ben", "", "", ""}));
    for (const char* sql : {"DROP TRIGGER signed_readings_no_update", "UPDATE reading SET compass_heading_deg = 315 WHERE position = 0"})
        ASSERT_TRUE(db::execute(m_database, sql));
    EXPECT_THAT(inEnglish(db::verify(m_database, {})->findings), testing::Contains(testing::HasSubstr("is not what was signed")));
}

TEST_F(SigningStore, anAmendmentIsANewRevision)
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

/// Aircraft were swung on 1980-01-06, too: who knows it says how, and the trail keeps it.
TEST_F(SigningStore, aDayFromWhichClocksCountIsCompletedByWhoKnowsIt)
{
    Swing swing = worksheetSwing(m_stored);
    swing.date = Date("1980-01-06");
    const SwingId id = *save(m_swings, swing);
    EXPECT_THAT(m_signing.complete(id).error().message.english(), testing::HasSubstr("say how it is known"));
    EXPECT_EQ(m_swings.swing(id)->state, SwingState::Draft);
    ASSERT_TRUE(m_signing.complete(id, "sheet 114 of the paper log"));
    EXPECT_EQ(m_swings.swing(id)->state, SwingState::Complete);
    const AuditRow last = m_signing.auditOf(m_swings.swing(id)->record)->back();
    EXPECT_EQ(last.what, "completed swing");
    EXPECT_EQ(last.detail, "the day is known: sheet 114 of the paper log");
    swing = worksheetSwing(m_stored); // of other days nothing is kept, and no words complete one that is to come
    swing.record.clear();
    swing.date = Date("2199-01-01");
    EXPECT_THAT(m_signing.complete(*save(m_swings, swing), "I was there").error().message.english(), testing::HasSubstr("still to come"));
}

TEST_F(SigningStore, aSwingIsCompleteOnlyWhenItIs)
{
    Swing swing = worksheetSwing(m_stored);
    swing.readings[2].compass.reset();
    const SwingId half = *save(m_swings, swing);
    EXPECT_THAT(m_signing.complete(half).error().message.english(), testing::HasSubstr("reading 3 has no compass heading"));
    swing = worksheetSwing(m_stored);
    swing.record.clear();
    swing.readings.resize(3);
    EXPECT_THAT(m_signing.complete(*save(m_swings, swing)).error().message.english(), testing::HasSubstr("3 readings"));
    swing.readings = worksheetReadings();
    swing.date = {};
    EXPECT_THAT(m_signing.complete(*save(m_swings, swing)).error().message.english(), testing::HasSubstr("date"));
}

} // namespace lubberline::test
