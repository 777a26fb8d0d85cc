// There is one way to do a thing, and one place where it is done: the text of the sources is held against the calls that only that place
// may make. Comments do not count.

#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <set>
#include <sstream>

#include "tests/structure/Sources.h"

namespace {

using namespace lubberline::test;
namespace fs = std::filesystem;

struct OneWay {
    const char* name;
    const char* calls;            ///< a regular expression
    std::set<std::string> places; ///< the files that may
};

void PrintTo(const OneWay& way, std::ostream* stream) { *stream << way.name; } // GoogleTest's name for it

const std::vector<OneWay> kWays = {
    {"clock",
        R"(QDateTime::current|QDate::current|QTime::current|system_clock|\btime\((nullptr|NULL|0|&)|\bgettimeofday|CLOCK_REALTIME|\b(local|gm)time(_r)?\(|'now'|CURRENT_(TIMESTAMP|DATE|TIME)\b)",
        {"core/base/Clock.h", "core/base/Clock.cpp"}},
    // The commands, the window and what is opened without another clock.
    {"machineClock", R"(machineClock\()", {"core/base/Clock.h", "core/base/Clock.cpp", "app/Paths.cpp", "db/engine/Database.cpp"}},
    // Besides: a backup that is restored is put in its place.
    {"writingFiles", R"(\bofstream|\bfopen\(|QSaveFile|QFile::rename|::rename\(|QIODevice::WriteOnly *\||\bmkstemp)",
        {"core/base/PartialFile.cpp", "db/transfer/Maintenance.cpp"}},
    // Besides: ten million reports of wind are summed up while the next are read, and their aircraft told two at a time.
    {"threads", R"(QtConcurrent|QFutureWatcher|QThreadPool|QThread::create|public QThread\b|std::j?thread|std::async)",
        {"ui/kit/Worker.h", "ui/kit/Worker.cpp", "core/format/csv/WindHands.h", "core/base/Alongside.h"}},
    {"readingNumbers", R"(\bfrom_chars\b|\bstrto[dflu][a-z]*\(|\bsto[dfilu][a-z]*\(|\bsscanf\b|\bato[fil]\()",
        {"core/base/Number.cpp", "core/base/PlainNumber.cpp"}},
    {"readingJson", R"(\bQJson[A-Z]|\bparse_event_t\b|\bsax_parse\b)", {"core/format/json/JsonDocument.cpp"}},
    {"askingForFiles", R"(QFileDialog\b)", {"ui/kit/Dialogs.h", "ui/kit/Dialogs.cpp"}},
};

/// Without what is said in comments, which may name what the code may not.
std::string codeOf(const std::string& text)
{
    std::istringstream lines(text);
    std::string code;
    for (std::string line; std::getline(lines, line);)
        code += line.substr(0, line.find("//")) + '\n';
    return code;
}

std::vector<std::string> filesThatCall(const std::string& calls)
{
    const std::regex pattern(calls);
    std::vector<std::string> found;
    const auto sources = sourcesBelow({"core", "db", "ui", "app"});
    for (const auto& [file, text] : sources)
        if (std::regex_search(codeOf(text), pattern))
            found.push_back(file);
    EXPECT_GT(sources.size(), 200u) << "the test looks in the wrong place";
    return found;
}

} // namespace

class OneWayOnly : public testing::TestWithParam<OneWay> {};

TEST_P(OneWayOnly, isGoneByEverybody)
{
    const auto& places = GetParam().places;
    std::set<std::string> unused = places;
    for (const std::string& file : filesThatCall(GetParam().calls)) {
        EXPECT_TRUE(places.contains(file)) << file << " goes another way; expected it in " << *places.begin() << " alone";
        unused.erase(file);
    }
    for (const std::string& place : places)
        EXPECT_TRUE(fs::exists(fs::path(LUBBERLINE_SOURCE) / place)) << place << " is not there";
    EXPECT_LT(unused.size(), places.size()) << "nothing is found: the pattern is wrong";
}

INSTANTIATE_TEST_SUITE_P(All, OneWayOnly, testing::ValuesIn(kWays), [](const auto& one) { return std::string(one.param.name); });
