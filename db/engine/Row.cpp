// What a row of a Statement holds. The one place where stored values are looked at: a file may be damaged, or written by another
// program, and SQLite lets any column hold a value of any kind.

#include <QSqlField>
#include <QSqlRecord>

#include <cmath>

#include "core/base/FileText.h"
#include "core/base/Number.h"
#include "core/base/UtcTime.h"
#include "core/record/Ranges.h"
#include "db/engine/Statement.h"

namespace lubberline::db {

namespace {

/// A damaged table of a million rows must not take memory for each.
constexpr std::size_t kMostDamages = 10'000;

constexpr Pattern kMoment = MARKED("db", "a moment of UTC as YYYY-MM-DDTHH:MM:SSZ");

bool isWhole(const QVariant& value) { return value.typeId() == QMetaType::LongLong; }

/// As SQLite has it: an empty column is no empty text.
Message stored(const QVariant& value)
{
    if (value.isNull())
        return MARKED("db", "nothing (NULL)");
    switch (value.typeId()) {
    case QMetaType::LongLong: return Message::verbatim(std::to_string(value.toLongLong()));
    case QMetaType::Double:
        if (!std::isfinite(value.toDouble()))
            return MARKED("db", "an infinite number");
        return Message::verbatim(shortestNumber(value.toDouble()));
    case QMetaType::QByteArray: return {MARKED("db", "a block of %1 bytes"), value.toByteArray().size()};
    default: return Message::verbatim(inQuotes(value.toString().toStdString()));
    }
}

Message wholeNumber(NumberRange range)
{
    return {MARKED("db", "a whole number from %1 to %2"), shortestNumber(range.least), shortestNumber(range.most)};
}

} // namespace

/// "site.latitude_deg, row 5". What is computed belongs to the first table that is read.
std::string Statement::placeOf(int column) const
{
    const QSqlRecord row = m_query.record();
    QString table = row.field(column).tableName();
    for (int i = 0; table.isEmpty() && i < row.count(); ++i)
        table = row.field(i).tableName();
    QString number = QStringLiteral("?");
    for (const char* name : {"record", "id"}) // the better one last
        for (int i = row.count() - 1; i >= 0; --i)
            if (row.fieldName(i) == name && row.field(i).tableName() == table)
                number = row.value(i).toString();
    return (table.isEmpty() ? row.fieldName(column) : table + "." + row.fieldName(column)).toStdString() + ", row "
        + number.left(40).toStdString();
}

void Statement::damages(int column, const Message& expected) const
{
    if (m_damages.size() < kMostDamages)
        m_damages.push_back({MARKED("db", "%1: %2 is stored; expected %3"), placeOf(column), stored(m_query.value(column)), expected});
}

void Statement::damages(int column, const Error& why) const
{
    if (m_damages.size() < kMostDamages)
        m_damages.push_back({MARKED("db", "%1 does not read: %2"), placeOf(column), described(why)});
}

std::string Statement::text(int column) const
{
    std::string value = longText(column);
    if (value.size() <= kLongestText)
        return value;
    damages(column, {MARKED("db", "a text of at most %1 bytes"), kLongestText});
    return {};
}

std::string Statement::optionalText(int column) const { return isNull(column) ? std::string() : text(column); }

std::string Statement::name(int column) const
{
    const std::size_t before = m_damages.size();
    std::string value = text(column);
    if (value.empty() && m_damages.size() == before)
        damages(column, MARKED("db", "a text that is not empty"));
    return value;
}

std::string Statement::longText(int column) const
{
    const QVariant value = m_query.value(column);
    if (value.typeId() == QMetaType::QString && !value.isNull())
        if (const QString whole = value.toString(); !whole.contains(QChar(u'\0')))
            return whole.toStdString();
    damages(column, MARKED("db", "a text"));
    return {};
}

std::string Statement::optionalLongText(int column) const { return isNull(column) ? std::string() : longText(column); }

std::string Statement::anything(int column) const { return m_query.value(column).toString().toStdString(); }

std::string Statement::bytes(int column) const { return m_query.value(column).toByteArray().toStdString(); }

RecordId Statement::record(int column) const
{
    if (RecordId id = m_query.value(column).toString().toStdString(); isRecordId(id))
        return id;
    damages(column, MARKED("db", "a record id (UUID in lower case with hyphens)"));
    return {};
}

RecordId Statement::optionalRecord(int column) const
{
    const QVariant value = m_query.value(column);
    const bool none = value.typeId() == QMetaType::QString && !value.isNull() && value.toString().isEmpty();
    return none ? RecordId() : record(column);
}

Date Statement::day(int column) const
{
    const QVariant value = m_query.value(column);
    const std::string stored = value.toString().toStdString();
    const auto day = Date::read(stored);
    if (value.isNull() || (!day && (!stored.empty() || value.typeId() != QMetaType::QString)))
        damages(column, MARKED("db", "a day of the calendar as YYYY-MM-DD"));
    return day.value_or(Date());
}

std::string Statement::moment(int column) const
{
    const std::size_t before = m_damages.size();
    std::string value = text(column);
    if (!value.empty() && !isUtcText(value))
        damages(column, kMoment);
    return m_damages.size() == before ? value : std::string();
}

std::string Statement::momentStated(int column) const
{
    const std::size_t before = m_damages.size();
    std::string value = moment(column);
    if (value.empty() && m_damages.size() == before)
        damages(column, kMoment);
    return value;
}

std::int64_t Statement::integer(int column) const
{
    const QVariant value = m_query.value(column);
    if (isWhole(value) && !value.isNull())
        return value.toLongLong();
    damages(column, MARKED("db", "a whole number"));
    return 0;
}

int Statement::integer(int column, NumberRange range) const
{
    const QVariant value = m_query.value(column);
    if (isWhole(value) && !value.isNull() && range.has(static_cast<double>(value.toLongLong())))
        return static_cast<int>(value.toLongLong());
    damages(column, wholeNumber(range));
    return static_cast<int>(range.least);
}

std::optional<int> Statement::optionalInteger(int column, NumberRange range) const
{
    return isNull(column) ? std::nullopt : std::optional(integer(column, range));
}

bool Statement::flag(int column) const { return integer(column, {0, 1}) != 0; }

double Statement::real(int column, NumberRange range) const
{
    const QVariant value = m_query.value(column);
    const bool isNumber = !value.isNull() && (isWhole(value) || value.typeId() == QMetaType::Double);
    if (isNumber && range.has(value.toDouble()))
        return value.toDouble();
    damages(column, inWords(range));
    return std::max(range.least, 0.0);
}

std::optional<double> Statement::optionalReal(int column, NumberRange range) const
{
    return isNull(column) ? std::nullopt : std::optional(real(column, range));
}

std::int64_t Statement::rowNumber(int column) const
{
    const QVariant value = m_query.value(column);
    if (isWhole(value) && value.toLongLong() > 0)
        return value.toLongLong();
    damages(column, MARKED("db", "the number of a row"));
    return 0;
}

} // namespace lubberline::db
