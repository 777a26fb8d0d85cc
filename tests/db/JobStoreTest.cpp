// Guided swings only grow, go to another machine and come back; the next one begins as the last was left.

#include "tests/db/SwingStores.h"

namespace lubberline::test {

class JobStore : public SwingStores {};

TEST_F(JobStore, aGuidedSwingOnlyGrowsAndASecondWriterIsTold)
{
    const SwingId id = guided();
    ASSERT_TRUE(m_jobs.append(id, 1, prepared()));
    ASSERT_TRUE(m_jobs.append(id, 2, taken(0)));
    const auto late = m_jobs.append(id, 2, taken(1)); // somebody who does not know of the last step
    ASSERT_FALSE(late);
    EXPECT_EQ(late.error().code, ErrorCode::Conflict);
    EXPECT_THAT(late.error().message.english(), testing::HasSubstr("3 steps there, 2 known here"));
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

TEST_F(JobStore, whatIsTypedIsKeptUntilItsStepIsStored)
{
    const SwingId id = guided();
    const std::vector<TypedText> half{{"guidedDatum", "44.5"}, {"guidedCompass", "4"}};
    ASSERT_TRUE(m_jobs.keepTyped(id, 1, {{"guidedDatum", "44"}}));
    ASSERT_TRUE(m_jobs.keepTyped(id, 1, half)); // in place of it
    EXPECT_EQ(*m_jobs.typed(id), half);
    EXPECT_EQ(m_jobs.keepTyped(id, 0, {}).error().code, ErrorCode::Conflict); // of a step that is stored
    EXPECT_EQ(*m_jobs.typed(id), half);
    EXPECT_TRUE(m_jobs.typed(guided())->empty());
    EXPECT_THAT(db::verify(m_database, {})->findings, testing::IsEmpty());
    ASSERT_TRUE(m_jobs.append(id, 1, prepared()));
    EXPECT_TRUE(m_jobs.typed(id)->empty());
    ASSERT_TRUE(m_jobs.keepTyped(id, 2, half));
    ASSERT_TRUE(m_jobs.close(id, true));
    EXPECT_TRUE(m_jobs.typed(id)->empty());
    EXPECT_EQ(m_jobs.keepTyped(id, 2, half).error().code, ErrorCode::Frozen);
}

TEST_F(JobStore, aJobIsTakenUpOnAnotherMachineAndComesBack)
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

TEST_F(JobStore, aJobThatIsFinishedAndSignedElsewhereComesBackSigned)
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

TEST_F(JobStore, lastTimeIsAsItWasLeft)
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

} // namespace lubberline::test
