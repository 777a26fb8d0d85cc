#pragma once
/// The colours of the plots: Okabe and Ito's set (distinguishable with every kind of colour vision), on a light or a dark
/// ground. Tints are opaque mixtures with the ground: archive PDFs know no transparency.

#include <QColor>
#include <QPalette>

#include <array>

namespace lubberline::ui {

struct PlotColours {
    QColor ground, text, faint; ///< faint: excluded readings and secondary text
    QColor grid, axis;
    QColor readings, suspect, selected;
    QColor approximate, exact, previous;
    QColor band;             ///< 95 % band of the approximate fit, a tint
    QColor limit, limitEdge; ///< limit band, a tint, and its edge
    QColor hatch, noise;
    std::array<QColor, 5> coefficient; ///< A…E

    friend bool operator==(const PlotColours&, const PlotColours&) = default;
};

/// For paper and exports: on white.
[[nodiscard]] PlotColours paperColours();
/// For the screen: light or dark by the palette's Base and Text.
[[nodiscard]] PlotColours coloursFor(const QPalette& palette);

} // namespace lubberline::ui
