// Forgeries that need more than one signed swing: what is whole in itself is put where it does not belong.

#include "core/format/exchange/Exchange.h"
#include "db/stores/KeyStore.h"
#include "tests/db/SignedFile.h"

namespace lubberline::test {

namespace {

using testing::Contains;
using testing::HasSubstr;

void signBy(db::SigningStore signing, SwingId swing, const char* performer, const char* inspector)
{
    ASSERT_TRUE(signing.complete(swing));
    ASSERT_TRUE(signing.sign(swing, {SignatureRole::Performer, performer, "PL 12", "", ""}));
    ASSERT_TRUE(signing.sign(swing, {SignatureRole::Inspector, inspector, "PL 7", "", ""}));
}

/// Besides the swing of SignedFile (row 1): a later one on another compass of the aircraft (row 2), and a signed revision of the first
/// (row 3) with another first reading; the station knows a key.
class SeveralSigned : public SignedFile {
protected:
    void SetUp() override
    {
        SignedFile::SetUp();
        auto database = db::openDatabase(m_path, db::OpenMode::ReadWriteCreate);
        db::FleetStore fleet(*database);
        CompassSystem second = *fleet.compass(CompassId{1});
        second.id = {};
        second.record.clear();
        second.name = "No. 2";
        second.serialNumber = "SN 2";
        db::SwingStore swings(*database);
        Stored place;
        place.compass = *save(fleet, second);
        place.site = swings.swing(m_swing)->site;
        const auto other = save(swings, swingOf(place, "2026-11-22"));
        ASSERT_TRUE(other);
        ASSERT_EQ(other->value, 2);
        db::SigningStore signing(*database);
        signBy(signing, *other, "Cleo", "Dan");
        const auto revised = signing.amend(m_swing, "misread");
        ASSERT_TRUE(revised);
        ASSERT_EQ(revised->value, 3);
        const Reading first = swings.swing(*revised)->readings.front();
        Reading read = first;
        read.compass = CompassHeading::fromDegrees(314);
        ASSERT_TRUE(swings.changeReading(*revised, first, read));
        signBy(signing, *revised, "Ada", "Ben");
        ASSERT_TRUE(db::KeyStore(*database).put({std::string(40, 'A'), "Ada", "a public key", ""}));
        ASSERT_THAT(inEnglish(db::verify(*database, {})->findings), testing::IsEmpty());
    }
};

struct Misplaced {
    const char* name;
    QStringList statements;
    std::vector<const char*> words; ///< each in a finding
};

void PrintTo(const Misplaced& forgery, std::ostream* out) { *out << forgery.name; }

class MisplacedRecords : public SeveralSigned, public testing::WithParamInterface<Misplaced> {};

const Misplaced kMisplaced[] = {
    {"signaturesOfTwoSwingsChangePlaces", {"UPDATE signature SET swing_id = 3 - swing_id WHERE swing_id IN (1, 2)"},
        {"Cleo (performer) on the swing of 2026-11-20", "Ada (performer) on the swing of 2026-11-22"}},
    {"oneSignatureOfEachChangesPlaces", {"UPDATE signature SET swing_id = 3 - swing_id WHERE swing_id IN (1, 2) AND role = 1"},
        {"Dan (inspector) on the swing of 2026-11-20", "Ben (inspector) on the swing of 2026-11-22"}},
    {"aSignatureMovesToTheSwingOfAnotherCompass", {"UPDATE signature SET swing_id = 2 WHERE swing_id = 1"},
        {"Ada (performer) on the swing of 2026-11-22"}},
    {"aSignedSwingMovesToAnotherCompass", {"UPDATE swing SET compass_id = 2 WHERE id = 1"},
        {"name of the compass was \"standby compass\" when it was signed and is \"No. 2\""}},
    {"signedSwingsChangeCompasses", {"UPDATE swing SET compass_id = 3 - compass_id WHERE id IN (1, 2)"},
        {"name of the compass was \"standby compass\"", "name of the compass was \"No. 2\""}},
    {"compassesChangeNames",
        {"UPDATE compass SET name = 'x' WHERE id = 1", "UPDATE compass SET name = 'standby compass' WHERE id = 2",
            "UPDATE compass SET name = 'No. 2' WHERE id = 1"},
        {"name of the compass was \"standby compass\"", "name of the compass was \"No. 2\""}},
    {"readingsOfTwoSwingsChangePlaces", {"UPDATE reading SET swing_id = 4 - swing_id WHERE swing_id IN (1, 3)"},
        {"Ada (performer) on the swing of 2026-11-20"}},
    {"theOlderRevisionIsReplayedUnderTheNewer",
        {"DELETE FROM reading WHERE swing_id = 3", "UPDATE reading SET swing_id = 3 WHERE swing_id = 1",
            "DELETE FROM signature WHERE swing_id = 3", "UPDATE signature SET swing_id = 3 WHERE swing_id = 1"},
        {"on the swing of 2026-11-20", "was taken out or changed"}},
    {"theNewerRevisionIsTakenOutSoThatTheOlderStands",
        {"DELETE FROM reading WHERE swing_id = 3", "DELETE FROM signature WHERE swing_id = 3", "DELETE FROM swing WHERE id = 3"},
        {"of which the audit trail says last \"froze swing\""}},
    {"theNewerRevisionSupersedesNothing", {"UPDATE swing SET supersedes = '' WHERE id = 3"},
        {"Ada (performer) on the swing of 2026-11-20"}},
    {"theOlderCallsItselfTheNewer",
        {"UPDATE swing SET supersedes = '' WHERE id = 3", "UPDATE swing SET revision = 3 - revision + 1 WHERE id IN (1, 3)"},
        {"Ada (performer) on the swing of 2026-11-20"}},
    {"recordsChangeIdentities",
        {"UPDATE swing SET record = 'x' || record WHERE id IN (1, 2)",
            "UPDATE swing SET record = (SELECT substr(record, 2) FROM swing o WHERE o.id = 3 - swing.id) WHERE id = 1",
            "UPDATE swing SET record = (SELECT record FROM audit_entry a WHERE a.what = 'froze swing' AND a.record <> (SELECT record FROM swing"
            " WHERE id = 1) ORDER BY a.id LIMIT 1) WHERE id = 2"},
        {"Ada (performer) on the swing of 2026-11-20", "Cleo (performer) on the swing of 2026-11-22"}},
    {"theStationsKeyIsGivenToAnother", {"UPDATE signing_key SET holder = 'Eve'"},
        {"the key AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA of Eve is not what the audit trail says"}},
    {"theStationsKeyIsReplaced", {"UPDATE signing_key SET fingerprint = '" + QString(40, 'B') + "'"},
        {"the key BBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBB of Ada is not what the audit trail says",
            "the key AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA (holder: Ada) is not there"}},
    {"theStationsKeyIsTakenOut", {"DELETE FROM signing_key"}, {"the audit trail does not say that it was removed"}},
    {"theEndOfTheTrailIsCut", {"DELETE FROM audit_entry WHERE id > (SELECT MAX(id) FROM audit_entry) - 4"}, {"are missing"}},
};

} // namespace

TEST_P(MisplacedRecords, areNamed)
{
    forge(GetParam().statements);
    const auto findings = found();
    for (const char* words : GetParam().words)
        EXPECT_THAT(findings, Contains(HasSubstr(words)));
}

INSTANTIATE_TEST_SUITE_P(
    Each, MisplacedRecords, testing::ValuesIn(kMisplaced), [](const auto& test) { return std::string(test.param.name); });

TEST_F(SeveralSigned, aStoredPublicKeyIsNotWhatSignaturesAreJudgedBy)
{
    forge({"UPDATE signing_key SET public_key = 'another'"});
    EXPECT_THAT(found(), testing::IsEmpty()); // docs/threat-model.md: a signature names its fingerprint
}

TEST_F(SeveralSigned, ofTwoDatabasesThatAreMergedEachKeepsItsSignatures)
{
    auto here = db::openDatabase(m_path, db::OpenMode::ReadWriteCreate);
    const Fleet all = *db::exportFleet(*here, {}, {});
    auto there = inMemory();
    const Stored own = store(there); // another base with the same names: types, aircraft and compasses are known by them
    const SwingId swing = *save(db::SwingStore(there), swingOf(own));
    signBy(db::SigningStore(there), swing, "Eve", "Finn");
    const auto imported = db::importFleet(there, all, {});
    ASSERT_TRUE(imported) << describe(imported.error());
    EXPECT_THAT(inEnglish(db::verify(there, {})->findings), testing::IsEmpty());
    const auto back = db::importFleet(*here, *db::exportFleet(there, {}, {}), {});
    ASSERT_TRUE(back) << describe(back.error());
    EXPECT_EQ(back->alreadyThere, 3);
    EXPECT_THAT(inEnglish(db::verify(*here, {})->findings), testing::IsEmpty());
    EXPECT_EQ(db::FleetStore(*here).totals()->swings, 4);
}

TEST_F(SeveralSigned, signaturesThatChangedPlacesAreNotImported)
{
    auto here = db::openDatabase(m_path, db::OpenMode::ReadOnly);
    Fleet forged = *db::exportFleet(*here, {}, {});
    ASSERT_EQ(forged.swings.size(), 3u);
    std::swap(forged.swings[0].signatures, forged.swings[1].signatures);
    auto there = inMemory();
    const auto refused = db::importFleet(there, forged, {});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::Corrupt);
    EXPECT_THAT(refused.error().message.english(), HasSubstr("is not what was signed"));
    EXPECT_EQ(db::FleetStore(there).totals()->swings, 0);
}

} // namespace lubberline::test
