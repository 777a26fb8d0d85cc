#pragma once

#include <QString>
#include <QTemporaryDir>

namespace lubberline::db {

/// A private folder (0700) among the machine's temporary ones, gone with this object; one that a killed program left is removed when
/// the next is made.
class WorkFolder {
public:
    WorkFolder();
    ~WorkFolder();
    WorkFolder(const WorkFolder&) = delete;
    WorkFolder& operator=(const WorkFolder&) = delete;

    [[nodiscard]] bool isValid() const { return m_folder.isValid() && m_lock >= 0; }
    [[nodiscard]] QString path() const { return m_folder.path(); }
    [[nodiscard]] QString filePath(const QString& name) const { return m_folder.filePath(name); }

private:
    QTemporaryDir m_folder;
    int m_lock = -1; ///< held while the folder is in use
};

} // namespace lubberline::db
