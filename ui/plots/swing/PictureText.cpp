#include "ui/plots/swing/PictureText.h"

#include <QCoreApplication>
#include <QStringList>

#include <cmath>

#include "ui/plots/swing/PictureCurves.h"
#include "ui/text/NumberText.h"

namespace lubberline::ui {

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(lubberline::ui::Plots)
};

QString heading(double heading_deg, AngleStyle style) { return QString::fromStdString(formatHeading(heading_deg, style)); }

QString angle(double angle_deg, AngleStyle style, int decimals = 1)
{
    return QString::fromStdString(formatSignedAngle(angle_deg, style, decimals));
}

QString studentisedText(double t) { return plainNumber(t, std::abs(t) < 10 ? 1 : 0); }

QString join(const QStringList& parts) { return parts.join(QStringLiteral(" · ")); }

} // namespace

QString suspectLabel(const PlottedReading& reading)
{
    const int whole_deg = static_cast<int>(std::lround(reading.magnetic.degrees())) % 360;
    const QString where = QStringLiteral("%1°").arg(whole_deg, 3, 10, QChar('0'));
    if (!reading.studentised)
        return where;
    return Words::tr("%1 t = %2").arg(where, studentisedText(*reading.studentised));
}

QString readingReadOut(const PlottedReading& reading, const SwingPicture& picture)
{
    const AngleStyle style = picture.angleStyle;
    QStringList parts{Words::tr("magnetic %1").arg(heading(reading.magnetic.degrees(), style)),
        Words::tr("compass %1").arg(heading(reading.compass.degrees(), style)),
        Words::tr("deviation %1").arg(angle(reading.deviation.degrees(), style))};
    if (picture.analysis && picture.analysis->approximate.fitted())
        parts += Words::tr("residual %1").arg(angle(residual_deg(reading, picture.analysis->approximate), style, 2));
    if (reading.studentised)
        parts += Words::tr("t = %1").arg(studentisedText(*reading.studentised));
    if (reading.suspect)
        parts += Words::tr("suspect");
    if (reading.excluded)
        parts += Words::tr("excluded");
    return join(parts);
}

QString placeReadOut(double magnetic_deg, double deviation_deg, const SwingPicture& picture)
{
    const AngleStyle style = picture.angleStyle;
    QStringList parts{
        Words::tr("magnetic %1").arg(heading(wrap360(magnetic_deg), style)), Words::tr("deviation %1").arg(angle(deviation_deg, style))};
    if (picture.analysis && picture.analysis->exact.fitted()) {
        const Deviation fitted = deviationAt(picture.analysis->exact, MagneticHeading::fromDegrees(magnetic_deg));
        parts += Words::tr("exact fit %1").arg(angle(fitted.degrees(), style));
    }
    return join(parts);
}

QString residualReadOut(double magnetic_deg, double residual_deg, const SwingPicture& picture)
{
    return join({Words::tr("magnetic %1").arg(heading(wrap360(magnetic_deg), picture.angleStyle)),
        Words::tr("residual %1").arg(angle(residual_deg, picture.angleStyle, 2))});
}

QString componentsReadOut(double compass_deg, const SwingPicture& picture)
{
    QStringList parts{Words::tr("compass %1").arg(heading(wrap360(compass_deg), picture.angleStyle))};
    if (!picture.analysis || !picture.analysis->approximate.fitted())
        return parts.first();
    const ApproximateFit& fit = picture.analysis->approximate;
    const auto compass = CompassHeading::fromDegrees(compass_deg);
    for (const Coefficient which : kCoefficients) {
        if (fit.of(which))
            parts += componentName(which) + " " + angle(toDegrees(component_rad(fit.smith(), which, compass)), picture.angleStyle);
    }
    parts += Words::tr("sum %1").arg(angle(deviationAt(fit.smith(), compass).degrees(), picture.angleStyle));
    return join(parts);
}

QString orderReadOut(int order, const SwingPicture& picture)
{
    if (order < 0 || !picture.analysis)
        return {};
    const Harmonics& harmonics = picture.analysis->harmonics;
    const QString name = orderName(order);
    const QString title = name.isEmpty() ? Words::tr("order %1").arg(order) : Words::tr("order %1 (%2)").arg(order).arg(name);
    if (order > harmonics.highestResolvable)
        return join({title, Words::tr("not resolved by these headings (highest order: %1)").arg(harmonics.highestResolvable)});
    if (order >= static_cast<int>(harmonics.orders.size()))
        return {};
    const HarmonicOrder& found = harmonics.orders[order];
    QStringList parts{title, Words::tr("amplitude %1°").arg(toDegrees(found.amplitude_rad()), 0, 'f', 2)};
    if (found.standardError_rad)
        parts.last() += QStringLiteral(" ± %1°").arg(toDegrees(*found.standardError_rad), 0, 'f', 2);
    if (found.nyquist)
        parts += Words::tr("only its cosine can be told (order = half the number of headings)");
    else if (order > 0)
        parts += Words::tr("phase %1").arg(angle(toDegrees(found.phase_rad()), AngleStyle::DecimalDegrees, 0));
    return join(parts);
}

QString noticeFor(const SwingPicture& picture)
{
    if (picture.readings.empty() && picture.title.isEmpty() && !picture.whyNoAnalysis.isEmpty())
        return picture.whyNoAnalysis; // of no swing yet: there is no row to enter anything in
    if (picture.readings.empty())
        return Words::tr("Enter readings: a magnetic and a compass heading in each row.\nThree headings give a first result.");
    if (!picture.analysis)
        return picture.whyNoAnalysis;
    return {};
}

QString orderName(int order)
{
    switch (order) {
    case 0: return QStringLiteral("A");
    case 1: return QStringLiteral("B/C");
    case 2: return QStringLiteral("D/E");
    default: return {};
    }
}

QString componentName(Coefficient which)
{
    switch (which) {
    case Coefficient::A: return QStringLiteral("A");
    case Coefficient::B: return QStringLiteral("B sin ψ′");
    case Coefficient::C: return QStringLiteral("C cos ψ′");
    case Coefficient::D: return QStringLiteral("D sin 2ψ′");
    case Coefficient::E: return QStringLiteral("E cos 2ψ′");
    }
    return {};
}

QString deviationCaption() { return Words::tr("deviation (°)\noutward = east (+)"); }
QString headingCaption() { return Words::tr("magnetic\nheading (°)"); }
QString deviationAxisTitle() { return Words::tr("deviation (°, east +)"); }
QString headingAxisTitle() { return Words::tr("magnetic heading (°)"); }

QString previousTitle(const SwingPicture& picture)
{
    if (!picture.previousTitle.isEmpty())
        return picture.previousTitle;
    return picture.previousLabel.isEmpty() ? Words::tr("previous swing") : Words::tr("previous swing (%1)").arg(picture.previousLabel);
}

QString limitTitle(const SwingPicture& picture, double scaleEnd_deg)
{
    if (!picture.limit_deg)
        return {};
    QString title = Words::tr("limit ±%1°").arg(*picture.limit_deg);
    if (!picture.limitDocument.isEmpty())
        title += QStringLiteral(" (%1)").arg(picture.limitDocument);
    if (*picture.limit_deg > scaleEnd_deg)
        title += Words::tr(", beyond this scale");
    return title;
}

} // namespace lubberline::ui
