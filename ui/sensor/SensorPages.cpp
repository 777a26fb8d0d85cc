// How the window reaches the page of a compass's sensor model.

#include "ui/kit/PageDescription.h"
#include "ui/plots/base/Plot.h"
#include "ui/sensor/SensorMaps.h"
#include "ui/sensor/SensorPage.h"

namespace lubberline::ui {

PageDescription SensorPage::description(PageContext& context)
{
    PageDescription page{
        QStringLiteral("sensor"), [&context] {
            auto* sensor = new SensorPage(context.edits, context.undo, context.files);
            connect(sensor, &SensorPage::benchWanted, &context.window, [&context](CompassId id) { context.go({"ironBench", id}); });
            return sensor;
        }};
    page.commands = {{MenuId::Model, 100, tr("&Sensor model of this compass"), tr("Ctrl+L"), "sensorModel",
        [&context](Page& shown) {
            context.go({"sensor", shown.shown().compass});
        },
        needsCompass}};
    page.help = tr(
        "What stands between the Earth's field and the compass: turn the figures and the maps of its deviation over heading, pitch and roll follow. "
        "The table below says which figure causes how much of each coefficient. Estimate takes the figures from the swings of this compass.");
    return page;
}

Result<void> SensorPage::open(const FleetItem& record)
{
    const auto* id = std::get_if<CompassId>(&record);
    return showCompass(id ? *id : CompassId());
}

bool SensorPage::isOf(const FleetItem& record) const { return record == FleetItem(compass()); }

Shown SensorPage::shown() const { return {{}, compass()}; }

Plot* SensorPage::plot() const { return &m_maps->front(); }

} // namespace lubberline::ui
