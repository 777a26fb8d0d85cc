#include "core/format/csv/ColumnName.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/base/FileText.h"

namespace lubberline::csv {

namespace {

/// What a unit is called in our names, by what spreadsheets write.
constexpr std::array<std::pair<std::string_view, std::string_view>, 24> kSuffixes{{{"\u00B0", "deg"}, {"\u00BA", "deg"}, {"deg", "deg"},
    {"deg.", "deg"}, {"degree", "deg"}, {"degrees", "deg"}, {"\u00B0e", "deg"}, {"\u00B0 e", "deg"}, {"deg e", "deg"}, {"deg east", "deg"},
    {"degrees east", "deg"}, {"east +", "deg"}, {"e+", "deg"}, {"stopnie", "deg"}, {"kt", "kt"}, {"kts", "kt"}, {"kn", "kt"},
    {"knots", "kt"}, {"m/s", "m_s"}, {"km/h", "km_h"}, {"m", "m"}, {"ft", "ft"}, {"s", "s"}, {"nt", "nt"}}};

std::string suffixOf(std::string_view written)
{
    const auto found = std::find_if(kSuffixes.begin(), kSuffixes.end(), [&](const auto& unit) { return unit.first == written; });
    return std::string(found == kSuffixes.end() ? written : found->second);
}

} // namespace

std::string columnKey(std::string_view cell)
{
    std::string name = inSmallLetters(trimmed(cell)), unit;
    for (const auto& [open, close] : {std::pair{'(', ')'}, std::pair{'[', ']'}})
        if (const auto at = name.rfind(open); at != std::string::npos && at > 0 && name.ends_with(close)) {
            unit = suffixOf(trimmed(std::string_view(name).substr(at + 1, name.size() - at - 2)));
            name = std::string(trimmed(std::string_view(name).substr(0, at)));
            break;
        }
    if (!unit.empty() && !name.ends_with("_" + unit) && !name.ends_with(" " + unit))
        name += "_" + unit;
    std::replace_if(
        name.begin(), name.end(), [](char c) { return c == ' ' || c == '-'; }, '_');
    return name;
}

} // namespace lubberline::csv
