#include "ui/kit/PlaceText.h"

#include <QCoreApplication>

#include <cmath>
#include <optional>

#include "core/angle/AngleText.h"
#include "ui/plots/world/WorldFieldText.h"
#include "ui/text/NumberText.h"
#include "ui/text/Translated.h"

namespace lubberline::ui {

namespace {

struct PlaceTextTexts {
    Q_DECLARE_TR_FUNCTIONS(lubberline::ui::PlaceText)
};

Error wrong(const QString& message) { return {ErrorCode::InvalidInput, said(message)}; }

QString toType(double value_deg, QChar positive, QChar negative)
{
    return QString::number(std::round(std::abs(value_deg) * 1e4) / 1e4, 'g', 10) + " " + (value_deg < 0 ? negative : positive);
}

} // namespace

Result<double> parseLatitude_deg(const QString& text)
{
    const auto latitude_deg = lubberline::parseLatitude_deg(text.toStdString());
    if (!latitude_deg)
        return wrong(PlaceTextTexts::tr("“%1” is no latitude; expected 90 S to 90 N, as 51.55 N, 51°33'N or -33.9").arg(text.trimmed()));
    return latitude_deg;
}

Result<double> parseLongitude_deg(const QString& text)
{
    if (const auto number = typedNumber(text))
        return *number;
    const auto longitude_deg = parseSignedAngle_deg(text.trimmed().toStdString());
    if (!longitude_deg)
        return wrong(
            PlaceTextTexts::tr("“%1” is no longitude; expected degrees, east positive, as 21.89 E, 21°53'E or -70.67").arg(text.trimmed()));
    return longitude_deg;
}

Result<double> parseHeight_m(const QString& text)
{
    if (text.trimmed().isEmpty())
        return 0.0;
    const auto height_m = typedNumber(text);
    if (!height_m)
        return wrong(PlaceTextTexts::tr("“%1” is no height; expected metres, as 118").arg(text.trimmed()));
    return *height_m;
}

QString placeText(const Place& place) { return latitudeText(place.latitude_deg, 2) + " " + longitudeText(place.longitude_deg, 2); }
QString latitudeToType(double latitude_deg) { return toType(latitude_deg, u'N', u'S'); }
QString longitudeToType(double longitude_deg) { return toType(longitude_deg, u'E', u'W'); }

} // namespace lubberline::ui
