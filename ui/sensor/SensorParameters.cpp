#include "ui/sensor/SensorParameters.h"

#include <QCoreApplication>

#include "core/angle/Angle.h"

namespace lubberline::ui {

namespace {

/// Ends of the sliders: beyond the iron of usual aircraft, so that the hand sees where a compass fails. More may be typed.
constexpr double kSoftIron = 0.5, kHardIron_nT = 20000, kMount_deg = 20, kCurrent_A = 100, kPerAmpere_nT = 200;
/// What may be typed: Model JSON and exchange files take it too.
constexpr double kMostSoftIron = 100, kMostField_nT = 1e6, kMostCurrent_A = 1e5;

struct SensorParametersTexts {
    Q_DECLARE_TR_FUNCTIONS(lubberline::ui::SensorParameters)
};

ParameterSpec symmetric(
    const QString& name, const QString& label, const QString& meaning, const QString& suffix, int decimals, double slider, double typed)
{
    return {name, label, meaning, suffix, decimals, -slider, slider, -typed, typed, suffix != QStringLiteral("°")};
}

ParameterSpec fieldSpec(const QString& name, const QString& label, const QString& meaning)
{
    return symmetric(name, label, meaning, QStringLiteral(" nT"), 1, kHardIron_nT, kMostField_nT);
}

ParameterSpec angleSpec(const QString& name, const QString& label, const QString& meaning, double slider_deg, double typed_deg)
{
    return symmetric(name, label, meaning, QStringLiteral("°"), 2, slider_deg, typed_deg);
}

std::vector<Parameter<SensorModel>> vectorParameters(Eigen::Vector3d SensorModel::*vector, const std::array<ParameterSpec, 3>& specs)
{
    std::vector<Parameter<SensorModel>> parameters;
    for (int axis = 0; axis < 3; ++axis)
        parameters.push_back(
            {specs[static_cast<std::size_t>(axis)], [vector, axis](const SensorModel& model) { return (model.*vector)(axis); },
                [vector, axis](SensorModel& model, double value) { (model.*vector)(axis) = value; }});
    return parameters;
}

} // namespace

std::vector<Parameter<SensorModel>> softIronParameters()
{
    static constexpr char kLetters[] = {'a', 'b', 'c', 'd', 'e', 'f', 'g', 'h', 'k'};
    const QString along[]
        = {SensorParametersTexts::tr("forward"), SensorParametersTexts::tr("to starboard"), SensorParametersTexts::tr("down")};
    std::vector<Parameter<SensorModel>> parameters;
    for (int i = 0; i < 9; ++i) {
        const int row = i / 3, column = i % 3;
        const QString letter(QLatin1Char(kLetters[i]));
        const QString meaning = SensorParametersTexts::tr("soft iron %1: field %2 for each nT %3").arg(letter, along[row], along[column]);
        parameters.push_back({symmetric(QStringLiteral("softIron_") + letter, letter, meaning, {}, 5, kSoftIron, kMostSoftIron),
            [row, column](const SensorModel& model) { return model.softIron(row, column); },
            [row, column](SensorModel& model, double value) { model.softIron(row, column) = value; }});
    }
    return parameters;
}

std::vector<Parameter<SensorModel>> hardIronParameters()
{
    return vectorParameters(&SensorModel::hardIron_nT,
        {fieldSpec("hardIron_P", "P", SensorParametersTexts::tr("hard iron P, forward")),
            fieldSpec("hardIron_Q", "Q", SensorParametersTexts::tr("hard iron Q, to starboard")),
            fieldSpec("hardIron_R", "R", SensorParametersTexts::tr("hard iron R, down"))});
}

std::vector<Parameter<PolarHardIron>> polarParameters()
{
    const ParameterSpec size{"polar_size", SensorParametersTexts::tr("size"), SensorParametersTexts::tr("size of the hard iron"),
        QStringLiteral(" nT"), 1, 0, kHardIron_nT, 0, kMostField_nT, true};
    return {
        {size, [](const PolarHardIron& polar) { return polar.size_nT; }, [](PolarHardIron& polar, double value) { polar.size_nT = value; }},
        {angleSpec("polar_elevation", QStringLiteral("γ"),
             SensorParametersTexts::tr("elevation γ of the hard iron, upward from the body's xy plane"), 90, 90),
            [](const PolarHardIron& polar) { return toDegrees(polar.elevation_rad); },
            [](PolarHardIron& polar, double value) { polar.elevation_rad = toRadians(value); }},
        {angleSpec("polar_azimuth", QStringLiteral("δ"),
             SensorParametersTexts::tr("azimuth δ of the hard iron, from forward towards starboard (not the deviation)"), 180, 180),
            [](const PolarHardIron& polar) { return toDegrees(polar.azimuth_rad); },
            [](PolarHardIron& polar, double value) { polar.azimuth_rad = toRadians(value); }}};
}

std::vector<Parameter<SensorModel>> softConstantParameters()
{
    return vectorParameters(&SensorModel::softConstant_nT,
        {fieldSpec("softConstant_1", QStringLiteral("D₁"), SensorParametersTexts::tr("soft constant D1, forward")),
            fieldSpec("softConstant_2", QStringLiteral("D₂"), SensorParametersTexts::tr("soft constant D2, to starboard")),
            fieldSpec("softConstant_3", QStringLiteral("D₃"), SensorParametersTexts::tr("soft constant D3, down"))});
}

std::vector<Parameter<SensorModel>> misalignmentParameters()
{
    const auto angle = [](const char* name, const QString& label, const QString& meaning, double Misalignment::*member) {
        return Parameter<SensorModel>{angleSpec(QLatin1String(name), label, meaning, kMount_deg, 180),
            [member](const SensorModel& model) { return toDegrees(model.misalignment.*member); },
            [member](SensorModel& model, double value) { model.misalignment.*member = toRadians(value); }};
    };
    return {angle("mount_roll", SensorParametersTexts::tr("roll"),
                SensorParametersTexts::tr("the sensor rolled in its mount, starboard side down +"), &Misalignment::roll_rad),
        angle("mount_pitch", SensorParametersTexts::tr("pitch"), SensorParametersTexts::tr("the sensor pitched in its mount, front up +"),
            &Misalignment::pitch_rad),
        angle("mount_yaw", SensorParametersTexts::tr("yaw"),
            SensorParametersTexts::tr("the sensor turned in its mount, clockwise from above +"), &Misalignment::yaw_rad)};
}

std::vector<Parameter<Circuit>> circuitParameters(const QString& prefix)
{
    std::vector<Parameter<Circuit>> parameters;
    parameters.push_back({symmetric(prefix + "Current", SensorParametersTexts::tr("current"), SensorParametersTexts::tr("current"),
                              QStringLiteral(" A"), 2, kCurrent_A, kMostCurrent_A),
        [](const Circuit& circuit) { return circuit.current_A; }, [](Circuit& circuit, double value) { circuit.current_A = value; }});
    const QString along[]
        = {SensorParametersTexts::tr("forward"), SensorParametersTexts::tr("to starboard"), SensorParametersTexts::tr("down")};
    for (int axis = 0; axis < 3; ++axis) {
        const QString letter(QLatin1Char("STV"[axis]));
        parameters.push_back(
            {symmetric(prefix + letter, letter, SensorParametersTexts::tr("field %1 for each ampere, %2").arg(letter, along[axis]),
                 QStringLiteral(" nT/A"), 2, kPerAmpere_nT, kMostField_nT),
                [axis](const Circuit& circuit) { return circuit.field_nT_per_A(axis); },
                [axis](Circuit& circuit, double value) { circuit.field_nT_per_A(axis) = value; }});
    }
    return parameters;
}

} // namespace lubberline::ui
