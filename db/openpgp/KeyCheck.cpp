#include "db/openpgp/KeyCheck.h"

#include <QDateTime>

#include <algorithm>

namespace lubberline::db {

namespace {

std::string day(std::int64_t unix_s) { return QDateTime::fromSecsSinceEpoch(unix_s, Qt::UTC).toString("yyyy-MM-dd").toStdString(); }

/// The last sixteen digits, in fours, as people read them to each other.
std::string shortKey(const std::string& fingerprint)
{
    const std::string last = fingerprint.size() > 16 ? fingerprint.substr(fingerprint.size() - 16) : fingerprint;
    std::string text;
    for (std::size_t i = 0; i < last.size(); ++i)
        text += (i > 0 && i % 4 == 0 ? " " : "") + last.substr(i, 1);
    return text;
}

KeyVerdict whole(const OpenPgpCheck& check, const std::string& name, const std::vector<StationKey>& station)
{
    const std::string key = shortKey(check.fingerprint);
    const auto known
        = std::find_if(station.begin(), station.end(), [&](const StationKey& one) { return one.fingerprint == check.fingerprint; });
    if (check.revoked)
        return {KeyState::Revoked, {MARKED("db", "the key %1 was revoked"), key}};
    if (check.expires_s && check.made_s > *check.expires_s)
        return {KeyState::Expired,
            {MARKED("db", "the key %1 had expired on %2, before it signed on %3"), key, day(*check.expires_s), day(check.made_s)}};
    if (known == station.end())
        return {KeyState::NotKnown, {MARKED("db", "key not known: %1, which calls itself %2"), key, check.userId}};
    if (!name.empty() && !samePerson(name, known->holder))
        return {KeyState::OtherHolder, {MARKED("db", "the key %1 is %2's, and the name is %3"), key, known->holder, name}};
    return {KeyState::Good, {MARKED("db", "verified by the key %1 of %2"), key, known->holder}};
}

} // namespace

Result<Signature> signedBy(Signature prepared, const std::string& content, const Progress& progress, const GpgOptions& options)
{
    auto key = publicKeyOf(prepared.key, progress, options);
    if (!key)
        return key.error();
    auto made = signDetached(content, prepared.key, progress, options);
    if (!made)
        return made.error();
    prepared.publicKey = std::move(key.value());
    prepared.openPgp = std::move(made.value());
    return prepared;
}

KeyVerdict verdictOn(const Signature& signature, const std::string& content, const std::vector<StationKey>& station,
    const Progress& progress, const GpgOptions& options)
{
    if (!signature.hasKey())
        return {KeyState::NameOnly, MARKED("db", "name not verified")};
    if (signature.openPgp.empty())
        return {KeyState::Bad, {MARKED("db", "it names the key %1 and carries no signature by it"), shortKey(signature.key)}};
    std::string keys = signature.publicKey + "\n";
    for (const StationKey& one : station)
        if (one.fingerprint == signature.key)
            keys += one.publicKey + "\n";
    const auto check = verifyDetached(content, signature.openPgp, keys, progress, options);
    if (!check)
        return {KeyState::NotChecked, {MARKED("db", "the key was not checked: %1"), check.error().message}};
    if (check->state != OpenPgpCheck::State::Whole || check->fingerprint != signature.key)
        return {KeyState::Bad, {MARKED("db", "the signature by the key %1 is not over what stands here"), shortKey(signature.key)}};
    return whole(*check, signature.name, station);
}

} // namespace lubberline::db
