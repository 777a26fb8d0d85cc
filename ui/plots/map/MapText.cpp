#include "ui/plots/map/MapText.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <cmath>

#include "core/angle/AngleText.h"
#include "core/base/Contract.h"
#include "ui/text/AngleWords.h"
#include "ui/text/NumberText.h"

namespace lubberline::ui {

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(lubberline::ui::MapText)
};

QString axisName(AttitudeAxis axis)
{
    switch (axis) {
    case AttitudeAxis::Heading: return Words::tr("heading");
    case AttitudeAxis::Pitch: return Words::tr("pitch");
    case AttitudeAxis::Roll: return Words::tr("roll");
    }
    return {};
}

} // namespace

QString attitudeTitle(AttitudeAxis axis)
{
    switch (axis) {
    case AttitudeAxis::Heading: return Words::tr("magnetic heading (°)");
    case AttitudeAxis::Pitch: return Words::tr("pitch (°, nose up +)");
    case AttitudeAxis::Roll: return Words::tr("roll (°, starboard down +)");
    }
    return {};
}

QString attitudeText(AttitudeAxis axis, double value_deg)
{
    const QString value = axis == AttitudeAxis::Heading ? shownHeading(value_deg, 0)
        : shownAngles() == AngleStyle::DegreesMinutes   ? angleTick(value_deg, 0.1) // it is neither east nor west
                                                        : signedNumber(value_deg, 1) + QStringLiteral("°");
    return axisName(axis) + " " + value;
}

QString attitudeTick(AttitudeAxis axis, double value_deg)
{
    if (axis != AttitudeAxis::Heading)
        return signedTick(value_deg, std::abs(value_deg - std::round(value_deg)) < 1e-6 ? 1.0 : 0.1);
    static constexpr const char* kPoints[] = {" N", " E", " S", " W"};
    const int whole_deg = static_cast<int>(std::lround(value_deg));
    return QStringLiteral("%1").arg(whole_deg, 3, 10, QChar('0')) + (whole_deg % 90 == 0 ? kPoints[whole_deg / 90 % 4] : "");
}

QString kindWord(const MapPicture& picture) { return picture.measured ? Words::tr("MEASURED") : Words::tr("MODELLED"); }

QString mapCaption(const MapPicture& picture)
{
    QStringList parts;
    if (!picture.title.isEmpty())
        parts += picture.title;
    if (picture.map)
        parts += attitudeText(heldAxis(picture.map->request), picture.map->request.held_deg);
    return parts.join(QStringLiteral(" · "));
}

QString mapValueTitle(const MapPicture& picture)
{
    return picture.difference ? Words::tr("difference of deviations (°, east +)") : Words::tr("deviation (°, east +)");
}

QString mapValueText(double value_deg) { return shownAngle(value_deg); }

QString vanishingText() { return Words::tr("horizontal field vanishes"); }

QString mapReadOut(const MapPicture& picture, double x_deg, double y_deg, std::optional<double> value_deg)
{
    const MapRequest& request = picture.map->request;
    const auto band_deg = value_deg && picture.band_deg ? picture.band_deg(x_deg, y_deg) : std::nullopt;
    QString value = !value_deg ? vanishingText()
        : picture.difference   ? Words::tr("difference %1").arg(mapValueText(*value_deg))
                               : Words::tr("deviation %1").arg(mapValueText(*value_deg));
    if (band_deg)
        value = Words::tr("%1 ± %2° (95 %, by its calibration)").arg(value).arg(*band_deg, 0, 'f', *band_deg < 0.95 ? 2 : 1);
    return Words::tr("%1, %2, %3").arg(attitudeText(request.x.axis, x_deg), attitudeText(request.y.axis, y_deg), value);
}

NiceScale mapScale(const MapPicture& picture, double largest_deg)
{
    LUBBERLINE_EXPECT(std::isfinite(picture.scale_deg) && picture.scale_deg >= 0, "a colour range is not negative");
    NiceScale scale = niceScale(picture.scale_deg > 0 ? picture.scale_deg : largest_deg, 5, 0.1);
    if (picture.scale_deg > 0)
        scale.end = picture.scale_deg;
    scale.end = std::min(scale.end, 180.0);
    return scale;
}

} // namespace lubberline::ui
