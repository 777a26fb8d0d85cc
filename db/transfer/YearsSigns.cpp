#include "db/transfer/YearsSigns.h"

#include "core/base/Number.h"
#include "core/fleet/SwingCurve.h"
#include "db/engine/Statement.h"

namespace lubberline::db {

namespace {

constexpr std::size_t kPlaceOfD = 3;
constexpr std::size_t kMostSuspicions = 20;

std::int32_t placeIn(std::unordered_map<std::string, std::int32_t>& places, const std::string& a, const std::string& b)
{
    return places.try_emplace(a + '\x1f' + b, static_cast<std::int32_t>(places.size())).first->second;
}

} // namespace

std::int32_t YearsSigns::kindOf(const std::string& type, const std::string& compass)
{
    const auto place = placeIn(m_kindPlace, type, compass);
    if (static_cast<std::size_t>(place) == m_kinds.size())
        m_kinds.push_back({type, compass, 0, 0});
    return place;
}

std::int32_t YearsSigns::compassOf(const std::string& aircraft, const std::string& compass)
{
    const auto place = placeIn(m_compassPlace, aircraft, compass);
    if (static_cast<std::size_t>(place) == m_compasses.size())
        m_compasses.push_back({aircraft, compass});
    return place;
}

void YearsSigns::add(const YearsSwing& swing)
{
    std::vector<double> magnetic, compass;
    for (const auto& reading : swing.file.swing.readings)
        if (reading.used()) {
            magnetic.push_back(reading.magnetic->degrees());
            compass.push_back(reading.compass->degrees());
        }
    const SwingCurve curve = fitCurve(magnetic, compass);
    if (!curve.known(kPlaceOfD))
        return;
    const auto kind = kindOf(swing.file.type, swing.file.compass);
    m_kinds[static_cast<std::size_t>(kind)].squares_deg2 += curve.residualSquares_deg2;
    m_kinds[static_cast<std::size_t>(kind)].freedom += curve.degreesOfFreedom();
    m_swings.push_back(
        {compassOf(swing.file.aircraft, swing.file.compass), kind, curve.value_deg[kPlaceOfD], curve.inverse[kPlaceOfD][kPlaceOfD]});
    m_line.push_back(swing.line);
}

Result<void> YearsSigns::addStored(Database& database, std::int64_t before)
{
    Statement statement(database,
        "SELECT a.registration, s.d_deg, s.reading_count, s.id FROM swing s JOIN compass c ON c.id = s.compass_id JOIN aircraft a"
        " ON a.id = c.aircraft_id JOIN aircraft_type t ON t.id = a.type_id WHERE t.name = ? AND c.name = ? AND s.d_deg IS NOT NULL"
        " AND s.reading_count > 0 AND (? = 0 OR s.id < ?) ORDER BY s.id");
    for (std::size_t kind = 0; kind < m_kinds.size(); ++kind) {
        statement << m_kinds[kind].type << m_kinds[kind].compass << before << before;
        if (const auto done = statement.run(); !done)
            return done;
        while (statement.next()) // evenly spaced headings: the variance of D is 2/n
            m_swings.push_back({compassOf(statement.text(0), m_kinds[kind].compass), static_cast<std::int32_t>(kind),
                statement.real(1, {-1e9, 1e9}), 2.0 / static_cast<double>(statement.integer(2))});
        if (const auto whole = statement.finished(); !whole)
            return whole;
    }
    return {};
}

Result<std::vector<Message>> YearsSigns::suspicions(Database& database, std::int64_t before)
{
    if (const auto stored = addStored(database, before); !stored)
        return stored.error();
    constexpr double usual_deg2 = 0.25; // of a reading where no residuals tell: half a degree
    for (auto& swing : m_swings) {
        const auto& kind = m_kinds[static_cast<std::size_t>(swing.kind)];
        swing.variance_deg2 *= kind.freedom > 0 ? kind.squares_deg2 / static_cast<double>(kind.freedom) : usual_deg2;
    }
    std::vector<Message> told;
    std::size_t more = 0;
    for (const auto& suspect : suspectSigns(m_swings)) {
        if (suspect.swings.front() >= m_line.size())
            continue; // it was there before: the fleet report tells of it
        if (told.size() == kMostSuspicions) {
            ++more;
            continue;
        }
        const auto& compass = m_compasses[static_cast<std::size_t>(suspect.compass)];
        told.push_back(
            {MARKED("db",
                 "%1 \u00B7 %2: D is %3\u00B0 in %4 of %5 swings (the first in line %6) where its siblings have %7\u00B0: the sign of these records is suspect; nothing is turned"),
                compass.aircraft, compass.name, signedFigureText(suspect.D_deg, 1), suspect.swings.size(), suspect.all,
                m_line[suspect.swings.front()], signedFigureText(suspect.siblingsD_deg, 1)});
    }
    if (more > 0)
        told.push_back({MARKED_N("db", "suspect of the other sign as well: the records of %n more compass system(s)"), more});
    return told;
}

} // namespace lubberline::db
