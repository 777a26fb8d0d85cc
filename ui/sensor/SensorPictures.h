#pragma once
/// Pictures of a sensor model in a field: the same data for the map, the surface and the level swing. core computes.

#include <memory>

#include "core/sensor/ModelUncertainty.h"
#include "core/sensor/SensorModel.h"
#include "ui/plots/map/MapPicture.h"
#include "ui/plots/swing/SwingPicture.h"

namespace lubberline::ui {

struct NamedModel {
    SensorModel model;
    QString name;
    std::optional<ModelUncertainty> uncertainty = {}; ///< of the calibration that gave it
};

/// Which of the two models is seen.
enum class Compared { Difference, This, Other };

struct ModelView {
    NamedModel model;
    std::optional<NamedModel> other; ///< to be compared with
    Compared compared = Compared::Difference;
    MeridianField field;
    MapRequest request;
    std::optional<double> limit_deg;
    QString limitDocument;
    bool coarse = false;
};

/// The full range of both axes, a node a degree.
[[nodiscard]] MapRequest wholeRequest(AttitudeAxis x, AttitudeAxis y, double held_deg);

/// The difference is this − other; all pictures of a comparison have the same colours.
[[nodiscard]] MapPicture mapPictureOf(const ModelView& view);

/// The level deviation every 10° with its fits; the other model stands as the previous swing.
[[nodiscard]] SwingPicture levelSwingOf(const ModelView& view);

} // namespace lubberline::ui
