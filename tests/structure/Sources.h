#pragma once
/// The sources as text, for the tests that hold them against the architecture.

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace lubberline::test {

inline std::string textOf(const std::filesystem::path& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

struct Source {
    std::string file; ///< from the root of the repository
    std::string text;
};

/// Every header and source below these folders of the repository.
inline std::vector<Source> sourcesBelow(const std::vector<std::string>& tops)
{
    namespace fs = std::filesystem;
    const fs::path root(LUBBERLINE_SOURCE);
    std::vector<Source> sources;
    for (const std::string& top : tops)
        for (const auto& entry : fs::recursive_directory_iterator(root / top))
            if (entry.path().extension() == ".h" || entry.path().extension() == ".cpp")
                sources.push_back({fs::relative(entry.path(), root).string(), textOf(entry.path())});
    return sources;
}

} // namespace lubberline::test
