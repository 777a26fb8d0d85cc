#include "db/engine/Statement.h"

#include <QSqlDatabase>

#include <cmath>

#include "db/engine/SqlError.h"

namespace lubberline::db {

Statement::Statement(const Database& database, const QString& sql) : m_query(database.connection()), m_database(database)
{
    m_query.setForwardOnly(true); // no cache of rows
    m_prepared = m_query.prepare(sql);
}

Statement& Statement::operator<<(const std::string& text)
{
    bind(QString::fromStdString(text));
    return *this;
}

Statement& Statement::operator<<(double number)
{
    m_finite = m_finite && std::isfinite(number);
    bind(number);
    return *this;
}

Statement& Statement::operator<<(std::int64_t number)
{
    bind(static_cast<qlonglong>(number));
    return *this;
}

Statement& Statement::null()
{
    bind(QVariant());
    return *this;
}

Result<void> Statement::run()
{
    m_bound = 0;
    m_damages.clear();
    if (!m_prepared)
        return errorOf(m_query.lastError(), m_database.path());
    if (!m_finite)
        return Error{
            ErrorCode::InvalidInput, MARKED("db", "a number is not finite; expected a real figure"), m_database.path().toStdString()};
    if (m_database.fault())
        if (const auto failed = m_database.fault()(m_query.lastQuery()))
            return *failed;
    if (!m_query.exec())
        return errorOf(m_query.lastError(), m_database.path());
    return {};
}

Result<void> Statement::readable() const
{
    if (m_query.lastError().isValid())
        return errorOf(m_query.lastError(), m_database.path());
    return {};
}

Result<void> Statement::finished() const
{
    if (auto read = readable(); !read)
        return read;
    if (!m_damages.empty())
        return Error{ErrorCode::Corrupt, m_damages.front(), m_database.path().toStdString()};
    return {};
}

Result<void> execute(const Database& database, const QString& sql)
{
    if (database.fault() && sql != "ROLLBACK")
        if (const auto failed = database.fault()(sql))
            return *failed;
    QSqlQuery query(database.connection());
    if (!query.exec(sql))
        return errorOf(query.lastError(), database.path());
    return {};
}

Result<std::int64_t> number(const Database& database, const QString& sql)
{
    Statement statement(database, sql);
    const auto found = firstOf<std::int64_t>(statement, [](Statement& row) { return row.isNull(0) ? 0 : row.integer(0); });
    if (!found)
        return found.error();
    return found->value_or(0);
}

} // namespace lubberline::db
