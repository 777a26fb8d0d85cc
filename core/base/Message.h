#pragma once
/// What the program says to people, so that it can be said in their language: a pattern and what is put into it.
///
///     Message{MARKED("core", "%1 is no date; expected YYYY-MM-DD"), inQuotes(text)}
///
/// Core and db make messages; english() is what commands, files and tests see; the window translates them (ui/text/Translated.h).
/// What is stored or signed are codes and figures, never a message. A sentence without MARKED does not compile.

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "core/base/Date.h"

namespace lubberline {

/// A sentence of the source, made by MARKED: lupdate looks for that word. `%1` … `%9` are filled in; `%n` is the count.
struct Pattern {
    const char* context; ///< null: only joins messages and texts, and has nothing to translate
    const char* english; ///< with `%n`, "(s)" behind a word is its plural: "%n reading(s)"
};

// lupdate knows MARKED as QT_TRANSLATE_NOOP and MARKED_N as QT_TRANSLATE_N_NOOP (target `translations`).
#define MARKED(context, english)                                                                                                           \
    ::lubberline::Pattern { context, english }
#define MARKED_N(context, english)                                                                                                         \
    ::lubberline::Pattern { context, english }

class Message {
public:
    class Argument;
    /// How a reader's language says a pattern; `count` is of `%n`, -1 where there is none. Puts no arguments in.
    using Language = std::function<std::string(const Pattern& pattern, std::int64_t count)>;

    Message() = default; ///< nothing to say
    template <class... Arguments>
    Message(Pattern pattern, Arguments&&... arguments);

    /// A text that is nobody's to translate: what SQLite or the system said, or what is in the reader's language already.
    [[nodiscard]] static Message verbatim(std::string text);
    static Message verbatim(const char*) = delete; // a sentence of ours is MARKED

    [[nodiscard]] bool empty() const { return m_pattern.english == nullptr; }
    [[nodiscard]] std::string english() const;
    [[nodiscard]] std::string in(const Language& language) const;

    friend bool operator==(const Message& a, const Message& b) { return a.english() == b.english(); }

private:
    Pattern m_pattern{nullptr, nullptr};
    std::int64_t m_count = -1;
    std::vector<Argument> m_arguments;
};

/// A figure, a name or a quotation (said as it is), or a message (translated by itself).
class Message::Argument {
public:
    Argument(std::string text) : m_value(std::move(text)) {}
    Argument(std::string_view text) : m_value(std::string(text)) {}
    Argument(Message message) : m_value(std::move(message)) {}
    Argument(Pattern pattern) : m_value(Message(pattern)) {}
    Argument(Date day) : m_value(day.text()) {}
    Argument(char letter) : m_value(std::string(1, letter)) {}
    template <class Number, std::enable_if_t<std::is_integral_v<Number> && !std::is_same_v<Number, bool>, int> = 0>
    Argument(Number number) : m_value(std::to_string(number))
    {
    }
    Argument(double) = delete;      // how many decimals is the caller's to say
    Argument(const char*) = delete; // a word of ours is MARKED; a symbol is a std::string

    [[nodiscard]] std::string in(const Language& language) const;

private:
    std::variant<std::string, Message> m_value;
};

namespace detail {
/// The count of `%n` is the first argument; the rest fill `%1` and on.
[[nodiscard]] bool hasCount(Pattern pattern);
} // namespace detail

template <class... Arguments>
Message::Message(Pattern pattern, Arguments&&... arguments) : m_pattern(pattern)
{
    m_arguments.reserve(sizeof...(arguments));
    [[maybe_unused]] const bool counted = detail::hasCount(pattern);
    [[maybe_unused]] const auto take = [&]<class One>(One&& one) {
        if constexpr (std::is_integral_v<std::decay_t<One>>)
            if (counted && m_count < 0) {
                m_count = static_cast<std::int64_t>(one);
                return;
            }
        m_arguments.emplace_back(std::forward<One>(one));
    };
    (take(std::forward<Arguments>(arguments)), ...);
}

/// Sentences one after the other, parted by "; ".
[[nodiscard]] Message together(std::vector<Message> messages);

/// For commands and files.
[[nodiscard]] std::vector<std::string> inEnglish(const std::vector<Message>& messages);

} // namespace lubberline
