// Whatever a comment cites by a key in brackets, as in [P 4], stands in docs/bibliography.md.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

namespace {

namespace fs = std::filesystem;

std::string slurped(const fs::path& path)
{
    std::ifstream file(path);
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

TEST(Bibliography, everyKeyThatIsCitedStandsThere)
{
    const fs::path root(LUBBERLINE_SOURCE);
    const std::string bibliography = slurped(root / "docs" / "bibliography.md");
    ASSERT_FALSE(bibliography.empty());
    const std::regex citation("\\[([A-Z]) [0-9]+[0-9., –-]*\\]");
    std::set<std::string> cited;
    for (const char* top : {"core", "db", "ui", "app", "tests"})
        for (const auto& entry : fs::recursive_directory_iterator(root / top)) {
            if (entry.path().extension() != ".h" && entry.path().extension() != ".cpp")
                continue;
            const std::string text = slurped(entry.path());
            for (std::sregex_iterator found(text.begin(), text.end(), citation), end; found != end; ++found)
                cited.insert((*found)[1].str());
        }
    EXPECT_TRUE(cited.contains("P")) << "the test looks in the wrong place";
    for (const auto& key : cited)
        EXPECT_NE(bibliography.find("| " + key + " |"), std::string::npos) << "[" << key << " …] is cited and not in docs/bibliography.md";
}

} // namespace
