#include "ui/text/NumberText.h"

#include <cmath>

#include "core/base/Number.h"

namespace lubberline::ui {

std::optional<double> typedNumber(const QString& text)
{
    const FileNumber number = readNumber(text.trimmed().toStdString(), true);
    return number.fault == NumberFault::None ? std::optional(number.value) : std::nullopt;
}

QString plainNumber(double value, int decimals)
{
    return std::isfinite(value) ? QString::fromStdString(figureText(value, decimals)) : QStringLiteral("—");
}

QString signedNumber(double value, int decimals)
{
    return std::isfinite(value) ? QString::fromStdString(signedFigureText(value, decimals)) : QStringLiteral("—");
}

} // namespace lubberline::ui
