#include "ui/text/AngleWords.h"

#include <QRegularExpression>

#include <algorithm>
#include <atomic>
#include <cmath>

#include "ui/text/NumberText.h"

namespace lubberline::ui {

namespace {

std::atomic<AngleStyle> g_style = AngleStyle::DecimalDegrees; // the window chooses; workers that make documents read it

/// @param decimals of the degrees; two less of the minutes say as much.
QString degreesMinutes(double size_deg, int decimals)
{
    const int places = std::clamp(decimals - 2, 0, 4);
    const qint64 parts = std::llround(std::pow(10, places)), all = std::llround(size_deg * 60 * static_cast<double>(parts));
    QString minutes = QStringLiteral("%1").arg(all % (60 * parts) / parts, 2, 10, QChar('0'));
    if (places > 0)
        minutes += QStringLiteral(".%1").arg(all % parts, places, 10, QChar('0'));
    return QStringLiteral("%1°%2'").arg(all / (60 * parts)).arg(minutes);
}

bool inMinutes() { return g_style == AngleStyle::DegreesMinutes; }

} // namespace

void showAnglesIn(AngleStyle style) { g_style = style; }

AngleStyle shownAngles() { return g_style; }

QString shownAngle(double angle_deg, int decimals) { return QString::fromStdString(formatSignedAngle(angle_deg, g_style, decimals)); }

QString shownSize(double size_deg, int decimals)
{
    return inMinutes() && std::isfinite(size_deg) ? degreesMinutes(std::abs(size_deg), decimals)
                                                  : plainNumber(size_deg, decimals) + QStringLiteral("°");
}

QString shownHeading(double heading_deg, int decimals) { return QString::fromStdString(formatHeading(heading_deg, g_style, decimals)); }

QString shownFigure(double angle_deg, int decimals)
{
    return inMinutes() && std::isfinite(angle_deg) ? shownAngle(angle_deg, decimals) : signedNumber(angle_deg, decimals);
}

QString angleTick(double angle_deg, double step_deg)
{
    if (std::abs(angle_deg) < 1e-9 * std::abs(step_deg))
        return QStringLiteral("0");
    const int decimals = std::max(0, static_cast<int>(std::ceil(-std::log10(std::abs(step_deg)) - 1e-9)));
    if (!inMinutes() || decimals == 0)
        return signedNumber(angle_deg, decimals);
    return (angle_deg < 0 ? QStringLiteral("−") : QStringLiteral("+")) + degreesMinutes(std::abs(angle_deg), decimals + 1);
}

QString degreeTick(double angle_deg, double step_deg)
{
    const QString tick = angleTick(angle_deg, step_deg);
    return tick.contains(u'°') ? tick : tick + u'°';
}

QString inAngleStyle(QString sentence)
{
    if (!inMinutes())
        return sentence;
    static const QRegularExpression decimal(QStringLiteral("(\\d+)\\.(\\d+)°(?!\\s?/)"));
    auto found = decimal.match(sentence);
    for (qsizetype from = 0; found.hasMatch(); found = decimal.match(sentence, from)) {
        QString angle
            = degreesMinutes(QString(found.captured(1) + '.' + found.captured(2)).toDouble(), static_cast<int>(found.capturedLength(2)));
        while (angle.indexOf(QChar(u'°')) < found.capturedLength(1))
            angle.prepend('0'); // a heading has three figures
        sentence.replace(found.capturedStart(), found.capturedLength(), angle);
        from = found.capturedStart() + angle.size();
    }
    return sentence;
}

QString inAngleColumn(QString cell)
{
    static const QRegularExpression figure(QStringLiteral("(\\d+\\.\\d+)(?![\\d°])"));
    return inMinutes() ? inAngleStyle(cell.replace(figure, QStringLiteral("\\1°"))) : cell;
}

QString angleUnit() { return inMinutes() ? QStringLiteral("° ′") : QStringLiteral("°"); }

} // namespace lubberline::ui
