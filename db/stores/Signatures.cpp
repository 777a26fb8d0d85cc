#include "db/stores/Signatures.h"

#include "db/engine/Statement.h"

namespace lubberline::db {

namespace {

Signature signatureFrom(const Statement& row)
{
    return {row.as<SignatureRole>(1), row.text(2), row.text(3), row.text(4), row.text(5), static_cast<int>(row.integer(6))};
}

const QString kSelectSignature = "SELECT swing_id, role, name, licence, time_utc, hash, contents FROM signature ";

} // namespace

Result<std::vector<Signature>> signaturesOf(Database& database, SwingId swing)
{
    Statement statement(database, kSelectSignature + "WHERE swing_id = ? ORDER BY id");
    statement << swing;
    return rowsOf<Signature>(statement, signatureFrom);
}

Result<std::map<SwingId, std::vector<Signature>>> allSignatures(Database& database)
{
    Statement statement(database, kSelectSignature + "ORDER BY id");
    auto rows = rowsOf<std::pair<SwingId, Signature>>(
        statement, [](Statement& row) { return std::pair(row.id<SwingId>(0), signatureFrom(row)); });
    if (!rows)
        return rows.error();
    std::map<SwingId, std::vector<Signature>> all;
    for (auto& [swing, signature] : *rows)
        all[swing].push_back(std::move(signature));
    return all;
}

Result<void> addSignature(Database& database, SwingId swing, const Signature& signature)
{
    Statement statement(
        database, "INSERT INTO signature (swing_id, role, name, licence, time_utc, hash, contents) VALUES (?, ?, ?, ?, ?, ?, ?)");
    statement << swing << static_cast<int>(signature.role) << signature.name << signature.licence << signature.timeUtc << signature.hash
              << signature.contents;
    return statement.run();
}

} // namespace lubberline::db
