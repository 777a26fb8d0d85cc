// The floors, held against the text of the sources. A folder of core may include what its own link line names, and nothing
// else; no two folders need each other; nothing looks up (core < db < ui < app). The linker alone would not see most of it:
// headers are found from the root of the repository, whatever is linked.

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "tests/structure/Sources.h"

namespace {

using namespace lubberline::test;
namespace fs = std::filesystem;

using Names = std::set<std::string>;
const std::vector<std::string> kNone;

struct Include {
    std::string file;   ///< from the root of the repository
    std::string folder; ///< where it lies
    std::string what;   ///< as it is written
};

/// Every #include of the sources below `top`.
std::vector<Include> includesBelow(const std::string& top)
{
    static const std::regex line("^\\s*#\\s*include\\s*[<\"]([^>\"]+)[>\"]");
    std::vector<Include> found;
    const auto sources = sourcesBelow({top});
    for (const auto& [file, text] : sources) {
        std::istringstream rows(text);
        std::smatch match;
        for (std::string row; std::getline(rows, row);)
            if (std::regex_search(row, match, line))
                found.push_back({file, fs::path(file).parent_path().string(), match[1].str()});
    }
    EXPECT_GT(sources.size(), 2u) << top << " has no sources: the test looks in the wrong place";
    return found;
}

/// The folder of ours that an include names; empty for what is not ours.
std::string folderOf(const Include& include)
{
    if (!fs::exists(fs::path(LUBBERLINE_SOURCE) / include.what))
        return {};
    return fs::path(include.what).parent_path().string();
}

std::vector<std::string> offences(const std::string& top, const std::string& forbidden)
{
    const std::regex pattern("^(" + forbidden + ")");
    std::vector<std::string> found;
    for (const Include& include : includesBelow(top))
        if (std::regex_search(include.what, pattern))
            found.push_back(include.file + " includes " + include.what);
    return found;
}

/// "core/sensor/map" is the library core_sensor_map.
std::string libraryOf(const std::string& folder)
{
    std::string name = folder;
    std::replace(name.begin(), name.end(), '/', '_');
    return name;
}

/// The libraries that the folder's link line names.
Names linked(const std::string& folder)
{
    const std::string text = textOf(fs::path(LUBBERLINE_SOURCE) / folder / "CMakeLists.txt");
    const std::regex line("target_link_libraries\\(\\s*" + libraryOf(folder) + "\\s+([^)]*)\\)");
    std::smatch match;
    if (!std::regex_search(text, match, line))
        return {};
    std::istringstream words(match[1].str());
    return {std::istream_iterator<std::string>(words), {}};
}

TEST(Floors, whatAFolderOfCoreIncludesStandsInItsLinkLine)
{
    std::vector<std::string> missing;
    for (const Include& include : includesBelow("core")) {
        const std::string other = folderOf(include);
        if (!other.empty() && other != include.folder && !linked(include.folder).contains(libraryOf(other)))
            missing.push_back(
                include.file + " includes " + include.what + ", and " + libraryOf(include.folder) + " does not link " + libraryOf(other));
    }
    EXPECT_EQ(missing, kNone);
}

TEST(Floors, aLinkLineOfCoreNamesNothingThatIsNotUsed)
{
    std::map<std::string, Names> used;
    for (const Include& include : includesBelow("core"))
        if (const std::string other = folderOf(include); !other.empty() && other != include.folder)
            used[include.folder].insert(libraryOf(other));
    std::vector<std::string> idle;
    for (const auto& [folder, others] : used)
        for (const std::string& name : linked(folder))
            if (name.starts_with("core_") && !others.contains(name))
                idle.push_back(libraryOf(folder) + " links " + name + " and includes nothing of it");
    EXPECT_EQ(idle, kNone);
}

TEST(Floors, whatIsNotOursIsLinkedWhereItIsIncluded)
{
    const std::vector<std::pair<std::string, std::string>> parts{{"Eigen/", "Eigen3::Eigen"}, {"boost/", "Boost::headers"},
        {"GeographicLib/", "PkgConfig::geographiclib"}, {"fftw3.h", "PkgConfig::fftw3"}, {"nlohmann/", "nlohmann_json::nlohmann_json"}};
    std::vector<std::string> missing;
    for (const Include& include : includesBelow("core"))
        for (const auto& [begins, library] : parts)
            if (include.what.starts_with(begins) && !linked(include.folder).contains(library))
                missing.push_back(
                    include.file + " includes " + include.what + ", and " + libraryOf(include.folder) + " does not link " + library);
    EXPECT_EQ(missing, kNone);
}

/// From where it stands, an include names no folder that a test could hold against anything.
TEST(Floors, anIncludeIsWrittenFromTheRoot)
{
    std::vector<std::string> beside;
    for (const char* top : {"core", "db", "ui", "app"})
        for (const Include& include : includesBelow(top))
            if (include.what.find("..") != std::string::npos
                || (folderOf(include).empty() && fs::exists(fs::path(LUBBERLINE_SOURCE) / include.folder / include.what)))
                beside.push_back(include.file + " includes " + include.what);
    EXPECT_EQ(beside, kNone);
}

/// Folders and those that they include. A folder and one inside it are of one family.
std::map<std::string, Names> arrows()
{
    std::map<std::string, Names> all;
    for (const char* top : {"core", "db", "ui", "app"})
        for (const Include& include : includesBelow(top)) {
            const std::string other = folderOf(include);
            if (!other.empty() && other != include.folder && !other.starts_with(include.folder + "/")
                && !include.folder.starts_with(other + "/"))
                all[include.folder].insert(other);
        }
    return all;
}

/// Whether a way of includes leads from one folder to the other.
bool leads(const std::map<std::string, Names>& arrows, const std::string& from, const std::string& to, Names& seen)
{
    const auto found = arrows.find(from);
    if (found == arrows.end() || !seen.insert(from).second)
        return false;
    for (const std::string& next : found->second)
        if (next == to || leads(arrows, next, to, seen))
            return true;
    return false;
}

TEST(Floors, noFoldersNeedEachOther)
{
    const auto all = arrows();
    std::vector<std::string> circles;
    for (const auto& [folder, others] : all)
        for (const std::string& other : others)
            if (Names seen; leads(all, other, folder, seen))
                circles.push_back(folder + " -> " + other + " -> … -> " + folder);
    EXPECT_EQ(circles, kNone);
}

TEST(Floors, aRoomHoldsNoMoreThanOneCanLookOver)
{
    std::map<std::string, int> files;
    for (const auto& source : sourcesBelow({"core", "db", "ui", "app"}))
        ++files[fs::path(source.file).parent_path().string()];
    for (const auto& [folder, count] : files)
        EXPECT_LE(count, 45) << folder << ": a subject of its own is in there";
}

TEST(Layers, coreKnowsNobody) { EXPECT_EQ(offences("core", "Q[A-Za-z]|qwt|sqlite3|ui/|db/|app/"), kNone); }
TEST(Layers, databaseKnowsCoreOnly) { EXPECT_EQ(offences("db", "qwt|ui/|app/|QWidget|QApplication|QGui"), kNone); }
TEST(Layers, windowWritesNoSql) { EXPECT_EQ(offences("ui", "QSql|QtSql|sqlite3|app/"), kNone); }
TEST(Layers, appWritesNoSql) { EXPECT_EQ(offences("app", "QSql|QtSql|sqlite3|[Qq]wt"), kNone); }
/// A new page is a folder and a line in the list of pages: nothing else of the window knows one.
TEST(Layers, theWindowKnowsPagesByTheirListOnly)
{
    const auto found = offences("ui/window", "ui/(?!kit/)[a-z]+/[A-Za-z]*Page\\.h");
    EXPECT_FALSE(found.empty()) << "the list of pages is looked for in the wrong place";
    for (const auto& line : found)
        EXPECT_TRUE(line.starts_with("ui/window/Pages.cpp ")) << line;
}
TEST(Layers, onlyPlotsUseQwt)
{
    for (const auto& line : offences("ui", "[Qq]wt"))
        EXPECT_TRUE(line.starts_with("ui/plots/")) << line;
}

} // namespace
