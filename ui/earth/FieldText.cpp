#include "ui/earth/FieldText.h"

#include <QCoreApplication>

#include <cmath>

#include "core/angle/AngleText.h"
#include "core/base/DateText.h"
#include "ui/text/NumberText.h"

namespace lubberline::ui {

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(lubberline::ui::FieldText)
};

Error wrong(const QString& message) { return {ErrorCode::InvalidInput, said(message)}; }

} // namespace

Result<Date> parseDate(const QString& text, bool mayBeEmpty)
{
    const QString typed = text.trimmed();
    if (typed.isEmpty() && mayBeEmpty)
        return Date();
    const auto day = plainDate(typed.toStdString());
    if (!day)
        return wrong(Words::tr("“%1” is no date; expected year-month-day or day.month.year, as 2026-11-20 or 20.11.2026").arg(typed));
    return *day;
}

Result<std::optional<double>> parseOptionalAngle_deg(const QString& text)
{
    if (text.trimmed().isEmpty())
        return std::optional<double>();
    const auto angle_deg = parseSignedAngle_deg(text.trimmed().toStdString());
    if (!angle_deg)
        return angle_deg.error();
    return std::optional<double>(*angle_deg);
}

Result<double> parsePositive_deg(const QString& text)
{
    const auto value = typedNumber(text);
    if (!value || *value <= 0.0 || *value > 90.0)
        return wrong(Words::tr("“%1” is no size of a division; expected degrees above 0 and up to 90, as 0.5").arg(text.trimmed()));
    return *value;
}

Result<std::optional<int>> parseYear(const QString& text)
{
    if (text.trimmed().isEmpty())
        return std::optional<int>();
    bool number = false;
    const int year = text.trimmed().toInt(&number);
    if (!number || year < 1900 || year > 2200)
        return wrong(Words::tr("“%1” is no year; expected four digits, as 1984").arg(text.trimmed()));
    return std::optional<int>(year);
}

} // namespace lubberline::ui
