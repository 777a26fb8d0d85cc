#include "ui/plots/base/NiceScale.h"

#include <algorithm>
#include <cmath>

#include "core/base/Contract.h"

namespace lubberline::ui {

double niceStep(double least)
{
    LUBBERLINE_EXPECT(std::isfinite(least) && least > 0, "a step of a scale is positive");
    const double power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double mantissa : {1.0, 2.0, 5.0}) {
        if (mantissa * power >= least * (1 - 1e-9)) // 0.2 from 3 · 0.2/3 is still 0.2
            return mantissa * power;
    }
    return 10.0 * power;
}

NiceScale niceScale(double maxAbs, int steps, double floor)
{
    const double held = std::isfinite(maxAbs) ? std::max(maxAbs, floor) : floor;
    const double step = niceStep(held / steps);
    return {std::ceil(held / step - 1e-9) * step, step};
}

QString plainTick(double value, double step)
{
    const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(std::abs(step)) - 1e-9)), 0, 6);
    QString text = QString::number(std::abs(value), 'f', decimals);
    const bool negative = value < 0 && text.toDouble() != 0.0;
    return negative ? QChar(0x2212) + text : text;
}

QString signedTick(double value, double step)
{
    const QString text = plainTick(value, step);
    if (text.toDouble() == 0.0 && !text.startsWith(QChar(0x2212)))
        return QStringLiteral("0");
    return text.startsWith(QChar(0x2212)) ? text : "+" + text;
}

} // namespace lubberline::ui
