// Linked into the program that tests kill. LUBBERLINE_KILL_AT=n: it is killed at its n-th call that changes a file, which is then not
// done; a write is done by half. So each moment of a migration or a signature can be tried, and none is left to chance.

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstdlib>

#include <fcntl.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace {

/// Whether this is the call.
bool now()
{
    static const long wanted = [] {
        const char* number = std::getenv("LUBBERLINE_KILL_AT");
        return number ? std::atol(number) : 0;
    }();
    static std::atomic<long> calls{0};
    return wanted > 0 && ++calls == wanted;
}

[[noreturn]] void end()
{
    for (;;)
        raise(SIGKILL);
}

long writeAt(int file, const void* bytes, size_t size, off64_t at)
{
    if (!now())
        return syscall(SYS_pwrite64, file, bytes, size, at);
    syscall(SYS_pwrite64, file, bytes, size / 2, at);
    end();
}

} // namespace

// In place of those of the C library; nothing of what calls them is told.
extern "C" {
ssize_t pwrite64(int file, const void* bytes, size_t size, off64_t at) { return writeAt(file, bytes, size, at); }
ssize_t pwrite(int file, const void* bytes, size_t size, off_t at) { return writeAt(file, bytes, size, at); }

ssize_t write(int file, const void* bytes, size_t size)
{
    if (!now())
        return syscall(SYS_write, file, bytes, size);
    syscall(SYS_write, file, bytes, size / 2);
    end();
}

int fsync(int file) { return now() ? (end(), 0) : static_cast<int>(syscall(SYS_fsync, file)); }
int fdatasync(int file) { return now() ? (end(), 0) : static_cast<int>(syscall(SYS_fdatasync, file)); }
int unlink(const char* path) noexcept { return now() ? (end(), 0) : static_cast<int>(syscall(SYS_unlinkat, AT_FDCWD, path, 0)); }
int rename(const char* from, const char* to) noexcept
{
    return now() ? (end(), 0) : static_cast<int>(syscall(SYS_renameat2, AT_FDCWD, from, AT_FDCWD, to, 0));
}
int ftruncate64(int file, off64_t size) noexcept { return now() ? (end(), 0) : static_cast<int>(syscall(SYS_ftruncate, file, size)); }
int ftruncate(int file, off_t size) noexcept { return now() ? (end(), 0) : static_cast<int>(syscall(SYS_ftruncate, file, size)); }

} // extern "C"
