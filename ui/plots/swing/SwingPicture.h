#pragma once
/// What every plot of a swing shows: one value, made by the page or the report from the same result object.

#include <QString>

#include <memory>
#include <optional>
#include <vector>

#include "core/angle/AngleText.h"
#include "core/swing/Analysis.h"

namespace lubberline::ui {

struct PlottedReading {
    int row = 0; ///< of the swing's table of readings
    MagneticHeading magnetic;
    CompassHeading compass;
    Deviation deviation;
    bool excluded = false;
    bool suspect = false;
    std::optional<double> studentised;
};

struct SwingPicture {
    QString title;
    std::vector<PlottedReading> readings;
    std::shared_ptr<const Analysis> analysis; ///< null while the readings do not allow a result
    QString whyNoAnalysis;                    ///< shown in the plot's place for the curve then
    double resolution_deg = 1.0;              ///< half of it each side is the bar of a reading
    std::optional<double> limit_deg;          ///< |deviation| allowed
    QString limitDocument;
    std::shared_ptr<const Analysis> previous; ///< last swing of the same compass
    QString previousLabel;                    ///< its date
    QString readingsTitle;                    ///< in the curve's legend, where nobody read them; empty: readings
    QString previousTitle;                    ///< where it is not a previous swing; empty: it is
    AngleStyle angleStyle = AngleStyle::DecimalDegrees;
};

} // namespace lubberline::ui
