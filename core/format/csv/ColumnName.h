#pragma once
/// Names of columns as people's spreadsheets write them.

#include <string>
#include <string_view>

namespace lubberline::csv {

/// The name by which a column is known: in small letters, spaces and hyphens as underscores, a unit in brackets at its end as our own
/// suffix: "Compass heading [°]" is compass_heading_deg, "Ground speed (m/s)" ground_speed_m_s, "Deviation (°E)" deviation_deg, which is
/// east positive. A unit that is not ours stays as it is written ("Deviation (°W)" is deviation_°w), so that nothing else is taken for it.
[[nodiscard]] std::string columnKey(std::string_view cell);

} // namespace lubberline::csv
