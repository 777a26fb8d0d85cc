#include "ui/plots/calibration/SensorTestDrawing.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QImage>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/base/Middle.h"
#include "ui/plots/drawn/DrawnAxes.h"
#include "ui/text/NumberText.h"
#include "ui/text/Translated.h"

namespace lubberline::ui {

namespace {

struct SensorTestWords {
    Q_DECLARE_TR_FUNCTIONS(lubberline::ui::SensorTestWords)
};

struct Reach {
    double least = std::numeric_limits<double>::max(), most = 0;
    void take(double value)
    {
        if (value > 0 && std::isfinite(value)) {
            least = std::min(least, value);
            most = std::max(most, value);
        }
    }
    [[nodiscard]] bool empty() const { return !(most > 0); }
};

DrawnAxes spectrumAxes(const LogSpectrum& spectrum, const QString& unit, const QRectF& rect, const QFont& font)
{
    Reach reach;
    for (std::size_t k = 1; k < spectrum.density.size(); ++k)
        reach.take(spectrum.density[k]);
    const double last = spectrum.frequency_hz.empty() ? 1 : spectrum.frequency_hz.back();
    return {rect, font, {0, last, SensorTestWords::tr("frequency (Hz)")},
        reach.empty() ? decades(1, 10, {})
                      : decades(std::max(reach.least, reach.most * 1e-12), reach.most, SensorTestWords::tr("density (%1²/Hz)").arg(unit))};
}

void paintSpectrum(QPainter& painter, const QRectF& rect, const LogSpectrum& spectrum, const QString& unit, const DrawnLook& look)
{
    const DrawnAxes axes = spectrumAxes(spectrum, unit, rect, painter.font());
    axes.paint(painter, look.colours);
    const double line = QFontMetricsF(painter.font()).height();
    painter.save();
    painter.setClipRect(axes.inside());
    if (look.isShown(0)) {
        QPolygonF curve;
        for (std::size_t k = 1; k < spectrum.density.size(); ++k)
            curve << axes.at(spectrum.frequency_hz[k], spectrum.density[k]);
        painter.setPen(curvePen(look.colours.approximate, painter.font(), 1));
        painter.drawPolyline(curve);
    }
    if (look.isShown(2) && spectrum.filter) {
        QPolygonF curve;
        for (std::size_t k = 1; k < spectrum.density.size(); ++k)
            curve << axes.at(spectrum.frequency_hz[k], spectrum.density[k] * gainSquared(*spectrum.filter, spectrum.frequency_hz[k]));
        painter.setPen(curvePen(look.colours.limitEdge, painter.font(), 1));
        painter.drawPolyline(curve);
    }
    if (look.isShown(1)) {
        constexpr std::size_t kMostNamed = 12;
        double row = 0.2;
        for (std::size_t i = 0; i < std::min(kMostNamed, spectrum.lines.size()); ++i) {
            const SpectralLine& one = spectrum.lines[i];
            const double x = axes.at(one.frequency_hz, 1).x(), y = axes.inside().top() + row * line;
            painter.setPen(QPen(look.colours.exact, 0, Qt::DashLine));
            painter.drawLine(QPointF(x, axes.inside().top()), QPointF(x, axes.inside().bottom()));
            painter.setPen(look.colours.text);
            const QString text = QStringLiteral("%1 Hz %2").arg(plainNumber(one.frequency_hz, 1), translated(one.source));
            const double wide = QFontMetricsF(painter.font()).horizontalAdvance(text);
            painter.drawText(QPointF(std::min(x + 0.3 * line, axes.inside().right() - wide), y + line), text);
            row = row > 5 ? 0.2 : row + 1.1;
        }
    }
    painter.restore();
}

QString spectrumReadOut(const LogSpectrum& spectrum, const QString& unit, const QRectF& rect, const QFont& font, const QPointF& at)
{
    const DrawnAxes axes = spectrumAxes(spectrum, unit, rect, font);
    if (!axes.contains(at) || spectrum.frequency_hz.size() < 2)
        return {};
    const double step = spectrum.frequency_hz[1];
    const auto k
        = std::clamp<std::size_t>(static_cast<std::size_t>(std::lround(axes.valueAt(at).x() / step)), 1, spectrum.density.size() - 1);
    QString text = SensorTestWords::tr("%1 Hz: %2 %3²/Hz")
                       .arg(plainNumber(spectrum.frequency_hz[k], 2), QString::number(spectrum.density[k], 'g', 3), unit);
    for (const SpectralLine& one : spectrum.lines)
        if (std::abs(one.frequency_hz - spectrum.frequency_hz[k]) <= 2 * step)
            text += SensorTestWords::tr("; %1, amplitude %2 %3").arg(translated(one.source), plainNumber(one.amplitude, 1), unit);
    return text;
}

DrawnAxes spectrogramAxes(const Spectrogram& spectrogram, const QRectF& rect, const QFont& font)
{
    const double first = spectrogram.time_s.empty() ? 0 : spectrogram.time_s.front(),
                 last = spectrogram.time_s.empty() ? 1 : spectrogram.time_s.back();
    return {rect, font, {first, std::max(last, first + 1e-9), SensorTestWords::tr("time (s)")},
        {0, spectrogram.rate_hz / 2, SensorTestWords::tr("frequency (Hz); dark: strong, decades below the strongest")}};
}

constexpr double kShownDecades = 6;

/// 0: as strong as the strongest, 1: kShownDecades below it.
double faintness(double density, double most)
{
    return density > 0 && most > 0 ? std::clamp(-std::log10(density / most) / kShownDecades, 0.0, 1.0) : 1.0;
}

QImage spectrogramImage(const Spectrogram& spectrogram, const PlotColours& colours)
{
    const auto columns = static_cast<int>(spectrogram.density.size()), rows = static_cast<int>(spectrogram.density.front().size());
    double most = 0;
    for (const auto& density : spectrogram.density)
        for (std::size_t k = 2; k < density.size(); ++k) // what turns slowly is no line
            most = std::max(most, density[k]);
    QImage image(columns, rows, QImage::Format_RGB32);
    for (int x = 0; x < columns; ++x)
        for (int y = 0; y < rows; ++y) {
            const double faint = faintness(spectrogram.density[static_cast<std::size_t>(x)][static_cast<std::size_t>(y)], most);
            const auto channel
                = [faint](int strong, int ground) { return static_cast<int>(std::lround(strong + faint * (ground - strong))); };
            const QColor &strong = colours.approximate, &ground = colours.ground;
            image.setPixel(x, rows - 1 - y,
                qRgb(channel(strong.red(), ground.red()), channel(strong.green(), ground.green()), channel(strong.blue(), ground.blue())));
        }
    return image;
}

void paintSpectrogram(QPainter& painter, const QRectF& rect, const Spectrogram& spectrogram, const DrawnLook& look)
{
    const DrawnAxes axes = spectrogramAxes(spectrogram, rect, painter.font());
    painter.drawImage(axes.inside(), spectrogramImage(spectrogram, look.colours));
    axes.paint(painter, look.colours);
}

struct QuietField {
    std::array<double, 3> middle{};
};

QuietField quietOf(const SensorLog& log, const InterferenceResult& result)
{
    QuietField quiet;
    const double until = result.actions.empty() ? std::numeric_limits<double>::max() : result.actions.front().from_s;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        std::vector<double> values;
        for (std::size_t row = 0; row < log.size(); ++row)
            if (log.time_s[row] < until && std::isfinite(log.field[axis][row]))
                values.push_back(log.field[axis][row]);
        quiet.middle[axis] = values.empty() ? 0 : middleOf(std::move(values));
    }
    return quiet;
}

struct ShownInterference {
    SensorLog log;
    InterferenceResult result;
    QuietField quiet;
    double most = 0;
};

DrawnAxes interferenceAxes(const ShownInterference& shown, const QRectF& rect, const QFont& font)
{
    const double first = shown.log.time_s.empty() ? 0 : shown.log.time_s.front(),
                 last = shown.log.time_s.empty() ? 1 : shown.log.time_s.back();
    return {rect, font, {first, last, SensorTestWords::tr("time (s)")},
        scaleAbout0(shown.most, 10, SensorTestWords::tr("field less that of before (nT)"))};
}

QColor colourOfAxis(std::size_t axis, const PlotColours& colours)
{
    return axis == 0 ? colours.approximate : axis == 1 ? colours.exact : colours.coefficient[3];
}

void paintInterference(QPainter& painter, const QRectF& rect, const ShownInterference& shown, const DrawnLook& look)
{
    const DrawnAxes axes = interferenceAxes(shown, rect, painter.font());
    axes.paint(painter, look.colours);
    const double line = QFontMetricsF(painter.font()).height();
    painter.save();
    painter.setClipRect(axes.inside());
    const std::size_t step = shown.log.size() / 4000 + 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (!look.isShown(axis))
            continue;
        QPolygonF curve;
        for (std::size_t row = 0; row < shown.log.size(); row += step)
            if (std::isfinite(shown.log.field[axis][row]))
                curve << axes.at(shown.log.time_s[row], shown.log.field[axis][row] - shown.quiet.middle[axis]);
        painter.setPen(curvePen(colourOfAxis(axis, look.colours), painter.font(), 1));
        painter.drawPolyline(curve);
    }
    double row = 0.2;
    for (const ActionOutcome& action : shown.result.actions) {
        const double x = axes.at(action.from_s, 0).x();
        painter.setPen(QPen(action.passes ? look.colours.axis : look.colours.exact, 0, Qt::DashLine));
        painter.drawLine(QPointF(x, axes.inside().top()), QPointF(x, axes.inside().bottom()));
        painter.setPen(action.passes ? look.colours.text : look.colours.exact);
        painter.drawText(QPointF(x + 0.3 * line, axes.inside().top() + (row + 1) * line), QString::fromStdString(action.action));
        row = row > 4 ? 0.2 : row + 1.1;
    }
    painter.restore();
}

} // namespace

DrawnPicture spectrumDrawing(const LogSpectrum& spectrum, const QString& unit)
{
    const auto shown = std::make_shared<const LogSpectrum>(spectrum);
    DrawnPicture picture;
    picture.paint
        = [shown, unit](QPainter& painter, const QRectF& rect, const DrawnLook& look) { paintSpectrum(painter, rect, *shown, unit, look); };
    picture.readOut
        = [shown, unit](const QRectF& rect, const QFont& font, const QPointF& at) { return spectrumReadOut(*shown, unit, rect, font, at); };
    picture.legend = [shown](const PlotColours& colours) {
        return std::vector<LegendEntry>{{SensorTestWords::tr("density of %1").arg(QString::fromStdString(shown->column)),
                                            LegendEntry::Key::Line, QPen(colours.approximate, 2)},
            {SensorTestWords::tr("lines"), LegendEntry::Key::Line, QPen(colours.exact, 1, Qt::DashLine), {}, !shown->lines.empty()},
            {SensorTestWords::tr("behind the filter"), LegendEntry::Key::Line, QPen(colours.limitEdge, 2), {}, shown->filter.has_value()}};
    };
    return picture;
}

DrawnPicture spectrogramDrawing(const Spectrogram& spectrogram, const QString& unit)
{
    DrawnPicture picture;
    if (spectrogram.density.size() < 2) {
        picture.notice = SensorTestWords::tr("the log is too short for a spectrogram: it needs two segments at least");
        return picture;
    }
    const auto shown = std::make_shared<const Spectrogram>(spectrogram);
    picture.paint
        = [shown](QPainter& painter, const QRectF& rect, const DrawnLook& look) { paintSpectrogram(painter, rect, *shown, look); };
    picture.readOut = [shown, unit](const QRectF& rect, const QFont& font, const QPointF& at) {
        const DrawnAxes axes = spectrogramAxes(*shown, rect, font);
        if (!axes.contains(at))
            return QString();
        const QPointF value = axes.valueAt(at);
        const auto nearest = std::min_element(shown->time_s.begin(), shown->time_s.end(),
            [&value](double a, double b) { return std::abs(a - value.x()) < std::abs(b - value.x()); });
        const auto& density = shown->density[static_cast<std::size_t>(nearest - shown->time_s.begin())];
        const auto k = std::min(static_cast<std::size_t>(std::max(0L, std::lround(value.y() / shown->step_hz))), density.size() - 1);
        return SensorTestWords::tr("%1 s, %2 Hz: %3 %4²/Hz")
            .arg(plainNumber(*nearest, 1), plainNumber(value.y(), 2), QString::number(density[k], 'g', 3), unit);
    };
    return picture;
}

DrawnPicture interferenceDrawing(const SensorLog& log, const InterferenceResult& result)
{
    auto shown = std::make_shared<ShownInterference>(ShownInterference{log, result, quietOf(log, result), 0});
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (const double value : log.field[axis])
            if (std::isfinite(value))
                shown->most = std::max(shown->most, std::abs(value - shown->quiet.middle[axis]));
    DrawnPicture picture;
    picture.paint
        = [shown](QPainter& painter, const QRectF& rect, const DrawnLook& look) { paintInterference(painter, rect, *shown, look); };
    picture.readOut = [shown](const QRectF& rect, const QFont& font, const QPointF& at) {
        const DrawnAxes axes = interferenceAxes(*shown, rect, font);
        if (!axes.contains(at) || shown->log.time_s.empty())
            return QString();
        const auto found = std::lower_bound(shown->log.time_s.begin(), shown->log.time_s.end(), axes.valueAt(at).x());
        const auto row = std::min(static_cast<std::size_t>(found - shown->log.time_s.begin()), shown->log.size() - 1);
        const auto off = [&](std::size_t axis) { return signedNumber(shown->log.field[axis][row] - shown->quiet.middle[axis], 0); };
        return SensorTestWords::tr("%1 s: x %2, y %3, z %4 nT").arg(plainNumber(shown->log.time_s[row], 1), off(0), off(1), off(2));
    };
    picture.legend = [](const PlotColours& colours) {
        std::vector<LegendEntry> entries;
        for (std::size_t axis = 0; axis < 3; ++axis)
            entries.push_back({QString(QLatin1Char("xyz"[axis])), LegendEntry::Key::Line, QPen(colourOfAxis(axis, colours), 2)});
        return entries;
    };
    return picture;
}

} // namespace lubberline::ui
