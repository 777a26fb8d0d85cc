#pragma once
/// Colours of signed values: white at zero, blue for west (−), red for east (+). Both arms are straight lines in CIELAB (D65)
/// from white to colours of the same lightness and chroma, so equal steps of the value are equal steps of lightness and of
/// ΔE*ab.

#include <QColor>

#include <array>

namespace lubberline::ui {

/// −1 (the blue end) … 0 (white) … +1 (the red end); beyond is the end.
[[nodiscard]] QColor divergingColour(double fraction);

/// The same in kDivergingHalf steps to each side of white, for images.
inline constexpr int kDivergingHalf = 256;
using DivergingTable = std::array<QRgb, 2 * kDivergingHalf + 1>;
[[nodiscard]] const DivergingTable& divergingTable();

/// Of the lines and labels that lie on these colours, on any ground.
[[nodiscard]] QColor inkOnMap();

} // namespace lubberline::ui
