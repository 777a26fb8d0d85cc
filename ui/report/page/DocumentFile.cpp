#include "ui/report/page/DocumentFile.h"

#include <QFileInfo>
#include <QSaveFile>

#include "ui/report/page/Words.h"

namespace lubberline::ui {

namespace {

Error ioError(const QString& message, const QString& path) { return {ErrorCode::Io, message.toStdString(), path.toStdString()}; }

} // namespace

Result<void> writeDocument(const QString& path, const QByteArray& bytes)
{
    const QFileInfo file(path), folder(file.path());
    if (!folder.exists())
        return ioError(Words::tr("the folder %1 does not exist; expected an existing folder to write into").arg(file.path()), path);
    if (!folder.isDir())
        return ioError(Words::tr("%1 is not a folder; expected a folder to write into").arg(file.path()), path);
    if (file.isDir())
        return ioError(Words::tr("this is a folder; expected the name of a file to write"), path);
    QSaveFile save(path);
    if (!save.open(QIODevice::WriteOnly)) {
        return ioError(Words::tr("the folder %1 takes no new file (%2); expected a folder that may be written to")
                           .arg(file.path(), save.errorString()),
            path);
    }
    if (save.write(bytes) != bytes.size() || !save.commit())
        return ioError(Words::tr("cannot be written into the folder %1: %2").arg(file.path(), save.errorString()), path);
    return {};
}

} // namespace lubberline::ui
