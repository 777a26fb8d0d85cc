#include "db/stores/Audit.h"

#include "db/engine/Statement.h"

namespace lubberline::db {

Result<void> audit(Database& database, const std::string& what, const std::string& record, const std::string& detail)
{
    Statement statement(database, "INSERT INTO audit_entry (time_utc, what, record, detail) VALUES (?, ?, ?, ?)");
    statement << database.clock().nowUtc_ms() << what << record << detail;
    return statement.run();
}

} // namespace lubberline::db
