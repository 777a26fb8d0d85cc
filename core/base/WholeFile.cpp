#include "core/base/WholeFile.h"

#include <filesystem>
#include <fstream>
#include <vector>

namespace lubberline {

Result<std::string> readWholeFile(const std::string& path, const std::string& expected)
{
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored))
        return Error{ErrorCode::Io, "is a folder; expected " + expected, path};
    std::ifstream file(path, std::ios::binary);
    if (!file)
        return Error{ErrorCode::Io, "cannot be opened; expected " + expected + " that exists and may be read", path};
    std::string text;
    std::vector<char> block(std::size_t{1} << 16);
    while (file.read(block.data(), static_cast<std::streamsize>(block.size())), file.gcount() > 0) {
        text.append(block.data(), static_cast<std::size_t>(file.gcount()));
        if (text.size() > kMaxWholeFileBytes)
            return Error{
                ErrorCode::Format, "is larger than " + std::to_string(kMaxWholeFileBytes >> 20) + " MiB; expected " + expected, path};
    }
    if (file.bad())
        return Error{ErrorCode::Io, "cannot be read to its end", path};
    return text;
}

} // namespace lubberline
