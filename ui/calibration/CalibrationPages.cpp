// How the window reaches the calibration from logs.

#include "ui/calibration/CalibrationPage.h"
#include "ui/calibration/LineOfSightPage.h"
#include "ui/calibration/SensorTestsPage.h"
#include "ui/kit/PageDescription.h"
#include "ui/sensor/SensorEdits.h"

namespace lubberline::ui {

PageDescription CalibrationPage::description(PageContext& context)
{
    PageDescription page{QStringLiteral("calibration"), [&context] {
                             auto* calibration = new CalibrationPage(context.stores, context.settings, context.files);
                             connect(calibration, &CalibrationPage::storeModel, &context.window, [&context](const SensorRecord& sensor) {
                                 context.undo.push(new MakeSensor(context.edits, sensor, MakeSensor::Direction::Make,
                                     tr("calibration %1").arg(QString::fromStdString(sensor.name))));
                             });
                             return calibration;
                         }};
    page.commands = {{MenuId::Model, 115, tr("&Calibration from a log…"), tr("Ctrl+Alt+G"), "calibration", [&context](Page& shown) {
                          context.go({"calibration", shown.shown().compass.valid() ? FleetItem(shown.shown().compass) : FleetItem()});
                      }}};
    page.outputs = {{MenuId::File, 217, tr("Write the &report as PDF…"), {}, "writeCalibrationReport",
        [](Page& shown) { dynamic_cast<CalibrationPage&>(shown).writeReport(); }}};
    page.help = tr(
        "Open a log of a magnetometer that was turned through all attitudes: its hard and soft iron, how sure they are, why no surer and what to do for "
        "better. Zoom into the log to use a part of it; Directions shows where no sample is; Deviation map shows what compensation takes away at each heading and pitch; the model is saved as JSON or as a C header, or stored among the sensor models of the compass from whose page this one was opened.");
    return page;
}

PageDescription SensorTestsPage::description(PageContext& context)
{
    PageDescription page{QStringLiteral("sensorTests"),
        [&context] { return new SensorTestsPage(context.edits, context.undo, context.settings, context.files); }};
    page.commands = {{MenuId::Model, 117, tr("&Tests of a sensor: spectrum, coil, interference…"), tr("Ctrl+Alt+T"), "sensorTests",
        [&context](Page& shown) {
            context.go({"sensorTests", shown.shown().compass.valid() ? FleetItem(shown.shown().compass) : FleetItem()});
        }}};
    page.outputs = {{MenuId::File, 218, tr("Write the &report as PDF…"), {}, "writeSensorTestReport",
        [](Page& shown) { dynamic_cast<SensorTestsPage&>(shown).writeReport(); }}};
    page.help = tr(
        "Spectrum: Welch's method (1967), periodic Hann window, half overlap; lines are named by the supplies (50, 60, 115, 400 Hz and harmonics) or by orders of a rotor, "
        "also where sampling folds them down: a frequency f stands at |f − n·rate|, and one that falls on 0 looks like hard iron. Notches of Q 5 cost 1/(2π f Q) of delay, a "
        "low-pass 1/(2π f). Coil: measured = scale · applied + bias + temperature + hysteresis; opened from a compass, a bench is kept with it, held against earlier ones, and its noise, hysteresis and nonlinearity are in the errors of every later swing. Interference: the aircraft stands still, things are switched at noted times, and "
        "the field must not change by more than 5, 5 and 8 mG (500, 500, 800 nT) on x, y and z, as makers ask.");
    return page;
}

PageDescription LineOfSightPage::description(PageContext& context)
{
    PageDescription page{QStringLiteral("lineOfSight"), [&context] {
                             return new LineOfSightPage(
                                 context.files, [&context] { return QString::fromStdString(context.stores.clock().nowUtc()); });
                         }};
    page.commands = {{MenuId::Model, 118, tr("&Line of sight of a helmet…"), tr("Ctrl+Alt+H"), "lineOfSight",
        [&context](Page&) { context.go({"lineOfSight"}); }}};
    page.outputs = {{MenuId::File, 219, tr("Write the &report as PDF…"), {}, "writeLineOfSightReport",
        [](Page& shown) { dynamic_cast<LineOfSightPage&>(shown).writeReport(); }}};
    page.help = tr(
        "Two magnetic sensors tell where a helmet looks in the aircraft: heading of the helmet less heading of the aircraft, each levelled by its own pitch and roll. An error of a tilt turns a heading by "
        "up to tan(dip) times itself, iron at the two sensors works opposite ways, and a constant field of the cockpit turns the helmet's north. Errors that stay are summed with their sign, those by chance as squares; "
        "both are carried through the turret's mount. A field that coils make to track the helmet is not modelled.");
    return page;
}

} // namespace lubberline::ui
