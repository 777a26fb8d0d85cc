// How the window reaches the pages of deviation in flight.

#include "ui/inflight/FlightLogPage.h"
#include "ui/inflight/WindsPage.h"
#include "ui/kit/PageDescription.h"
#include "ui/sensor/SensorEdits.h"

namespace lubberline::ui {

PageDescription WindsPage::description(PageContext& context)
{
    PageDescription page{QStringLiteral("winds"), [&context] {
                             return new WindsPage(
                                 context.files, [&context] { return QString::fromStdString(context.stores.clock().nowUtc()); });
                         }};
    page.commands
        = {{MenuId::Fleet, 115, tr("Deviation from &winds…"), tr("Ctrl+Alt+W"), "winds", [&context](Page&) { context.go({"winds"}); }}};
    page.outputs = {{MenuId::File, 216, tr("Write the &tables to upload…"), {}, "writeWindTables",
                        [](Page& shown) { dynamic_cast<WindsPage&>(shown).writeTables(); }},
        {MenuId::File, 217, tr("Write the &report as PDF…"), {}, "writeWindReport",
            [](Page& shown) { dynamic_cast<WindsPage&>(shown).writeReport(); }}};
    page.help = tr(
        "An aircraft's wind is wrong across its track by airspeed times the error of its heading. Each report beside a reference wind gives that error: "
        "e = dir(Vg − reported wind) − dir(Vg − reference wind) = offset + a sin ψ′ + b cos ψ′; deviation is −e (N. Jacobs, D. Mulally, A. Anderson, 2014, "
        "equations 1 and 4 to 7). Standard errors are by flights, since reports of a flight share the error of the reference; a constant error of the reference "
        "looks like B or C. Tables of eight points are enlarged by 1.05 (the paper), 1.0530 (so that straight lines hold the sine) or not.");
    return page;
}

PageDescription FlightLogPage::description(PageContext& context)
{
    PageDescription page{
        QStringLiteral("flightLog"), [&context] {
            auto* log = new FlightLogPage(context.stores, context.files);
            connect(log, &FlightLogPage::makeSwing, &context.window, [&context](const Swing& swing) { context.makeSwing(swing); });
            connect(log, &FlightLogPage::storeModel, &context.window, [&context](const SensorRecord& sensor) {
                context.undo.push(new MakeSensor(context.edits, sensor, MakeSensor::Direction::Make,
                    tr("keep the sensor model %1").arg(QString::fromStdString(sensor.name))));
            });
            return log;
        }};
    page.commands = {{MenuId::Swing, 201, tr("Swing in &flight from a log…"), tr("Ctrl+Alt+L"), "flightLog",
        [&context](Page& shown) {
            context.go({"flightLog", shown.shown().compass});
        },
        needsCompass}};
    page.outputs = {{MenuId::File, 216, tr("Write the &report as PDF…"), {}, "writeFlightReport",
        [](Page& shown) { dynamic_cast<FlightLogPage&>(shown).writeReport(); }}};
    page.help
        = tr("Legs: ground velocities of three or more headings lie on a circle about the wind, whose radius is the airspeed, so the heading of each leg follows "
             "without a model. Continuous: δ = A + B sin ψ′ + C cos ψ′ + D sin 2ψ′ + E cos 2ψ′ is followed by a Kalman filter, without process noise the least-squares "
             "solution; χ² of the last 10, 20, 40 and 80 innovations raises an alarm, falsely in one of ten logs of 1400 updates. The means of the legs become the readings "
             "of a swing; the next log of the compass goes on from the swings in flight since its last other swing, recomputed from those readings.")
        + QLatin1Char(' ')
        + tr(
            "Whole sensor model: sin δ = Σ g (S b + p/H) with b the Earth's field in the aircraft over H and g what a field along each axis does across the heading "
            "read, exact at every attitude (after Poisson; Kayton and Fried 1997, 9.13); level flight tells A to E of it. "
            "Kept with the compass, with its errors, it is where the next flight goes on; a circuit that is on is part of it, as the heading is read with it.");
    return page;
}

} // namespace lubberline::ui
