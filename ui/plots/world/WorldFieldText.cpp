#include "ui/plots/world/WorldFieldText.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

#include "ui/plots/base/NiceScale.h"
#include "ui/plots/map/MapText.h"

namespace lubberline::ui {

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(lubberline::ui::WorldFieldText)
};

QString elementName(FieldElement element)
{
    switch (element) {
    case FieldElement::Declination: return Words::tr("declination");
    case FieldElement::Inclination: return Words::tr("inclination");
    case FieldElement::Horizontal: return Words::tr("horizontal field H");
    case FieldElement::Down: return Words::tr("vertical field Z");
    case FieldElement::Total: return Words::tr("total field F");
    }
    return {};
}

QString degreesText(double value_deg, int decimals, const QString& positive, const QString& negative)
{
    const QString digits = QString::number(std::abs(value_deg), 'f', decimals) + u'°';
    const bool zero = std::abs(value_deg) < 0.5 * std::pow(10.0, -decimals);
    return zero ? digits : digits + " " + (value_deg > 0 ? positive : negative);
}

} // namespace

bool isAngle(FieldElement element) { return element == FieldElement::Declination || element == FieldElement::Inclination; }

QString fieldElementTitle(FieldElement element)
{
    const QString unit = element == FieldElement::Declination ? Words::tr("°, east +")
        : element == FieldElement::Inclination                ? Words::tr("°, down +")
        : element == FieldElement::Down                       ? Words::tr("nT, down +")
                                                              : Words::tr("nT");
    return elementName(element) + " (" + unit + ")";
}

QString isolineText(FieldElement element, double level)
{
    if (isAngle(element))
        return signedTick(level, 1) + u'°';
    return plainTick(level, 1);
}

QString latitudeText(double latitude_deg, int decimals) { return degreesText(latitude_deg, decimals, Words::tr("N"), Words::tr("S")); }
QString longitudeText(double longitude_deg, int decimals) { return degreesText(longitude_deg, decimals, Words::tr("E"), Words::tr("W")); }

double gridValueAt(const FieldGrid& grid, double latitude_deg, double longitude_deg)
{
    const double x = std::clamp((longitude_deg + 180) / 360 * (grid.columns - 1), 0.0, grid.columns - 1.0);
    const double y = std::clamp((latitude_deg + 90) / 180 * (grid.rows - 1), 0.0, grid.rows - 1.0);
    const int column = std::min(static_cast<int>(x), grid.columns - 2), row = std::min(static_cast<int>(y), grid.rows - 2);
    const auto node = [&](int dx, int dy) { return grid.values[static_cast<std::size_t>(row + dy) * grid.columns + column + dx]; };
    const auto [least, most] = std::minmax({node(0, 0), node(1, 0), node(0, 1), node(1, 1)});
    if (grid.element == FieldElement::Declination && most - least > 180)
        return node(x - column >= 0.5, y - row >= 0.5);
    return std::lerp(std::lerp(node(0, 0), node(1, 0), x - column), std::lerp(node(0, 1), node(1, 1), x - column), y - row);
}

QString worldReadOut(const FieldGrid& grid, double latitude_deg, double longitude_deg)
{
    const double value = gridValueAt(grid, latitude_deg, longitude_deg);
    const QString text = isAngle(grid.element) ? mapValueText(value) : plainTick(value, 1) + Words::tr(" nT");
    return Words::tr("%1, %2: %3 %4").arg(latitudeText(latitude_deg, 1), longitudeText(longitude_deg, 1), elementName(grid.element), text);
}

} // namespace lubberline::ui
