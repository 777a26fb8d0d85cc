#include "core/record/SharedErrors.h"

#include <algorithm>
#include <vector>

#include "core/base/FileText.h"
#include "core/base/Number.h"
#include "core/record/Ranges.h"

namespace lubberline {

namespace {

constexpr std::string_view kLetters = "ABCDE";

/// The words between spaces, semicolons and the commas behind which a space stands.
std::vector<std::string_view> wordsOf(std::string_view text)
{
    std::vector<std::string_view> words;
    while (!(text = trimmed(text)).empty()) {
        std::size_t end = 0;
        while (end < text.size() && spaceAt(text.substr(end)) == 0 && text[end] != ';')
            ++end;
        std::string_view word = text.substr(0, end);
        while (word.ends_with(','))
            word.remove_suffix(1);
        if (!word.empty())
            words.push_back(word);
        text.remove_prefix(std::min(text.size(), end + (end < text.size() && text[end] == ';' ? 1 : 0)));
    }
    return words;
}

} // namespace

bool SharedErrors::any() const
{
    return std::any_of(of_deg.begin(), of_deg.end(), [](double error_deg) { return error_deg != 0.0; });
}

Result<SharedErrors> readSharedErrors(std::string_view text)
{
    const auto wrong = [text] {
        return Error{ErrorCode::InvalidInput,
            {MARKED("core", "%1 is no error that readings share; expected degrees (of A) or letters with degrees, as in A 0.6 B 0.2"),
                figuresInQuotes(text)}};
    };
    SharedErrors errors;
    std::size_t letter = 0;
    bool named = false;
    std::array<bool, 5> taken{};
    const auto words = wordsOf(text);
    for (std::string_view word : words) {
        if (word.size() == 1 && kLetters.find(word[0]) != std::string_view::npos) {
            if (named)
                return wrong();
            letter = kLetters.find(word[0]);
            named = true;
            continue;
        }
        constexpr std::string_view kDegree = "°";
        if (word.ends_with(kDegree))
            word.remove_suffix(kDegree.size());
        const auto number = readNumber(word, true);
        const bool alone = words.size() == 1;
        if (number.fault != NumberFault::None || !kSharedErrorRange.has(number.value) || (!named && !alone) || taken[letter])
            return wrong();
        errors.of_deg[letter] = number.value;
        taken[letter] = true;
        named = false;
    }
    return named ? Result<SharedErrors>(wrong()) : errors;
}

std::string textOf(const SharedErrors& errors)
{
    std::string text;
    for (std::size_t i = 0; i < errors.of_deg.size(); ++i)
        if (errors.of_deg[i] != 0.0)
            text += (text.empty() ? "" : " ") + std::string(1, kLetters[i]) + " " + shortestNumber(errors.of_deg[i]);
    return text;
}

} // namespace lubberline
