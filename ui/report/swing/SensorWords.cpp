/// The sensor model of a report: its parameters, its coefficients in the swing's field, and its map.

#include "core/sensor/PoissonSmith.h"
#include "ui/report/page/Figures.h"
#include "ui/report/page/Words.h"
#include "ui/report/swing/FieldPage.h"

namespace lubberline::ui {

namespace {

using Align = TableColumn::Align;

/// What is flown; beyond it a map tells the modeller more than the crew.
constexpr double kMostRoll_deg = 60;
constexpr int kHeadings = 181, kRolls = 121;

TableRow vectorRow(const QString& name, const QString& unit, const QStringList& figures)
{
    return {QStringList{name, unit} + figures, TableRow::Look::Plain};
}

QStringList figuresOf(const Eigen::Vector3d& vector, int decimals)
{
    return {signedFigure(vector.x(), decimals), signedFigure(vector.y(), decimals), signedFigure(vector.z(), decimals)};
}

Table parametersTable(const SensorModel& model)
{
    Table table{Words::tr("Parameters of the sensor model"), {}, {}};
    table.columns = {{Words::tr("Parameter"), {}, {}, 62, Align::Left}, {Words::tr("Unit"), {}, {}, 18, Align::Left},
        {Words::tr("x"), Words::tr("forward"), {}, 26}, {Words::tr("y"), Words::tr("starboard"), {}, 26},
        {Words::tr("z"), Words::tr("down"), {}, 26}};
    const QString none = Words::tr("no unit"), nT = QStringLiteral("nT");
    const std::array rows{Words::tr("Soft iron a, b, c"), Words::tr("Soft iron d, e, f"), Words::tr("Soft iron g, h, k")};
    for (int i = 0; i < 3; ++i)
        table.rows.push_back(vectorRow(rows[static_cast<std::size_t>(i)], none, figuresOf(model.softIron.row(i).transpose(), 4)));
    table.rows.push_back(vectorRow(Words::tr("Hard iron P, Q, R"), nT, figuresOf(model.hardIron_nT, 1)));
    table.rows.push_back(vectorRow(Words::tr("Soft constants"), nT, figuresOf(model.softConstant_nT, 1)));
    for (const auto& circuit : model.circuits)
        table.rows.push_back(
            vectorRow(Words::tr("%1, %2 A, %3")
                          .arg(printable(circuit.name), figure(circuit.current_A, 1), circuit.on ? Words::tr("on") : Words::tr("off")),
                QStringLiteral("nT/A"), figuresOf(circuit.field_nT_per_A, 2)));
    const auto& mount = model.misalignment;
    table.rows.push_back(vectorRow(Words::tr("Misalignment: roll, pitch, yaw"), QStringLiteral("°"),
        {signedFigure(toDegrees(mount.roll_rad), 2), signedFigure(toDegrees(mount.pitch_rad), 2),
            signedFigure(toDegrees(mount.yaw_rad), 2)}));
    return table;
}

QString termsOf(const PoissonSmith& smith, Coefficient which)
{
    QStringList terms;
    for (const auto& term : smith.terms)
        if (term.coefficient == which)
            terms += QStringLiteral("%1 %2").arg(printable(term.cause), signedFigure(term.value, 4));
    return terms.isEmpty() ? dash() : terms.join(QStringLiteral(", "));
}

Table smithTable(const PoissonSmith& smith)
{
    Table table{Words::tr("Its coefficients in the field of this swing"), {}, {}};
    table.columns = {{Words::tr("Coefficient"), {}, {}, 20, Align::Left}, {Words::tr("Exact"), {}, Words::tr("no unit"), 22},
        {Words::tr("As an angle"), {}, QStringLiteral("°"), 22}, {Words::tr("Comes from"), {}, {}, 94, Align::Left}};
    const std::array exact{smith.exact.A, smith.exact.B, smith.exact.C, smith.exact.D, smith.exact.E};
    std::array<std::optional<double>, kCoefficientCount> angles_rad;
    if (const auto& a = smith.approximate)
        angles_rad = {a->A_rad, a->B_rad, a->C_rad, a->D_rad, a->E_rad};
    for (const Coefficient c : kCoefficients) {
        TableRow row;
        row.cells = {QChar::fromLatin1(letterOf(c)), signedFigure(exact[indexOf(c)], 4), signedFigure(inDegrees(angles_rad[indexOf(c)]), 2),
            termsOf(smith, c)};
        table.rows.push_back(row);
    }
    return table;
}

MapPicture mapOf(const ReportInput& input, const SensorModel& model, const QString& title)
{
    MapRequest request;
    request.x = {AttitudeAxis::Heading, fullRange(AttitudeAxis::Heading), kHeadings};
    request.y = {AttitudeAxis::Roll, {-kMostRoll_deg, kMostRoll_deg}, kRolls};
    auto map = std::make_shared<DeviationMap>();
    computeMap(responseOf(model), input.record.swing.field->field.meridian(), request, *map);
    MapPicture picture;
    picture.title = title;
    if (input.record.limits)
        picture.limit_deg = input.record.limits->maxDeviation_deg;
    picture.extremes = extremesOf(*map, 4);
    picture.vanishing = vanishingPlaces(*map);
    picture.map = std::move(map);
    return picture;
}

} // namespace

void describeSensor(const ReportInput& input, const SensorRecord& sensor, FieldPage& page)
{
    page.sensor = {{Words::tr("Name"), joined({printable(sensor.name), wordFor(sensor.origin)})}};
    if (const QString note = printable(sensor.note); !note.isEmpty())
        page.sensor.push_back({Words::tr("Note"), note});
    page.parameters = parametersTable(sensor.model);
    if (!input.record.swing.field) {
        page.sensor.push_back({Words::tr("In use"),
            Words::tr("the swing keeps no field of the Earth's; without H and dip the model has neither coefficients nor a map")});
        return;
    }
    if (const auto smith = smithOf(sensor.model, input.record.swing.field->field.meridian())) {
        page.sensor.push_back({Words::tr("Directive force"),
            Words::tr("λ = %1: mean horizontal field at the sensor as a part of H").arg(figure(smith->lambda, 4))});
        if (!smith->whyNoApproximate.empty())
            page.sensor.push_back({Words::tr("Angles"), printable(smith->whyNoApproximate)});
        page.smith = smithTable(*smith);
    } else {
        page.sensor.push_back({Words::tr("Coefficients"), printable(smith.error().message)});
    }
    page.map = mapOf(input, sensor.model, printable(sensor.name));
}

} // namespace lubberline::ui
