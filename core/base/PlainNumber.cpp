#include "core/base/PlainNumber.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>

namespace lubberline {

bool takePlainNumber(std::string_view text, double& value)
{
    static constexpr std::array<double, 16> kPowers{1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
    constexpr std::size_t kMostShort = 17; // a sign, a point, fifteen figures
    const char* at = text.data();
    const char* const end = at + text.size();
    const bool negative = at != end && *at == '-';
    at += negative;
    if (text.size() <= kMostShort) {
        std::uint64_t digits = 0;
        const char* const whole = at;
        for (; at != end && static_cast<unsigned>(*at - '0') < 10; ++at)
            digits = 10 * digits + static_cast<unsigned>(*at - '0');
        std::ptrdiff_t count = at - whole, decimals = 0;
        if (count > 0 && at != end && *at == '.') {
            const char* const point = ++at;
            for (; at != end && static_cast<unsigned>(*at - '0') < 10; ++at)
                digits = 10 * digits + static_cast<unsigned>(*at - '0');
            decimals = at - point;
            count += decimals;
        }
        if (at == end && count > 0 && count <= 15) {
            const double size = static_cast<double>(digits) / kPowers[static_cast<std::size_t>(decimals)];
            value = negative ? -size : size;
            return true;
        }
    }
    const auto [stop, fault] = std::from_chars(text.data(), end, value);
    return fault == std::errc() && stop == end && std::isfinite(value);
}

} // namespace lubberline
