#include "db/InstrumentRepository.h"

#include "db/Saving.h"

namespace lubberline::db {

namespace {

const Table& instrumentTable()
{
    static const Table table{"datum instrument", "datum_instrument",
        {"name", "kind", "maker", "serial_number", "calibration_due", "ahead", "gives_true", "zero_deg", "resolution_deg", "note"}};
    return table;
}

} // namespace

Result<std::vector<DatumInstrument>> InstrumentRepository::instruments()
{
    Statement statement(m_database, "SELECT record, " + instrumentTable().fields.join(", ") + " FROM datum_instrument ORDER BY name");
    return rowsOf<DatumInstrument>(statement, [](Statement& row) {
        return DatumInstrument{row.text(0), row.text(1), row.as<DatumKind>(2), row.text(3), row.text(4), row.text(5),
            row.as<SightingDirection>(6), row.integer(7) != 0, row.real(8), row.real(9), row.text(10)};
    });
}

Result<void> InstrumentRepository::save(const DatumInstrument& instrument)
{
    if (const auto named = requireName(instrument.name, "the name of the instrument"); !named)
        return named.error();
    const auto id = rowWith(m_database, instrumentTable(), instrument.record);
    if (!id)
        return id.error();
    const auto saved = saveRecord(m_database, instrumentTable(), *id, instrument.record, [&](Statement& statement) {
        statement << instrument.name << static_cast<int>(instrument.kind) << instrument.maker << instrument.serialNumber
                  << instrument.calibrationDue << static_cast<int>(instrument.ahead) << instrument.givesTrue << instrument.zero_deg
                  << instrument.resolution_deg << instrument.note;
    });
    return saved ? Result<void>() : saved.error();
}

Result<void> InstrumentRepository::remove(const RecordId& record) { return removeRecord(m_database, instrumentTable(), record); }

} // namespace lubberline::db
