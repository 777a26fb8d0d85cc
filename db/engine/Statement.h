#pragma once
/// Private to db: one prepared statement with bound parameters, and its rows.

#include <QSqlQuery>
#include <QVariant>

#include <optional>
#include <string>
#include <vector>

#include "core/base/NumberRange.h"
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
    /// Whether next() returned false because there are no more rows, and not because one could not be read (a damaged page).
    Result<void> readable() const;
    /// The same, and no row was damaged.
    Result<void> finished() const;

    // What a row holds (Row.cpp). Each value is held against what its column should hold. Another one damages the row and is read as
    // what is not stated: finished() tells of it, with its table, row and column.
    [[nodiscard]] std::string text(int column) const; ///< of people: at most kLongestText bytes
    [[nodiscard]] std::string optionalText(int column) const;
    [[nodiscard]] std::string name(int column) const;     ///< a text that is not empty
    [[nodiscard]] std::string longText(int column) const; ///< of ours: JSON, what an audit entry says
    [[nodiscard]] std::string optionalLongText(int column) const;
    [[nodiscard]] std::string anything(int column) const; ///< of whatever kind, as text: to be shown
    [[nodiscard]] RecordId record(int column) const;
    [[nodiscard]] RecordId optionalRecord(int column) const; ///< or an empty text
    [[nodiscard]] Date day(int column) const;                ///< none stated where the text is empty
    [[nodiscard]] std::string moment(int column) const;      ///< ISO 8601 in UTC, or an empty text
    [[nodiscard]] std::string momentStated(int column) const;
    [[nodiscard]] std::int64_t integer(int column) const;
    [[nodiscard]] int integer(int column, NumberRange range) const;
    [[nodiscard]] std::optional<int> optionalInteger(int column, NumberRange range) const;
    [[nodiscard]] bool flag(int column) const; ///< 0 or 1
    [[nodiscard]] double real(int column, NumberRange range) const;
    [[nodiscard]] std::optional<double> optionalReal(int column, NumberRange range) const;
    /// One of an enumeration that ends with `last`.
    template <class Enum>
    [[nodiscard]] Enum as(int column, Enum last) const
    {
        return static_cast<Enum>(integer(column, {0, static_cast<double>(last)}));
    }
    template <class IdType>
    [[nodiscard]] IdType id(int column) const
    {
        return {rowNumber(column)};
    }
    template <class IdType> ///< NULL is not valid
    [[nodiscard]] IdType optionalId(int column) const
    {
        return isNull(column) ? IdType{} : id<IdType>(column);
    }
    [[nodiscard]] std::string bytes(int column) const; ///< as they are
    [[nodiscard]] bool isNull(int column) const { return m_query.value(column).isNull(); }

    /// What is stored in this column of the row is not what it should be.
    void damages(int column, const Message& expected) const;
    /// It is a document that does not read.
    void damages(int column, const Error& why) const;
    /// Of all rows that were read since run(), each with its table, row and column.
    [[nodiscard]] const std::vector<Message>& damages() const { return m_damages; }

    [[nodiscard]] std::int64_t insertedId() const { return m_query.lastInsertId().toLongLong(); }
    [[nodiscard]] int changed() const { return m_query.numRowsAffected(); }

private:
    void bind(const QVariant& value) { m_query.bindValue(m_bound++, value); }
    [[nodiscard]] std::int64_t rowNumber(int column) const;
    [[nodiscard]] std::string placeOf(int column) const;
    QSqlQuery m_query;
    const Database& m_database;
    int m_bound = 0;
    bool m_prepared = false;
    bool m_finite = true;
    mutable std::vector<Message> m_damages;
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

/// The same for a list that shows what can be shown: a damaged row is there, too, and what does not read is as if it were not stated.
template <class Row, class Make>
Result<std::vector<Row>> shownRowsOf(Statement& statement, Make make)
{
    if (const auto done = statement.run(); !done)
        return done.error();
    std::vector<Row> rows;
    while (statement.next())
        rows.push_back(make(statement));
    if (const auto read = statement.readable(); !read)
        return read.error();
    return rows;
}

/// What is wrong with the rows of a statement, read by `read`; and why it ends where not all of them can be.
template <class Read>
std::vector<Message> damagesIn(Statement& statement, Read read)
{
    auto whole = statement.run();
    if (whole) {
        while (statement.next())
            read(statement);
        whole = statement.readable();
    }
    std::vector<Message> damages = statement.damages();
    if (!whole)
        damages.push_back(described(whole.error()));
    return damages;
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
