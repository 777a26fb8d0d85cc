#include "tests/app/Program.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include <sys/wait.h>

namespace lubberline::test {

namespace {

std::string slurp(const std::filesystem::path& path)
{
    std::ifstream file(path, std::ios::binary);
    std::ostringstream content;
    content << file.rdbuf();
    return content.str();
}

std::string quoted(const std::string& argument)
{
    std::string result = "'";
    for (const char c : argument)
        result += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return result + "'";
}

} // namespace

Sandbox::Sandbox()
{
    std::string pattern = (std::filesystem::temp_directory_path() / "lubberline-test-XXXXXX").string();
    m_folder = mkdtemp(pattern.data());
    std::filesystem::create_directories(m_folder / ".home");
    std::filesystem::permissions(m_folder / ".home", std::filesystem::perms::owner_all); // as a runtime folder must be
}

Sandbox::~Sandbox()
{
    std::error_code ignored;
    std::filesystem::remove_all(m_folder, ignored);
}

std::string Sandbox::write(const std::string& name, const std::string& content) const
{
    std::ofstream(m_folder / name, std::ios::binary) << content;
    return path(name);
}

std::string Sandbox::read(const std::string& name) const { return slurp(m_folder / name); }

Outcome Sandbox::run(
    const std::vector<std::string>& arguments, const std::string& environment, const std::string& input, const std::string& output) const
{
    const auto home = m_folder / ".home";
    std::string command = "cd " + quoted(m_folder.string())
        + " && env -u DISPLAY -u WAYLAND_DISPLAY -u QT_QPA_PLATFORM -u LUBBERLINE_DB HOME=" + quoted(home.string())
        + " XDG_DATA_HOME=" + quoted((home / "data").string()) + " XDG_RUNTIME_DIR=" + quoted(home.string()) + " " + environment + " "
        + quoted(LUBBERLINE_PROGRAM);
    for (const auto& argument : arguments)
        command += " " + quoted(argument);
    command += " >" + quoted(output.empty() ? (home / "out").string() : output) + " 2>" + quoted((home / "err").string()) + " <"
        + (input.empty() ? "/dev/null" : quoted(path(input)));
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), output.empty() ? slurp(home / "out") : std::string(),
        slurp(home / "err")};
}

std::vector<std::string> Sandbox::files() const
{
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(m_folder))
        if (entry.path().filename() != ".home")
            names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

} // namespace lubberline::test
