#include "core/base/NearWord.h"

#include <algorithm>
#include <cctype>
#include <numeric>
#include <vector>

namespace lubberline {

namespace {

constexpr std::size_t kNear = 2;

char lower(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

} // namespace

std::size_t editDistance(std::string_view a, std::string_view b)
{
    // Damerau's distance, restricted to swaps of neighbours: three rows of the table are enough.
    std::vector<std::size_t> twoBack(b.size() + 1), back(b.size() + 1), row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        twoBack.swap(back);
        back.swap(row);
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const bool same = lower(a[i - 1]) == lower(b[j - 1]);
            row[j] = std::min({back[j] + 1, row[j - 1] + 1, back[j - 1] + (same ? 0 : 1)});
            if (i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) && lower(a[i - 2]) == lower(b[j - 1]))
                row[j] = std::min(row[j], twoBack[j - 2] + 1);
        }
    }
    return row[b.size()];
}

std::string_view nearWord(std::string_view word, std::span<const std::string_view> known)
{
    std::string_view nearest;
    std::size_t least = kNear + 1;
    for (const auto candidate : known) {
        // A long stranger is not worth the table.
        if (word.size() > candidate.size() + kNear)
            continue;
        if (const auto distance = editDistance(word, candidate); distance < std::min(least, candidate.size())) {
            least = distance;
            nearest = candidate;
        }
    }
    return nearest;
}

} // namespace lubberline
