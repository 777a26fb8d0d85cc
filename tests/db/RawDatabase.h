#pragma once
/// A database file as another program sees it: raw SQL, without our repositories and settings.

#include <QFile>
#include <QSqlDatabase>
#include <QSqlQuery>
#include <QStringList>

namespace lubberline::test {

class RawDatabase {
public:
    explicit RawDatabase(const QString& path)
    {
        m_handle = QSqlDatabase::addDatabase("QSQLITE", kName);
        m_handle.setDatabaseName(path);
        m_handle.open();
    }
    ~RawDatabase()
    {
        m_handle.close();
        m_handle = {};
        QSqlDatabase::removeDatabase(kName);
    }
    RawDatabase(const RawDatabase&) = delete;
    RawDatabase& operator=(const RawDatabase&) = delete;

    /// @return whether all succeeded.
    bool run(const QStringList& statements)
    {
        for (const QString& sql : statements)
            if (!QSqlQuery(m_handle).exec(sql))
                return false;
        return true;
    }

private:
    static constexpr const char* kName = "another program";
    QSqlDatabase m_handle;
};

inline QByteArray contents(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

inline bool write(const QString& path, const QByteArray& bytes)
{
    QFile file(path);
    return file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size();
}

} // namespace lubberline::test
