#pragma once
/// Figures as documents print them: columns of one number of decimals, U+2212 for minus, no unit (that stands in the head).
/// What is missing or not finite is printed as a dash.

#include <QString>

#include <optional>

#include "core/angle/AngleText.h"
#include "core/record/Swing.h"

namespace lubberline::ui {

[[nodiscard]] QString dash();
/// "+3.25", "−0.50"; zero has no sign, and neither has what rounds to it.
[[nodiscard]] QString signedFigure(std::optional<double> value, int decimals);
[[nodiscard]] QString figure(std::optional<double> value, int decimals);
/// Never 360: what rounds up to it is north.
[[nodiscard]] QString headingFigure(std::optional<double> heading_deg, int decimals);
[[nodiscard]] std::optional<double> inDegrees(std::optional<double> angle_rad);
/// "047.5°" and "+3.2°", with the unit, for sentences.
[[nodiscard]] QString headingWords(double heading_deg, AngleStyle style);
[[nodiscard]] QString angleWords(double angle_deg, AngleStyle style);

/// Headings and deviations in the style that the reader chose.
class AngleFigures {
public:
    /// As many decimals as the readings of the swing have: what was read is printed as it was read. 1 to 3.
    AngleFigures(AngleStyle style, const Swing& swing);
    [[nodiscard]] QString heading(std::optional<double> heading_deg) const;
    [[nodiscard]] QString angle(std::optional<double> angle_deg) const;
    [[nodiscard]] QString unit() const; ///< "°" or "° ′"
    [[nodiscard]] int decimals() const { return m_decimals; }

private:
    [[nodiscard]] QString bare(const std::string& text) const;
    AngleStyle m_style;
    int m_decimals;
};

} // namespace lubberline::ui
