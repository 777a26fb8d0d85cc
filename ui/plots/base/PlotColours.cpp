#include "ui/plots/base/PlotColours.h"

namespace lubberline::ui {

namespace {

// M. Okabe, K. Ito, "Color Universal Design" (2008).
const QColor kOrange(0xE6, 0x9F, 0x00), kSkyBlue(0x56, 0xB4, 0xE9), kGreen(0x00, 0x9E, 0x73), kYellow(0xF0, 0xE4, 0x42),
    kBlue(0x00, 0x72, 0xB2), kVermilion(0xD5, 0x5E, 0x00), kPurple(0xCC, 0x79, 0xA7);

QColor mixed(const QColor& colour, const QColor& ground, double share)
{
    const auto channel = [share](int a, int b) { return qRound(share * a + (1.0 - share) * b); };
    return QColor(channel(colour.red(), ground.red()), channel(colour.green(), ground.green()), channel(colour.blue(), ground.blue()));
}

PlotColours coloursOn(const QColor& ground, const QColor& text)
{
    const bool dark = ground.lightnessF() < 0.5;
    PlotColours colours;
    colours.ground = ground;
    colours.text = colours.readings = text;
    colours.faint = mixed(text, ground, 0.58);
    colours.grid = mixed(text, ground, dark ? 0.20 : 0.14);
    colours.axis = mixed(text, ground, 0.62);
    colours.suspect = kPurple;
    colours.selected = kOrange;
    colours.approximate = dark ? kSkyBlue : kBlue; // blue is too dark to read on a dark ground
    colours.exact = kVermilion;
    colours.previous = mixed(text, ground, 0.50);
    colours.band = mixed(colours.approximate, ground, dark ? 0.30 : 0.20);
    colours.limit = mixed(kGreen, ground, dark ? 0.16 : 0.09);
    colours.limitEdge = mixed(kGreen, ground, dark ? 0.70 : 0.60);
    colours.hatch = mixed(text, ground, 0.28);
    colours.noise = kVermilion;
    // On a dark ground yellow beside orange, and grey beside purple, would look alike.
    colours.coefficient = dark ? std::array{mixed(text, ground, 0.9), kYellow, kVermilion, kGreen, kPurple}
                               : std::array{mixed(text, ground, 0.65), kSkyBlue, kOrange, kGreen, kPurple};
    return colours;
}

} // namespace

PlotColours paperColours() { return coloursOn(Qt::white, Qt::black); }

PlotColours coloursFor(const QPalette& palette)
{
    return coloursOn(palette.color(QPalette::Active, QPalette::Base), palette.color(QPalette::Active, QPalette::Text));
}

} // namespace lubberline::ui
