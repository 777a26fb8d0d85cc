// What is kept beside and within swings: raw figures, instruments, rules, waivers, electrical swings; a second writer is told.

#include "tests/db/SwingStores.h"

namespace lubberline::test {

class RecordStores : public SwingStores {};

TEST_F(RecordStores, twoWritersOfOneReading)
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
    EXPECT_THAT(second.error().message.english(), testing::HasSubstr("compass 300"));
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

TEST_F(RecordStores, rawFiguresAndTimesAreKept)
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

    ASSERT_TRUE(db::execute(m_database, "UPDATE reading SET raw_json = '[[317],[' WHERE raw_json <> ''"));
    const auto damaged = m_swings.swing(stored.id);
    ASSERT_FALSE(damaged); // told, not read as if no figures had been kept
    EXPECT_EQ(damaged.error().code, ErrorCode::Corrupt);
}

TEST_F(RecordStores, aDayThatIsNoneIsToldWhereItIsRead)
{
    const SwingId id = *save(m_swings, worksheetSwing(m_stored));
    for (const char* other : {"2026-02-30", "last spring", "20261120"}) {
        ASSERT_TRUE(db::execute(m_database, QStringLiteral("UPDATE swing SET date = '%1'").arg(other)));
        const auto refused = m_swings.swing(id);
        ASSERT_FALSE(refused) << other;
        EXPECT_EQ(refused.error().code, ErrorCode::Corrupt);
        EXPECT_THAT(refused.error().message.english(), testing::HasSubstr(other));
        const auto listed = m_swings.swingsOf(m_stored.compass);
        ASSERT_TRUE(listed && listed->size() == 1) << "a list shows what can be shown";
        EXPECT_TRUE(listed->front().date.empty());
        EXPECT_THAT(inEnglish(db::listDamages(m_database)), testing::Contains(testing::HasSubstr("swing.date, row 1")));
        int seen = 0;
        EXPECT_FALSE(m_swings.forEach([&](const Swing&) { return ++seen > 0; }));
        EXPECT_EQ(seen, 0);
    }
    ASSERT_TRUE(db::execute(m_database, "UPDATE swing SET date = ''"));
    EXPECT_TRUE(m_swings.swing(id)->date.empty());
    ASSERT_TRUE(db::execute(m_database, "UPDATE compass SET installed = 'new'"));
    EXPECT_EQ(m_fleet.compass(m_stored.compass).error().code, ErrorCode::Corrupt);
    EXPECT_EQ(db::DueStore(m_database).compasses().error().code, ErrorCode::Corrupt);
}

TEST_F(RecordStores, instrumentsRulesWaiversAndElectricalSwings)
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
    for (const DatumKind kind : {DatumKind::ShadowPin, DatumKind::Astrocompass}) { // the one stands beside the other
        stored.kind = kind;
        ASSERT_TRUE(save(instruments, stored));
        EXPECT_EQ(*instruments.instruments(), std::vector{stored});
    }
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

TEST_F(RecordStores, coilBenchesAreKeptFoundByDayAndGoWithTheFleet)
{
    db::CoilStore benches(m_database);
    CoilBench first = coilBenchOn("2025-05-01"), second = coilBenchOn("2026-05-01");
    second.serialNumber = "S 2";
    first.record = *benches.add(m_stored.compass, first);
    second.record = *benches.add(m_stored.compass, second);
    const auto all = *benches.of(m_stored.compass);
    ASSERT_EQ(all.size(), 2u);
    EXPECT_EQ(all[0], second);
    EXPECT_EQ(all[1], first);
    EXPECT_EQ(*benches.before(m_stored.compass, "2025-04-30", ""), std::nullopt);
    EXPECT_EQ(*benches.before(m_stored.compass, "2025-05-01", ""), first);
    EXPECT_EQ(*benches.before(m_stored.compass, "2026-11-28", ""), second);
    EXPECT_EQ(*benches.before(m_stored.compass, "2026-11-28", "S 1"), first) << "the other is of another sensor";
    EXPECT_EQ(*benches.before(m_stored.compass, {}, ""), std::nullopt) << "a swing without a date is after none";
    db::Database elsewhere = inMemory();
    const Fleet fleet = *db::exportFleet(m_database, {}, {});
    ASSERT_TRUE(db::importFleet(elsewhere, fleet, {}));
    ASSERT_TRUE(db::importFleet(elsewhere, fleet, {})); // a second time it is known
    EXPECT_EQ(db::exportFleet(elsewhere, {}, {})->coilBenches.size(), 2u);
    EXPECT_EQ(db::exportFleet(elsewhere, {}, {})->coilBenches.front().bench, fleet.coilBenches.front().bench);
    ASSERT_TRUE(benches.remove(m_stored.compass, second.record));
    EXPECT_EQ(benches.remove(m_stored.compass, second.record).error().code, ErrorCode::NotFound);
    EXPECT_EQ(benches.of(m_stored.compass)->size(), 1u);
    EXPECT_THAT(db::verify(m_database, {})->findings, testing::IsEmpty());
}

TEST_F(RecordStores, aWholeFleetGoesToAnotherDatabaseAndBackTheSame)
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
