// The one result of a stored swing: with what its last swing and its siblings let expect, and with the divisions of its guided swing.

#include "core/earth/FieldModel.h"
#include "db/stores/ResultCache.h"
#include "db/stores/Stores.h"
#include "db/transfer/Maintenance.h"
#include "tests/db/SwingStores.h"

namespace lubberline::test {

class ResultStore : public SwingStores {};

TEST_F(ResultStore, theSwingBeforeIsTheHistoryOfTheNext)
{
    Swing before = worksheetSwing(m_stored);
    before.date = "2025-05-05";
    const SwingId first = *save(m_swings, before);
    Swing now = worksheetSwing(m_stored);
    now.date = "2026-05-05";
    const SwingId next = *save(m_swings, now);
    const auto without = m_results.questionOf(first), with = m_results.questionOf(next);
    ASSERT_TRUE(without && with);
    EXPECT_FALSE(without->options.history);
    ASSERT_TRUE(with->options.history);
    const auto told = m_results.resultOf(first)->approximate.smith();
    EXPECT_NEAR(with->options.history->mean.B_rad, told.B_rad, 1e-12);
    EXPECT_NEAR(with->options.history->mean.E_rad, told.E_rad, 1e-12);
    // Of its headings alone, it is the same question.
    const auto byRecord = m_results.questionOf(*m_swings.record(next));
    ASSERT_EQ(byRecord->readings.size(), with->readings.size());
    for (std::size_t i = 0; i < with->readings.size(); ++i) {
        EXPECT_EQ(byRecord->readings[i].magnetic, with->readings[i].magnetic);
        EXPECT_EQ(byRecord->readings[i].compass, with->readings[i].compass);
    }
}

/// Noise of 212 nT rms in a field of 18 000 nT: 0.7° on each reading of a swing after the bench, none before it.
TEST_F(ResultStore, theSensorsBenchIsInTheErrorsOfEveryLaterSwing)
{
    Swing before = worksheetSwing(m_stored), after = before;
    before.date = "2026-04-30";
    after.date = "2026-05-02";
    const FieldStamp stamp{"WMM2025", {51.55, 21.89, 117}, "2026-05-02", {18000, 0, 46000}};
    before.field = after.field = stamp;
    const SwingId first = *save(m_swings, before), next = *save(m_swings, after);
    const auto none = m_results.resultOf(next);
    const auto withoutBench = m_results.questionOf(next)->options.readingError_rad;
    const RecordId record = *db::CoilStore(m_database).add(m_stored.compass, coilBenchOn("2026-05-01"));
    EXPECT_EQ(m_results.questionOf(first)->words.size(), 0u);
    const auto question = m_results.questionOf(next);
    ASSERT_EQ(question->words.size(), 1u);
    EXPECT_THAT(question->words.front().english(), testing::HasSubstr("by its coil bench of 2026-05-01"));
    const double sensor_rad = std::sqrt(std::pow(question->options.readingError_rad, 2) - std::pow(withoutBench, 2));
    const auto bench = sensorBenchOf(coilBenchOn("2026-05-01"));
    EXPECT_NEAR(sensor_rad, std::atan(bench->whole_nT() / 18000), 1e-12);
    EXPECT_NEAR(toDegrees(sensor_rad), 0.7, 0.15);
    const auto with = m_results.resultOf(next);
    EXPECT_GT(*with->approximate.standardError[0], *none->approximate.standardError[0]);
    EXPECT_EQ(with->approximate.smith().B_rad, none->approximate.smith().B_rad);
    EXPECT_EQ(with->warnings.size(), none->warnings.size() + 1);
    ASSERT_TRUE(db::CoilStore(m_database).remove(m_stored.compass, record));
    EXPECT_EQ(m_results.questionOf(next)->options.readingError_rad, withoutBench);
}

TEST_F(ResultStore, siblingsAreTheHistoryOfACompassThatWasNeverSwung)
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
    EXPECT_FALSE(m_results.questionOf(own)->options.history); // two aircraft are no type
    swung("THREE", -2.2);
    const auto question = m_results.questionOf(own);
    ASSERT_TRUE(question && question->options.history);
    EXPECT_NEAR(toDegrees(question->options.history->mean.D_rad), -2.0, 1e-9); // its own D tells nothing of itself
    // s = 0.2 of three: the mean's 0.2/√3, with as much of 0.2 beside it as their readings do not explain, times Student's 4.303 for 1.96.
    const double spread_deg = toDegrees(question->options.history->standardDeviation.D_rad);
    EXPECT_GT(spread_deg, 0.1155 * 4.3027 / 1.96);
    EXPECT_LT(spread_deg, 0.2310 * 4.3027 / 1.96);
    EXPECT_EQ(question->options.history->standardDeviation.B_rad, anyCurve().standardDeviation.B_rad);
    const SwingRecord record = *m_swings.record(own);
    EXPECT_EQ(m_results.questionOf(record, {})->options.history.has_value(), false);

    Swing later = record.swing; // its last swing tells more than its siblings
    later.id = {};
    later.record = {};
    later.state = SwingState::Draft;
    later.date = "2026-11-25";
    const SwingId next = *save(m_swings, later);
    EXPECT_FALSE(*m_results.siblingsOf(*m_swings.record(next)));
    EXPECT_NEAR(toDegrees(m_results.questionOf(next)->options.history->mean.D_rad), 5.0, 1e-6);
}

TEST_F(ResultStore, aResultHasTheDivisionsOfItsJobOrIsRefused)
{
    const SwingId id = *save(m_swings, worksheetSwing(m_stored));
    const SwingRecord record = *m_swings.record(id);
    const Analysis alone = *m_results.resultOf(record);
    SwingRecord placed = record; // in a field, as predictions want it
    placed.swing.field = *stampField(*makePlace(52.2, 20.9, 100), "2026-11-20");
    const SwingAtPlace placeAlone = *m_results.placeOf(placed);
    SwingJob job = smallJob();
    job.datum.resolution_deg = 5;
    ASSERT_TRUE(m_jobs.add(id, job, true)); // the swing itself does not name it, as in files of before
    const Analysis guided = *m_results.resultOf(record);
    EXPECT_GT(*guided.approximate.standardError[0], *alone.approximate.standardError[0]);
    EXPECT_EQ(m_results.resultOf(id)->approximate.standardError, guided.approximate.standardError);
    EXPECT_GT(m_results.placeOf(placed)->standardError.A, placeAlone.standardError.A);

    ASSERT_TRUE(db::execute(m_database, "UPDATE swing_job SET plan_json = '{'"));
    const auto refused = m_results.resultOf(record);
    ASSERT_FALSE(refused); // not as if there had been no datum
    EXPECT_EQ(refused.error().code, ErrorCode::Corrupt);
    EXPECT_EQ(m_results.placeOf(placed).error().code, ErrorCode::Corrupt);
    EXPECT_THAT(refused.error().message.english(), testing::HasSubstr("guided swing"));
}

/// A swing of a log: 2001 readings on a curve with B = 3° sin.
Swing logSwing(const Stored& stored)
{
    Swing swing = swingOf(stored);
    swing.readings.clear();
    for (std::size_t i = 0; i <= db::kRefreshedAtOnce; ++i) {
        const double magnetic_deg = std::fmod(0.733 * static_cast<double>(i), 360.0);
        swing.readings.push_back(reading(magnetic_deg, magnetic_deg - 3 * std::sin(toRadians(magnetic_deg))));
    }
    return swing;
}

TEST_F(ResultStore, aChangeInALogWaitsForNoResultAndLeavesNoOldOne)
{
    const SwingId id = *save(m_swings, logSwing(m_stored));
    const auto row = [&] { return m_swings.swingsOf(m_stored.compass)->front(); };
    const SwingRow before = row();
    ASSERT_TRUE(before.coefficient_deg[1]);
    const auto change = [&](double compass_deg) {
        const Reading known = m_swings.swing(id)->readings[7];
        Reading other = known;
        other.compass = CompassHeading::fromDegrees(compass_deg);
        ASSERT_TRUE(m_swings.changeReading(id, known, other));
    };
    change(99);
    EXPECT_EQ(*m_results.behind(id), 1);
    EXPECT_FALSE(row().maxAbsDeviation_deg || row().coefficient_deg[1]);
    EXPECT_EQ(row().status, Status::NotKnown);
    auto report = db::verify(m_database, {}); // no damage, and worth knowing
    EXPECT_TRUE(report->findings.empty());
    EXPECT_THAT(report->notes,
        testing::Contains(
            testing::ResultOf([](const Message& one) { return one.english(); }, testing::HasSubstr("results are not computed since"))));
    // What was computed of the readings before another change is not kept.
    const auto record = *m_swings.record(id);
    const auto analysis = *m_results.resultOf(record);
    const ReadingId changed = record.swing.readings[7].id;
    change(101);
    ASSERT_TRUE(m_results.keep(record, analysis, 1, changed));
    EXPECT_FALSE(row().maxAbsDeviation_deg);
    const auto newer = *m_swings.record(id);
    ASSERT_TRUE(m_results.keep(newer, *m_results.resultOf(newer), *m_results.behind(id), changed));
    EXPECT_EQ(*m_results.behind(id), 0);
    ASSERT_TRUE(row().maxAbsDeviation_deg);
    EXPECT_GT(*row().maxAbsDeviation_deg, *before.maxAbsDeviation_deg);
    EXPECT_TRUE(db::verify(m_database, {})->findings.empty()); // to the digit that recomputing gives
    EXPECT_THAT(db::verify(m_database, {})->notes, testing::IsEmpty());
}

TEST_F(ResultStore, figuresThatClaimToBeBehindAreNoLessChecked)
{
    const SwingId id = *save(m_swings, logSwing(m_stored));
    ASSERT_TRUE(db::execute(m_database, "UPDATE swing SET results_behind = 1, b_deg = 0.1"));
    EXPECT_FALSE(db::verify(m_database, {})->findings.empty());
    ASSERT_TRUE(m_results.catchUp(id));
    EXPECT_TRUE(db::verify(m_database, {})->findings.empty());
}

TEST(ResultStoreOfAFile, aProgramThatWasKilledBetweenIsMadeGoodByTheNext)
{
    const QTemporaryDir folder;
    const QString path = folder.filePath("log.lubberline");
    SwingId id;
    {
        auto stores = std::move(db::openStores(path, db::OpenMode::ReadWriteCreate).value());
        const Stored stored = store(stores->database());
        id = *save(stores->swings, logSwing(stored));
        const Reading known = stores->swings.swing(id)->readings[7];
        Reading other = known;
        other.compass = CompassHeading::fromDegrees(99);
        ASSERT_TRUE(stores->swings.changeReading(id, known, other));
    }
    {
        auto reading = std::move(db::openStores(path, db::OpenMode::ReadOnly).value());
        EXPECT_EQ(*reading->results.behind(id), 1); // who only reads changes nothing
    }
    auto stores = std::move(db::openStores(path, db::OpenMode::ReadWriteCreate).value());
    EXPECT_EQ(*stores->results.behind(id), 0);
    EXPECT_TRUE(db::verify(stores->database(), {})->findings.empty());
}

} // namespace lubberline::test
