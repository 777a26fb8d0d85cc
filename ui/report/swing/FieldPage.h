#pragma once
/// What a report says about the Earth's field and the sensor, before it is set on a page or in HTML.

#include <QStringList>

#include <optional>
#include <vector>

#include "ui/plots/map/MapPicture.h"
#include "ui/report/page/Table.h"
#include "ui/report/swing/Report.h"

namespace lubberline::ui {

struct FieldPage {
    std::vector<Fact> field;       ///< the stamp; empty: the swing keeps none
    Table combinations;            ///< what the swing tells: its exact coefficients as combinations of Poisson's parameters
    QStringList unknown;           ///< what a level swing cannot tell
    std::vector<Fact> sensor;      ///< the newest sensor model of the compass; empty: it has none
    Table parameters;              ///< of that model
    Table smith;                   ///< its coefficients in the swing's field, with where they come from
    std::optional<MapPicture> map; ///< heading × roll in the swing's field, modelled
};

/// None when the swing keeps no field and its compass no sensor model.
[[nodiscard]] std::optional<FieldPage> fieldPageOf(const ReportInput& input);

/// The parts, each in a source of its own.
void describeField(const ReportInput& input, FieldPage& page);
void describeSensor(const ReportInput& input, const SensorRecord& sensor, FieldPage& page);

} // namespace lubberline::ui
