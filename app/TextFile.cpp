#include "app/TextFile.h"

#include "ui/report/page/DocumentFile.h"

namespace lubberline::app {

Result<void> writeTextFile(const std::string& path, const std::string& content)
{
    return ui::writeDocument(QString::fromStdString(path), QByteArray::fromStdString(content));
}

} // namespace lubberline::app
