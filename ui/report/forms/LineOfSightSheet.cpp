#include "ui/report/forms/LineOfSightSheet.h"

#include "core/angle/Angle.h"
#include "ui/plots/calibration/SightDrawing.h"
#include "ui/report/page/Figures.h"
#include "ui/report/page/Words.h"

namespace lubberline::ui {

namespace {

constexpr int kDecimals = 3;

TableRow sightRow(const QString& name, const QString& kind, const SightError& error, bool sign, TableRow::Look look)
{
    const auto angle = [sign](double value) { return sign ? signedFigure(value, kDecimals) : figure(value, kDecimals); };
    return {{name, kind, angle(error.aircraft.azimuth_deg), angle(error.aircraft.elevation_deg), angle(error.turret.azimuth_deg),
                angle(error.turret.elevation_deg)},
        look};
}

} // namespace

Table sightTable(const SightBudget& budget)
{
    const QString degrees = QStringLiteral("°");
    Table table{Words::tr("Causes"),
        {{Words::tr("Cause"), {}, {}, 58, TableColumn::Align::Left}, {Words::tr("Kind"), {}, {}, 26, TableColumn::Align::Left},
            {Words::tr("Azimuth"), Words::tr("aircraft"), degrees, 22}, {Words::tr("Elevation"), Words::tr("aircraft"), degrees, 22},
            {Words::tr("Azimuth"), Words::tr("turret"), degrees, 22}, {Words::tr("Elevation"), Words::tr("turret"), degrees, 22}},
        {}};
    for (const SightCause& cause : budget.causes)
        table.rows.push_back(sightRow(printable(cause.name), cause.byChance ? Words::tr("1 sigma") : Words::tr("stays"), cause.error,
            !cause.byChance, TableRow::Look::Plain));
    table.rows.push_back(sightRow(Words::tr("all that stays"), Words::tr("stays"), budget.stays, true, TableRow::Look::Plain));
    table.rows.push_back(sightRow(Words::tr("all by chance"), Words::tr("1 sigma"), budget.byChance, false, TableRow::Look::Plain));
    table.rows.push_back(sightRow(Words::tr("together"), Words::tr("root of squares"), budget.whole, false, TableRow::Look::Marked));
    return table;
}

QString sightWords(const SightBudget& budget)
{
    return Words::tr("Looking at azimuth %1°, elevation %2° in the aircraft (helmet: heading %3°, pitch %4°, roll %5°), that is %6°, %7° "
                     "for the turret: off by %8° in azimuth and %9° in elevation there.")
        .arg(signedFigure(budget.truth.aircraft.azimuth_deg, 1), signedFigure(budget.truth.aircraft.elevation_deg, 1),
            headingFigure(budget.helmet.heading.degrees(), 1), signedFigure(toDegrees(budget.helmet.pitch_rad), 1),
            signedFigure(toDegrees(budget.helmet.roll_rad), 1), signedFigure(budget.truth.turret.azimuth_deg, 1),
            signedFigure(budget.truth.turret.elevation_deg, 1), figure(budget.whole.turret.azimuth_deg, kDecimals),
            figure(budget.whole.turret.elevation_deg, kDecimals));
}

ReferenceSheet sightSheet(const SightCase& given, const SightBudget& budget)
{
    ReferenceSheet sheet;
    sheet.title = Words::tr("Line of sight of a helmet");
    sheet.text << sightWords(budget)
               << Words::tr("Field %1 nT, dip %2°; aircraft: heading %3°, pitch %4°, roll %5°. Noise of an axis %6 nT (aircraft) and %7 nT "
                            "(helmet); pitch and roll sure to %8° and %9°.")
                      .arg(figure(given.field.total_nT(), 0), signedFigure(toDegrees(given.field.inclination_rad()), 1),
                          headingFigure(given.aircraftAttitude.heading.degrees(), 1),
                          signedFigure(toDegrees(given.aircraftAttitude.pitch_rad), 1),
                          signedFigure(toDegrees(given.aircraftAttitude.roll_rad), 1), figure(given.aircraft.noise_nT, 0),
                          figure(given.helmet.noise_nT, 0), figure(given.aircraft.tiltError_deg, 2), figure(given.helmet.tiltError_deg, 2))
               << Words::tr("Turret: mount roll %1°, pitch %2°, yaw %3°, each sure to %4°. Field of the cockpit %5, %6, %7 nT.")
                      .arg(signedFigure(toDegrees(given.turret.roll_rad), 2), signedFigure(toDegrees(given.turret.pitch_rad), 2),
                          signedFigure(toDegrees(given.turret.yaw_rad), 2), figure(given.turretError_deg, 2),
                          signedFigure(given.cockpit_nT.x(), 0), signedFigure(given.cockpit_nT.y(), 0),
                          signedFigure(given.cockpit_nT.z(), 0));
    for (const Message& warning : budget.warnings)
        sheet.text << printable(warning);
    sheet.pictures.push_back(
        {80, [picture = sightDrawing(sightSweep(given))](QPainter& painter, const QRectF& rect) { renderDrawn(painter, rect, picture); }});
    sheet.table = sightTable(budget);
    return sheet;
}

} // namespace lubberline::ui
