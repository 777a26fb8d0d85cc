#include "ui/recovery/PrivateFile.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <cerrno>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace lubberline::ui {

namespace {

constexpr qint64 kMost_bytes = 16 << 20;

class Handle {
public:
    explicit Handle(int handle) : m_handle(handle) {}
    ~Handle()
    {
        if (m_handle >= 0)
            ::close(m_handle);
    }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    [[nodiscard]] int get() const { return m_handle; }
    [[nodiscard]] bool valid() const { return m_handle >= 0; }

private:
    int m_handle;
};

bool isOursAlone(const struct stat& state) { return state.st_uid == ::geteuid() && (state.st_mode & (S_IWGRP | S_IWOTH)) == 0; }

Error refused(Pattern why, const QString& path) { return {ErrorCode::Io, why, path.toStdString()}; }

/// The folder by its handle, so that what is opened in it is what was looked at.
Result<int> openFolder(const QString& path)
{
    const QString folder = QFileInfo(path).absolutePath();
    const int handle = ::open(QFile::encodeName(folder).constData(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    struct stat state = {};
    if (handle < 0)
        return refused(MARKED("ui", "its folder cannot be opened; expected a folder of the user's own"), path);
    if (::fstat(handle, &state) == 0 && isOursAlone(state))
        return handle;
    ::close(handle);
    return refused(MARKED("ui", "others may write into its folder; expected a folder of the user's own"), path);
}

Result<void> check(int file, const QString& path)
{
    struct stat state = {};
    if (::fstat(file, &state) != 0 || !S_ISREG(state.st_mode))
        return refused(MARKED("ui", "this is no plain file; expected the recovery file that this program has written"), path);
    if (!isOursAlone(state) || state.st_nlink != 1)
        return refused(MARKED("ui", "others may have written this file; expected one of the user's own"), path);
    if (state.st_size > kMost_bytes)
        return refused(MARKED("ui", "this file is larger than any that this program has written; expected a recovery file"), path);
    return {};
}

/// Neither through a link, nor waiting for the other end of a pipe.
constexpr int kCarefully = O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC;

/// A program that was killed, or a full drive, may have left half a line: the next one must not go on with it.
bool endsInALine(int file)
{
    const off_t size = ::lseek(file, 0, SEEK_END);
    char last = '\n';
    return size <= 0 || ::pread(file, &last, 1, size - 1) != 1 || last == '\n';
}

} // namespace

Result<QByteArray> readPrivateFile(const QString& path)
{
    struct stat state = {};
    if (::lstat(QFile::encodeName(path).constData(), &state) != 0)
        return QByteArray();
    const auto folder = openFolder(path);
    if (!folder)
        return folder.error();
    const Handle in(*folder), file(::openat(in.get(), QFile::encodeName(QFileInfo(path).fileName()).constData(), O_RDONLY | kCarefully));
    if (!file.valid())
        return refused(errno == ELOOP ? MARKED("ui", "this is a link; expected the recovery file that this program has written")
                                      : MARKED("ui", "this file cannot be read; expected one of the user's own"),
            path);
    if (const auto fine = check(file.get(), path); !fine)
        return fine.error();
    QFile reading;
    if (!reading.open(file.get(), QIODevice::ReadOnly))
        return refused(MARKED("ui", "this file cannot be read; expected one of the user's own"), path);
    return reading.read(kMost_bytes);
}

Result<void> appendPrivately(const QString& path, const QByteArray& text)
{
    const QString name = QFileInfo(path).absolutePath();
    if (!QFileInfo::exists(name) && QDir().mkpath(QFileInfo(name).absolutePath()))
        ::mkdir(QFile::encodeName(name).constData(), 0700);
    const auto folder = openFolder(path);
    if (!folder)
        return folder.error();
    const Handle in(*folder),
        file(::openat(in.get(), QFile::encodeName(QFileInfo(path).fileName()).constData(), O_RDWR | O_APPEND | O_CREAT | kCarefully, 0600));
    if (!file.valid())
        return refused(MARKED("ui", "this file cannot be written; expected one of the user's own"), path);
    if (const auto fine = check(file.get(), path); !fine)
        return fine;
    const QByteArray all = endsInALine(file.get()) ? text : '\n' + text;
    qsizetype done = 0;
    while (done < all.size()) {
        const auto written = ::write(file.get(), all.constData() + done, static_cast<std::size_t>(all.size() - done));
        if (written < 0 && errno != EINTR)
            return refused(MARKED("ui", "the drive takes no more; expected room for it"), path);
        done += std::max<qsizetype>(written, 0);
    }
    if (::fsync(file.get()) != 0 && errno != EINVAL)
        return refused(MARKED("ui", "the drive failed; expected one that is there"), path);
    return {};
}

} // namespace lubberline::ui
