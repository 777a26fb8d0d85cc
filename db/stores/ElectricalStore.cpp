#include "db/stores/ElectricalStore.h"

#include "core/format/exchange/ElectricalJson.h"
#include "db/stores/Saving.h"

namespace lubberline::db {

namespace {

const Table& electricalTable()
{
    static const Table table{MARKED("db", "electrical swing"), "electrical_swing", {"compass_id", "date", "electrical_json"}};
    return table;
}

auto bindTo(CompassId compass)
{
    return
        [compass](Statement& statement, const ElectricalSwing& swing) { statement << compass << swing.date << writeElectricalJson(swing); };
}

} // namespace

Result<std::vector<ElectricalSwing>> ElectricalStore::of(CompassId compass)
{
    Statement statement(
        m_database, "SELECT record, electrical_json FROM electrical_swing WHERE compass_id = ? ORDER BY date DESC, id DESC");
    statement << compass;
    const std::string file = m_database.path().toStdString();
    return wholeRows(rowsOf<Result<ElectricalSwing>>(statement, [&](Statement& row) -> Result<ElectricalSwing> {
        auto swing = readElectricalJson(row.text(1), file);
        if (!swing)
            return Error{
                ErrorCode::Corrupt, {MARKED("db", "the electrical swing %1 does not read: %2"), row.text(0), swing.error().message}, file};
        swing->record = row.text(0);
        return swing;
    }));
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
