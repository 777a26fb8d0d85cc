#include "db/stores/SwingMarks.h"

#include "db/engine/Statement.h"
#include "db/stores/Signatures.h"

namespace lubberline::db {

Result<SwingMarks> marksOf(Database& database, SwingId swing)
{
    Statement statement(database, "SELECT s.radio, " + somebodySigned() + " FROM swing s WHERE s.id = ?");
    statement << swing;
    return oneOf<SwingMarks>(statement, database, MARKED("db", "swing"), [](Statement& row) {
        return SwingMarks{row.as(0, RadioState::Off), row.flag(1)};
    });
}

} // namespace lubberline::db
