#include <gmock/gmock.h>

#include <set>

#include "core/record/DerivedId.h"
#include "core/record/Fleet.h"
#include "core/record/Signature.h"
#include "tests/core/format/Support.h"

namespace lubberline::test {

TEST(DerivedId, differsByKindAndByWhereOneNameEndsAndTheNextBegins)
{
    const std::set<RecordId> ids{recordIdOfType("a"), recordIdOfAircraft("a"), recordIdOfSite("a"), recordIdOfLimits("a"),
        recordIdOfCompass("a", "b"), recordIdOfCompass("ab", ""), recordIdOfCompass("", "ab")};
    EXPECT_EQ(ids.size(), 7u);
    for (const auto& id : ids)
        EXPECT_TRUE(isRecordId(id)) << id;
}

TEST(DerivedId, ofASwingFollowsEveryReadingAndNote)
{
    const Swing swing = wholeRecord().swing;
    const auto id = [](const Swing& one) { return recordIdOfSwing(one, "SP-TST", "standby", "Mielec"); };
    Swing other = swing;
    other.state = SwingState::Draft; // being signed does not make it another swing
    other.id = SwingId{9};
    EXPECT_EQ(id(other), id(swing));
    other = swing;
    other.readings[1].exclusion = Exclusion{"why"};
    EXPECT_NE(id(other), id(swing));
    other = swing;
    other.readings[0].pitch_deg.reset();
    EXPECT_NE(id(other), id(swing));
    EXPECT_NE(recordIdOfSwing(swing, "SP-TST", "standby", ""), id(swing));
}

TEST(ToFleet, renumbersAndKeepsTheRecords)
{
    SwingRecord record = wholeRecord();
    record.aircraft.id = AircraftId{71};
    record.compass.limits = LimitsProfileId{5};
    record.limits->id = LimitsProfileId{5};
    record.swing.site = SiteId{8};
    record.site->id = SiteId{8};
    record.swing.readings[0].id = ReadingId{1234};
    const Fleet fleet = toFleet(record);
    EXPECT_EQ(fleet, toFleet(wholeRecord())); // nothing of the database's numbers is left
    EXPECT_EQ(fleet.swings[0].record, record.swing.record);
    EXPECT_EQ(fleet.compasses[0].limits, fleet.limits[0].id);
    EXPECT_EQ(fleet.swings[0].site, fleet.sites[0].id);
}

TEST(ToFleet, dropsReferencesToWhatTheRecordDoesNotHold)
{
    SwingRecord record = wholeRecord();
    record.site.reset();
    record.limits.reset();
    const Fleet fleet = toFleet(record);
    EXPECT_FALSE(fleet.swings[0].site.valid());
    EXPECT_FALSE(fleet.compasses[0].limits.valid());
    EXPECT_TRUE(fleet.sites.empty() && fleet.limits.empty());
}

TEST(ToFleet, givesIdentitiesToWhatHasNone)
{
    SwingRecord record;
    record.aircraft.registration = "SP-TST";
    record.site.emplace().name = "Mielec";
    const Fleet fleet = toFleet(record);
    for (const RecordId& id :
        {fleet.types[0].record, fleet.aircraft[0].record, fleet.compasses[0].record, fleet.sites[0].record, fleet.swings[0].record})
        EXPECT_TRUE(isRecordId(id)) << id;
    EXPECT_EQ(fleet, toFleet(record));
}

TEST(ShippedLimits, areThoseWhoseSourceWasRead)
{
    // 14 CFR 23/25/27/29.1327: 10 degrees; TM 1-1500-204-23-4, 4-27: spread 5; HSI maintenance page: 2 degrees.
    int ten = 0, spread = 0, two = 0;
    std::set<std::string> names, records;
    for (const auto& profile : shippedLimitsProfiles()) {
        names.insert(profile.name);
        records.insert(profile.record);
        EXPECT_FALSE(profile.document.empty());
        EXPECT_FALSE(profile.scope.empty());
        EXPECT_TRUE(isRecordId(profile.record));
        ten += profile.maxDeviation_deg == 10.0;
        two += profile.maxDeviation_deg == 2.0;
        spread += profile.maxSpread_deg == 5.0;
    }
    EXPECT_EQ(ten, 4);
    EXPECT_EQ(two, 1);
    EXPECT_EQ(spread, 1);
    EXPECT_EQ(names.size(), 6u);
    EXPECT_EQ(records.size(), 6u);
}

TEST(Signatures, twoPeopleOverTheSameContentsFreezeASwing)
{
    const Signature performer{SignatureRole::Performer, "Ada", "", "", "h1"}, inspector{SignatureRole::Inspector, "Ben", "", "", "h1"};
    const Signature authority{SignatureRole::Authority, "Cyd", "", "", "h1"};
    EXPECT_FALSE(freezes({}, {}));
    EXPECT_FALSE(freezes({performer}, {true}));
    EXPECT_FALSE(freezes({inspector, authority}, {true, true}));
    EXPECT_FALSE(freezes({performer, inspector}, {true, false})); // he stood over other contents
    EXPECT_TRUE(freezes({performer, inspector}, {true, true}));
    EXPECT_TRUE(freezes({performer, inspector, authority}, {true, false, true}));
}

TEST(Signatures, nobodyChecksHisOwnWork)
{
    for (const auto& [one, other] :
        {std::pair{"Ada Nowak", "ada  nowak"}, {"A. Nowak", "A Nowak"}, {"Zielińska", "ZIELIŃSKA"}, {"Ćwik", "ćwik"}, {"Иванов", "ИВАНОВ"},
            {"PL 12", "pl-12"}, {"PL12", "PL 12"}, {"Ada Nowak", "NOWAK, Ada"}, {"Zofia Ćwik-Nowak", "Ćwik-Nowak Zofia"}})
        EXPECT_TRUE(samePerson(one, other)) << one;
    EXPECT_FALSE(samePerson("Ada", "Adam"));
    EXPECT_FALSE(samePerson("Ada Nowak", "Ada Ada Nowak"));
    EXPECT_FALSE(samePerson("Ada", ""));
    EXPECT_FALSE(samePerson("", "")); // nobody is no person
    EXPECT_FALSE(samePerson(".", "-"));
    const Signature ada{SignatureRole::Performer, "Ada", "PL 12", "", "h1"};
    const auto why = [&](SignatureRole role, const char* name, const char* licence, bool holds = true) {
        return whyNotSign({role, name, licence, "", ""}, {ada}, {holds}, "Cyd", "Dora").english();
    };
    EXPECT_NE(why(SignatureRole::Inspector, "ADA", "PL 7"), "");
    EXPECT_NE(why(SignatureRole::Authority, "Ada", ""), "");
    EXPECT_NE(why(SignatureRole::Inspector, "A. D. A.", ""), "");
    EXPECT_NE(why(SignatureRole::Inspector, "Ben", "PL-12"), ""); // one licence is one person
    EXPECT_NE(why(SignatureRole::Inspector, "Cyd", ""), "");      // the swing names him as its adjuster
    EXPECT_NE(why(SignatureRole::Performer, "Dora", ""), "");     // and her as its inspector
    EXPECT_EQ(why(SignatureRole::Inspector, "Ben", "PL 7"), "");
    EXPECT_EQ(why(SignatureRole::Performer, "Ada", "PL 12"), "");        // once more, after a change
    EXPECT_EQ(why(SignatureRole::Inspector, "Ada", "PL 12", false), ""); // what she did was changed by another since
}

} // namespace lubberline::test
