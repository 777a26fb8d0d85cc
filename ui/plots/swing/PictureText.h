#pragma once
/// What the plots say in words: read-outs, labels of readings, notices, axis titles. All units are named.

#include <QString>

#include "ui/plots/swing/SwingPicture.h"

namespace lubberline::ui {

/// "045° t = 15": what stands beside a suspect reading. t is the studentised residual.
[[nodiscard]] QString suspectLabel(const PlottedReading& reading);

/// Headings, deviation, residual and t of a reading, and whether it is suspect or excluded.
[[nodiscard]] QString readingReadOut(const PlottedReading& reading, const SwingPicture& picture);

/// A place of the plot that is no reading: heading, deviation, and what the fits say there.
[[nodiscard]] QString placeReadOut(double magnetic_deg, double deviation_deg, const SwingPicture& picture);

/// The same in the strip of residuals of the approximate fit.
[[nodiscard]] QString residualReadOut(double magnetic_deg, double residual_deg, const SwingPicture& picture);

/// Components of the approximate fit at a compass heading.
[[nodiscard]] QString componentsReadOut(double compass_deg, const SwingPicture& picture);

/// One order of the spectrum: amplitude, uncertainty, phase, and what it is called.
[[nodiscard]] QString orderReadOut(int order, const SwingPicture& picture);

/// What to do or why there is no curve; empty when there is nothing to say.
[[nodiscard]] QString noticeFor(const SwingPicture& picture);

/// "A", "B/C", "D/E"; empty above order 2.
[[nodiscard]] QString orderName(int order);
/// "A", "B sin ψ′", …: the component in the formula of the approximate fit.
[[nodiscard]] QString componentName(Coefficient which);
/// "limit ±10° (14 CFR 25.1327)".
[[nodiscard]] QString limitTitle(const SwingPicture& picture, double scaleEnd_deg);

/// The two captions of the polar plot, and the titles of the axes.
[[nodiscard]] QString deviationCaption();
[[nodiscard]] QString headingCaption();
[[nodiscard]] QString deviationAxisTitle();
[[nodiscard]] QString headingAxisTitle();

/// "previous swing (2025-11-20)".
[[nodiscard]] QString previousTitle(const SwingPicture& picture);

} // namespace lubberline::ui
