#pragma once
/// Private to db: one prepared statement with bound parameters, and its rows.

#include <QSqlQuery>
#include <QVariant>

#include <optional>
#include <string>
#include <vector>

#include "core/record/Id.h"
#include "db/engine/Database.h"

namespace lubberline::db {

class Statement {
public:
    Statement(const Database& database, const QString& sql);

    Statement& operator<<(const std::string& text);
    Statement& operator<<(const char* text) { return *this << std::string(text); }
    Statement& operator<<(Date day) { return *this << day.text(); }
    Statement& operator<<(double number);
    Statement& operator<<(std::int64_t number);
    Statement& operator<<(int number) { return *this << static_cast<std::int64_t>(number); }
    Statement& operator<<(bool yes) { return *this << static_cast<std::int64_t>(yes); }
    template <class T>
    Statement& operator<<(const std::optional<T>& value)
    {
        return value ? *this << *value : null();
    }
    /// An id that is not valid is NULL.
    template <class Tag>
    Statement& operator<<(Id<Tag> id)
    {
        return id.valid() ? *this << id.value : null();
    }
    Statement& null();

    /// Runs with what was bound; afterwards parameters can be bound anew. Errors: those of errorOf(); InvalidInput for a number
    /// that is not finite (SQLite would store NULL for it).
    Result<void> run();
    bool next() { return m_query.next(); }
    /// Whether next() returned false because there are no more rows, and not because one could not be read (a damaged page), and no
    /// row was damaged.
    Result<void> finished() const;

    [[nodiscard]] std::string text(int column) const { return m_query.value(column).toString().toStdString(); }
    /// None stated where the text is empty, and where it names no day: that damages the row.
    [[nodiscard]] Date day(int column) const;
    /// What is stored in a row is not what it should be: finished() tells of the first such.
    void damages(const Message& why) const;
    [[nodiscard]] bool damaged() const { return m_damage.has_value(); }
    [[nodiscard]] std::int64_t integer(int column) const { return m_query.value(column).toLongLong(); }
    [[nodiscard]] double real(int column) const { return m_query.value(column).toDouble(); }
    [[nodiscard]] std::optional<double> optionalReal(int column) const;
    [[nodiscard]] std::optional<int> optionalInteger(int column) const;
    template <class IdType>
    [[nodiscard]] IdType id(int column) const
    {
        return {m_query.value(column).toLongLong()};
    } // NULL is 0: not valid
    template <class Enum>
    [[nodiscard]] Enum as(int column) const
    {
        return static_cast<Enum>(integer(column));
    }
    [[nodiscard]] std::int64_t insertedId() const { return m_query.lastInsertId().toLongLong(); }
    [[nodiscard]] int changed() const { return m_query.numRowsAffected(); }

private:
    void bind(const QVariant& value) { m_query.bindValue(m_bound++, value); }
    QSqlQuery m_query;
    const Database& m_database;
    int m_bound = 0;
    bool m_prepared = false;
    bool m_finite = true;
    mutable std::optional<Message> m_damage;
};

/// Runs a statement and makes a value of each of its rows.
template <class Row, class Make>
Result<std::vector<Row>> rowsOf(Statement& statement, Make make)
{
    if (const auto done = statement.run(); !done)
        return done.error();
    std::vector<Row> rows;
    while (statement.next())
        rows.push_back(make(statement));
    if (const auto read = statement.finished(); !read)
        return read.error();
    return rows;
}

/// Rows of which each may be damaged: all of them, or the first fault.
template <class Row>
Result<std::vector<Row>> wholeRows(Result<std::vector<Result<Row>>> rows)
{
    if (!rows)
        return rows.error();
    std::vector<Row> whole;
    for (auto& row : *rows) {
        if (!row)
            return row.error();
        whole.push_back(std::move(row.value()));
    }
    return whole;
}

/// The first row, if there is any.
template <class Row, class Make>
Result<std::optional<Row>> firstOf(Statement& statement, Make make)
{
    if (const auto done = statement.run(); !done)
        return done.error();
    std::optional<Row> row;
    if (statement.next())
        row = make(statement);
    if (const auto read = statement.finished(); !read)
        return read.error();
    return row;
}

/// The first row. Errors: NotFound ("there is no such `what` in the database").
template <class Row, class Make>
Result<Row> oneOf(Statement& statement, const Database& database, const Message& what, Make make)
{
    auto found = firstOf<Row>(statement, make);
    if (!found)
        return found.error();
    if (!*found)
        return Error{ErrorCode::NotFound, {MARKED("db", "there is no such %1 in the database"), what}, database.path().toStdString()};
    return std::move(**found);
}

/// A statement without parameters.
Result<void> execute(const Database& database, const QString& sql);
/// The first column of the first row, as a number; 0 when there is no row.
Result<std::int64_t> number(const Database& database, const QString& sql);

} // namespace lubberline::db
