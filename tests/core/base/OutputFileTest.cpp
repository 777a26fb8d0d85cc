// Files are written whole or not at all, and never over what is no plain file or is read by the one who writes.

#include "core/base/OutputFile.h"

#include <gmock/gmock.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

namespace lubberline {

namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class OutputFile : public testing::Test {
protected:
    OutputFile()
    {
        std::string pattern = (fs::temp_directory_path() / "lubberline-output-XXXXXX").string();
        m_folder = mkdtemp(pattern.data());
        fs::permissions(m_folder, fs::perms(0755));
    }
    ~OutputFile() override { fs::remove_all(m_folder); }

    [[nodiscard]] std::string path(const std::string& name) const { return (m_folder / name).string(); }
    std::string made(const std::string& name, const std::string& content) const
    {
        std::ofstream(path(name), std::ios::binary) << content;
        return path(name);
    }
    [[nodiscard]] std::string content(const std::string& name) const
    {
        std::ostringstream text;
        text << std::ifstream(path(name), std::ios::binary).rdbuf();
        return text.str();
    }
    [[nodiscard]] std::size_t count() const
    {
        return static_cast<std::size_t>(std::distance(fs::directory_iterator(m_folder), fs::directory_iterator()));
    }
    /// One error that names the file and what was expected, and not a file more or less than before.
    void expectRefused(
        const std::string& path, const std::string& says, const std::vector<std::string>& inputs = {}, ErrorCode code = ErrorCode::Io) const
    {
        const auto before = count();
        const auto checked = checkOutput(path, inputs);
        const auto written = writeWholeFile(path, "new", inputs);
        ASSERT_FALSE(written) << path;
        ASSERT_FALSE(checked) << path;
        EXPECT_EQ(describe(checked.error()), describe(written.error()));
        EXPECT_EQ(written.error().code, code);
        EXPECT_EQ(written.error().file, path);
        EXPECT_THAT(describe(written.error()), testing::AllOf(HasSubstr(says), HasSubstr("expected")));
        EXPECT_EQ(count(), before);
    }

    fs::path m_folder;
};

/// Rights mean nothing to root: who runs as root is somebody else for a moment.
class NotRoot {
public:
    NotRoot() : m_wasRoot(geteuid() == 0)
    {
        if (m_wasRoot && seteuid(65534) != 0)
            std::abort();
    }
    ~NotRoot()
    {
        if (m_wasRoot && seteuid(0) != 0)
            std::abort();
    }
    NotRoot(const NotRoot&) = delete;
    NotRoot& operator=(const NotRoot&) = delete;

private:
    bool m_wasRoot;
};

} // namespace

TEST_F(OutputFile, isWrittenWhole)
{
    const std::string text("a\0b\n", 4);
    ASSERT_TRUE(writeWholeFile(path("new"), text));
    EXPECT_EQ(content("new"), text);
    ASSERT_TRUE(writeWholeFile(path("new"), ""));
    EXPECT_EQ(content("new"), "");
    EXPECT_EQ(count(), 1u);
}

TEST_F(OutputFile, hasTheRightsOfItsTime)
{
    const mode_t before = umask(027);
    ASSERT_TRUE(writeWholeFile(path("new"), "x"));
    umask(before);
    EXPECT_EQ(fs::status(path("new")).permissions(), fs::perms(0640));
    fs::permissions(path("new"), fs::perms(0606));
    ASSERT_TRUE(writeWholeFile(path("new"), "y"));
    EXPECT_EQ(fs::status(path("new")).permissions(), fs::perms(0606));
    EXPECT_EQ(content("new"), "y");
}

TEST_F(OutputFile, ofALinkReplacesWhatTheLinkNames)
{
    fs::create_directory(path("other"));
    made("other/real", "old");
    fs::create_symlink("other/real", path("one"));
    fs::create_symlink(path("one"), path("two"));
    ASSERT_TRUE(writeWholeFile(path("two"), "new"));
    EXPECT_EQ(content("other/real"), "new");
    EXPECT_TRUE(fs::is_symlink(path("one")) && fs::is_symlink(path("two")));
    fs::create_symlink("other/notYet", path("three"));
    ASSERT_TRUE(writeWholeFile(path("three"), "made"));
    EXPECT_EQ(content("other/notYet"), "made");
    fs::create_symlink("loop", path("loop"));
    expectRefused(path("loop"), "leads to no file");
}

TEST_F(OutputFile, isNoFolderDevicePipeOrSocket)
{
    fs::create_directory(path("folder"));
    fs::create_symlink("folder", path("linked"));
    expectRefused(path("folder"), "this is a folder");
    expectRefused(path("linked"), "this is a folder");
    expectRefused(path("missing/"), "folder");
    expectRefused("", "no name");
    ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);
    expectRefused(path("pipe"), "this is a pipe"); // nobody reads it: who opened it would wait for ever
    expectRefused("/dev/full", "this is a device");
    expectRefused("/dev/null", "this is a device");
    const int handle = socket(AF_UNIX, SOCK_STREAM, 0);
    sockaddr_un address = {};
    address.sun_family = AF_UNIX;
    path("socket").copy(address.sun_path, sizeof address.sun_path - 1);
    ASSERT_EQ(bind(handle, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    expectRefused(path("socket"), "this is a socket");
    close(handle);
}

TEST_F(OutputFile, isNoneOfTheInputsUnderWhateverName)
{
    const std::string input = made("input.csv", "typed");
    fs::create_symlink("input.csv", path("symlink.csv"));
    fs::create_hard_link(input, path("hard.csv"));
    const auto relative = fs::relative(input).string();
    for (const auto& name : {input, path("symlink.csv"), path("hard.csv"), relative, path("./input.csv")}) {
        expectRefused(name, "which is read", {path("gone.csv"), input}, ErrorCode::InvalidInput);
        expectRefused(input, "which is read", {name}, ErrorCode::InvalidInput);
    }
    EXPECT_EQ(content("input.csv"), "typed");
    EXPECT_TRUE(writeWholeFile(path("another.csv"), "new", {input}));
}

TEST_F(OutputFile, needsAFolderThatTakesIt)
{
    made("file", "x");
    expectRefused(path("no/such.csv"), path("no") + " does not exist");
    expectRefused(path("file/new.csv"), path("file") + " is not a folder");
    fs::create_directory(path("closed"));
    made("closed/old.csv", "old");
    fs::permissions(path("closed"), fs::perms(0555));
    made("kept.csv", "kept");
    fs::permissions(path("kept.csv"), fs::perms(0444));
    {
        const NotRoot somebody;
        expectRefused(path("closed/new.csv"), "takes no new file");
        expectRefused(path("closed/old.csv"), "written");
        expectRefused(path("kept.csv"), "may not be written");
    }
    fs::permissions(path("closed"), fs::perms(0755));
    EXPECT_EQ(content("closed/old.csv"), "old");
    EXPECT_EQ(content("kept.csv"), "kept");
}

TEST_F(OutputFile, thatDoesNotFitLeavesTheOldOne)
{
    made("old", "old");
    rlimit before = {};
    ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit small{1000, before.rlim_max};
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
    const auto written = writeWholeFile(path("old"), std::string(5000, 'x')); // stops half-way, as on a drive that fills up
    setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, handler);
    ASSERT_FALSE(written);
    EXPECT_THAT(describe(written.error()), testing::AllOf(HasSubstr(path("old")), HasSubstr("cannot be written"), HasSubstr("expected")));
    EXPECT_EQ(content("old"), "old");
    EXPECT_EQ(count(), 1u);
}

} // namespace lubberline
