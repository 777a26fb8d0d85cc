#include "db/stores/CoilStore.h"

#include "core/format/exchange/CoilJson.h"
#include "db/saving/Saving.h"
#include "db/stores/Tables.h"

namespace lubberline::db {

namespace {

CoilBench benchFrom(const Statement& row)
{
    (void)row.id<CompassId>(2);
    (void)row.day(3); // the document's, for sorting
    const std::size_t before = row.damages().size();
    auto bench = readCoilBenchJson(row.longText(4), {});
    if (!bench) {
        if (row.damages().size() == before)
            row.damages(4, bench.error());
        return {};
    }
    bench->record = row.record(1);
    return std::move(*bench);
}

bool sameSensor(const std::string& one, const std::string& other) { return one.empty() || other.empty() || one == other; }

} // namespace

const Table& coilTable()
{
    static const Table table{
        MARKED("db", "coil bench"), "coil_bench", {"compass_id", "date", "coil_json"}, [](const Statement& row) { (void)benchFrom(row); }};
    return table;
}

Result<std::vector<CoilBench>> CoilStore::of(CompassId compass)
{
    Statement statement(m_database, selectFrom(coilTable()) + "WHERE compass_id = ? ORDER BY date DESC, id DESC");
    statement << compass;
    return rowsOf<CoilBench>(statement, benchFrom);
}

Result<std::optional<CoilBench>> CoilStore::before(CompassId compass, Date day, const std::string& serialNumber)
{
    Statement statement(m_database, selectFrom(coilTable()) + "WHERE compass_id = ? AND date <= ? ORDER BY date DESC, id DESC");
    statement << compass << day;
    auto benches = rowsOf<CoilBench>(statement, benchFrom);
    if (!benches)
        return benches.error();
    for (auto& bench : *benches)
        if (sameSensor(bench.serialNumber, serialNumber))
            return std::optional(std::move(bench));
    return std::optional<CoilBench>();
}

Result<RecordId> CoilStore::add(CompassId compass, const CoilBench& bench)
{
    CoilBench whole = bench;
    if (whole.record.empty())
        whole.record = newRecordId();
    const auto store = [&]() -> Result<RecordId> {
        const auto added = addRecord<RowId>(m_database, coilTable(), whole,
            [compass](Statement& statement, const CoilBench& one) { statement << compass << one.date << writeCoilBenchJson(one); });
        return added ? Result<RecordId>(whole.record) : added.error();
    };
    return noting(m_database, store, [&](const RecordId&) { m_database.changes().note(change::Sensors{compass}); });
}

Result<void> CoilStore::remove(CompassId compass, const RecordId& record)
{
    return noting(
        m_database, [&] { return removeRecord(m_database, coilTable(), record); },
        [&] { m_database.changes().note(change::Sensors{compass}); });
}

} // namespace lubberline::db
