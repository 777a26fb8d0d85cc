#include "core/format/csv/StrayCsv.h"

#include <array>
#include <cmath>

#include "core/base/FileText.h"
#include "core/base/WholeFile.h"
#include "core/format/csv/FigureCsv.h"

namespace lubberline {

namespace {

constexpr std::array<std::string_view, 6> kStrayColumns{"x_m", "y_m", "z_m", "bx_nt", "by_nt", "bz_nt"};

} // namespace

Result<std::vector<StrayReading>> readStrayCsv(std::istream& input, const std::string& name)
{
    const Progress none;
    FigureCsv csv(input, name, MARKED("core", "places and fields: x_m, y_m, z_m, bx_nT, by_nT, bz_nT, a reading a row"), none);
    if (const auto header = csv.readHeader(kStrayColumns); !header)
        return header.error();
    std::array<std::size_t, 6> places{};
    for (std::size_t i = 0; i < places.size(); ++i) {
        const auto place = csv.column(kStrayColumns[i]);
        if (!place)
            return csv.here(
                {MARKED("core", "there is no column %1; expected x_m, y_m, z_m, bx_nT, by_nT and bz_nT"), inQuotes(kStrayColumns[i])});
        places[i] = *place;
    }
    std::vector<StrayReading> readings;
    for (;;) {
        const auto more = csv.next();
        if (!more)
            return more.error();
        if (!*more)
            return readings;
        std::array<double, 6> figures{};
        for (std::size_t i = 0; i < figures.size(); ++i) {
            if (!csv.figure(places[i], figures[i]))
                return csv.noFigure(places[i]);
            if (!std::isfinite(figures[i]))
                return csv.here({MARKED("core", "there is no figure for %1; expected one in each cell"), inQuotes(kStrayColumns[i])});
        }
        readings.push_back({{figures[0], figures[1], figures[2]}, {figures[3], figures[4], figures[5]}});
    }
}

Result<std::vector<StrayReading>> readStrayCsvFile(const std::string& path)
{
    const auto file = openInput(path, MARKED("core", "places and fields"));
    return file ? readStrayCsv(**file, nameOfInput(path)) : Result<std::vector<StrayReading>>(file.error());
}

} // namespace lubberline
