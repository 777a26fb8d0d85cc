#include "ui/plots/base/NiceScale.h"

#include <algorithm>
#include <cmath>

#include "core/base/Contract.h"
#include "ui/text/NumberText.h"

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

namespace {

/// As many as the step needs.
int decimalsFor(double step) { return std::clamp(static_cast<int>(std::ceil(-std::log10(std::abs(step)) - 1e-9)), 0, 6); }

} // namespace

QString plainTick(double value, double step) { return plainNumber(value, decimalsFor(step)); }

QString signedTick(double value, double step)
{
    const QString text = signedNumber(value, decimalsFor(step));
    return text.front().isDigit() ? QStringLiteral("0") : text; // only zero has no sign
}

} // namespace lubberline::ui
