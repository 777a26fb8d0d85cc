#pragma once
/// Ways to a heading without a compass base, as a page shows them: what is typed, and what comes of it.

#include <QString>
#include <QStringList>

#include <optional>

#include "core/base/Date.h"
#include "core/reference/Alignment.h"
#include "ui/plots/drawn/DrawnPicture.h"

namespace lubberline::ui {

enum class DatumMethod { Sun, Runway, TransferGyro, Synchro, Grid };

struct DatumInputs {
    Place place{52, 21, 0};
    UtcTime time;
    std::optional<double> variation_deg; ///< none: that of the model
    double variationError_deg = 0.3;
    SunSighting sighting;
    bool ofShadow = true;
    std::optional<double> bearing_deg; ///< of shadow or sun from the nose, as read
    RunwayAlignment runway;
    std::optional<double> runway_deg; ///< its direction, magnetic
    TransferGyro gyro;
    SynchroTransmission synchro;
    double heading_deg = 0, meridian_deg = 0, tableStep_deg = 5; ///< grid
    friend bool operator==(const DatumInputs& a, const DatumInputs& b);
};

struct DatumAnswer {
    QString headline;
    QStringList lines; ///< what else is to be known
    std::optional<ErrorBudget> budget;
    QStringList warnings;
};

/// Errors: those of the field model.
Result<DatumAnswer> answerOf(DatumMethod method, const DatumInputs& inputs);

/// How well the sun tells a heading over the day of the time: standard deviation, and its elevation.
[[nodiscard]] DrawnPicture sunDay(const DatumInputs& inputs);

} // namespace lubberline::ui
