// What the program is given and where it writes is not always as it should be: a full disk, names that other programs take for more than
// names, control characters, no display, two first users at once.

#include <sys/resource.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <sys/stat.h>

#include "tests/app/Program.h"
#include "tests/app/Published.h"

namespace lubberline::test {

namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

std::string swingOf(const std::string& aircraft)
{
    return "# aircraft: " + aircraft + "\n# compass: standby\n# date: 2026-01-05\n" + kHeader + "0,358\n90,88\n180,181\n270,272\n";
}

mode_t rightsOf(const fs::path& path)
{
    struct stat state = {};
    return ::stat(path.c_str(), &state) == 0 ? state.st_mode & 0777 : 0;
}

class Hostile : public testing::Test {
protected:
    Hostile() { sandbox.write("swing.csv", swingOf("TEST-1")); }
    Sandbox sandbox;
};

} // namespace

TEST_F(Hostile, aFullDiskIsAFailureOfEveryCommand)
{
    ASSERT_EQ(sandbox.run({"import", "swing.csv", "--db", "fleet.db"}).status, 0);
    for (const std::vector<std::string>& command : std::vector<std::vector<std::string>>{{"--help"}, {"--version"}, {"card", "--help"},
             {"analyse", "swing.csv"}, {"analyse", "swing.csv", "--json"}, {"card", "swing.csv"}, {"correct", "swing.csv"},
             {"field", "--lat", "50", "--lon", "20", "--date", "2026-01-01"}, {"swings", "--db", "fleet.db"}, {"due", "--db", "fleet.db"},
             {"db", "status", "--db", "fleet.db"}, {"db", "verify", "--db", "fleet.db"}, {"export", "--db", "fleet.db", "-o", "-"},
             {"report", "swing.csv", "-o", "-", "--format", "json"}}) {
        const auto whole = sandbox.run(command);
        ASSERT_EQ(whole.status, 0) << command[0] << ": " << whole.err;
        const auto full = sandbox.run(command, {}, {}, "/dev/full");
        EXPECT_EQ(full.status, 1) << command[0];
        EXPECT_THAT(full.err, HasSubstr("lubberline: ")) << command[0];
        EXPECT_THAT(full.err, HasSubstr("standard output takes no more")) << command[0];
    }
}

TEST_F(Hostile, everyErrorBeginsWithTheProgramsName)
{
    for (const std::vector<std::string>& command :
        std::vector<std::vector<std::string>>{{"nonsense"}, {"card"}, {"card", "--step", "7", "swing.csv"}, {"--nonsense"},
            {"map", "model.json", "--size", "\x1b[2J"}, {"analyse", "not there.csv"}, {"swings", "--db", "not there.db"}, {"db"}}) {
        const auto outcome = sandbox.run(command);
        EXPECT_THAT(outcome.status, testing::AnyOf(1, 2)) << command[0];
        std::istringstream lines(outcome.err);
        for (std::string line; std::getline(lines, line);)
            EXPECT_THAT(line, testing::StartsWith("lubberline: ")) << command[0];
        EXPECT_THAT(outcome.err, Not(HasSubstr("\x1b"))) << command[0];
    }
}

TEST_F(Hostile, noPdfMakesALibrarySpeak)
{
    const fs::path corpus = fs::path(LUBBERLINE_SAMPLES) / "../../tests/fuzz/corpus/pdf";
    for (const char* name : {"not-a-file.pdf", "names-of-nothing.pdf", "names-in-circles.pdf", "deep.pdf", "encrypted.pdf"}) {
        ASSERT_TRUE(fs::exists(corpus / name)) << name;
        const auto outcome = sandbox.run({"import", (corpus / name).string(), "--db", "pdf.db"});
        EXPECT_EQ(outcome.status, 1) << name;
        EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << name << ": " << outcome.err;
        EXPECT_THAT(outcome.err, testing::StartsWith("lubberline: ")) << name;
    }
}

TEST_F(Hostile, controlCharactersAreShownAndNotSent)
{
    const std::string evil = "E\x1b]0;owned\x07\xe2\x80\xaeVIL\xc2\x9b"; // title of the window, a bell, writing turned about, C1
    sandbox.write("evil.csv", swingOf(evil));
    const auto imported = sandbox.run({"import", "evil.csv", "--db", "fleet.db"});
    ASSERT_EQ(imported.status, 0) << imported.err;
    for (const std::vector<std::string>& command : std::vector<std::vector<std::string>>{{"swings", "--db", "fleet.db"},
             {"swings", "--db", "fleet.db", "--json"}, {"due", "--db", "fleet.db"}, {"fleet", "--db", "fleet.db"},
             {"swings", "--db", "fleet.db", "--aircraft", evil}, {"import", "evil.csv", "--db", "fleet.db"}, {"analyse", evil}}) {
        const auto outcome = sandbox.run(command);
        for (const char* sent : {"\x1b", "\x07", "\xe2\x80\xae", "\xc2\x9b"})
            EXPECT_THAT(outcome.out + outcome.err, Not(HasSubstr(sent))) << command[0] << " " << command.back();
    }
    EXPECT_THAT(sandbox.run({"swings", "--db", "fleet.db"}).out, HasSubstr("E\\u001B]0;owned\\u0007\\u202EVIL\\u009B"));
}

TEST_F(Hostile, theDataFolderIsPrivateAndOutputsFollowTheUmask)
{
    const auto imported = sandbox.run({"import", "swing.csv"});
    ASSERT_EQ(imported.status, 0) << imported.err;
    const fs::path folder = fs::path(sandbox.path(".home")) / "data/lubberline";
    EXPECT_EQ(rightsOf(folder), 0700u);
    EXPECT_EQ(rightsOf(folder / "fleet.lubberline"), 0600u);
    fs::permissions(folder, fs::perms(0755)); // as an older version left them
    fs::permissions(folder / "fleet.lubberline", fs::perms(0644));
    ASSERT_EQ(sandbox.run({"db", "backup", (folder / "copy.lubberline").string()}).status, 0);
    EXPECT_EQ(rightsOf(folder), 0700u);
    for (const auto& entry : fs::directory_iterator(folder))
        EXPECT_EQ(rightsOf(entry.path()), 0600u) << entry.path();
    ASSERT_EQ(sandbox.run({"export", "-o", "out.lubberline.json"}).status, 0);
    const mode_t mask = ::umask(0);
    ::umask(mask);
    EXPECT_EQ(rightsOf(sandbox.path("out.lubberline.json")), 0666u & ~mask);
}

TEST_F(Hostile, theNameOfADatabaseIsTheNameOfAFile)
{
    for (const std::string name :
        {":memory:", "file:x.db?mode=memory", "file::memory:", "file:y.db", "a?b#c%20 d.db", "-wal.db", "w\xc3\xb3z.db", "qrc:z.db"}) {
        const auto imported = sandbox.run({"import", "swing.csv", "--db=" + name});
        EXPECT_EQ(imported.status, 0) << name << ": " << imported.err;
        EXPECT_TRUE(fs::is_regular_file(fs::path(sandbox.path(".")) / name)) << name;
        EXPECT_THAT(sandbox.run({"swings", "--db=" + name}).out, HasSubstr("TEST-1")) << name;
        EXPECT_THAT(sandbox.run({"swings"}, "LUBBERLINE_DB='" + name + "'").out, HasSubstr("TEST-1")) << name;
        const auto copied = sandbox.run({"db", "backup", "--db=" + name, "file:" + std::to_string(name.size()) + name + "?mode=memory"});
        EXPECT_EQ(copied.status, 0) << copied.err;
        EXPECT_TRUE(fs::is_regular_file(fs::path(sandbox.path(".")) / ("file:" + std::to_string(name.size()) + name + "?mode=memory")))
            << name;
    }
}

TEST_F(Hostile, whatIsNoFileIsNoDatabase)
{
    ASSERT_EQ(::mkfifo(sandbox.path("pipe").c_str(), 0600), 0);
    for (const std::string name : {"pipe", "/dev/null", "/dev/zero", "/dev/full"})
        for (const std::vector<std::string>& command : std::vector<std::vector<std::string>>{{"import", "swing.csv"}, {"swings"}}) {
            std::vector<std::string> arguments = command;
            arguments.push_back("--db=" + name);
            const auto outcome = sandbox.run(arguments);
            EXPECT_EQ(outcome.status, 1) << name;
            EXPECT_THAT(outcome.err, HasSubstr(name + ": this is a pipe or a device")) << command[0];
        }
    const std::string other = "b\xff.db"; // one that Qt would change
    const auto refused = sandbox.run({"import", "swing.csv", "--db=" + other});
    EXPECT_EQ(refused.status, 1);
    EXPECT_THAT(refused.err, HasSubstr("is not UTF-8"));
    EXPECT_EQ(sandbox.run({"report", "swing.csv", "-o", "b\xff.pdf"}).status, 1);
    EXPECT_THAT(sandbox.files(), testing::Not(testing::Contains(testing::StartsWith("b"))));
}

TEST_F(Hostile, firstWritersOfOneNewDatabaseAllSucceed)
{
    constexpr int kWriters = 4;
    for (int i = 0; i < kWriters; ++i)
        sandbox.write("swing" + std::to_string(i) + ".csv", swingOf("TEST-" + std::to_string(i)));
    std::string all
        = "for i in 0 1 2 3; do ( '" LUBBERLINE_PROGRAM "' import swing$i.csv --db new.db || echo $i >> failed ) 2>> errors & done; wait";
    ASSERT_EQ(std::system(("cd '" + sandbox.path(".") + "' && " + all).c_str()), 0);
    EXPECT_EQ(sandbox.read("failed"), "") << sandbox.read("errors");
    const auto listed = sandbox.run({"swings", "--db", "new.db"});
    for (int i = 0; i < kWriters; ++i)
        EXPECT_THAT(listed.out, HasSubstr("TEST-" + std::to_string(i)));
    EXPECT_EQ(sandbox.run({"db", "verify", "--db", "new.db"}).status, 0);
}

TEST_F(Hostile, noCommandNeedsADisplay)
{
    ASSERT_EQ(sandbox.run({"import", "swing.csv", "--db", "fleet.db"}).status, 0);
    for (const char* platform : {"QT_QPA_PLATFORM=xcb", "QT_QPA_PLATFORM=wayland", "QT_QPA_PLATFORM=nonsense"}) {
        for (const std::vector<std::string>& command :
            std::vector<std::vector<std::string>>{{"swings", "--db", "fleet.db"}, {"db", "verify", "--db", "fleet.db"},
                {"card", "swing.csv", "-o", "card.pdf"}, {"report", "swing.csv", "-o", "report.pdf"}, {"due", "--db", "fleet.db"}})
            EXPECT_EQ(sandbox.run(command, platform).status, 0) << platform << " " << command[0];
        const auto window = sandbox.run({"--db", "fleet.db"}, platform);
        if (std::string(platform).ends_with("nonsense"))
            continue; // a platform of Qt's own may be called anything
        EXPECT_EQ(window.status, 1);
        EXPECT_EQ(std::count(window.err.begin(), window.err.end(), '\n'), 1) << window.err;
    }
}

TEST_F(Hostile, aTextHasALength)
{
    sandbox.write("long.csv", "# configuration: " + std::string(20'000, 'x') + "\n" + swingOf("TEST-2"));
    for (const char* command : {"analyse", "card"}) {
        const auto outcome = sandbox.run({command, "long.csv"});
        EXPECT_EQ(outcome.status, 1);
        EXPECT_THAT(outcome.err, testing::AllOf(HasSubstr("long.csv:1:"), HasSubstr("20000 bytes; expected at most 10000")));
    }
    sandbox.write("long.csv", "# configuration: " + std::string(9'000, 'x') + "\n" + swingOf("TEST-2"));
    EXPECT_EQ(sandbox.run({"card", "long.csv", "-o", "card.pdf"}).status, 0);
    EXPECT_EQ(sandbox.run({"report", "long.csv", "-o", "report.pdf"}).status, 0);
}

/// What is refused takes no more than 512 MB before it is: by the length of the file, of a text in it, or by what its values would take.
TEST_F(Hostile, aHugeExchangeFileIsRefusedInBoundedMemory)
{
    const std::string head = "{\"format\": \"lubberline\", \"version\": 8, ";
    struct Huge {
        std::string begins, unit, ends;
        std::size_t bytes;
        const char* words;
    };
    const Huge kFiles[] = {
        {head + "\"aircraft\": [", "0,", "0]}", 300'000'000, "is larger than 128 MiB; expected an exchange file"},
        {head + "\"aircraft\": [", "0,", "0]}", 38'000'000, "the values up to here take more than 240 MiB"},
        {head + "\"aircraft\": [", "{},", "0]}", 100'000'000, "the values up to here take more than 240 MiB"},
        {head + "\"aircraft\": [", "{},", "0]}", 9'000'000, "is missing"},
        {head + "\"note\": \"", "a", "\"}", 100'000'000, "holds a text of more than 4 MiB"},
        {"", "[", "", 100'000'000, "is nested too deeply"},
    };
    for (const Huge& huge : kFiles) {
        const std::string path = sandbox.write("huge.lubberline.json", huge.begins);
        {
            std::string some; // a program is started from this one's memory, and its largest counts as that program's
            while (some.size() < 1'000'000)
                some += huge.unit;
            std::ofstream file(sandbox.path("huge.lubberline.json"), std::ios::app | std::ios::binary);
            for (std::size_t written = 0; written < huge.bytes; written += some.size())
                file << some;
            file << huge.ends;
        }
        const auto outcome = sandbox.run({"import", path});
        EXPECT_EQ(outcome.status, 1);
        EXPECT_THAT(outcome.err, HasSubstr(huge.words));
        EXPECT_LT(outcome.err.size(), 1000u);
    }
    rusage usage{};
    ASSERT_EQ(getrusage(RUSAGE_CHILDREN, &usage), 0);
    EXPECT_LT(usage.ru_maxrss, 512 * 1000);
}

TEST_F(Hostile, outOfMemoryIsOneLine)
{
    std::string many = kHeader;
    for (int i = 0; i < 900'000; ++i)
        many += "1,2\n";
    sandbox.write("many.csv", many);
    const std::string limited
        = "cd '" + sandbox.path(".") + "' && ulimit -v 260000 && '" LUBBERLINE_PROGRAM "' analyse many.csv > out 2> err";
    const int status = std::system(("bash -c \"" + limited + "\"").c_str());
    EXPECT_EQ(WEXITSTATUS(status), 1) << sandbox.read("err");
    EXPECT_THAT(sandbox.read("err"), testing::StartsWith("lubberline: there is not enough memory"));
}

} // namespace lubberline::test
