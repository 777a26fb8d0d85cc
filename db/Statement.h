#pragma once
/// Private to db: one prepared statement with bound parameters, and its rows.

#include <QSqlQuery>
#include <QVariant>

#include <cmath>
#include <optional>
#include <string>

#include "core/record/Id.h"
#include "db/Database.h"

namespace lubberline::db {

class Statement {
public:
    Statement(const Database& database, const QString& sql);

    Statement& operator<<(const std::string& text);
    Statement& operator<<(const char* text) { return *this << std::string(text); }
    Statement& operator<<(double number);
    Statement& operator<<(std::int64_t number);
    Statement& operator<<(int number) { return *this << static_cast<std::int64_t>(number); }
    Statement& operator<<(bool yes) { return *this << static_cast<std::int64_t>(yes); }
    template <class T>
    Statement& operator<<(const std::optional<T>& value) { return value ? *this << *value : null(); }
    /// An id that is not valid is NULL.
    template <class Tag>
    Statement& operator<<(Id<Tag> id) { return id.valid() ? *this << id.value : null(); }
    Statement& null();

    /// Runs with what was bound; afterwards parameters can be bound anew. Errors: those of errorOf(); InvalidInput for a number
    /// that is not finite (SQLite would store NULL for it).
    Result<void> run();
    bool next() { return m_query.next(); }

    [[nodiscard]] std::string text(int column) const { return m_query.value(column).toString().toStdString(); }
    [[nodiscard]] std::int64_t integer(int column) const { return m_query.value(column).toLongLong(); }
    [[nodiscard]] double real(int column) const { return m_query.value(column).toDouble(); }
    [[nodiscard]] std::optional<double> optionalReal(int column) const;
    [[nodiscard]] std::optional<int> optionalInteger(int column) const;
    template <class IdType>
    [[nodiscard]] IdType id(int column) const { return {m_query.value(column).toLongLong()}; } // NULL is 0: not valid
    template <class Enum>
    [[nodiscard]] Enum as(int column) const { return static_cast<Enum>(integer(column)); }
    [[nodiscard]] std::int64_t insertedId() const { return m_query.lastInsertId().toLongLong(); }
    [[nodiscard]] int changed() const { return m_query.numRowsAffected(); }

private:
    void bind(const QVariant& value) { m_query.bindValue(m_bound++, value); }
    QSqlQuery m_query;
    QString m_path;
    int m_bound = 0;
    bool m_prepared = false;
    bool m_finite = true;
};

/// A statement without parameters.
Result<void> execute(const Database& database, const QString& sql);
/// The first column of the first row, as a number; 0 when there is no row.
Result<std::int64_t> number(const Database& database, const QString& sql);

} // namespace lubberline::db
