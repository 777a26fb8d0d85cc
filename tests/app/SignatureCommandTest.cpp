// Signatures by OpenPGP keys through the command line: made, written as files that gpg itself accepts, and judged by the station's list.

#include <gmock/gmock.h>

#include "tests/app/Keys.h"
#include "tests/app/Program.h"
#include "tests/app/Published.h"

namespace lubberline::test {

namespace {

using testing::AllOf;
using testing::HasSubstr;

const std::string kStated
    = "# aircraft: SP-TST\n# type: PZL-130\n# compass: standby\n# site: Deblin\n# date: 2026-11-20\n# adjuster: Ada\n# inspector: Ben\n";

class SignatureCommands : public testing::Test {
protected:
    void SetUp() override
    {
        m_ada = m_ring.make("Ada <ada@station.example>");
        m_ben = m_ring.make("Ben <ben@station.example>");
        ASSERT_EQ(m_ada.size(), 40u) << "gpg makes no key: is it installed?";
        ASSERT_EQ(m_ben.size(), 40u);
        ASSERT_EQ(run({"import", m_sandbox.write("k.csv", kStated + kWorksheet[0].check)}).status, 0);
        m_record = run({"swings", "--json"}).json()["swings"][0]["record"];
        ASSERT_EQ(run({"complete", m_record}).status, 0);
    }
    Outcome run(std::vector<std::string> arguments) const
    {
        if (arguments.front() == "db")
            arguments.insert(arguments.begin() + 2, {"--db", "a.db"});
        else if (arguments.front() == "keys")
            arguments.insert(arguments.begin() + 2, {"--db", "a.db"});
        else
            arguments.insert(arguments.begin() + 1, {"--db", "a.db"});
        return m_sandbox.run(arguments, m_ring.environment());
    }
    Outcome sign(const char* role, const char* name, const std::string& key) const
    {
        return run({"sign", m_record, "--role", role, "--name", name, "--key", key});
    }
    Outcome signBoth() const
    {
        const auto first = sign("performer", "Ada", m_ada);
        return first.status == 0 ? sign("inspector", "Ben", m_ben) : first;
    }
    void know(const std::string& fingerprint, const std::string& holder) const
    {
        const auto added = run({"keys", "add", m_ring.publicKey(fingerprint), "--name", holder});
        ASSERT_EQ(added.status, 0) << added.err;
    }

    Sandbox m_sandbox;
    KeyRing m_ring;
    std::string m_ada, m_ben, m_record;
};

} // namespace

TEST_F(SignatureCommands, twoKeysSignAndWhatIsWrittenSatisfiesGpgAndUs)
{
    const auto done = signBoth();
    ASSERT_EQ(done.status, 0) << done.err;
    EXPECT_THAT(done.out, HasSubstr("signed"));
    const auto written = run({"export", "--signature", m_record, "-o", "s.txt"});
    ASSERT_EQ(written.status, 0) << written.err;
    for (const char* file :
        {"s-1-performer.txt", "s-1-performer.txt.asc", "s-1-performer.txt.key.asc", "s-2-inspector.txt", "s-2-inspector.txt.asc"})
        EXPECT_FALSE(m_sandbox.read(file).empty()) << file;
    EXPECT_THAT(m_sandbox.read("s-2-inspector.txt"),
        AllOf(HasSubstr("lubberline signed content 3\n"), HasSubstr("\"name\": \"Ben\""), HasSubstr("SP-TST"), HasSubstr("\"before\""),
            HasSubstr("\"name\": \"Ada\"")));
    const std::string text = m_sandbox.path("s-2-inspector.txt");
    EXPECT_EQ(m_ring.run("gpg --batch --verify '" + text + ".asc' '" + text + "'"), 0);
    // The station does not know the key yet.
    const auto unknown = run({"verify", "s-2-inspector.txt", "--json"});
    EXPECT_EQ(unknown.status, 1);
    EXPECT_EQ(unknown.json()["state"], "not_known");
    EXPECT_THAT(unknown.err, HasSubstr("key not known"));
    know(m_ben, "Ben");
    const auto known = run({"verify", "s-2-inspector.txt", "--json"});
    EXPECT_EQ(known.status, 0) << known.err;
    EXPECT_EQ(known.json()["state"], "good");
    EXPECT_EQ(known.json()["name"], "Ben");
    EXPECT_EQ(known.json()["key"], m_ben);
    // One letter of the text, and neither accepts it.
    std::string forged = m_sandbox.read("s-2-inspector.txt");
    forged.replace(forged.find("SP-TST"), 6, "SP-TSX");
    m_sandbox.write("s-2-inspector.txt", forged);
    EXPECT_NE(m_ring.run("gpg --batch --verify '" + text + ".asc' '" + text + "'"), 0);
    const auto bad = run({"verify", "s-2-inspector.txt", "--json"});
    EXPECT_EQ(bad.status, 1);
    EXPECT_EQ(bad.json()["state"], "bad");
}

TEST_F(SignatureCommands, whatTheStationKnowsDecides)
{
    ASSERT_EQ(signBoth().status, 0);
    const auto stranger = run({"db", "verify", "--json"});
    EXPECT_EQ(stranger.status, 0) << stranger.out;
    EXPECT_THAT(stranger.json()["notes"].dump(), HasSubstr("key not known"));
    know(m_ada, "Ada");
    know(m_ben, "Ben");
    const auto keys = run({"keys", "list", "--json"}).json()["keys"];
    ASSERT_EQ(keys.size(), 2u);
    EXPECT_EQ(keys[0]["holder"], "Ada");
    EXPECT_EQ(keys[0]["fingerprint"], m_ada);
    EXPECT_EQ(run({"db", "verify", "--json"}).json()["notes"].size(), 0u);
    ASSERT_EQ(run({"report", "--swing", m_record, "-o", "r.html"}).status, 0);
    EXPECT_THAT(m_sandbox.read("r.html"), AllOf(HasSubstr("verified by the key"), testing::Not(HasSubstr("name not verified"))));
    EXPECT_EQ(run({"keys", "remove", m_ben.substr(32)}).status, 0);
    EXPECT_EQ(run({"keys", "list", "--json"}).json()["keys"].size(), 1u);
    EXPECT_THAT(run({"db", "verify", "--json"}).json()["notes"].dump(), HasSubstr("key not known"));
    EXPECT_EQ(run({"keys", "remove", "0000"}).status, 1);
}

TEST_F(SignatureCommands, oneKeyIsOnePersonWhateverItsName)
{
    ASSERT_EQ(sign("performer", "Ada", m_ada).status, 0);
    const auto again = sign("inspector", "Somebody Else", m_ada);
    EXPECT_EQ(again.status, 1);
    EXPECT_THAT(again.err, HasSubstr("expected another person"));
    EXPECT_EQ(sign("inspector", "Ben", "no-such-key").status, 1);
    EXPECT_EQ(run({"audit", m_record, "--json"}).json()["entries"].back()["what"], "signed swing");
}

TEST_F(SignatureCommands, aKeyOfAnotherNameIsTold)
{
    ASSERT_EQ(sign("performer", "Eve", m_ada).status, 0);
    know(m_ada, "Ada");
    const auto verified = run({"db", "verify"});
    EXPECT_EQ(verified.status, 1);
    EXPECT_THAT(verified.out, AllOf(HasSubstr("Ada"), HasSubstr("Eve")));
}

TEST_F(SignatureCommands, aRevokedKeyIsTold)
{
    ASSERT_EQ(signBoth().status, 0);
    know(m_ada, "Ada");
    know(m_ben, "Ben");
    m_ring.revoke(m_ben);
    know(m_ben, "Ben"); // its newer copy
    EXPECT_THAT(run({"db", "verify", "--json"}).json()["notes"].dump(), HasSubstr("was revoked"));
    ASSERT_EQ(run({"export", "--signature", m_record, "--role", "inspector", "-o", "b.txt"}).status, 0);
    const auto verdict = run({"verify", "b.txt", "--json"});
    EXPECT_EQ(verdict.status, 1);
    EXPECT_EQ(verdict.json()["state"], "revoked");
}

TEST_F(SignatureCommands, expiryIsJudgedAtTheMomentOfSigning)
{
    // Made in 2020 for a year, and signed with then: the text is of today, its key was in force when it signed.
    const std::string old = m_ring.make("Olga <olga@station.example>", "--faked-system-time 20200101T000000", "1y");
    ASSERT_EQ(old.size(), 40u);
    ASSERT_EQ(sign("performer", "Ada", m_ada).status, 0);
    ASSERT_EQ(run({"export", "--signature", m_record, "-o", "t.txt"}).status, 0);
    std::string text = m_sandbox.read("t.txt");
    text.replace(text.find(m_ada), 40, old);
    text.replace(text.find("\"Ada\""), 5, "\"Olga\"");
    m_sandbox.write("t.txt", text);
    const auto signAt = [&](const char* time) {
        return m_ring.run("gpg --batch --yes --faked-system-time " + std::string(time) + " --local-user " + old + " --armor --output '"
            + m_sandbox.path("t.txt.asc") + "' --detach-sign '" + m_sandbox.path("t.txt") + "'");
    };
    std::filesystem::remove(m_sandbox.path("t.txt.key.asc"));
    know(old, "Olga");
    ASSERT_EQ(signAt("20200601T000000"), 0);
    EXPECT_EQ(run({"verify", "t.txt", "--json"}).json()["state"], "good");
    // gpg refuses to sign with an expired key: the clock says 2020, and the key is made shorter afterwards.
    ASSERT_EQ(m_ring.run("gpg --batch --faked-system-time 20200102T000000 --passphrase '' --quick-set-expire " + old + " 2020-03-01"), 0);
    know(old, "Olga");
    const auto late = run({"verify", "t.txt", "--json"});
    EXPECT_EQ(late.status, 1);
    EXPECT_EQ(late.json()["state"], "expired");
}

TEST_F(SignatureCommands, namesWithoutAKeyAreSaidNotToBeVerified)
{
    ASSERT_EQ(run({"sign", m_record, "--role", "performer", "--name", "Ada"}).status, 0);
    ASSERT_EQ(run({"sign", m_record, "--role", "inspector", "--name", "Ben"}).status, 0);
    ASSERT_EQ(run({"report", "--swing", m_record, "-o", "r.html"}).status, 0);
    EXPECT_THAT(m_sandbox.read("r.html"), HasSubstr("name not verified"));
    const auto report = run({"report", "--swing", m_record, "-o", "r.json"});
    ASSERT_EQ(report.status, 0);
    const auto head = run({"db", "status", "--json"}).json()["audit_head"].get<std::string>();
    EXPECT_EQ(nlohmann::json::parse(m_sandbox.read("r.json"))["audit"]["head"], head);
    EXPECT_EQ(run({"db", "verify", "--head", head}).status, 0);
    EXPECT_EQ(run({"db", "verify", "--head", std::string(64, 'a')}).status, 1);
    EXPECT_EQ(run({"db", "verify", "--head", "short"}).status, 1);
    ASSERT_EQ(run({"export", "--signature", m_record, "-o", "s.txt"}).status, 0);
    EXPECT_THAT(m_sandbox.files(), testing::Not(testing::Contains(HasSubstr(".asc"))));
    EXPECT_EQ(run({"verify", "s-1-performer.txt"}).status, 1);
    EXPECT_EQ(run({"export", "-o", "s.txt"}).status, 2);
}

TEST_F(SignatureCommands, withoutGpgItIsSaid)
{
    const auto without
        = m_sandbox.run({"sign", m_record, "--db", "a.db", "--role", "performer", "--name", "Ada", "--key", m_ada}, "PATH=/nowhere");
    EXPECT_EQ(without.status, 1);
    EXPECT_THAT(without.err, HasSubstr("the program gpg is not there"));
}

} // namespace lubberline::test
