#include "ui/text/NumberText.h"

#include <cmath>

#include "core/base/Number.h"

namespace lubberline::ui {

namespace {

QString withSign(double value, int decimals, const QString& plus)
{
    const QString figures = QString::number(std::abs(value), 'f', decimals);
    if (figures.toDouble() == 0.0)
        return figures;
    return (value < 0 ? QString(QChar(0x2212)) : plus) + figures;
}

} // namespace

std::optional<double> typedNumber(const QString& text)
{
    const FileNumber number = readNumber(text.trimmed().toStdString(), true);
    return number.fault == NumberFault::None ? std::optional(number.value) : std::nullopt;
}

QString plainNumber(double value, int decimals) { return withSign(value, decimals, {}); }
QString signedNumber(double value, int decimals) { return withSign(value, decimals, QStringLiteral("+")); }

} // namespace lubberline::ui
