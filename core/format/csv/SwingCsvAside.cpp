#include "core/format/csv/SwingCsvAside.h"

#include <algorithm>

#include "core/base/FileText.h"
#include "core/format/csv/TextCell.h"

namespace lubberline::csv {

namespace {

constexpr std::array<std::string_view, 18> kDegrees{"\u00B0", "deg", "degs", "degree", "degrees", "\u00B0m", "\u00B0c", "\u00B0t", "deg m",
    "deg c", "deg t", "degm", "degc", "degt", "degrees magnetic", "degrees compass", "st", "stopnie"};
constexpr std::array<std::string_view, 34> kSummaries{"mean", "average", "avg", "sum", "total", "min", "minimum", "max", "maximum",
    "median", "rms", "std", "stdev", "stddev", "sd", "standard", "range", "count", "\u015Brednia", "\u015Arednia", "\u015AREDNIA",
    "srednia", "suma", "razem", "mediana", "odchylenie", "mittel", "mittelwert", "durchschnitt", "summe", "moyenne", "somme", "media",
    "promedio"};

bool hasFigure(std::string_view text) { return text.find_first_of("0123456789") != std::string_view::npos; }

/// In small letters, without the brackets and stops around it.
std::string plainWord(std::string_view cell)
{
    constexpr std::string_view kAround = "[](){}.:= ";
    const auto first = cell.find_first_not_of(kAround);
    if (first == std::string_view::npos)
        return {};
    return inSmallLetters(cell.substr(first, cell.find_last_not_of(kAround) + 1 - first));
}

/// A cell that begins with such a word and holds no figure.
bool sumsUp(std::string_view cell)
{
    if (hasFigure(cell))
        return false;
    const std::string word = plainWord(cell);
    const std::string_view begin = std::string_view(word).substr(0, word.find_first_of(" .:,_-"));
    return std::find(kSummaries.begin(), kSummaries.end(), begin) != kSummaries.end();
}

} // namespace

bool isUnitsRow(const std::vector<std::string>& cells, const Columns& columns)
{
    bool degrees = false;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const auto known = std::find(columns.place.begin(), columns.place.end(), std::optional(i));
        const bool angle = known != columns.place.end() && known - columns.place.begin() <= static_cast<std::ptrdiff_t>(Column::Roll);
        const std::string word = plainWord(trimmed(cells[i]));
        const bool ofDegrees = std::find(kDegrees.begin(), kDegrees.end(), word) != kDegrees.end();
        if (angle && !word.empty() && !ofDegrees)
            return false;
        if (hasFigure(cells[i]))
            return false;
        degrees |= angle && ofDegrees;
    }
    return degrees;
}

SummaryRow summaryRowOf(const std::vector<std::string>& cells, const Columns& columns)
{
    SummaryRow row;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const auto cell = trimmed(cells[i]);
        if (cell.empty() || columns.of(Column::Excluded) == i || !sumsUp(cell))
            continue;
        const bool note = columns.of(Column::Note) == i;
        if (!note || row.word.empty())
            row = {textOfCell(cell), note};
        if (!note)
            break;
    }
    return row;
}

} // namespace lubberline::csv
