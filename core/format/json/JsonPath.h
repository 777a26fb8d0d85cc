#pragma once
/// Where a value stands in a JSON file, in words for an error: aircraft[2].compasses[0].kind.

#include <optional>
#include <string>
#include <string_view>

namespace lubberline {

/// Appends ".key", or "[index]" where there is no key.
inline void appendStep(std::string& path, std::optional<std::string_view> key, std::size_t index)
{
    if (key)
        path.append(path.empty() ? "" : ".").append(key->substr(0, 60));
    else
        path.append("[").append(std::to_string(index)).append("]");
}

/// A step on the way, linked to the step before it: costs nothing until a message needs the text.
struct JsonPath {
    const JsonPath* before = nullptr;
    std::optional<std::string_view> key = {};
    std::size_t index = 0;

    [[nodiscard]] std::string text() const
    {
        std::string path = before ? before->text() : std::string();
        if (before)
            appendStep(path, key, index);
        return path;
    }
};

} // namespace lubberline
