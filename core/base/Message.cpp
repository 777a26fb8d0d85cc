#include "core/base/Message.h"

namespace lubberline {

namespace {

std::string plainEnglish(const Pattern& pattern, std::int64_t count)
{
    std::string text = pattern.english;
    if (count < 0)
        return text;
    for (std::size_t at = text.find("(s)"); at != std::string::npos; at = text.find("(s)", at))
        text.replace(at, 3, count == 1 ? "" : "s");
    return text;
}

} // namespace

bool detail::hasCount(Pattern pattern) { return std::string_view(pattern.english).find("%n") != std::string_view::npos; }

Message Message::verbatim(std::string text)
{
    Message message;
    if (text.empty())
        return message;
    message.m_pattern = {nullptr, "%1"};
    message.m_arguments.emplace_back(std::move(text));
    return message;
}

std::string Message::english() const { return in(plainEnglish); }

std::string Message::in(const Language& language) const
{
    if (empty())
        return {};
    const std::string pattern = m_pattern.context ? language(m_pattern, m_count) : plainEnglish(m_pattern, m_count);
    std::string text;
    for (std::size_t i = 0; i < pattern.size(); ++i) {
        const char next = pattern[i] == '%' && i + 1 < pattern.size() ? pattern[i + 1] : '\0';
        const auto place = static_cast<std::size_t>(next - '1');
        if (next == 'n' && m_count >= 0)
            text += std::to_string(m_count);
        else if (next >= '1' && next <= '9' && place < m_arguments.size())
            text += m_arguments[place].in(language);
        else {
            text += pattern[i];
            continue;
        }
        ++i;
    }
    return text;
}

std::string Message::Argument::in(const Language& language) const
{
    if (const auto* message = std::get_if<Message>(&m_value))
        return message->in(language);
    return std::get<std::string>(m_value);
}

Message together(std::vector<Message> messages)
{
    Message all;
    for (auto& message : messages)
        if (!message.empty())
            all = all.empty() ? std::move(message) : Message{Pattern{nullptr, "%1; %2"}, std::move(all), std::move(message)};
    return all;
}

std::vector<std::string> inEnglish(const std::vector<Message>& messages)
{
    std::vector<std::string> texts;
    for (const auto& message : messages)
        texts.push_back(message.english());
    return texts;
}

} // namespace lubberline
