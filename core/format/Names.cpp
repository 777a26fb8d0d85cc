#include "core/format/Names.h"

#include <chrono>
#include <cstdlib>

namespace lubberline {

bool isDateOrEmpty(const std::string& text)
{
    if (text.empty())
        return true;
    if (text.size() != 10 || text[4] != '-' || text[7] != '-' || text.find_first_not_of("0123456789-") != std::string::npos)
        return false;
    for (const std::size_t i : {0u, 1u, 2u, 3u, 5u, 6u, 8u, 9u})
        if (text[i] == '-')
            return false;
    const auto part = [&](std::size_t from, std::size_t count) { return std::atoi(text.substr(from, count).c_str()); };
    return std::chrono::year_month_day(std::chrono::year(part(0, 4)), std::chrono::month(static_cast<unsigned>(part(5, 2))),
        std::chrono::day(static_cast<unsigned>(part(8, 2)))).ok();
}

} // namespace lubberline
