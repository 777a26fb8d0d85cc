#pragma once
/// Runs the built program as a user would and keeps what it said.

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace lubberline::test {

struct Outcome {
    int status = -1;
    std::string out;
    std::string err;
    [[nodiscard]] nlohmann::json json() const { return nlohmann::json::parse(out); }
};

/// Each test gets a folder of its own, removed afterwards, and a home inside it: nothing of the user's is touched.
class Sandbox {
public:
    Sandbox();
    ~Sandbox();
    Sandbox(const Sandbox&) = delete;
    Sandbox& operator=(const Sandbox&) = delete;

    [[nodiscard]] std::string path(const std::string& name) const { return (m_folder / name).string(); }
    /// Writes a file into the folder. @return its path.
    std::string write(const std::string& name, const std::string& content) const;
    [[nodiscard]] std::string read(const std::string& name) const;
    /// Runs `lubberline ARGUMENTS…` in the folder, without a display. @param input a file of the folder, for standard input
    /// @param output where standard output goes instead of into the outcome
    [[nodiscard]] Outcome run(const std::vector<std::string>& arguments, const std::string& environment = {}, const std::string& input = {},
        const std::string& output = {}) const;
    [[nodiscard]] std::vector<std::string> files() const;

private:
    std::filesystem::path m_folder;
};

} // namespace lubberline::test
