// gpg as it may be: it hangs, it is cancelled, nobody answers for the pass phrase, it says nothing that anybody understands.

#include <gmock/gmock.h>

#include <QElapsedTimer>
#include <QFile>
#include <QTemporaryDir>

#include "db/openpgp/KeyCheck.h"

namespace lubberline::test {

namespace {

using testing::HasSubstr;

class FakeGpg : public testing::Test {
protected:
    /// @param script what the program of that name does
    db::GpgOptions says(const QByteArray& script)
    {
        QFile file(m_folder.filePath(QStringLiteral("gpg")));
        EXPECT_TRUE(file.open(QIODevice::WriteOnly) && file.write("#!/bin/sh\n" + script + "\n") > 0);
        file.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
        return {file.fileName(), 300};
    }
    /// Signed by a key, as it is stored.
    static Signature byKey()
    {
        Signature one;
        one.name = "Ada";
        one.key = std::string(40, 'A');
        one.publicKey = "a key";
        one.openPgp = "a signature";
        return one;
    }

    QTemporaryDir m_folder;
    Progress m_never = [](double) { return false; };
};

} // namespace

TEST_F(FakeGpg, thatHangsIsGivenUpInTime)
{
    const auto hangs = says("exec sleep 60");
    QElapsedTimer time;
    time.start();
    const auto keys = db::secretKeys({}, hangs);
    ASSERT_FALSE(keys);
    EXPECT_EQ(keys.error().code, ErrorCode::Locked);
    EXPECT_THAT(keys.error().message.english(), HasSubstr("did not answer"));
    const auto made = db::signDetached("text", "AAAA", {}, hangs);
    ASSERT_FALSE(made);
    EXPECT_EQ(made.error().code, ErrorCode::Locked);
    const auto verdict = db::verdictOn(byKey(), "text", {}, {}, hangs);
    EXPECT_EQ(verdict.state, KeyState::NotChecked);
    EXPECT_THAT(verdict.words.english(), HasSubstr("did not answer"));
    EXPECT_LT(time.elapsed(), 30'000); // not the minute that it would have slept
}

TEST_F(FakeGpg, thatIsCancelledSaysWhatWasNotDone)
{
    const auto hangs = says("exec sleep 60");
    const auto made = db::signDetached("text", "AAAA", m_never, hangs);
    ASSERT_FALSE(made);
    EXPECT_EQ(made.error().code, ErrorCode::Cancelled);
    EXPECT_EQ(made.error().message.english(), "cancelled; nothing was signed");
    const auto checked = db::verifyDetached("text", "signature", "key", m_never, hangs);
    ASSERT_FALSE(checked);
    EXPECT_EQ(checked.error().code, ErrorCode::Cancelled);
    EXPECT_THAT(checked.error().message.english(), testing::Not(HasSubstr("signed")));
}

TEST_F(FakeGpg, withoutAnybodyToAskForThePassPhraseSaysWhy)
{
    const auto made = db::signDetached(
        "text", "AAAA", {}, says("echo '[GNUPG:] FAILURE sign 67108949' >&2; echo 'gpg: signing failed: No pinentry' >&2; exit 2"));
    ASSERT_FALSE(made);
    EXPECT_EQ(made.error().code, ErrorCode::Io);
    EXPECT_THAT(made.error().message.english(), HasSubstr("signing failed: No pinentry"));
}

TEST_F(FakeGpg, thatIsKilledOrSaysNothingIsNoSignature)
{
    for (const char* script : {"kill -9 $$", "exit 0", "cat > /dev/null; echo '[GNUPG:] GOODSIG'; printf '\\377\\000\\n'"}) {
        const auto options = says(script);
        const auto checked = db::verifyDetached("text", "signature", "key", {}, options);
        EXPECT_FALSE(checked && checked->state == db::OpenPgpCheck::State::Whole) << script;
        const auto verdict = db::verdictOn(byKey(), "text", {}, {}, options);
        EXPECT_FALSE(isVerified(verdict)) << script;
    }
    EXPECT_FALSE(db::signDetached("text", "AAAA", {}, says("exit 0"))); // empty
}

TEST_F(FakeGpg, thatIsNotThereIsSaid)
{
    const auto keys = db::secretKeys({}, {m_folder.filePath("nowhere"), 300});
    ASSERT_FALSE(keys);
    EXPECT_EQ(keys.error().code, ErrorCode::NotFound);
}

} // namespace lubberline::test
