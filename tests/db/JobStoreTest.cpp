// Guided swings only grow, go to another machine and come back; the next one begins as the last was left.

#include "core/earth/FieldModel.h"
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

TEST_F(JobStore, theSwingBeforeIsTheHistoryOfTheNext)
{
    Swing before = worksheetSwing(m_stored);
    before.date = "2025-05-05";
    const SwingId first = *save(m_swings, before);
    Swing now = worksheetSwing(m_stored);
    now.date = "2026-05-05";
    const SwingId next = *save(m_swings, now);
    const auto without = m_jobs.questionOf(first), with = m_jobs.questionOf(next);
    ASSERT_TRUE(without && with);
    EXPECT_FALSE(without->options.history);
    ASSERT_TRUE(with->options.history);
    const auto told = m_jobs.resultOf(first)->approximate.smith();
    EXPECT_NEAR(with->options.history->mean.B_rad, told.B_rad, 1e-12);
    EXPECT_NEAR(with->options.history->mean.E_rad, told.E_rad, 1e-12);
    // Of its headings alone, it is the same question.
    const auto byRecord = m_jobs.questionOf(*m_swings.record(next));
    ASSERT_EQ(byRecord->readings.size(), with->readings.size());
    for (std::size_t i = 0; i < with->readings.size(); ++i) {
        EXPECT_EQ(byRecord->readings[i].magnetic, with->readings[i].magnetic);
        EXPECT_EQ(byRecord->readings[i].compass, with->readings[i].compass);
    }
}

TEST_F(JobStore, siblingsAreTheHistoryOfACompassThatWasNeverSwung)
{
    const auto swung = [this](const std::string& registration, double D_deg) {
        Aircraft aircraft;
        aircraft.type = m_stored.type;
        aircraft.registration = registration;
        CompassSystem compass;
        compass.aircraft = *save(m_fleet, aircraft);
        compass.name = "standby compass";
        Stored there = m_stored;
        there.compass = *save(m_fleet, compass);
        Swing swing = swingOf(there);
        swing.readings.clear();
        for (int heading = 0; heading < 360; heading += 45)
            swing.readings.push_back(reading(heading + D_deg * std::sin(2 * toRadians(heading)), heading));
        const SwingId id = *save(m_swings, swing);
        EXPECT_TRUE(m_signing.complete(id)); // drafts tell nothing of a type
        return id;
    };
    const SwingId own = swung("OWN", 5.0);
    swung("ONE", -1.8);
    swung("TWO", -2.0);
    EXPECT_FALSE(m_jobs.questionOf(own)->options.history); // two aircraft are no type
    swung("THREE", -2.2);
    const auto question = m_jobs.questionOf(own);
    ASSERT_TRUE(question && question->options.history);
    EXPECT_NEAR(toDegrees(question->options.history->mean.D_rad), -2.0, 1e-9); // its own D tells nothing of itself
    // s = 0.2 of three: the mean's 0.2/√3, with as much of 0.2 beside it as their readings do not explain, times Student's 4.303 for 1.96.
    const double spread_deg = toDegrees(question->options.history->standardDeviation.D_rad);
    EXPECT_GT(spread_deg, 0.1155 * 4.3027 / 1.96);
    EXPECT_LT(spread_deg, 0.2310 * 4.3027 / 1.96);
    EXPECT_EQ(question->options.history->standardDeviation.B_rad, anyCurve().standardDeviation.B_rad);
    const SwingRecord record = *m_swings.record(own);
    EXPECT_EQ(m_jobs.questionOf(record, {})->options.history.has_value(), false);

    Swing later = record.swing; // its last swing tells more than its siblings
    later.id = {};
    later.record = {};
    later.state = SwingState::Draft;
    later.date = "2026-11-25";
    const SwingId next = *save(m_swings, later);
    EXPECT_FALSE(*m_jobs.siblingsOf(*m_swings.record(next)));
    EXPECT_NEAR(toDegrees(m_jobs.questionOf(next)->options.history->mean.D_rad), 5.0, 1e-6);
}

TEST_F(JobStore, aResultHasTheDivisionsOfItsJobOrIsRefused)
{
    const SwingId id = *save(m_swings, worksheetSwing(m_stored));
    const SwingRecord record = *m_swings.record(id);
    const Analysis alone = *m_jobs.resultOf(record);
    SwingRecord placed = record; // in a field, as predictions want it
    placed.swing.field = *stampField(*makePlace(52.2, 20.9, 100), "2026-11-20");
    const SwingAtPlace placeAlone = *m_jobs.placeOf(placed);
    SwingJob job = smallJob();
    job.datum.resolution_deg = 5;
    ASSERT_TRUE(m_jobs.add(id, job, true)); // the swing itself does not name it, as in files of before
    const Analysis guided = *m_jobs.resultOf(record);
    EXPECT_GT(*guided.approximate.standardError[0], *alone.approximate.standardError[0]);
    EXPECT_EQ(m_jobs.resultOf(id)->approximate.standardError, guided.approximate.standardError);
    EXPECT_GT(m_jobs.placeOf(placed)->standardError.A, placeAlone.standardError.A);

    ASSERT_TRUE(db::execute(m_database, "UPDATE swing_job SET plan_json = '{'"));
    const auto refused = m_jobs.resultOf(record);
    ASSERT_FALSE(refused); // not as if there had been no datum
    EXPECT_EQ(refused.error().code, ErrorCode::Corrupt);
    EXPECT_EQ(m_jobs.placeOf(placed).error().code, ErrorCode::Corrupt);
    EXPECT_THAT(refused.error().message.english(), testing::HasSubstr("guided swing"));
}

} // namespace lubberline::test
