#include "core/format/json/JsonDocument.h"

#include <algorithm>
#include <optional>
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
constexpr std::size_t kMostBytes = std::size_t{240} << 20, kValueBytes = 16, kElementBytes = 16, kKeyBytes = 112, kOpenBytes = 64;
/// The parser has a text twice, and once more where it is kept. The longest of ours is a key in ASCII armour, or the particulars of a swing.
constexpr std::size_t kMostStringBytes = std::size_t{4} << 20;
/// An object is a record of ours or a list by name; each is held against the others.
constexpr std::size_t kMostObjectKeys = 10'000;

/// Ends the parser with what is wrong.
struct Refused {
    Message why;
    ErrorCode code;
};

/// Builds the document and follows the parser: where it is, and which keys the open objects have. The library's own parser with a callback
/// looks through the whole list above at the end of each object in it: a million take hours.
class Builder final : public nlohmann::json_sax<Json> {
public:
    explicit Builder(const Message& expected) : m_expected(expected) {}
    bool null() override { return value(nullptr); }
    bool boolean(bool one) override { return value(one); }
    bool number_integer(number_integer_t one) override { return value(one); }
    bool number_unsigned(number_unsigned_t one) override { return value(one); }
    bool number_float(number_float_t one, const string_t&) override { return value(one); }
    bool string(string_t& one) override
    {
        take(one.size() + sizeof(std::string));
        return value(std::move(one));
    }
    bool binary(binary_t&) override { return false; } // JSON has none
    bool start_object(std::size_t) override { return open(Json::object()); }
    bool start_array(std::size_t) override { return open(Json::array()); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }
    bool key(string_t& name) override
    {
        Level& level = m_levels.back();
        level.key = name;
        take(kKeyBytes + name.size());
        if (level.value->size() == kMostObjectKeys)
            refuse({MARKED("core", "%1: has more than %2 keys; expected %3"), path(), kMostObjectKeys, m_expected});
        if (level.value->contains(name))
            refuse({MARKED("core", "%1: is there twice; expected each key once"), path()});
        return true;
    }
    bool parse_error(std::size_t byte, const std::string&, const nlohmann::detail::exception& why) override
    {
        constexpr int kNumberOutOfRange = 406;
        if (why.id == kNumberOutOfRange)
            throw Refused{{MARKED("core", "%1: is out of range; expected a number that can be held"), path()}, ErrorCode::InvalidInput};
        m_errorAt = byte;
        return false;
    }
    [[nodiscard]] std::size_t errorAt() const { return m_errorAt; }
    [[nodiscard]] Json document() { return std::move(m_document); }

private:
    struct Level {
        Json* value; ///< it stays where it is while it is open: the list that it is in does not grow meanwhile
        std::string key;
    };
    [[nodiscard]] Message path() const
    {
        std::string text;
        for (const Level& level : m_levels) { // a list has the value in it that is open already
            const std::size_t index = level.value->size() - (&level != &m_levels.back() ? 1 : 0);
            appendStep(text, level.value->is_array() ? std::nullopt : std::optional<std::string_view>(level.key), index);
        }
        return text.empty() ? Message(MARKED("core", "the file")) : Message::verbatim(text);
    }
    Json* put(Json one)
    {
        if (m_levels.empty())
            return &(m_document = std::move(one));
        Json& parent = *m_levels.back().value;
        if (parent.is_object())
            return &(parent[m_levels.back().key] = std::move(one));
        parent.push_back(std::move(one));
        return &parent.back();
    }
    bool value(Json one)
    {
        take(kValueBytes);
        put(std::move(one));
        return true;
    }
    bool open(Json one)
    {
        take(kOpenBytes);
        if (m_levels.size() == kMaxDepth)
            refuse({MARKED("core", "%1: is nested too deeply; expected %2"), path(), m_expected});
        m_levels.push_back({put(std::move(one)), {}});
        return true;
    }
    bool close()
    {
        m_levels.pop_back();
        return true;
    }
    void take(std::size_t bytes)
    {
        m_bytes += bytes + (!m_levels.empty() && m_levels.back().value->is_array() ? kElementBytes : 0);
        if (m_bytes > kMostBytes)
            refuse({MARKED("core", "%1: the values up to here take more than %2 MiB; expected %3, of a smaller size"), path(),
                kMostBytes >> 20, m_expected});
    }
    [[noreturn]] static void refuse(const Message& problem) { throw Refused{problem, ErrorCode::Format}; }

    const Message& m_expected;
    Json m_document;
    std::size_t m_bytes = 0, m_errorAt = 0;
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
    Builder builder(expected);
    try {
        return Json::sax_parse(text, &builder) ? Result<Json>(builder.document()) : notJson(text, builder.errorAt(), name, expected);
    } catch (const Refused& refused) {
        return Error{refused.code, refused.why, name};
    }
}

} // namespace lubberline
