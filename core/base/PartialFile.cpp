#include "core/base/PartialFile.h"

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <random>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace lubberline {

namespace {

namespace fs = std::filesystem;

constexpr int kMostNames = 1000; ///< tried for one file: those that other programs write are passed over
constexpr std::string_view kBeginning = ".lubberline-", kEnding = ".partial", kJournal = "-journal";

bool isPartial(const std::string& name)
{
    // SQLite keeps a journal beside a copy that it makes.
    const std::string_view whole(name), ending = whole.ends_with(kJournal) ? whole.substr(0, whole.size() - kJournal.size()) : whole;
    return whole.starts_with(kBeginning) && ending.ends_with(kEnding);
}

/// One of ours that nobody writes; a journal is that of the file beside it.
void removeIfLeft(const std::string& path)
{
    const std::string whole = path.ends_with(kJournal) ? path.substr(0, path.size() - kJournal.size()) : path;
    const int handle = ::open(whole.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (handle < 0) {
        if (errno == ENOENT && whole != path)
            ::unlink(path.c_str());
        return;
    }
    struct stat state = {};
    if (::fstat(handle, &state) == 0 && S_ISREG(state.st_mode) && state.st_uid == ::geteuid() && ::flock(handle, LOCK_EX | LOCK_NB) == 0)
        ::unlink(path.c_str());
    ::close(handle);
}

bool isStillThere(int handle)
{
    struct stat state = {};
    return ::fstat(handle, &state) == 0 && state.st_nlink > 0;
}

} // namespace

PartialFile::PartialFile(const std::string& folder)
{
    removeLeftovers(folder);
    std::random_device random;
    for (int tries = 0; m_handle < 0 && tries < kMostNames; ++tries) {
        m_name = (fs::path(folder) / (std::string(kBeginning) + std::to_string(random()) + std::string(kEnding))).string();
        m_handle = ::open(m_name.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666); // less what the user's umask takes away
        if (m_handle < 0 && errno != EEXIST)
            break;
        // Between both calls another program may have taken it for one that was left.
        if (m_handle >= 0 && (::flock(m_handle, LOCK_EX) != 0 || !isStillThere(m_handle))) {
            const bool locks = isStillThere(m_handle); // a file system without locks: nobody takes it away either
            if (!locks) {
                ::close(m_handle);
                m_handle = -1;
            }
        }
    }
    m_left = m_handle >= 0;
}

PartialFile::~PartialFile()
{
    if (m_left)
        ::unlink(m_name.c_str());
    if (m_handle >= 0)
        ::close(m_handle);
}

bool PartialFile::finish()
{
    return ::fsync(m_handle) == 0 || errno == EINVAL; // a file system without it
}

bool PartialFile::renameTo(const std::string& target)
{
    m_left = std::rename(m_name.c_str(), target.c_str()) != 0;
    if (m_left)
        return false;
    const int handle = m_handle;
    m_handle = -1;
    ::close(handle);
    return true;
}

void removeLeftovers(const std::string& folder)
{
    std::error_code error;
    for (fs::directory_iterator at(folder, fs::directory_options::skip_permission_denied, error), end; !error && at != end;
         at.increment(error))
        if (const std::string name = at->path().filename().string(); isPartial(name))
            removeIfLeft(at->path().string());
}

} // namespace lubberline
