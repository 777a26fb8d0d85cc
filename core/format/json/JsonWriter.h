#pragma once
/// Writes JSON text as it goes, with keys in the order given and the shortest digits of every number: large fleets need no tree
/// in memory, and the same values always give the same bytes.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lubberline {

enum class JsonLayout {
    Lines,   ///< for people: a key a line, indented
    Compact, ///< no space and no line end
};

class JsonWriter {
public:
    explicit JsonWriter(JsonLayout layout = JsonLayout::Lines) : m_compact(layout == JsonLayout::Compact) {}

    /// Begins an object, on one line when `inOneLine`; as the value of `key`, or with an empty key as the next of an array.
    void beginObject(std::string_view key = {}, bool inOneLine = false);
    void beginArray(std::string_view key = {}, bool inOneLine = false);
    void end(); ///< of the innermost object or array

    void text(std::string_view key, std::string_view value);            ///< what is no UTF-8 in it becomes U+FFFD
    void number(std::string_view key, double value);                    ///< finite
    void numbers(std::string_view key, std::span<const double> values); ///< finite; an array in one line
    void integer(std::string_view key, std::int64_t value);
    void boolean(std::string_view key, bool value);
    void null(std::string_view key);

    /// All that was written, with a newline at the end (not when compact); every object and array has been ended.
    [[nodiscard]] std::string take();

private:
    struct Level {
        char closing;
        bool inOneLine;
        bool empty = true;
    };
    void begin(std::string_view key, char opening, Level level);
    void startValue(std::string_view key);
    void newLine();
    void string(std::string_view value);

    bool m_compact;
    std::string m_text;
    std::vector<Level> m_levels;
};

} // namespace lubberline
