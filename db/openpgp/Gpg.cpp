#include "db/openpgp/Gpg.h"

#include <QElapsedTimer>
#include <QFile>
#include <QProcess>

#include <algorithm>
#include <map>

#include "db/engine/WorkFolder.h"

namespace lubberline::db {

namespace {

struct Ran {
    int status = 0;
    QByteArray output, words; ///< what it wrote, and what it said
};

const QStringList kAlways{"--batch", "--no-tty", "--display-charset", "utf-8"};

/// A key ring of nobody, gone with it: what is in it is what was put there.
class KeyRing {
public:
    [[nodiscard]] QStringList options() const { return {"--homedir", m_folder.path(), "--no-autostart", "--no-auto-check-trustdb"}; }
    [[nodiscard]] QString put(const QString& name, const std::string& text) const
    {
        QFile file(m_folder.filePath(name));
        const bool written = file.open(QIODevice::WriteOnly) && file.write(QByteArray::fromStdString(text)) == qint64(text.size());
        return written ? file.fileName() : QString();
    }

private:
    WorkFolder m_folder;
};

Error noGpg()
{
    return {ErrorCode::NotFound, MARKED("db", "the program gpg is not there; expected it to be installed (on Debian: apt install gpg)")};
}

/// The last of its words that is no status line.
Error failed(const Ran& ran)
{
    QString last;
    for (const QByteArray& line : ran.words.split('\n'))
        if (!line.isEmpty() && !line.startsWith("[GNUPG:]"))
            last = QString::fromUtf8(line);
    return {ErrorCode::Io, {MARKED("db", "gpg failed (%1)"), last.toStdString()}};
}

Result<Ran> run(const QStringList& arguments, const std::string& input, const Progress& progress, const GpgOptions& options)
{
    QProcess gpg;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("LC_ALL", "C");
    gpg.setProcessEnvironment(environment);
    gpg.start(options.program, kAlways + arguments);
    if (!gpg.waitForStarted())
        return noGpg();
    gpg.write(QByteArray::fromStdString(input));
    gpg.closeWriteChannel();
    QElapsedTimer time;
    time.start();
    constexpr int kLook_ms = 100;
    Ran ran;
    while (!gpg.waitForFinished(kLook_ms) && gpg.state() != QProcess::NotRunning) {
        const bool cancelled = progress && !progress(0.5);
        if (!cancelled && time.elapsed() < options.timeout_ms)
            continue;
        gpg.kill();
        gpg.waitForFinished();
        return cancelled ? Error{ErrorCode::Cancelled, MARKED("db", "cancelled: gpg had not answered yet")}
                         : Error{ErrorCode::Locked,
                             {MARKED("db", "gpg did not answer within %1 s; expected a pass phrase, or a card that is there"),
                                 options.timeout_ms / 1000}};
    }
    ran.output = gpg.readAllStandardOutput();
    ran.words = gpg.readAllStandardError();
    ran.status = gpg.exitStatus() == QProcess::NormalExit ? gpg.exitCode() : -1;
    return ran;
}

/// Records of `--with-colons` (doc/DETAILS of GnuPG): one a line.
std::vector<OpenPgpKey> keysFrom(const QByteArray& listing)
{
    std::vector<OpenPgpKey> keys;
    bool primary = false;
    for (const QByteArray& line : listing.split('\n')) {
        const auto fields = line.split(':');
        const QByteArray kind = fields.value(0);
        if (kind == "pub" || kind == "sec") {
            keys.push_back({});
            keys.back().revoked = fields.value(1) == "r";
            if (const auto expires = fields.value(6).toLongLong(); expires > 0)
                keys.back().expires_s = expires;
            primary = true;
        } else if (kind == "sub" || kind == "ssb") {
            primary = false;
        } else if (kind == "fpr" && primary && !keys.empty()) {
            keys.back().fingerprint = fields.value(9).toStdString();
            primary = false;
        } else if (kind == "uid" && !keys.empty() && keys.back().userId.empty()) {
            keys.back().userId = fields.value(9).toStdString();
        }
    }
    return keys;
}

/// When each key and subkey ends, by its fingerprint.
std::map<QByteArray, std::int64_t> endsFrom(const QByteArray& listing)
{
    std::map<QByteArray, std::int64_t> ends;
    std::int64_t expires = 0;
    for (const QByteArray& line : listing.split('\n')) {
        const auto fields = line.split(':');
        if (fields.value(0) == "pub" || fields.value(0) == "sub")
            expires = fields.value(6).toLongLong();
        else if (fields.value(0) == "fpr" && expires > 0)
            ends[fields.value(9)] = expires;
    }
    return ends;
}

/// What the status lines say (doc/DETAILS of GnuPG).
OpenPgpCheck checkFrom(const QByteArray& status, const std::map<QByteArray, std::int64_t>& ends)
{
    OpenPgpCheck check;
    bool valid = false, bad = false;
    for (const QByteArray& line : status.split('\n')) {
        const auto words = line.split(' ');
        const QByteArray what = words.value(1);
        if (words.value(0) != "[GNUPG:]")
            continue;
        if (what == "VALIDSIG") {
            valid = true;
            check.made_s = words.value(4).toLongLong();
            check.fingerprint = words.value(11).toStdString();
            for (const QByteArray& key : {words.value(2), words.value(11)})
                if (const auto end = ends.find(key); end != ends.end())
                    check.expires_s = std::min(check.expires_s.value_or(end->second), end->second);
        } else if (what == "BADSIG" || what == "ERRSIG" || what == "EXPSIG") {
            bad = true;
        } else if (what == "NO_PUBKEY") {
            check.state = OpenPgpCheck::State::NoKey;
            check.fingerprint = words.value(2).toStdString();
        } else if (what == "REVKEYSIG" || what == "KEYREVOKED") {
            check.revoked = true;
        }
        if (what == "GOODSIG" || what == "EXPKEYSIG" || what == "REVKEYSIG")
            check.userId = words.mid(3).join(' ').toStdString();
    }
    if (valid && !bad)
        check.state = OpenPgpCheck::State::Whole;
    return check;
}

} // namespace

Result<std::vector<OpenPgpKey>> secretKeys(const Progress& progress, const GpgOptions& options)
{
    const auto ran = run({"--with-colons", "--list-secret-keys"}, {}, progress, options);
    if (!ran)
        return ran.error();
    if (ran->status != 0)
        return failed(*ran);
    auto keys = keysFrom(ran->output);
    std::erase_if(keys, [](const OpenPgpKey& one) { return one.revoked; });
    return keys;
}

Result<std::string> publicKeyOf(const std::string& fingerprint, const Progress& progress, const GpgOptions& options)
{
    const auto ran
        = run({"--armor", "--export-options", "export-minimal", "--export", QString::fromStdString(fingerprint)}, {}, progress, options);
    if (!ran)
        return ran.error();
    if (ran->output.isEmpty())
        return Error{ErrorCode::NotFound, {MARKED("db", "the key ring has no key %1; expected one of `gpg --list-keys`"), fingerprint}};
    return ran->output.toStdString();
}

Result<std::string> signDetached(
    const std::string& text, const std::string& fingerprint, const Progress& progress, const GpgOptions& options)
{
    const auto ran
        = run({"--status-fd", "2", "--armor", "--local-user", QString::fromStdString(fingerprint), "--detach-sign", "--output", "-"}, text,
            progress, options);
    if (!ran && ran.error().code == ErrorCode::Cancelled)
        return Error{ErrorCode::Cancelled, MARKED("db", "cancelled; nothing was signed")};
    if (!ran)
        return ran.error();
    if (ran->status != 0 || ran->output.isEmpty())
        return failed(*ran);
    return ran->output.toStdString();
}

Result<std::vector<OpenPgpKey>> keysIn(const std::string& publicKeys, const Progress& progress, const GpgOptions& options)
{
    const KeyRing ring;
    const auto imported = run(ring.options() + QStringList{"--import"}, publicKeys, progress, options);
    if (!imported)
        return imported.error();
    const auto listed = run(ring.options() + QStringList{"--with-colons", "--list-keys"}, {}, progress, options);
    if (!listed)
        return listed.error();
    auto keys = keysFrom(listed->output);
    if (keys.empty())
        return Error{ErrorCode::Format, MARKED("db", "there is no OpenPGP public key in it; expected what `gpg --armor --export` writes")};
    return keys;
}

Result<OpenPgpCheck> verifyDetached(const std::string& text, const std::string& signature, const std::string& publicKeys,
    const Progress& progress, const GpgOptions& options)
{
    const KeyRing ring;
    const QString signedText = ring.put("content.txt", text), detached = ring.put("content.txt.asc", signature);
    if (signedText.isEmpty() || detached.isEmpty())
        return Error{ErrorCode::Io, MARKED("db", "no folder for a while could be made; expected room on the drive for temporary files")};
    const auto imported = run(ring.options() + QStringList{"--import"}, publicKeys, progress, options);
    if (!imported)
        return imported.error();
    const auto listed
        = run(ring.options() + QStringList{"--with-colons", "--with-subkey-fingerprint", "--list-keys"}, {}, progress, options);
    if (!listed)
        return listed.error();
    const auto verified = run(ring.options() + QStringList{"--status-fd", "1", "--verify", detached, signedText}, {}, progress, options);
    if (!verified)
        return verified.error();
    return checkFrom(verified->output, endsFrom(listed->output));
}

} // namespace lubberline::db
