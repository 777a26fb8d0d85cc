#include "core/format/reference/PairCsv.h"

#include <array>

#include "core/angle/AngleText.h"
#include "core/base/WholeFile.h"
#include "core/format/reference/SmallTable.h"

namespace lubberline {

namespace {

constexpr std::array<std::string_view, 3> kPairColumns{"first_compass_deg", "second_compass_deg", "magnetic_heading_deg"};

} // namespace

Result<std::vector<PairReading>> readPairCsv(std::string_view text, const std::string& name)
{
    std::vector<PairReading> pairs;
    const auto read = readSmallTable(text, name, kPairColumns, 2, [&pairs](const SmallRow& row) -> Result<void> {
        std::array<std::optional<double>, 3> heading_deg;
        for (std::size_t c = 0; c < kPairColumns.size(); ++c) {
            if (row[c].empty())
                continue;
            const auto heading = parseHeading_deg(row[c], c == 2 ? North::Magnetic : North::Compass);
            if (!heading)
                return Error{heading.error().code, {MARKED("core", "%1: %2"), std::string(kPairColumns[c]), heading.error().message}};
            heading_deg[c] = *heading;
        }
        if (!heading_deg[0] || !heading_deg[1])
            return {};
        PairReading pair{CompassHeading::fromDegrees(*heading_deg[0]), CompassHeading::fromDegrees(*heading_deg[1]), {}};
        if (heading_deg[2])
            pair.datum = MagneticHeading::fromDegrees(*heading_deg[2]);
        pairs.push_back(pair);
        return {};
    });
    return read ? Result<std::vector<PairReading>>(std::move(pairs)) : Result<std::vector<PairReading>>(read.error());
}

Result<std::vector<PairReading>> readPairCsvFile(const std::string& path)
{
    const auto text = readWholeFile(path, MARKED("core", "a table of two compasses read together"));
    return text ? readPairCsv(*text, nameOfInput(path)) : Result<std::vector<PairReading>>(text.error());
}

} // namespace lubberline
