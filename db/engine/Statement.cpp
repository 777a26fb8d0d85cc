#include "db/engine/Statement.h"

#include <QSqlDatabase>

#include <cmath>

#include "core/base/FileText.h"
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
    m_damage.reset();
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

Result<void> Statement::finished() const
{
    if (m_query.lastError().isValid())
        return errorOf(m_query.lastError(), m_database.path());
    if (m_damage)
        return Error{ErrorCode::Corrupt, *m_damage, m_database.path().toStdString()};
    return {};
}

Date Statement::day(int column) const
{
    const std::string stored = text(column);
    const auto day = Date::read(stored);
    if (!day && !stored.empty())
        damages({MARKED("db", "%1 is stored where a day should be; expected YYYY-MM-DD"), inQuotes(stored)});
    return day.value_or(Date());
}

void Statement::damages(const Message& why) const
{
    if (!m_damage)
        m_damage = why;
}

std::optional<double> Statement::optionalReal(int column) const
{
    const QVariant value = m_query.value(column);
    return value.isNull() ? std::nullopt : std::optional(value.toDouble());
}

std::optional<int> Statement::optionalInteger(int column) const
{
    const QVariant value = m_query.value(column);
    return value.isNull() ? std::nullopt : std::optional(value.toInt());
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
    const auto found = firstOf<std::int64_t>(statement, [](Statement& row) { return row.integer(0); });
    if (!found)
        return found.error();
    return found->value_or(0);
}

} // namespace lubberline::db
