#include "core/calibration/SensorLog.h"

#include "core/base/FileText.h"

namespace lubberline {

namespace {

constexpr std::array<double, 5> kNanotesla{1.0, 1e3, 1e2, 1e5, 1.0};
constexpr std::array<std::string_view, 5> kUnitNames{"nT", "uT", "mG", "G", "counts"};

void keep(std::vector<double>& values, const std::vector<std::size_t>& rows)
{
    if (values.empty())
        return;
    std::vector<double> kept;
    kept.reserve(rows.size());
    for (const std::size_t row : rows)
        kept.push_back(values[row]);
    values = std::move(kept);
}

} // namespace

double nanoteslaPer(FieldUnit unit) { return kNanotesla[static_cast<std::size_t>(unit)]; }
std::string_view nameOf(FieldUnit unit) { return kUnitNames[static_cast<std::size_t>(unit)]; }

const std::vector<double>* columnOf(const SensorLog& log, std::string_view name)
{
    for (const auto& column : log.others)
        if (inSmallLetters(column.name) == inSmallLetters(name))
            return &column.values;
    return nullptr;
}

SensorLog partOf(const SensorLog& log, double from, double to)
{
    std::vector<std::size_t> rows;
    for (std::size_t row = 0; row < log.size(); ++row) {
        const double where = log.time_s.empty() ? static_cast<double>(row) : log.time_s[row];
        if (where >= from && where <= to)
            rows.push_back(row);
    }
    SensorLog part = log;
    keep(part.time_s, rows);
    for (auto& axis : part.field)
        keep(axis, rows);
    keep(part.heading_deg, rows);
    keep(part.pitch_deg, rows);
    keep(part.roll_deg, rows);
    for (auto* columns : {&part.currents, &part.others})
        for (auto& column : *columns)
            keep(column.values, rows);
    part.counts.rows = static_cast<std::int64_t>(rows.size());
    return part;
}

} // namespace lubberline
