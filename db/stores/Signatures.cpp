#include "db/stores/Signatures.h"

#include "core/format/exchange/SignedContent.h"
#include "core/record/RecordWords.h"
#include "db/engine/Statement.h"
#include "db/saving/Audit.h"

namespace lubberline::db {

namespace {

std::string hashFrom(const Statement& row, int column)
{
    std::string hash = row.text(column);
    if (hash.size() != 64 || hash.find_first_not_of("0123456789abcdef") != std::string::npos)
        row.damages(column, MARKED("db", "64 hexadecimal digits (SHA-256)"));
    return hash;
}

Signature signatureFrom(const Statement& row)
{
    return {row.as(1, SignatureRole::Authority), row.name(2), row.text(3), row.momentStated(4), hashFrom(row, 5),
        row.integer(6, {1, kSignedContents}), row.text(7), row.text(8), row.text(9), row.longText(10), row.text(11), row.longText(12),
        row.longText(13)};
}

const QString kSignatureColumns
    = "swing_id, role, name, licence, time_utc, hash, contents, file, file_head, record_head, particulars, key, public_key, openpgp";
const QString kSelectSignature = "SELECT " + kSignatureColumns + ", id FROM signature ";

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

std::vector<Message> damagedSignatures(Database& database)
{
    Statement statement(database, kSelectSignature + "ORDER BY id");
    return damagesIn(statement, [](Statement& row) {
        (void)row.id<SwingId>(0);
        (void)signatureFrom(row);
    });
}

QString somebodySigned()
{
    return "(s.state = 2 AND (EXISTS (SELECT 1 FROM signature g WHERE g.swing_id = s.id)"
           " OR EXISTS (SELECT 1 FROM audit_entry a, audit_head h WHERE a.record = s.record AND a.id <= h.entries_before"
           " AND (a.what = 'froze swing' OR a.detail LIKE '%state: 1 -> 2%' OR (a.what = 'added swing' AND a.detail LIKE '%; state: 2;%')))))";
}

std::string auditText(const Signature& signature)
{
    return std::string(fileWord(signature.role)) + ": " + signature.name + " " + signature.licence + ", hash " + signature.hash;
}

Result<void> addSignature(Database& database, SwingId swing, const RecordId& record, const Signature& signature, const char* what)
{
    Statement statement(database, "INSERT INTO signature (" + kSignatureColumns + ") VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
    statement << swing << static_cast<int>(signature.role) << signature.name << signature.licence << signature.timeUtc << signature.hash
              << signature.contents << signature.file << signature.fileHead << signature.recordHead << signature.particulars
              << signature.key << signature.publicKey << signature.openPgp;
    if (const auto kept = statement.run(); !kept)
        return kept;
    return audit(database, what, record, auditText(signature));
}

} // namespace lubberline::db
