#include "core/base/WholeFile.h"

#include <filesystem>
#include <fstream>
#include <iostream>
#include <vector>

namespace lubberline {

std::string nameOfInput(const std::string& path) { return isStandardStream(path) ? "standard input" : path; }

Result<std::unique_ptr<std::istream>> openInput(const std::string& path, const Message& expected)
{
    if (isStandardStream(path))
        return std::make_unique<std::istream>(std::cin.rdbuf());
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored))
        return Error{ErrorCode::Io, {MARKED("core", "is a folder; expected %1"), expected}, path};
    auto file = std::make_unique<std::ifstream>(path, std::ios::binary);
    if (!*file)
        return Error{ErrorCode::Io, {MARKED("core", "cannot be opened; expected %1 that exists and may be read"), expected}, path};
    return std::unique_ptr<std::istream>(std::move(file));
}

Result<std::string> readWholeFile(const std::string& path, const Message& expected, std::size_t mostBytes)
{
    const auto file = openInput(path, expected);
    if (!file)
        return file.error();
    const std::string name = nameOfInput(path);
    const Error tooLarge{ErrorCode::Format, {MARKED("core", "is larger than %1 MiB; expected %2"), mostBytes >> 20, expected}, name};
    std::error_code unknown;
    const auto size = isStandardStream(path) ? 0 : std::filesystem::file_size(path, unknown);
    if (!unknown && size > mostBytes)
        return tooLarge;
    std::string text;
    if (!unknown)
        text.reserve(size);
    std::vector<char> block(std::size_t{1} << 16);
    while ((*file)->read(block.data(), static_cast<std::streamsize>(block.size())), (*file)->gcount() > 0) {
        text.append(block.data(), static_cast<std::size_t>((*file)->gcount()));
        if (text.size() > mostBytes)
            return tooLarge;
    }
    if ((*file)->bad())
        return Error{ErrorCode::Io, MARKED("core", "cannot be read to its end"), name};
    return text;
}

} // namespace lubberline
