#pragma once
/// Private to the import of years: D of each swing that comes in, held against its type's.

#include <string>
#include <unordered_map>
#include <vector>

#include "core/fleet/SignCheck.h"
#include "core/format/csv/YearsCsv.h"
#include "db/engine/Database.h"

namespace lubberline::db {

class YearsSigns {
public:
    void add(const YearsSwing& swing);
    /// With the swings of the same types that were there before. @param before the first swing that this import made; 0: none.
    Result<std::vector<Message>> suspicions(Database& database, std::int64_t before);

private:
    struct Kind {
        std::string type, compass;
        double squares_deg2 = 0; ///< of residuals
        std::int64_t freedom = 0;
    };
    struct Compass {
        std::string aircraft, name;
    };
    std::int32_t kindOf(const std::string& type, const std::string& compass);
    std::int32_t compassOf(const std::string& aircraft, const std::string& compass);
    Result<void> addStored(Database& database, std::int64_t before);

    std::vector<Kind> m_kinds;
    std::vector<Compass> m_compasses;
    std::unordered_map<std::string, std::int32_t> m_kindPlace, m_compassPlace;
    std::vector<DOfSwing> m_swings;   ///< variances for unit variance of a reading
    std::vector<std::int64_t> m_line; ///< of the swings of the table, which come first
};

} // namespace lubberline::db
