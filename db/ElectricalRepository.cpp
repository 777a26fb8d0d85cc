#include "db/ElectricalRepository.h"

#include "core/format/exchange/ElectricalJson.h"
#include "db/Saving.h"

namespace lubberline::db {

namespace {

const Table& electricalTable()
{
    static const Table table{"electrical swing", "electrical_swing", {"compass_id", "date", "electrical_json"}};
    return table;
}

} // namespace

Result<std::vector<ElectricalSwing>> ElectricalRepository::of(CompassId compass)
{
    Statement statement(
        m_database, "SELECT record, electrical_json FROM electrical_swing WHERE compass_id = ? ORDER BY date DESC, id DESC");
    statement << compass;
    const std::string file = m_database.path().toStdString();
    return wholeRows(rowsOf<Result<ElectricalSwing>>(statement, [&](Statement& row) -> Result<ElectricalSwing> {
        auto swing = readElectricalJson(row.text(1), file);
        if (!swing)
            return Error{ErrorCode::Corrupt, "the electrical swing " + row.text(0) + " does not read: " + swing.error().message, file};
        swing->record = row.text(0);
        return swing;
    }));
}

Result<void> ElectricalRepository::save(CompassId compass, const ElectricalSwing& swing)
{
    const auto id = rowWith(m_database, electricalTable(), swing.record);
    if (!id)
        return id.error();
    const auto saved = saveRecord(m_database, electricalTable(), *id, swing.record,
        [&](Statement& statement) { statement << compass << swing.date << writeElectricalJson(swing); });
    return saved ? Result<void>() : saved.error();
}

} // namespace lubberline::db
