// Every command that writes a file refuses what it reads and what is no plain file, in one line, and changes nothing.

#include <gmock/gmock.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include <sys/stat.h>

#include "core/nmea/NmeaSentence.h"
#include "tests/app/Program.h"
#include "tests/app/Published.h"

namespace lubberline::test {

namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

const std::string kSwing = "# aircraft: TEST-1\n# compass: standby\n# date: 2026-01-05\n" + kHeader + "0,358\n90,88\n180,181\n270,272\n";

/// A circle at 1°/s of a compass that reads 2° low.
std::string turnLog()
{
    std::string log;
    for (int second = 0; second < 360; second += 10) {
        char body[128];
        std::snprintf(body, sizeof body, "GPRMC,10%02d%02d,A,5210.00,N,02057.00,E,8.0,%d.0,231125,6.0,E", second / 60, second % 60,
            (second + 6) % 360);
        log += makeNmea(body) + "\r\n";
        std::snprintf(body, sizeof body, "HCHDG,%d.0,,,,", (second + 358) % 360);
        log += makeNmea(body) + "\r\n";
    }
    return log;
}

/// Each with the ending of its output last, so that all are tried with every kind of place.
struct Writer {
    std::vector<std::string> command;
    std::string input; ///< that it reads, in the sandbox
    std::string ending;
};

class Outputs : public testing::Test {
protected:
    Outputs()
    {
        sandbox.write("swing.csv", kSwing);
        sandbox.write("model.json", R"({"field": {"H_nT": 18500, "dip_deg": 67}})");
        sandbox.write("log.nmea", turnLog());
        fs::copy_file(LUBBERLINE_SAMPLES "/example-airframe.json", sandbox.path("bench.json"));
        const auto imported = sandbox.run({"import", "swing.csv", "--db", "fleet.db"});
        EXPECT_EQ(imported.status, 0) << imported.err;
    }
    [[nodiscard]] std::vector<Writer> writers() const
    {
        return {{{"report", "swing.csv", "-o"}, "swing.csv", ".csv"}, {{"card", "swing.csv", "-o"}, "swing.csv", ".pdf"},
            {{"simulate", "model.json", "-o"}, "model.json", ".json"}, {{"map", "model.json", "--size", "5x5", "-o"}, "model.json", ".png"},
            {{"iron", "bench.json", "--H-nT", "18500", "--dip-deg", "67", "-o"}, "bench.json", ".json"},
            {{"nmea", "log.nmea", "-o"}, "log.nmea", ".csv"}, {{"export", "--db", "fleet.db", "-o"}, "fleet.db", ".json"},
            {{"due", "--db", "fleet.db", "--ics"}, "fleet.db", ".ics"},
            {{"predict", "model.json", "--lat", "50", "--lon", "20", "--date", "2026-01-01", "-o"}, "model.json", ".csv"}};
    }
    void expectRefused(const Writer& writer, const std::string& output, const std::string& says) const
    {
        const auto before = sandbox.files();
        const auto content = sandbox.read(writer.input);
        auto command = writer.command;
        command.push_back(output);
        const auto outcome = sandbox.run(command);
        EXPECT_EQ(outcome.status, 1) << command[0] << ": " << outcome.err;
        EXPECT_EQ(outcome.out, "");
        EXPECT_THAT(outcome.err, testing::AllOf(HasSubstr("lubberline: " + output + ": "), HasSubstr(says), HasSubstr("expected")));
        EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
        EXPECT_EQ(sandbox.files(), before);
        EXPECT_EQ(sandbox.read(writer.input), content);
    }

    const Sandbox sandbox;
};

} // namespace

TEST_F(Outputs, areNeverWhatTheCommandReads)
{
    for (const auto& writer : writers()) {
        const auto link = "symlink" + writer.ending, hard = "hard" + writer.ending;
        fs::create_symlink(writer.input, sandbox.path(link));
        fs::create_hard_link(sandbox.path(writer.input), sandbox.path(hard));
        expectRefused(writer, link, "which is read");
        expectRefused(writer, hard, "which is read");
        expectRefused(writer, "./.home/../" + hard, "which is read");
        fs::remove(sandbox.path(link));
        fs::remove(sandbox.path(hard));
    }
    expectRefused({{"simulate", "model.json", "-o"}, "model.json", ".json"}, "model.json", "which is read");
    sandbox.write("second.csv", kSwing);
    fs::create_symlink("second.csv", sandbox.path("card.pdf"));
    expectRefused({{"card", "swing.csv", "--second", "second.csv", "-o"}, "second.csv", ".pdf"}, "card.pdf", "which is read");
}

TEST_F(Outputs, areNeverAFolderAPipeOrADevice)
{
    for (const auto& writer : writers()) {
        const auto folder = "folder" + writer.ending, pipe = "pipe" + writer.ending, full = "full" + writer.ending;
        fs::create_directory(sandbox.path(folder));
        ASSERT_EQ(mkfifo(sandbox.path(pipe).c_str(), 0600), 0);
        fs::create_symlink("/dev/full", sandbox.path(full));
        expectRefused(writer, folder, "this is a folder");
        expectRefused(writer, pipe, "this is a pipe");
        expectRefused(writer, full, "this is a device");
        for (const auto& name : {folder, pipe, full})
            fs::remove(sandbox.path(name));
        expectRefused(writer, "/dev/null", "this is a device"); // whatever it is called
        expectRefused(writer, ".", "this is a folder");
        expectRefused(writer, "no/out" + writer.ending, "the folder no does not exist");
        expectRefused(writer, writer.input + "/out" + writer.ending, writer.input + " is not a folder");
    }
}

TEST_F(Outputs, goToStandardOutputWhereThereIsOneFormat)
{
    const auto exported = sandbox.run({"export", "--db", "fleet.db", "-o", "-"});
    EXPECT_EQ(exported.status, 0) << exported.err;
    EXPECT_EQ(sandbox.run({"export", "--db", "fleet.db", "-o", "fleet.lubberline.json"}).status, 0);
    EXPECT_EQ(exported.out, sandbox.read("fleet.lubberline.json"));
    const auto calendar = sandbox.run({"due", "--db", "fleet.db", "--ics", "-"});
    EXPECT_THAT(calendar.out, HasSubstr("BEGIN:VCALENDAR"));
    EXPECT_FALSE(fs::exists(sandbox.path("-")));
}

/// For all commands alike: usage, before any work.
TEST_F(Outputs, haveAKnownEnding)
{
    for (const auto& writer : writers())
        for (const std::string& name : {std::string("out.xyz"), std::string("out"), "out" + writer.ending + ".bak"}) {
            auto command = writer.command;
            command.push_back(name);
            const auto outcome = sandbox.run(command);
            EXPECT_EQ(outcome.status, 2) << command[0] << outcome.err;
            EXPECT_THAT(outcome.err, testing::AllOf(HasSubstr("\"" + name + "\" has another ending"), HasSubstr(writer.ending)));
            EXPECT_FALSE(fs::exists(sandbox.path(name)));
        }
    EXPECT_EQ(sandbox.run({"simulate", "model.json", "-o", "OUT.CSV"}).status, 0); // as some systems write them
    EXPECT_EQ(sandbox.run({"db", "backup", "-", "--db", "fleet.db"}).status, 2);
    EXPECT_EQ(sandbox.run({"demo", "--no-window", "-o", "-"}).status, 2);
    EXPECT_EQ(sandbox.run({"swings", "--db", "-"}).status, 1);
    EXPECT_FALSE(fs::exists(sandbox.path("-")));
}

TEST_F(Outputs, ofEveryCommandGoToStandardOutput)
{
    for (auto writer : writers()) {
        auto toFile = writer.command;
        toFile.push_back("file" + writer.ending);
        ASSERT_EQ(sandbox.run(toFile).status, 0) << writer.command[0];
        writer.command.push_back("-");
        const bool several = writer.command[0] == "report" || writer.command[0] == "simulate" || writer.command[0] == "map"
            || writer.command[0] == "predict";
        if (several)
            writer.command.insert(writer.command.end(), {"--format", writer.ending.substr(1)});
        const auto outcome = sandbox.run(writer.command);
        EXPECT_EQ(outcome.status, 0) << writer.command[0] << ": " << outcome.err;
        if (writer.ending == ".pdf") { // its identity is another one each time
            EXPECT_THAT(outcome.out, testing::StartsWith("%PDF-"));
        } else {
            EXPECT_EQ(outcome.out, sandbox.read("file" + writer.ending)) << writer.command[0];
        }
    }
    EXPECT_THAT(sandbox.run({"report", "swing.csv", "-o", "-"}).out, testing::StartsWith("%PDF-"));
    EXPECT_EQ(sandbox.run({"report", "swing.csv", "-o", "out.pdf", "--format", "csv"}).status, 2);
    EXPECT_EQ(sandbox.run({"report", "swing.csv", "-o", "-", "--format", "docx"}).status, 2);
    EXPECT_FALSE(fs::exists(sandbox.path("-")));
}

TEST_F(Outputs, inputsAreTakenFromStandardInput)
{
    const std::vector<std::pair<std::vector<std::string>, std::string>> readers{{{"analyse", "-", "--json"}, "swing.csv"},
        {{"correct", "-", "--json"}, "swing.csv"}, {{"card", "-", "--json"}, "swing.csv"}, {{"smith", "-", "--json"}, "model.json"},
        {{"simulate", "-", "--json"}, "model.json"}, {{"map", "model.json", "--minus", "-", "--size", "5x5"}, "model.json"},
        {{"predict", "-", "--lat", "50", "--lon", "20", "--date", "2026-01-01", "--json"}, "model.json"},
        {{"iron", "-", "--json"}, "bench.json"}, {{"nmea", "-", "--json"}, "log.nmea"}};
    for (const auto& [command, input] : readers) {
        auto named = command;
        std::replace(named.begin(), named.end(), std::string("-"), input);
        const auto expected = sandbox.run(named), outcome = sandbox.run(command, {}, input);
        EXPECT_EQ(outcome.status, 0) << command[0] << ": " << outcome.err;
        EXPECT_EQ(expected.status, 0) << expected.err;
        if (command[0] != "map") { // which names its models
            EXPECT_EQ(outcome.out, expected.out) << command[0];
        }
    }
    EXPECT_EQ(sandbox.run({"export", "--db", "fleet.db", "-o", "fleet.json"}).status, 0);
    EXPECT_EQ(sandbox.run({"report", "swing.csv", "-o", "report.pdf"}).status, 0);
    for (const std::string input : {"swing.csv", "fleet.json", "report.pdf"}) {
        const auto imported = sandbox.run({"import", "-", "--db", "again-" + input + ".db"}, {}, input);
        EXPECT_EQ(imported.status, 0) << imported.err;
        EXPECT_THAT(imported.err, HasSubstr("stored 1 new swing of")) << input;
    }
    const auto twice = sandbox.run({"map", "-", "--minus", "-"}, {}, "model.json");
    EXPECT_EQ(twice.status, 1);
    EXPECT_THAT(twice.err, HasSubstr("standard input (-) is named twice"));
    sandbox.write("bad.csv", kHeader + "0,x\n");
    EXPECT_THAT(sandbox.run({"analyse", "-"}, {}, "bad.csv").err, HasSubstr("lubberline: standard input:2: compass_heading_deg"));
    EXPECT_FALSE(fs::exists(sandbox.path("-")));
}

TEST_F(Outputs, keepTheRightsOfWhatTheyReplace)
{
    fs::permissions(sandbox.write("out.csv", "old"), fs::perms(0606));
    ASSERT_EQ(sandbox.run({"report", "swing.csv", "-o", "out.csv"}).status, 0);
    EXPECT_EQ(fs::status(sandbox.path("out.csv")).permissions(), fs::perms(0606));
    EXPECT_THAT(sandbox.read("out.csv"), testing::Not(testing::StartsWith("old")));
}

} // namespace lubberline::test
