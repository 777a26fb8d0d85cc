#include "db/stores/ElectricalStore.h"

#include "core/format/exchange/ElectricalJson.h"
#include "db/saving/Saving.h"
#include "db/stores/Tables.h"

namespace lubberline::db {

namespace {

ElectricalSwing electricalFrom(const Statement& row)
{
    (void)row.id<CompassId>(2);
    (void)row.day(3); // the document's, for sorting
    const std::size_t before = row.damages().size();
    auto swing = readElectricalJson(row.longText(4), {});
    if (!swing) {
        if (row.damages().size() == before)
            row.damages(4, swing.error());
        return {};
    }
    swing->record = row.record(1);
    return std::move(*swing);
}

auto bindTo(CompassId compass)
{
    return
        [compass](Statement& statement, const ElectricalSwing& swing) { statement << compass << swing.date << writeElectricalJson(swing); };
}

} // namespace

const Table& electricalTable()
{
    static const Table table{MARKED("db", "electrical swing"), "electrical_swing", {"compass_id", "date", "electrical_json"},
        [](const Statement& row) { (void)electricalFrom(row); }};
    return table;
}

Result<std::vector<ElectricalSwing>> ElectricalStore::of(CompassId compass)
{
    Statement statement(m_database, selectFrom(electricalTable()) + "WHERE compass_id = ? ORDER BY date DESC, id DESC");
    statement << compass;
    return rowsOf<ElectricalSwing>(statement, electricalFrom);
}

Result<RecordId> ElectricalStore::add(CompassId compass, const ElectricalSwing& swing)
{
    ElectricalSwing whole = swing;
    if (whole.record.empty())
        whole.record = newRecordId();
    const auto store = [&]() -> Result<RecordId> {
        const auto added = addRecord<RowId>(m_database, electricalTable(), whole, bindTo(compass));
        return added ? Result<RecordId>(whole.record) : added.error();
    };
    return noting(m_database, store, [&](const RecordId&) { m_database.changes().note(change::Electrical{compass}); });
}

Result<void> ElectricalStore::change(CompassId compass, const ElectricalSwing& known, const ElectricalSwing& swing)
{
    const auto id = rowWith(m_database, electricalTable(), known.record);
    if (!id)
        return id.error();
    return noting(
        m_database, [&] { return changeRecord(m_database, electricalTable(), *id, known, swing, bindTo(compass)); },
        [&] { m_database.changes().note(change::Electrical{compass}); });
}

Result<void> ElectricalStore::remove(CompassId compass, const RecordId& record)
{
    return noting(
        m_database, [&] { return removeRecord(m_database, electricalTable(), record); },
        [&] { m_database.changes().note(change::Electrical{compass}); });
}

} // namespace lubberline::db
