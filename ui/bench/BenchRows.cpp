#include "ui/bench/BenchRows.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/angle/Angle.h"
#include "core/angle/WrittenDegrees.h"
#include "core/base/Number.h"
#include "core/record/DefaultNames.h"
#include "ui/kit/Words.h"

namespace lubberline::ui {

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(lubberline::ui::BenchRows)
};

constexpr std::array kShapes{"box", "cylinder", "ellipsoid", "sphere"};

Error wrong(int row, const QString& what) { return {ErrorCode::InvalidInput, said(Words::tr("row %1: %2").arg(row + 1).arg(what))}; }

QString text(double value) { return toText(shortestNumber(value)); }
QString text(const Eigen::Vector3d& v) { return text(v.x()) + ' ' + text(v.y()) + ' ' + text(v.z()); }

/// Numbers apart by spaces (or × and semicolons), decimal point or comma.
Result<std::vector<double>> numbers(const QString& cell)
{
    static const QRegularExpression separators(QStringLiteral("[\\s;×x]+"));
    std::vector<double> values;
    for (const QString& part : cell.split(separators, Qt::SkipEmptyParts)) {
        const FileNumber number = readNumber(part.toStdString(), true);
        if (number.fault != NumberFault::None)
            return Error{ErrorCode::InvalidInput, said(Words::tr("\"%1\" is not a number").arg(part))};
        values.push_back(number.value);
    }
    return values;
}

/// `count` numbers, or none where an empty cell is zero.
Result<std::vector<double>> numbers(const QString& cell, std::size_t count, bool mayBeEmpty)
{
    auto values = numbers(cell);
    if (values && values->empty() && mayBeEmpty)
        return std::vector<double>(count, 0.0);
    if (values && values->size() != count)
        return Error{ErrorCode::InvalidInput,
            said(Words::tr("\"%1\" has %2 numbers; expected %3 apart by spaces").arg(cell).arg(values->size()).arg(count))};
    return values;
}

Eigen::Vector3d vector(const std::vector<double>& values) { return {values[0], values[1], values[2]}; }

QString sizeText(const Shape& shape)
{
    if (const auto* box = std::get_if<Box>(&shape))
        return text(box->size_m);
    if (const auto* cylinder = std::get_if<Cylinder>(&shape))
        return text(cylinder->diameter_m) + ' ' + text(cylinder->length_m);
    if (const auto* ellipsoid = std::get_if<Ellipsoid>(&shape))
        return text(ellipsoid->size_m);
    return text(std::get<Sphere>(shape).diameter_m);
}

Result<Shape> shapeOf(const QString& name, const QString& size)
{
    const auto found = std::find(kShapes.begin(), kShapes.end(), name.trimmed().toLower().toStdString());
    if (found == kShapes.end())
        return Error{ErrorCode::InvalidInput, said(Words::tr("\"%1\" is no shape; expected box, cylinder, ellipsoid or sphere").arg(name))};
    const auto kind = found - kShapes.begin();
    const auto values = numbers(size, kind == 1 ? 2 : kind == 3 ? 1 : 3, false);
    if (!values)
        return values.error();
    if (kind == 0)
        return Shape(Box{vector(*values)});
    if (kind == 1)
        return Shape(Cylinder{(*values)[0], (*values)[1]});
    if (kind == 2)
        return Shape(Ellipsoid{vector(*values)});
    return Shape(Sphere{(*values)[0]});
}

QString cell(const QStringList& row, PartColumn column) { return row.value(static_cast<int>(column)).trimmed(); }
QString cell(const QStringList& row, ConductorColumn column) { return row.value(static_cast<int>(column)).trimmed(); }

Result<FerrousPart> partOf(const QStringList& row)
{
    FerrousPart part;
    part.name = cell(row, PartColumn::Name).toStdString();
    const auto shape = shapeOf(cell(row, PartColumn::Shape), cell(row, PartColumn::Size));
    if (!shape)
        return shape.error();
    part.shape = *shape;
    const auto susceptibility = numbers(cell(row, PartColumn::Susceptibility), 1, true),
               remanence = numbers(cell(row, PartColumn::Remanence), 3, true);
    if (!susceptibility)
        return susceptibility.error();
    if (!remanence)
        return remanence.error();
    part.susceptibility = susceptibility->front();
    part.remanence_T = vector(*remanence);
    part.group = cell(row, PartColumn::Group).toStdString();
    if (const QString typed = cell(row, PartColumn::Coercivity); !typed.isEmpty()) {
        const auto coercivity = numbers(typed, 1, false);
        if (!coercivity)
            return coercivity.error();
        if (!(coercivity->front() >= 0))
            return Error{ErrorCode::InvalidInput, said(Words::tr("a coercivity is 0 A/m or more"))};
        part.coercivity_A_per_m = coercivity->front();
    }
    return part;
}

Result<Placement> placementOf(const QStringList& row)
{
    const auto centre = numbers(cell(row, PartColumn::Centre), 3, false), turn = numbers(cell(row, PartColumn::Turn), 3, true);
    if (!centre)
        return centre.error();
    if (!turn)
        return turn.error();
    return Placement{
        cell(row, PartColumn::State).toStdString(), vector(*centre), toRadians((*turn)[0]), toRadians((*turn)[1]), toRadians((*turn)[2])};
}

QString turnText(const Placement& at)
{
    return text(writtenDegrees(at.roll_rad)) + ' ' + text(writtenDegrees(at.pitch_rad)) + ' ' + text(writtenDegrees(at.yaw_rad));
}

Result<std::variant<CurrentLoop, WirePath>> conductorOf(const QStringList& row)
{
    const QString kind = cell(row, ConductorColumn::Kind).toLower();
    const auto values = numbers(cell(row, ConductorColumn::Geometry));
    if (!values)
        return values.error();
    if (kind == QLatin1String("loop")) {
        if (values->size() != 8)
            return Error{ErrorCode::InvalidInput, said(Words::tr("a loop has 8 numbers: centre x y z; normal x y z; diameter; turns"))};
        if (!((*values)[7] >= 1 && (*values)[7] <= 1e6 && (*values)[7] == std::floor((*values)[7])))
            return Error{ErrorCode::InvalidInput, said(Words::tr("a loop has a whole number of turns, 1 or more"))};
        return std::variant<CurrentLoop, WirePath>(CurrentLoop{{(*values)[0], (*values)[1], (*values)[2]},
            {(*values)[3], (*values)[4], (*values)[5]}, (*values)[6], static_cast<int>((*values)[7])});
    }
    if (kind != QLatin1String("wire"))
        return Error{ErrorCode::InvalidInput, said(Words::tr("\"%1\" is no conductor; expected loop or wire").arg(kind))};
    if (values->size() < 6 || values->size() % 3 != 0)
        return Error{ErrorCode::InvalidInput, said(Words::tr("a wire has points x y z; x y z; … two at least"))};
    WirePath path;
    for (std::size_t i = 0; i + 2 < values->size(); i += 3)
        path.points_m.push_back({(*values)[i], (*values)[i + 1], (*values)[i + 2]});
    return std::variant<CurrentLoop, WirePath>(path);
}

QStringList conductorRow(const std::variant<CurrentLoop, WirePath>& conductor)
{
    if (const auto* loop = std::get_if<CurrentLoop>(&conductor))
        return {QStringLiteral("loop"),
            text(loop->centre_m) + QStringLiteral("; ") + text(loop->normal) + QStringLiteral("; ") + text(loop->diameter_m)
                + QStringLiteral("; ") + QString::number(loop->turns)};
    QStringList points;
    for (const auto& point : std::get<WirePath>(conductor).points_m)
        points << text(point);
    return {QStringLiteral("wire"), points.join(QStringLiteral("; "))};
}

Result<void> addPart(IronBench& bench, const QStringList& row)
{
    if (cell(row, PartColumn::Name).isEmpty()) { // another placement of the part above
        if (bench.parts.empty())
            return Error{ErrorCode::InvalidInput, said(Words::tr("the first row has no name"))};
    } else {
        auto part = partOf(row);
        if (!part)
            return part.error();
        bench.parts.push_back(std::move(part.value()));
    }
    const auto placement = placementOf(row);
    if (!placement)
        return placement.error();
    bench.parts.back().placements.push_back(*placement);
    return {};
}

Result<void> addConductor(IronBench& bench, const QStringList& row)
{
    if (cell(row, ConductorColumn::Circuit).isEmpty()) {
        if (bench.circuits.empty())
            return Error{ErrorCode::InvalidInput, said(Words::tr("the first conductor has no circuit"))};
    } else {
        const auto current = numbers(cell(row, ConductorColumn::Current), 1, true);
        if (!current)
            return current.error();
        const QString on = cell(row, ConductorColumn::On).toLower();
        if (on != QLatin1String("on") && on != QLatin1String("off"))
            return Error{ErrorCode::InvalidInput, said(Words::tr("\"%1\" is no state of a circuit; expected on or off").arg(on))};
        bench.circuits.push_back({cell(row, ConductorColumn::Circuit).toStdString(), {}, current->front(), on == QLatin1String("on")});
    }
    const auto conductor = conductorOf(row);
    if (!conductor)
        return conductor.error();
    bench.circuits.back().conductors.push_back(*conductor);
    return {};
}

} // namespace

QStringList partHeads()
{
    return {Words::tr("part"), Words::tr("shape"), Words::tr("size (m)"), Words::tr("χ"), Words::tr("remanence (T)"), Words::tr("group"),
        Words::tr("state"), Words::tr("centre x y z (m)"), Words::tr("roll pitch yaw (°)"), Words::tr("coercivity (A/m)")};
}

QStringList conductorHeads()
{
    return {Words::tr("circuit"), Words::tr("current (A)"), Words::tr("on/off"), Words::tr("kind"), Words::tr("geometry (m)")};
}

QStringList newPart()
{
    return {toText(std::string(kNewPart)), QStringLiteral("box"), QStringLiteral("0.2 0.1 0.1"), QStringLiteral("100"), QString(),
        QString(), QString(), QStringLiteral("1 0 0"), QStringLiteral("0 0 0"), QString()};
}

QStringList newConductor()
{
    return {toText(std::string(kNewCircuit)), QStringLiteral("1"), QStringLiteral("off"), QStringLiteral("wire"),
        QStringLiteral("1 0.5 0; 1 -0.5 0")};
}

BenchRows rowsOf(const IronBench& bench)
{
    BenchRows rows{text(bench.sensor_m), {}, {}};
    for (const auto& part : bench.parts)
        for (std::size_t i = 0; i < part.placements.size(); ++i) {
            const Placement& at = part.placements[i];
            QStringList row;
            if (i == 0)
                row << toText(part.name) << QString::fromLatin1(kShapes[part.shape.index()]) << sizeText(part.shape)
                    << text(part.susceptibility) << text(part.remanence_T) << toText(part.group);
            else
                row << QString() << QString() << QString() << QString() << QString() << QString();
            row << toText(at.state) << text(at.centre_m) << turnText(at);
            rows.parts.push_back(row << (i == 0 && part.coercivity_A_per_m ? text(*part.coercivity_A_per_m) : QString()));
        }
    for (const auto& circuit : bench.circuits)
        for (std::size_t i = 0; i < circuit.conductors.size(); ++i) {
            QStringList row{QString(), QString(), QString()};
            if (i == 0)
                row = {toText(circuit.name), text(circuit.current_A), circuit.on ? QStringLiteral("on") : QStringLiteral("off")};
            rows.conductors.push_back(row + conductorRow(circuit.conductors[i]));
        }
    return rows;
}

Result<IronBench> benchOf(const BenchRows& rows)
{
    IronBench bench;
    const auto sensor = numbers(rows.sensor, 3, true);
    if (!sensor)
        return Error{ErrorCode::InvalidInput, said(Words::tr("sensor: %1").arg(toText(sensor.error().message)))};
    bench.sensor_m = vector(*sensor);
    for (std::size_t i = 0; i < rows.parts.size(); ++i)
        if (const auto added = addPart(bench, rows.parts[i]); !added)
            return wrong(static_cast<int>(i), toText(added.error().message));
    for (std::size_t i = 0; i < rows.conductors.size(); ++i)
        if (const auto added = addConductor(bench, rows.conductors[i]); !added)
            return wrong(static_cast<int>(i), Words::tr("(circuits) %1").arg(toText(added.error().message)));
    return bench;
}

} // namespace lubberline::ui
