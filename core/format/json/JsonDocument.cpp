#include "core/format/json/JsonDocument.h"

#include <algorithm>
#include <optional>
#include <set>
#include <vector>

#include <nlohmann/json.hpp>

#include "core/base/FileText.h"
#include "core/format/json/JsonPath.h"

namespace lubberline {

namespace {

using Json = nlohmann::json;

/// Aircraft, compass, swing, reading, extra, and room for a version to come; keeps a hostile file from taking memory.
constexpr std::size_t kMaxDepth = 32;

/// What the values of a document may take; a text of 64 MiB can hold thirty million of them. That of one value, one key with its value,
/// an empty array or object, as the library keeps them (64-bit machine, with what the allocator adds). An array that grows is there
/// twice for a moment.
constexpr std::size_t kMostBytes = std::size_t{320} << 20, kValueBytes = 16, kElementBytes = 16, kKeyBytes = 112, kOpenBytes = 64;
/// The parser has a text twice, and once more where it is kept. The longest of ours is a key in ASCII armour, or the particulars of a swing.
constexpr std::size_t kMostStringBytes = std::size_t{4} << 20;
/// An object is a record of ours or a list by name; each is held against the others.
constexpr std::size_t kMostObjectKeys = 10'000;

/// Ends the parser, which could only be told to keep nothing: it would go on, and keep where it is, five million levels deep.
struct Refused {
    Message why;
};

/// Follows the parser: where it is, and which keys the open objects have.
class Follower {
public:
    explicit Follower(const Message& expected) : m_expected(expected) {}
    bool operator()(Json::parse_event_t event, const Json& parsed)
    {
        switch (event) {
        case Json::parse_event_t::object_start:
        case Json::parse_event_t::array_start:
            take(kOpenBytes);
            if (m_levels.size() == kMaxDepth)
                refuse({MARKED("core", "%1: is nested too deeply; expected %2"), path(), m_expected});
            m_levels.push_back({event == Json::parse_event_t::array_start, 0, {}, {}});
            break;
        case Json::parse_event_t::object_end:
        case Json::parse_event_t::array_end:
            m_levels.pop_back();
            valueEnds();
            break;
        case Json::parse_event_t::key:
            m_levels.back().key = parsed.get_ref<const std::string&>();
            take(kKeyBytes + m_levels.back().key.size());
            if (m_levels.back().keys.size() == kMostObjectKeys)
                refuse({MARKED("core", "%1: has more than %2 keys; expected %3"), path(), kMostObjectKeys, m_expected});
            if (!m_levels.back().keys.insert(m_levels.back().key).second)
                refuse({MARKED("core", "%1: is there twice; expected each key once"), path()});
            break;
        case Json::parse_event_t::value:
            take(kValueBytes + (parsed.is_string() ? parsed.get_ref<const std::string&>().size() + sizeof(std::string) : 0));
            valueEnds();
            break;
        }
        return true;
    }
    [[nodiscard]] Message path() const
    {
        std::string text;
        for (const auto& level : m_levels)
            appendStep(text, level.isArray ? std::nullopt : std::optional<std::string_view>(level.key), level.index);
        return text.empty() ? Message(MARKED("core", "the file")) : Message::verbatim(text);
    }

private:
    struct Level {
        bool isArray;
        std::size_t index;
        std::string key;
        std::set<std::string> keys;
    };
    void valueEnds()
    {
        if (!m_levels.empty())
            ++m_levels.back().index;
    }
    void take(std::size_t bytes)
    {
        m_bytes += bytes + (!m_levels.empty() && m_levels.back().isArray ? kElementBytes : 0);
        if (m_bytes > kMostBytes)
            refuse({MARKED("core", "%1: the values up to here take more than %2 MiB; expected %3, of a smaller size"), path(),
                kMostBytes >> 20, m_expected});
    }
    [[noreturn]] static void refuse(const Message& problem) { throw Refused{problem}; }

    const Message& m_expected;
    std::size_t m_bytes = 0;
    std::vector<Level> m_levels;
};

/// Where a text begins that is longer than may be; found before the parser takes memory for it.
std::optional<std::size_t> tooLongString(std::string_view text)
{
    for (std::size_t i = text.find('"'); i != std::string_view::npos; i = text.find('"', i + 1)) {
        const std::size_t begin = i++;
        while (i < text.size() && text[i] != '"')
            i += text[i] == '\\' ? 2 : 1;
        if (i - begin > kMostStringBytes)
            return begin;
        if (i >= text.size())
            break;
    }
    return {};
}

std::ptrdiff_t lineAt(std::string_view text, std::size_t byte)
{
    return std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(byte), '\n') + 1;
}

Error notJson(std::string_view text, std::size_t byte, const std::string& name, const Message& expected)
{
    const auto before = text.substr(0, std::min(byte > 0 ? byte - 1 : 0, text.size()));
    const auto line = lineAt(before, before.size());
    const auto lineStart = before.rfind('\n') == std::string_view::npos ? 0 : before.rfind('\n') + 1;
    const auto content = text.substr(lineStart, text.find('\n', lineStart) - lineStart);
    if (const auto bytes = notUtf8(content); !bytes.empty())
        return {ErrorCode::Format, bytes, name, line};
    return {ErrorCode::Format,
        {MARKED("core", "is not well-formed JSON at column %1; expected %2, whole"), before.size() - lineStart + 1, expected}, name, line};
}

} // namespace

Result<Json> parseJson(std::string_view text, const std::string& name, const Message& expected)
{
    if (trimmed(text).empty())
        return Error{ErrorCode::Format, {MARKED("core", "is empty; expected %1"), expected}, name};
    if (const auto other = otherEncoding(text); !other.empty())
        return Error{ErrorCode::Format, other, name};
    if (text.size() > kMostJsonBytes)
        return Error{ErrorCode::Format, {MARKED("core", "is larger than %1 MiB; expected %2"), kMostJsonBytes >> 20, expected}, name};
    if (const auto begin = tooLongString(text))
        return Error{ErrorCode::Format, {MARKED("core", "holds a text of more than %1 MiB; expected %2"), kMostStringBytes >> 20, expected},
            name, lineAt(text, *begin)};
    Follower follower(expected);
    try {
        return Json::parse(text, [&](int, Json::parse_event_t event, Json& parsed) { return follower(event, parsed); });
    } catch (const Refused& refused) {
        return Error{ErrorCode::Format, refused.why, name};
    } catch (const Json::parse_error& error) {
        return notJson(text, error.byte, name, expected);
    } catch (const Json::out_of_range&) {
        return Error{
            ErrorCode::InvalidInput, {MARKED("core", "%1: is out of range; expected a number that can be held"), follower.path()}, name};
    }
}

} // namespace lubberline
