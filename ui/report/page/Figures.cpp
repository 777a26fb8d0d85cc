#include "ui/report/page/Figures.h"

#include <algorithm>
#include <cmath>

#include "core/angle/PrintedHeading.h"
#include "ui/text/NumberText.h"

namespace lubberline::ui {

namespace {

constexpr int kMostDecimals = 3;

int decimalsOf(double value)
{
    double scale = 10;
    for (int decimals = 1; decimals < kMostDecimals; ++decimals, scale *= 10)
        if (std::abs(value * scale - std::round(value * scale)) < 1e-6)
            return decimals;
    return kMostDecimals;
}

int decimalsOf(const Swing& swing)
{
    int decimals = 1;
    for (const Reading& reading : swing.readings) {
        if (reading.magnetic)
            decimals = std::max(decimals, decimalsOf(reading.magnetic->degrees()));
        if (reading.compass)
            decimals = std::max(decimals, decimalsOf(reading.compass->degrees()));
        if (reading.nominal_deg)
            decimals = std::max(decimals, decimalsOf(*reading.nominal_deg));
    }
    return decimals;
}

} // namespace

QString dash() { return QStringLiteral("—"); }

QString figure(std::optional<double> value, int decimals)
{
    return value && std::isfinite(*value) ? plainNumber(*value, decimals) : dash();
}

QString headingFigure(std::optional<double> heading_deg, int decimals)
{
    return heading_deg && std::isfinite(*heading_deg) ? figure(printedHeading_deg(*heading_deg, decimals), decimals) : dash();
}

QString signedFigure(std::optional<double> value, int decimals)
{
    return value && std::isfinite(*value) ? signedNumber(*value, decimals) : dash();
}

std::optional<double> inDegrees(std::optional<double> angle_rad) { return angle_rad ? std::optional(toDegrees(*angle_rad)) : std::nullopt; }

QString headingWords(double heading_deg, AngleStyle style) { return QString::fromStdString(formatHeading(heading_deg, style)); }

QString angleWords(double angle_deg, AngleStyle style) { return QString::fromStdString(formatSignedAngle(angle_deg, style)); }

AngleFigures::AngleFigures(AngleStyle style, const Swing& swing) : m_style(style), m_decimals(decimalsOf(swing)) {}

QString AngleFigures::heading(std::optional<double> heading_deg) const
{
    return heading_deg ? bare(formatHeading(*heading_deg, m_style, m_decimals)) : dash();
}

QString AngleFigures::angle(std::optional<double> angle_deg) const
{
    return angle_deg ? bare(formatSignedAngle(*angle_deg, m_style, m_decimals)) : dash();
}

QString AngleFigures::unit() const { return m_style == AngleStyle::DecimalDegrees ? QStringLiteral("°") : QStringLiteral("° ′"); }

QString AngleFigures::bare(const std::string& text) const
{
    QString figure = QString::fromStdString(text);
    if (m_style == AngleStyle::DecimalDegrees)
        figure.remove(QChar(0x00B0));
    return figure;
}

} // namespace lubberline::ui
