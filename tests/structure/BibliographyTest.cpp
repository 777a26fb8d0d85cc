// Whatever a comment cites by a key in brackets, as in [P 4], stands in docs/bibliography.md.

#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <set>

#include "tests/structure/Sources.h"

namespace {

using namespace lubberline::test;
namespace fs = std::filesystem;

TEST(Bibliography, everyKeyThatIsCitedStandsThere)
{
    const std::string bibliography = textOf(fs::path(LUBBERLINE_SOURCE) / "docs" / "bibliography.md");
    ASSERT_FALSE(bibliography.empty());
    // [P 4], [P 14–15, K 9.13]: whole brackets first, then each letter before a number.
    const std::regex bracket("\\[([A-Z] [0-9][^\\]\\n]*)\\]"), key("(?:^|[ ,;])([A-Z]) [0-9]");
    std::set<std::string> cited;
    for (const auto& [file, text] : sourcesBelow({"core", "db", "ui", "app", "tests"}))
        for (std::sregex_iterator found(text.begin(), text.end(), bracket), end; found != end; ++found) {
            const std::string inside = (*found)[1].str();
            for (std::sregex_iterator one(inside.begin(), inside.end(), key); one != end; ++one)
                cited.insert((*one)[1].str());
        }
    for (const char* known : {"P", "M", "K"})
        EXPECT_TRUE(cited.contains(known)) << "the test looks in the wrong place: nobody cites [" << known << " …]";
    for (const auto& one : cited)
        EXPECT_NE(bibliography.find("| " + one + " |"), std::string::npos) << "[" << one << " …] is cited and not in docs/bibliography.md";
}

} // namespace
