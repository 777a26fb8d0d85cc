// A value of any kind in any cell of a database, and what reads it.

#include "core/demo/DemoFleet.h"
#include "core/format/exchange/Exchange.h"
#include "db/engine/Statement.h"
#include "db/schema/Schema.h"
#include "db/stores/SigningStore.h"
#include "db/transfer/Maintenance.h"
#include "db/transfer/Transfer.h"
#include "tests/fuzz/Parsers.h"

namespace lubberline::test {

namespace {

struct Cell {
    QString table, column;
};

struct SmallDatabase {
    db::Database database;
    std::vector<Cell> cells;
};

SmallDatabase make()
{
    DemoOptions options;
    options.aircraftPerType = 1;
    options.swingsPerCompass = 1;
    options.populationAircraft = 0;
    auto database = db::openDatabase(":memory:", db::OpenMode::ReadWriteCreate);
    LUBBERLINE_EXPECT(database.ok() && db::importFleet(*database, demoFleet(options), {}).ok(), "a small fleet is stored");
    SmallDatabase small{std::move(database.value()), {}};
    db::SigningStore signing(small.database);
    for (const SwingId id : {SwingId{1}, SwingId{2}, SwingId{3}}) // those that are complete: signatures have cells, too
        for (const auto& [role, name] : {std::pair(SignatureRole::Performer, "Ada"), std::pair(SignatureRole::Inspector, "Ben")})
            static_cast<void>(signing.sign(id, {role, name, "PL 12", "", ""}).ok());
    const auto texts = [&](const QString& sql) {
        db::Statement statement(small.database, sql);
        return *db::rowsOf<std::string>(statement, [](db::Statement& row) { return row.anything(0); });
    };
    for (const char* sql : {"PRAGMA foreign_keys = OFF", "PRAGMA ignore_check_constraints = ON"})
        LUBBERLINE_EXPECT(db::execute(small.database, sql).ok(), "another program holds itself to nothing");
    for (const auto& trigger : texts("SELECT name FROM sqlite_master WHERE type = 'trigger'"))
        LUBBERLINE_EXPECT(db::execute(small.database, QString::fromStdString("DROP TRIGGER " + trigger)).ok(), "a trigger is dropped");
    for (const auto& table : texts("SELECT name FROM sqlite_master WHERE type = 'table' AND name NOT LIKE 'sqlite_%'"))
        for (const auto& column : texts(QString::fromStdString("SELECT name FROM pragma_table_info('" + table + "') WHERE name <> 'id'")))
            small.cells.push_back({QString::fromStdString(table), QString::fromStdString(column)});
    return small;
}

/// As SQL: a text, a block, a whole number, a figure or nothing.
QString literal(char kind, std::string_view bytes)
{
    const QByteArray raw(bytes.data(), static_cast<qsizetype>(bytes.size()));
    switch (static_cast<unsigned char>(kind) % 5) {
    case 0: return "CAST(x'" + QString::fromLatin1(raw.toHex()) + "' AS TEXT)";
    case 1: return "x'" + QString::fromLatin1(raw.toHex()) + "'";
    case 2: return "CAST(x'" + QString::fromLatin1(raw.toHex()) + "' AS INTEGER)";
    case 3: return "CAST(x'" + QString::fromLatin1(raw.toHex()) + "' AS REAL)";
    default: return "NULL";
    }
}

} // namespace

bool checkDatabaseRow(std::string_view bytes)
{
    static SmallDatabase small = make();
    if (bytes.size() < 3)
        return false;
    const Cell& cell = small.cells[static_cast<unsigned char>(bytes[0]) % small.cells.size()];
    const QString where = " WHERE rowid = (SELECT MIN(rowid) FROM " + cell.table + ")",
                  set = "UPDATE " + cell.table + " SET " + cell.column;
    const QString keep = "CREATE TEMP TABLE kept AS SELECT " + cell.column + " AS value FROM " + cell.table + where;
    LUBBERLINE_EXPECT(db::execute(small.database, keep).ok(), "the cell is kept");
    const bool changed = db::execute(small.database, set + " = " + literal(bytes[1], bytes.substr(2)) + where).ok();
    if (changed) {
        const auto report = db::verify(small.database, {});
        LUBBERLINE_EXPECT(report.ok(), "what is damaged is a finding");
        const auto fleet = db::exportFleet(small.database, {}, {});
        LUBBERLINE_EXPECT(fleet.ok() || !report->findings.empty(), "verify tells what an export does");
        LUBBERLINE_EXPECT(!fleet || readExchange(writeExchange(*fleet), "fuzz").ok(), "what is written can be read");
        LUBBERLINE_EXPECT(db::execute(small.database, set + " = (SELECT value FROM kept)" + where).ok(), "the cell is put back");
    }
    LUBBERLINE_EXPECT(db::execute(small.database, "DROP TABLE kept").ok(), "what was kept goes");
    return changed;
}

} // namespace lubberline::test

/// libFuzzer calls it first: the database is made outside of the time that one input may take.
extern "C" int LLVMFuzzerInitialize(int*, char***);
int LLVMFuzzerInitialize(int*, char***)
{
    lubberline::test::checkDatabaseRow({});
    return 0;
}
