// What somebody changes in the file behind the program's back is named by verify(): signatures, what they cover, and the audit trail.

#include "core/format/exchange/Exchange.h"
#include "core/format/exchange/SignedContent.h"
#include "db/stores/DueStore.h"
#include "db/transfer/SignedFleet.h"
#include "tests/db/SignedFile.h"

namespace lubberline::test {

namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;

struct Forgery {
    const char* name;
    QStringList statements;
    const char* words;
    bool holds; ///< whether both signatures still stand over what the record says
};

void PrintTo(const Forgery& forgery, std::ostream* out) { *out << forgery.name; }

class Forgeries : public SignedFile, public testing::WithParamInterface<Forgery> {};

const Forgery kForgeries[] = {
    {"aSignatureIsTakenOut", {"DELETE FROM signature WHERE name = 'Ben'"}, "the signature \"inspector: Ben PL 7", false},
    {"theFirstSignatureIsTakenOut", {"DELETE FROM signature WHERE name = 'Ada'"}, "the signature \"performer: Ada PL 12", false},
    {"allSignaturesAreTakenOut", {"DELETE FROM signature"}, "it was taken out or changed", false},
    {"aSignatureIsPutIn",
        {"INSERT INTO signature SELECT 99, swing_id, 2, 'Cleo', 'PL 1', time_utc, hash, contents, file, file_head, record_head, particulars, key,"
         " public_key, openpgp FROM signature WHERE id = 1"},
        "Cleo (authority) on the swing of 2026-11-20", false},
    {"anOlderSignatureIsPutIn",
        {"INSERT INTO signature (swing_id, role, name, licence, time_utc, hash) VALUES (1, 2, 'Cleo', '', '2026-11-20T10:00:00Z', '"
            + QString(64, 'a') + "')"},
        "Cleo (authority)", false},
    {"whoSigned", {"UPDATE signature SET name = 'Eve' WHERE name = 'Ben'"}, "Eve (inspector)", false},
    {"theLicence", {"UPDATE signature SET licence = 'PL 8' WHERE name = 'Ben'"}, "inspector: Ben PL 7", false},
    {"theRole", {"UPDATE signature SET role = 2 WHERE name = 'Ben'"}, "Ben (authority)", false},
    {"theTime", {"UPDATE signature SET time_utc = '2026-11-20T10:00:00Z' WHERE name = 'Ben'"}, "Ben (inspector)", false},
    {"theTimeOfTheFirst", {"UPDATE signature SET time_utc = '2026-11-20T10:00:00Z' WHERE name = 'Ada'"}, "Ada (performer)", false},
    {"theKey", {"UPDATE signature SET key = '" + QString(40, 'A') + "' WHERE name = 'Ben'"}, "Ben (inspector)", false},
    {"theHash", {"UPDATE signature SET hash = '" + QString(64, 'b') + "' WHERE name = 'Ben'"}, "Ben (inspector)", false},
    {"theRegistration", {"UPDATE aircraft SET registration = '3714'"},
        "registration of the aircraft was \"3713\" when it was signed and is \"3714\"", false},
    {"theSerialNumberOfTheAircraft", {"UPDATE aircraft SET serial_number = '99'"}, "serial_number of the aircraft", false},
    {"theType", {"UPDATE aircraft_type SET name = 'Su-17'"}, "name of the type was \"Su-22\"", false},
    {"theCompass", {"UPDATE compass SET name = 'No. 1'"}, "name of the compass was \"standby compass\"", false},
    {"theSerialNumberOfTheCompass", {"UPDATE compass SET serial_number = 'X1'"}, "serial_number of the compass", false},
    {"theSite", {"UPDATE site SET name = 'Radom'"}, "name of the site", false},
    {"theLimits", {"UPDATE limits_profile SET max_deviation_deg = 45"}, "max_deviation_deg of the limits", false},
    {"anotherAircraft",
        {"INSERT INTO aircraft SELECT 77, '11111111-1111-4111-8111-111111111111', type_id, 'OTHER', '', '', NULL, '', 0, NULL FROM aircraft LIMIT 1",
            "UPDATE compass SET aircraft_id = 77"},
        "registration of the aircraft was \"3713\" when it was signed and is \"OTHER\"", false},
    {"aReading", {"UPDATE reading SET compass_heading_deg = 315 WHERE position = 0"}, "is not what was signed", false},
    {"theDate", {"UPDATE swing SET date = '2026-11-21'"}, "does not hold", false},
    {"theState", {"UPDATE swing SET state = 0"}, "was signed by two people and is not frozen", true},
    {"rolesChangePlaces", {"UPDATE signature SET role = 1 - role"}, "Ben (performer)", false},
    {"signaturesChangePlaces",
        {"UPDATE signature SET id = 98 WHERE name = 'Ada'", "UPDATE signature SET id = 1 WHERE name = 'Ben'",
            "UPDATE signature SET id = 2 WHERE name = 'Ada'"},
        "Ben (inspector)", false},
    {"theRecordId", {"UPDATE swing SET record = '11111111-1111-4111-8111-111111111111'"}, "is not in the audit trail", false},
    {"theContentsAreCalledOlder", {"UPDATE signature SET contents = 2"}, "Ada (performer)", false},
    {"theParticularsAreNestedAMillionDeep",
        {"UPDATE signature SET particulars = '{\"types\":[{\"name\":' || replace(hex(zeroblob(1000000)), '00', '[') ||"
         " replace(hex(zeroblob(1000000)), '00', ']') || '}]}'"},
        "Ada (performer)", false},
    {"aNote", {"UPDATE reading SET note = 'looked at' WHERE position = 1"}, "is not what was signed", false},
    {"readingsChangePlaces",
        {"UPDATE reading SET position = 99 WHERE position = 0", "UPDATE reading SET position = 0 WHERE position = 1",
            "UPDATE reading SET position = 1 WHERE position = 99"},
        "is not what was signed", false},
    {"theFilesIdentity", {"UPDATE audit_head SET file = '11111111-1111-4111-8111-111111111111'"}, "does not follow the one before it",
        true},
    {"aBaseIsTakenOut", {"UPDATE swing SET site_id = NULL", "DELETE FROM site"}, "is not there: it was taken out behind", false},
    {"anotherAircraftIsPutIn",
        {"INSERT INTO aircraft SELECT 77, '11111111-1111-4111-8111-111111111111', type_id, 'OTHER', '', '', NULL, '', 0, NULL FROM aircraft LIMIT 1"},
        "aircraft, row 77: the audit trail does not know the record", true},
    {"aKeyIsPutIn",
        {"INSERT INTO signing_key (fingerprint, holder, added_utc, public_key) VALUES ('" + QString(40, 'A')
            + "', 'Eve', '2026-11-20', 'x')"},
        "of Eve is not what the audit trail says", true},
    {"anEntryIsChanged", {"UPDATE audit_entry SET detail = 'nothing' WHERE what = 'completed swing'"}, "completed swing, record", true},
    {"theTimeOfAnEntry", {"UPDATE audit_entry SET time_utc = '2020-01-01T00:00:00.000Z' WHERE id = 3"}, "entry 3 (2020-01-01", true},
    {"anEntryIsTakenOut", {"DELETE FROM audit_entry WHERE id = 4"}, "entry 4 is missing", true},
    {"entriesAreTakenOut", {"DELETE FROM audit_entry WHERE id BETWEEN 3 AND 5"}, "entries 3 to 5 are missing", true},
    {"theFirstIsTakenOut", {"DELETE FROM audit_entry WHERE id = 1"}, "entry 1 is missing", true},
    {"theLastIsTakenOut", {"DELETE FROM audit_entry WHERE id = (SELECT MAX(id) FROM audit_entry)"}, "is missing", true},
    {"allAreTakenOut", {"DELETE FROM audit_entry"}, "are missing", true},
    {"entriesChangePlaces",
        {"UPDATE audit_entry SET id = 1000 WHERE id = 2", "UPDATE audit_entry SET id = 2 WHERE id = 3",
            "UPDATE audit_entry SET id = 3 WHERE id = 1000"},
        "does not follow the one before it", true},
    {"anEntryIsPutIn",
        {"INSERT INTO audit_entry (time_utc, what, record, detail) VALUES ('2026-11-20T10:00:00.000Z', 'changed swing', 'x', 'date')"},
        "was put in behind the program's back", true},
    {"moreEntriesAreCalledOlderThanThereAre", {"UPDATE audit_head SET entries_before = 999999"}, "says that 999999 entries were there",
        true},
    {"theTailIsCutAndTheHeadMoved",
        {"DELETE FROM audit_entry WHERE id > 8",
            "UPDATE audit_head SET entries = 8, head = (SELECT file_link FROM audit_entry WHERE id = 8)"},
        "is not in the audit trail", true}, // no entry names the signatures any more
};

} // namespace

TEST_P(Forgeries, isNamed)
{
    forge(GetParam().statements);
    EXPECT_THAT(found(), Contains(HasSubstr(GetParam().words)));
    const auto hold = holdNow();
    EXPECT_EQ(std::all_of(hold.begin(), hold.end(), [](bool one) { return one; }) && hold.size() == 2, GetParam().holds);
    const bool onlyAdded = QString::fromLatin1(GetParam().name).endsWith("SignatureIsPutIn"); // beside two that hold: each says so itself
    EXPECT_EQ(standsNow(), GetParam().holds || onlyAdded);
    expectListsFollow();
}

TEST_F(SignedFile, signedByItsStateAloneStandsForNothing)
{
    forge({"UPDATE swing SET state = 1", "DELETE FROM signature",
        "DELETE FROM audit_entry WHERE what IN ('signed swing', 'froze swing')"}); // as one that was complete, and nobody signed
    EXPECT_FALSE(standsNow());
    forge({"UPDATE swing SET state = 2"});
    EXPECT_FALSE(standsNow());
    expectListsFollow();
    EXPECT_THAT(found(), Contains(HasSubstr("the audit trail does not say by whom")));
}

INSTANTIATE_TEST_SUITE_P(Each, Forgeries, testing::ValuesIn(kForgeries), [](const auto& test) { return std::string(test.param.name); });

TEST_F(SignedFile, aListIsHashedAsFarAsTheWindowHasTimeFor)
{
    auto database = db::openDatabase(m_path, db::OpenMode::ReadWriteCreate);
    db::SwingStore swings(*database);
    SwingRow row = swings.swingsOf(swings.swing(m_swing)->compass)->front();
    const auto one = *db::signedMarks(*database, {row});
    EXPECT_THAT(one, testing::ElementsAre(db::SignedMark::Stands));
    const auto many = *db::signedMarks(*database, std::vector<SwingRow>(400, row));
    ASSERT_EQ(many.size(), 400u);
    EXPECT_EQ(many.front(), db::SignedMark::Stands);
    EXPECT_EQ(many.back(), db::SignedMark::NotChecked) << "nobody says of it that it stands";
    row.state = SwingState::Complete;
    EXPECT_THAT(*db::signedMarks(*database, {row}), testing::ElementsAre(db::SignedMark::No));
}

TEST_F(SignedFile, anAmendmentThatNobodySignedTakesNoFindingOutOfTheDueList)
{
    forge({"CREATE TEMP TABLE copy AS SELECT * FROM swing",
        "UPDATE copy SET id = 77, supersedes = record, revision = 2, record = '22222222-2222-4222-8222-222222222222'",
        "INSERT INTO swing SELECT * FROM copy"});
    auto database = db::openDatabase(m_path, db::OpenMode::ReadWriteCreate);
    const auto due = db::DueStore(*database).compasses();
    ASSERT_TRUE(due) << describe(due.error());
    ASSERT_EQ(due->front().findings.size(), 2u); // the copy is of the same day
    EXPECT_FALSE(due->front().findings.front().isSigned);
    EXPECT_TRUE(due->front().findings.back().isSigned);
}

TEST_F(SignedFile, aSignedSwingThatWasTakenOutIsMissed)
{
    forge({"DELETE FROM reading", "DELETE FROM signature", "DELETE FROM swing"});
    EXPECT_THAT(found(), Contains(AllOf(HasSubstr("of which the audit trail says last \"froze swing\""), HasSubstr("is not there"))));
}

TEST_F(SignedFile, whatTheProgramRemovesIsNotMissed)
{
    auto database = db::openDatabase(m_path, db::OpenMode::ReadWriteCreate);
    db::SiteStore sites(*database);
    ASSERT_TRUE(save(sites, Site{{}, {}, "Mielec", {}, {}, {}, {}, {}, {}}));
    const auto all = *sites.sites();
    const auto mielec = std::find_if(all.begin(), all.end(), [](const Site& one) { return one.name == "Mielec"; });
    ASSERT_NE(mielec, all.end());
    ASSERT_TRUE(sites.removeSite(mielec->record));
    EXPECT_THAT(db::verify(*database, {})->findings, testing::IsEmpty());
}

TEST_F(SignedFile, ofTheTailOnlyAHeadElsewhereTells)
{
    { // something without a signature, at the end
        auto database = db::openDatabase(m_path, db::OpenMode::ReadWriteCreate);
        ASSERT_TRUE(save(db::SiteStore(*database), Site{{}, {}, "Mielec", {}, {}, {}, {}, {}, {}}));
    }
    std::string head;
    {
        auto database = db::openDatabase(m_path, db::OpenMode::ReadOnly);
        head = db::SigningStore(*database).trailHead()->head;
        EXPECT_THAT(db::verify(*database, {}, {{head, {}}, {head.substr(0, 12), {}}, {m_head, {}}})->findings, testing::IsEmpty());
    }
    forge({"DELETE FROM site WHERE name = 'Mielec'", "DELETE FROM audit_entry WHERE id = (SELECT MAX(id) FROM audit_entry)",
        "UPDATE audit_head SET entries = entries - 1, head = (SELECT file_link FROM audit_entry ORDER BY id DESC LIMIT 1)"});
    EXPECT_THAT(found(), testing::IsEmpty()); // the file alone cannot tell: docs/threat-model.md
    EXPECT_THAT(found({{head, Message::verbatim(std::string("the report"))}}),
        Contains(AllOf(HasSubstr(head.substr(0, 12)), HasSubstr("the report"), HasSubstr("cut off"))));
}

TEST_F(SignedFile, aChangeThroughTheProgramIsToldAndTheSignatureStands)
{
    auto database = db::openDatabase(m_path, db::OpenMode::ReadWriteCreate);
    db::FleetStore fleet(*database);
    Aircraft renamed = *fleet.aircraft(AircraftId{1});
    renamed.registration = "3713A";
    ASSERT_TRUE(save(fleet, renamed));
    const auto states = *db::SigningStore(*database).states(m_swing);
    ASSERT_EQ(states.size(), 2u);
    EXPECT_TRUE(states[0].holds && states[1].holds);
    ASSERT_EQ(states[0].since.size(), 1u);
    EXPECT_EQ(states[0].since[0].what.english(), "registration of the aircraft");
    EXPECT_EQ(states[0].since[0].before.english(), "3713");
    EXPECT_THAT(db::verify(*database, {})->findings, testing::IsEmpty());
}

TEST_F(SignedFile, anImportThatDoesNotHoldIsRefusedOrMarked)
{
    auto here = db::openDatabase(m_path, db::OpenMode::ReadOnly);
    const Fleet fleet = *db::exportFleet(*here, {}, {});
    const std::string written = writeExchange(fleet);
    EXPECT_EQ(exchangeVersionOf(fleet), 5);
    const auto elsewhere = [&](auto change) {
        auto read = readExchange(written, "a.lubberline.json");
        EXPECT_TRUE(read) << describe(read.error());
        change(*read);
        auto there = inMemory();
        auto imported = db::importFleet(there, *read, {});
        std::vector<std::string> findings = imported ? inEnglish(db::verify(there, {})->findings) : std::vector<std::string>();
        if (imported && imported->warnings.empty()) {
            EXPECT_EQ(writeExchange(*db::exportFleet(there, {}, {})), written); // both sides keep the heads
            EXPECT_EQ(db::SwingStore(there).swing(imported->swingIds.front())->signatures, fleet.swings.front().signatures);
        }
        return std::pair(std::move(imported), findings);
    };
    const auto whole = elsewhere([](Fleet&) {});
    ASSERT_TRUE(whole.first) << describe(whole.first.error());
    EXPECT_THAT(whole.first->warnings, testing::IsEmpty());
    EXPECT_THAT(whole.second, testing::IsEmpty());

    const std::vector<std::function<void(Fleet&)>> refused = {
        [](Fleet& one) { one.swings[0].readings[0].compass = CompassHeading::fromDegrees(1); },
        [](Fleet& one) { one.swings[0].signatures[1].name = "Eve"; },
        [](Fleet& one) { one.swings[0].signatures[0].licence = "PL 99"; },
        [](Fleet& one) { one.swings[0].signatures.erase(one.swings[0].signatures.begin()); },
        [](Fleet& one) {
            one.swings[0].signatures[1].particulars.replace(one.swings[0].signatures[1].particulars.find("3713"), 4, "3714");
        },
    };
    for (const auto& change : refused) {
        const auto result = elsewhere(change);
        ASSERT_FALSE(result.first);
        EXPECT_EQ(result.first.error().code, ErrorCode::Corrupt);
        EXPECT_THAT(
            result.first.error().message.english(), AllOf(HasSubstr("3713"), HasSubstr("2026-11-20"), HasSubstr("is not what was signed")));
    }
    // The signatures are whole, but what stands beside them is another aircraft: told, marked, and found.
    const auto marked = elsewhere([](Fleet& one) { one.aircraft[0].registration = "3714"; });
    ASSERT_TRUE(marked.first);
    EXPECT_THAT(inEnglish(marked.first->warnings),
        Contains(AllOf(HasSubstr("signed as registration of the aircraft \"3713\""), HasSubstr("3714"))));
    EXPECT_THAT(marked.second, testing::IsEmpty()); // told, in the trail, and printed as "signed as"
    const auto unsignedOne = elsewhere([](Fleet& one) { one.swings[0].signatures.clear(); });
    ASSERT_TRUE(unsignedOne.first);
    EXPECT_THAT(inEnglish(unsignedOne.first->warnings),
        Contains(AllOf(HasSubstr("3713"), HasSubstr("2026-11-20"), HasSubstr("does not say by whom"), HasSubstr("printed as not signed"))));
    Fleet bare = fleet;
    bare.swings[0].signatures.clear();
    bare.swings[0].readings[0].compass = CompassHeading::fromDegrees(1);
    auto there = inMemory();
    const auto id = db::importFleet(there, bare, {})->swingIds.front();
    const Swing stored = *db::SwingStore(there).swing(id);
    EXPECT_EQ(stored.state, SwingState::Signed); // as it came, frozen
    EXPECT_FALSE(*db::SigningStore(there).stands(stored, {}));
    const auto late = db::SigningStore(there).sign(id, {SignatureRole::Performer, "Eve", "", "", ""});
    EXPECT_THAT(late.error().message.english(), HasSubstr("nobody's signature is there"));
    EXPECT_THAT(inEnglish(db::verify(there, {})->notes), Contains(HasSubstr("it is printed as not signed")));
    for (const auto& compass : *db::DueStore(there).compasses()) { // and it takes no compass off the list
        EXPECT_TRUE(compass.signedSwings.empty());
        for (const auto& finding : compass.findings)
            EXPECT_FALSE(finding.isSigned);
    }
    auto signedThere = inMemory();
    ASSERT_TRUE(db::importFleet(signedThere, fleet, {}));
    EXPECT_EQ(db::DueStore(signedThere).compasses()->at(0).signedSwings.size(), 1u);
}

TEST_F(SignedFile, aDemonstrationIsSignedInNames)
{
    auto here = db::openDatabase(m_path, db::OpenMode::ReadOnly);
    Fleet fleet = *db::exportFleet(*here, {}, {});
    fleet.swings[0].signatures.clear();
    fleet.swings[0].people.datumReader = "Ada";
    fleet.swings[0].people.inspector = "Ben";
    db::signInNames(fleet);
    auto there = inMemory();
    const auto imported = db::importFleet(there, fleet, {});
    ASSERT_TRUE(imported) << describe(imported.error());
    EXPECT_THAT(inEnglish(imported->warnings), testing::IsEmpty());
    const auto id = imported->swingIds.front();
    db::SigningStore signing(there);
    EXPECT_TRUE(*signing.stands(*db::SwingStore(there).swing(id), *signing.states(id)));
    EXPECT_THAT(db::verify(there, {})->findings, testing::IsEmpty());
}

TEST_F(SignedFile, aClockThatWasSetBackIsTold)
{
    using namespace std::chrono;
    auto database = db::openDatabase(m_path, db::OpenMode::ReadWriteCreate);
    database->setClock({[] { return Clock::Time(sys_days(2020y / January / 2)); }});
    db::SigningStore signing(*database);
    EXPECT_GT(signing.clockStandsBefore()->size(), 10u);
    ASSERT_TRUE(save(db::SiteStore(*database), Site{{}, {}, "Mielec", {}, {}, {}, {}, {}, {}}));
    const auto report = *db::verify(*database, {});
    EXPECT_THAT(report.findings, testing::IsEmpty());
    EXPECT_THAT(inEnglish(report.notes), Contains(AllOf(HasSubstr("2020-01-02"), HasSubstr("the clock had been set back"))));
    EXPECT_EQ(*signing.clockStandsBefore(), ""); // that entry is the last now
}

TEST_F(SignedFile, whatIsSignedWhileTheSwingChangesIsRefused)
{
    auto database = db::openDatabase(m_path, db::OpenMode::ReadWriteCreate);
    db::SigningStore signing(*database);
    const auto made = signing.amend(m_swing, "wrong site");
    ASSERT_TRUE(made && signing.complete(*made));
    const auto prepared = signing.prepare(*made, {SignatureRole::Performer, "Ada", "", "", ""});
    ASSERT_TRUE(prepared) << describe(prepared.error());
    EXPECT_EQ(db::sha256(*signing.contentOf(*made, *prepared)), prepared->hash);
    ASSERT_TRUE(save(db::SiteStore(*database), Site{{}, {}, "Mielec", {}, {}, {}, {}, {}, {}})); // something else may happen meanwhile
    auto changed = prepared.value();
    changed.name = "Eve";
    EXPECT_EQ(signing.add(*made, changed).error().code, ErrorCode::Conflict);
    ASSERT_TRUE(signing.reopen(*made, "misread") && signing.complete(*made));
    EXPECT_EQ(signing.add(*made, *prepared).error().code, ErrorCode::Conflict);
    const auto again = signing.prepare(*made, {SignatureRole::Performer, "Ada", "", "", ""});
    EXPECT_TRUE(signing.add(*made, *again));
    EXPECT_EQ(*signing.hold(*made), std::vector<bool>{true});
}

} // namespace lubberline::test
