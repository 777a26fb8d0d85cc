#include "core/format/csv/TextCell.h"

#include <algorithm>
#include <array>

#include "core/base/FileText.h"

namespace lubberline {

namespace {

/// The full-width forms are computed where the keyboard is Chinese, Japanese or Korean.
constexpr std::array<std::string_view, 8> kBeginFormulas{"=", "+", "-", "@", "\uFF1D", "\uFF0B", "\uFF0D", "\uFF20"};

bool beginsFormula(std::string_view text)
{
    if (text.starts_with('\t') || text.starts_with('\r') || text.starts_with('\n'))
        return true;
    while (const std::size_t space = spaceAt(text))
        text.remove_prefix(space);
    return std::any_of(kBeginFormulas.begin(), kBeginFormulas.end(), [text](std::string_view sign) { return text.starts_with(sign); });
}

/// Whatever marks stand before it already.
bool needsMark(std::string_view text) { return beginsFormula(text.substr(std::min(text.find_first_not_of('\''), text.size()))); }

} // namespace

std::string withTextMark(std::string_view text) { return (needsMark(text) ? "'" : "") + std::string(text); }

std::string textOfCell(std::string_view cell)
{
    if (cell.starts_with('\'') && needsMark(cell))
        cell.remove_prefix(1);
    return std::string(cell);
}

std::string csvQuoted(std::string_view text)
{
    std::string quoted = "\"";
    for (const char c : text)
        quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + "\"";
}

std::string csvTextCell(std::string_view text)
{
    const std::string marked = withTextMark(text);
    const bool plain = marked.find_first_of(",;\t\"\n\r|") == std::string::npos && trimmed(marked).size() == marked.size();
    return plain ? marked : csvQuoted(marked);
}

} // namespace lubberline
