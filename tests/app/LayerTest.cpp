// The layers, held against the text of the sources: app -> ui -> core, app -> db -> core. The link lines enforce most of it;
// this finds what a system include path would let through.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>

namespace {

namespace fs = std::filesystem;

/// Lines of the sources below `folder` that include something `forbidden` names.
std::vector<std::string> offences(const std::string& folder, const std::string& forbidden)
{
    const std::regex include("^\\s*#\\s*include\\s*[<\"](" + forbidden + ")");
    std::vector<std::string> found;
    int files = 0;
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(LUBBERLINE_SOURCE) / folder)) {
        if (entry.path().extension() != ".h" && entry.path().extension() != ".cpp")
            continue;
        ++files;
        std::ifstream file(entry.path());
        for (std::string line; std::getline(file, line);)
            if (std::regex_search(line, include))
                found.push_back(entry.path().string() + ": " + line);
    }
    EXPECT_GT(files, 2) << folder << " has no sources: the test looks in the wrong place";
    return found;
}

const std::vector<std::string> kNone;

TEST(Layers, coreKnowsNobody) { EXPECT_EQ(offences("core", "Q[A-Za-z]|qwt|sqlite3|ui/|db/|app/"), kNone); }
TEST(Layers, databaseKnowsCoreOnly) { EXPECT_EQ(offences("db", "qwt|ui/|app/|QWidget|QApplication"), kNone); }
TEST(Layers, windowSeesNoSql) { EXPECT_EQ(offences("ui", "QSql|QtSql|sqlite3|db/|app/"), kNone); }
TEST(Layers, appWritesNoSql) { EXPECT_EQ(offences("app", "QSql|QtSql|sqlite3|[Qq]wt"), kNone); }
TEST(Layers, onlyPlotsUseQwt)
{
    for (const auto& line : offences("ui", "[Qq]wt"))
        EXPECT_NE(line.find("/ui/plots/"), std::string::npos) << line;
}

} // namespace
