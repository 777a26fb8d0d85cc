#include "core/base/OutputFile.h"

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/base/PartialFile.h"
#include "core/base/WholeFile.h"

namespace lubberline {

namespace {

namespace fs = std::filesystem;

constexpr int kMostLinks = 40; ///< as many as the kernel follows (path_resolution(7))

Error outputError(const Message& message, const std::string& path) { return {ErrorCode::Io, message, path}; }

std::string reasonOf(int error) { return std::generic_category().message(error); }

std::optional<struct stat> stateOf(const std::string& path)
{
    struct stat state = {};
    return ::stat(path.c_str(), &state) == 0 ? std::optional(state) : std::nullopt;
}

/// To who the program acts as, which access(2) does not ask.
bool allows(const std::string& path, int what) { return ::faccessat(AT_FDCWD, path.c_str(), what, AT_EACCESS) == 0; }

/// What is wrong with it when it is no plain file.
Pattern kindOf(const struct stat& state)
{
    switch (state.st_mode & S_IFMT) {
    case S_IFDIR: return MARKED("core", "this is a folder; expected the name of a file to write");
    case S_IFIFO: return MARKED("core", "this is a pipe; expected the name of a file to write");
    case S_IFSOCK: return MARKED("core", "this is a socket; expected the name of a file to write");
    default: return MARKED("core", "this is a device; expected the name of a file to write");
    }
}

/// The file that a symbolic link names in the end, there or not: the link itself must not be replaced.
Result<fs::path> targetOf(const std::string& path)
{
    fs::path target(path);
    std::error_code error;
    for (int links = 0; fs::is_symlink(fs::symlink_status(target, error)); ++links) {
        const fs::path next = fs::read_symlink(target, error);
        if (error || links == kMostLinks)
            return outputError(MARKED("core", "this is a link that leads to no file; expected the name of a file to write"), path);
        target = target.parent_path() / next; // an absolute one replaces the whole
    }
    return target;
}

fs::path folderOf(const fs::path& target) { return target.has_parent_path() ? target.parent_path() : fs::path("."); }

Result<void> checkFolder(const fs::path& folder, const std::string& path)
{
    const auto state = stateOf(folder.string());
    if (!state)
        return outputError(
            {MARKED("core", "the folder %1 does not exist; expected an existing folder to write into"), folder.string()}, path);
    if (!S_ISDIR(state->st_mode))
        return outputError({MARKED("core", "%1 is not a folder; expected a folder to write into"), folder.string()}, path);
    if (!allows(folder.string(), W_OK | X_OK))
        return outputError({MARKED("core", "the folder %1 takes no new file (%2); expected a folder that may be written to"),
                               folder.string(), reasonOf(errno)},
            path);
    return {};
}

Result<void> checkExisting(const struct stat& file, const std::string& path, const std::vector<std::string>& inputs)
{
    if (!S_ISREG(file.st_mode))
        return outputError(kindOf(file), path);
    for (const auto& input : inputs)
        if (const auto other = stateOf(input); other && other->st_dev == file.st_dev && other->st_ino == file.st_ino)
            return Error{ErrorCode::InvalidInput,
                {MARKED("core", "this is the same file as %1, which is read; expected another name"), input}, path};
    if (!allows(path, W_OK))
        return outputError(
            {MARKED("core", "this file may not be written (%1); expected one that may, or another name"), reasonOf(errno)}, path);
    return {};
}

bool takeRights(int handle, const struct stat& file)
{
    const bool owned = ::fchown(handle, file.st_uid, file.st_gid) == 0; // another user's file: the new one is ours
    return ::fchmod(handle, file.st_mode & (owned ? 07777 : 0777)) == 0;
}

bool write(int handle, std::string_view content)
{
    while (!content.empty()) {
        const auto written = ::write(handle, content.data(), content.size());
        if (written < 0 && errno != EINTR)
            return false;
        if (written > 0)
            content.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
}

/// So that the new name outlives a power cut; the file is there in any case.
void keepFolder(const fs::path& folder)
{
    if (const int handle = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC); handle >= 0) {
        ::fsync(handle);
        ::close(handle);
    }
}

Error writingError(int error, const fs::path& folder, const std::string& path)
{
    if (error == ENOSPC || error == EDQUOT)
        return {ErrorCode::Full,
            {MARKED("core", "there is no room for it in the folder %1; expected a drive with free space"), folder.string()}, path};
    return outputError(
        {MARKED("core", "cannot be written into the folder %1 (%2); expected a drive that takes it"), folder.string(), reasonOf(error)},
        path);
}

} // namespace

Result<void> checkOutput(const std::string& path, const std::vector<std::string>& inputs)
{
    if (isStandardStream(path))
        return {};
    if (path.empty())
        return outputError(MARKED("core", "there is no name; expected the name of a file to write"), path);
    if (const auto file = stateOf(path))
        if (const auto allowed = checkExisting(*file, path, inputs); !allowed)
            return allowed;
    const auto target = targetOf(path);
    if (!target)
        return target.error();
    if (!target->has_filename())
        return outputError(MARKED("core", "this is the name of a folder; expected the name of a file to write"), path);
    return checkFolder(folderOf(*target), path);
}

Result<void> writeWholeFile(const std::string& path, std::string_view content, const std::vector<std::string>& inputs)
{
    if (isStandardStream(path)) {
        if (std::fwrite(content.data(), 1, content.size(), stdout) != content.size() || std::fflush(stdout) != 0)
            return Error{ErrorCode::Io, MARKED("core", "standard output takes no more; expected one that is read to its end"), path};
        return {};
    }
    if (const auto allowed = checkOutput(path, inputs); !allowed)
        return allowed;
    const auto target = targetOf(path);
    if (!target)
        return target.error();
    const fs::path folder = folderOf(*target);
    PartialFile beside(folder.string());
    if (!beside.isOpen())
        return outputError({MARKED("core", "the folder %1 takes no new file (%2); expected a folder that may be written to"),
                               folder.string(), reasonOf(errno)},
            path);
    const auto before = stateOf(target->string());
    if ((before && !takeRights(beside.handle(), *before)) || !write(beside.handle(), content) || !beside.finish()
        || !beside.renameTo(target->string()))
        return writingError(errno, folder, path);
    keepFolder(folder);
    return {};
}

} // namespace lubberline
