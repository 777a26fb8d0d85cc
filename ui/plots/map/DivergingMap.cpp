#include "ui/plots/map/DivergingMap.h"

#include <algorithm>
#include <cmath>

namespace lubberline::ui {

namespace {

struct Lab {
    double l, a, b;
};

// Ends with L* 45 and C*ab 52, hues 284° and 36° (blue and red are told apart with every kind of colour vision); inside sRGB
// all the way to white.
constexpr Lab kWhite{100, 0, 0}, kWest{45, 12.58, -50.46}, kEast{45, 42.07, 30.56};

double uncurved(double f) { return f > 6.0 / 29 ? f * f * f : 3 * (6.0 / 29) * (6.0 / 29) * (f - 4.0 / 29); }

int channel(double linear)
{
    const double coded = linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055; // IEC 61966-2-1
    return static_cast<int>(std::lround(255 * std::clamp(coded, 0.0, 1.0)));
}

/// CIE 1976 L*a*b* with the white of D65, to sRGB (IEC 61966-2-1).
QColor toRgb(const Lab& lab)
{
    const double f = (lab.l + 16) / 116;
    const double x = 0.95047 * uncurved(f + lab.a / 500), y = uncurved(f), z = 1.08883 * uncurved(f - lab.b / 200);
    return QColor(channel(3.2404542 * x - 1.5371385 * y - 0.4985314 * z), channel(-0.9692660 * x + 1.8760108 * y + 0.0415560 * z),
        channel(0.0556434 * x - 0.2040259 * y + 1.0572252 * z));
}

DivergingTable makeTable()
{
    DivergingTable table;
    for (int i = -kDivergingHalf; i <= kDivergingHalf; ++i)
        table[static_cast<std::size_t>(i + kDivergingHalf)] = divergingColour(static_cast<double>(i) / kDivergingHalf).rgb();
    return table;
}

} // namespace

QColor divergingColour(double fraction)
{
    const double part = std::min(std::abs(fraction), 1.0);
    const Lab& end = fraction < 0 ? kWest : kEast;
    return toRgb({std::lerp(kWhite.l, end.l, part), part * end.a, part * end.b});
}

const DivergingTable& divergingTable()
{
    static const DivergingTable table = makeTable();
    return table;
}

QColor inkOnMap() { return QColor(0x18, 0x18, 0x18); }

} // namespace lubberline::ui
