#include "ui/plots/reference/TimePicture.h"

#include <QCoreApplication>
#include <QPainter>

#include <algorithm>
#include <cmath>

#include "core/angle/Angle.h"
#include "core/angle/PrintedHeading.h"
#include "core/reference/LevellingLoop.h"
#include "ui/plots/drawn/DrawnAxes.h"
#include "ui/text/NumberText.h"

namespace lubberline::ui {

namespace {

struct ReferenceWords {
    Q_DECLARE_TR_FUNCTIONS(lubberline::ui::ReferenceWords)
};

QColor colourOfBand(std::size_t i, const PlotColours& colours)
{
    return i < colours.coefficient.size() ? colours.coefficient[i] : colours.faint;
}

void paintDial(QPainter& painter, const QRectF& rect, double heading_deg, const QString& title, const PlotColours& colours)
{
    const double line = painter.fontMetrics().height(), size = std::min(rect.width(), rect.height() - 4 * line) - 6;
    const QPointF centre(rect.center().x(), rect.top() + 1.3 * line + size / 2);
    painter.setPen(colours.text);
    painter.drawText(QRectF(rect.left(), rect.top(), rect.width(), 1.2 * line), Qt::AlignCenter, title);
    painter.setPen(QPen(colours.axis, 1.5));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(centre, size / 2, size / 2);
    painter.save();
    painter.translate(centre);
    for (int mark = 0; mark < 360; mark += 10) {
        painter.save();
        painter.rotate(mark - heading_deg);
        painter.setPen(QPen(colours.text, mark % 30 == 0 ? 1.5 : 0));
        painter.drawLine(QPointF(0, -size / 2), QPointF(0, -size / 2 + (mark % 30 == 0 ? 0.1 : 0.06) * size));
        if (mark % 30 == 0) {
            const QString name = mark == 0 ? QStringLiteral("N")
                : mark == 90               ? QStringLiteral("E")
                : mark == 180              ? QStringLiteral("S")
                : mark == 270              ? QStringLiteral("W")
                                           : QString::number(mark / 10);
            painter.drawText(QRectF(-20, -size * 0.4, 40, line), Qt::AlignCenter, name);
        }
        painter.restore();
    }
    painter.setPen(QPen(colours.exact, 2)); // the lubber line
    painter.drawLine(QPointF(0, -size / 2 - 4), QPointF(0, -size * 0.28));
    painter.restore();
    painter.setPen(colours.text);
    painter.drawText(QRectF(rect.left(), centre.y() + size / 2 + 2, rect.width(), 1.2 * line), Qt::AlignCenter,
        QStringLiteral("%1°").arg(printedHeading_deg(heading_deg, 1), 5, 'f', 1, QChar('0')));
}

} // namespace

QString nameOfSource(ErrorSource source)
{
    switch (source) {
    case ErrorSource::Tilt: return ReferenceWords::tr("tilt");
    case ErrorSource::OwnDeviation: return ReferenceWords::tr("deviation");
    case ErrorSource::Slaving: return ReferenceWords::tr("slaving");
    case ErrorSource::Drift: return ReferenceWords::tr("drift");
    case ErrorSource::Gimbal: return ReferenceWords::tr("gimbal");
    case ErrorSource::Card: return ReferenceWords::tr("card");
    case ErrorSource::Together: break;
    }
    return ReferenceWords::tr("together");
}

TimePicture pictureOf(const ReferenceRun& run, std::size_t most)
{
    TimePicture picture;
    const std::size_t every = std::max<std::size_t>(1, (run.time_s.size() + most - 1) / most);
    const ErrorShare* slaving = nullptr;
    for (const ErrorShare& share : run.shares)
        if (share.source == ErrorSource::Slaving)
            slaving = &share;
    for (const ErrorShare& share : run.shares)
        if (&share != slaving)
            picture.bands.push_back(
                {share.source == ErrorSource::Together && slaving ? ReferenceWords::tr("slaving and together") : nameOfSource(share.source),
                    {}});
    for (std::size_t i = 0; i < run.time_s.size(); i += every) {
        picture.time_s.push_back(run.time_s[i]);
        picture.error_deg.push_back(toDegrees(run.headingError_rad[i]));
        picture.vertical_deg.push_back(toDegrees(std::hypot(run.tilt[i].forward_rad, run.tilt[i].starboard_rad)));
        std::size_t band = 0;
        for (const ErrorShare& share : run.shares) {
            if (&share == slaving)
                continue;
            double figure = share.error_rad[i];
            if (share.source == ErrorSource::Together && slaving)
                figure += slaving->error_rad[i];
            picture.bands[band++].share_deg.push_back(toDegrees(figure));
        }
    }
    return picture;
}

namespace {

QString figure(double value, int decimals = 2) { return plainNumber(value, decimals); }

/// Error, tilt, then the bands: the order of the legend.
std::vector<LegendEntry> timeLegend(const TimePicture& picture, const PlotColours& colours)
{
    std::vector<LegendEntry> entries{{ReferenceWords::tr("error shown"), LegendEntry::Key::Line, QPen(colours.text, 2)},
        {ReferenceWords::tr("tilt of the vertical"), LegendEntry::Key::Line, QPen(colours.text, 1, Qt::DashLine)}};
    for (std::size_t band = 0; band < picture.bands.size(); ++band)
        entries.push_back({picture.bands[band].name, LegendEntry::Key::Area, Qt::NoPen, colourOfBand(band, colours)});
    return entries;
}

DrawnAxes timeAxes(const TimePicture& picture, const QRectF& rect, const QFont& font)
{
    double most = 0;
    for (std::size_t i = 0; i < picture.time_s.size(); ++i) {
        double above = 0, below = 0;
        for (const auto& band : picture.bands)
            (band.share_deg[i] > 0 ? above : below) += band.share_deg[i];
        most = std::max({most, above, -below, std::abs(picture.error_deg[i]), picture.vertical_deg[i]});
    }
    const double last = picture.time_s.empty() ? 1 : picture.time_s.back();
    return {rect, font, {0, last > 0 ? last : 1, ReferenceWords::tr("time (s)")},
        scaleAbout0(most, 0.1, ReferenceWords::tr("read − magnetic (°), shares of the sources stacked"))};
}

void paintBands(QPainter& painter, const DrawnAxes& axes, const TimePicture& picture, const DrawnLook& look)
{
    const std::size_t count = picture.time_s.size();
    for (const bool positive : {true, false}) {
        std::vector<double> edge(count, 0.0);
        for (std::size_t band = 0; band < picture.bands.size(); ++band) {
            if (!look.isShown(band + 2))
                continue;
            QPolygonF shape;
            for (std::size_t i = 0; i < count; ++i)
                shape << axes.at(picture.time_s[i], edge[i]);
            for (std::size_t i = 0; i < count; ++i)
                if (const double share = picture.bands[band].share_deg[i]; (share > 0) == positive)
                    edge[i] += share;
            for (std::size_t i = count; i-- > 0;)
                shape << axes.at(picture.time_s[i], edge[i]);
            painter.setPen(Qt::NoPen);
            painter.setBrush(colourOfBand(band, look.colours));
            painter.drawPolygon(shape);
        }
    }
    painter.setBrush(Qt::NoBrush);
}

void paintTime(QPainter& painter, const QRectF& rect, const TimePicture& picture, const DrawnLook& look)
{
    const DrawnAxes axes = timeAxes(picture, rect, painter.font());
    axes.paint(painter, look.colours);
    painter.save();
    painter.setClipRect(axes.inside());
    paintBands(painter, axes, picture, look);
    QPolygonF error, vertical;
    for (std::size_t i = 0; i < picture.time_s.size(); ++i) {
        error << axes.at(picture.time_s[i], picture.error_deg[i]);
        vertical << axes.at(picture.time_s[i], picture.vertical_deg[i]);
    }
    painter.setPen(curvePen(look.colours.text, painter.font(), 1, Qt::DashLine));
    if (look.isShown(1))
        painter.drawPolyline(vertical);
    painter.setPen(curvePen(look.colours.text, painter.font()));
    if (look.isShown(0))
        painter.drawPolyline(error);
    if (picture.at_s > 0) {
        painter.setPen(QPen(look.colours.exact, 0));
        const double x = axes.at(picture.at_s, 0).x();
        painter.drawLine(QPointF(x, axes.inside().top()), QPointF(x, axes.inside().bottom()));
    }
    painter.restore();
}

QString timeReadOut(const TimePicture& picture, const QRectF& rect, const QFont& font, const QPointF& at)
{
    const DrawnAxes axes = timeAxes(picture, rect, font);
    if (picture.time_s.empty() || !axes.contains(at))
        return {};
    const auto found = std::lower_bound(picture.time_s.begin(), picture.time_s.end(), axes.valueAt(at).x());
    const auto i = std::min(static_cast<std::size_t>(found - picture.time_s.begin()), picture.time_s.size() - 1);
    QStringList shares;
    for (const auto& band : picture.bands)
        shares += QStringLiteral("%1 %2°").arg(band.name, signedNumber(band.share_deg[i], 2));
    return ReferenceWords::tr("%1 s: error %2°, tilt %3°; %4")
        .arg(figure(picture.time_s[i], 1), signedNumber(picture.error_deg[i], 2), figure(picture.vertical_deg[i]),
            shares.join(QStringLiteral(", ")));
}

// Frequencies of flying: from a minute's thousandth part of a hertz to gusts.
constexpr double kLeast_hz = 1e-4, kMost_hz = 1;

DrawnAxes gainAxes(const QRectF& rect, const QFont& font)
{
    return {rect, font, decades(kLeast_hz, kMost_hz, ReferenceWords::tr("frequency (Hz)")), {1e-4, 4, ReferenceWords::tr("gain"), true}};
}

double slavingGain(double tau_s, double frequency_hz) { return 1 / std::hypot(1.0, 2 * kPi * frequency_hz * tau_s); }

std::optional<double> slavingTau(const Scenario& scenario) { return scenario.gyro ? scenario.gyro->slavingTau_s : std::nullopt; }

void paintGainCurve(QPainter& painter, const DrawnAxes& axes, const std::function<double(double)>& gain)
{
    constexpr int kPoints = 300;
    QPolygonF curve;
    for (int i = 0; i <= kPoints; ++i) {
        const double frequency_hz = kLeast_hz * std::pow(kMost_hz / kLeast_hz, double(i) / kPoints);
        curve << axes.at(frequency_hz, gain(frequency_hz));
    }
    painter.drawPolyline(curve);
}

void paintGains(QPainter& painter, const QRectF& rect, const Scenario& scenario, const DrawnLook& look)
{
    const DrawnAxes axes = gainAxes(rect, painter.font());
    axes.paint(painter, look.colours);
    painter.save();
    painter.setClipRect(axes.inside());
    if (scenario.vertical && look.isShown(0)) {
        painter.setPen(curvePen(look.colours.exact, painter.font()));
        paintGainCurve(painter, axes, [&](double hz) { return gainAt(*scenario.vertical, 2 * kPi * hz); });
    }
    if (const auto tau = slavingTau(scenario); tau && look.isShown(1)) {
        painter.setPen(curvePen(look.colours.approximate, painter.font(), 1.5, Qt::DashLine));
        paintGainCurve(painter, axes, [&](double hz) { return slavingGain(*tau, hz); });
    }
    painter.restore();
}

QString gainReadOut(const Scenario& scenario, const QRectF& rect, const QFont& font, const QPointF& at)
{
    const DrawnAxes axes = gainAxes(rect, font);
    if (!axes.contains(at))
        return {};
    const double hz = axes.valueAt(at).x();
    QStringList gains;
    if (scenario.vertical)
        gains += ReferenceWords::tr("levelling %1").arg(figure(gainAt(*scenario.vertical, 2 * kPi * hz), 4));
    if (const auto tau = slavingTau(scenario))
        gains += ReferenceWords::tr("slaving %1").arg(figure(slavingGain(*tau, hz), 4));
    return ReferenceWords::tr("period %1 s: gain of %2").arg(figure(1 / hz, 1 / hz < 100 ? 1 : 0), gains.join(QStringLiteral(", ")));
}

} // namespace

DrawnPicture timeDrawing(std::shared_ptr<const TimePicture> picture)
{
    DrawnPicture drawn;
    drawn.paint = [picture](QPainter& painter, const QRectF& rect, const DrawnLook& look) { paintTime(painter, rect, *picture, look); };
    drawn.readOut = [picture](const QRectF& rect, const QFont& font, const QPointF& at) { return timeReadOut(*picture, rect, font, at); };
    drawn.legend = [picture](const PlotColours& colours) { return timeLegend(*picture, colours); };
    return drawn;
}

DrawnPicture gainDrawing(const Scenario& scenario)
{
    DrawnPicture drawn;
    if (!scenario.vertical && !slavingTau(scenario)) {
        drawn.notice = ReferenceWords::tr("no loop: neither a vertical gyro nor a time constant of slaving");
        return drawn;
    }
    drawn.paint = [scenario](QPainter& painter, const QRectF& rect, const DrawnLook& look) { paintGains(painter, rect, scenario, look); };
    drawn.readOut = [scenario](const QRectF& rect, const QFont& font, const QPointF& at) { return gainReadOut(scenario, rect, font, at); };
    drawn.legend = [scenario](const PlotColours& colours) {
        return std::vector<LegendEntry>{{ReferenceWords::tr("levelling: tilt of gyro ÷ tilt of the apparent vertical"),
                                            LegendEntry::Key::Line, QPen(colours.exact, 2), {}, scenario.vertical.has_value()},
            {ReferenceWords::tr("slaving: gyro ÷ sensor"), LegendEntry::Key::Line, QPen(colours.approximate, 2, Qt::DashLine), {},
                slavingTau(scenario).has_value()}};
    };
    return drawn;
}

void paintDials(
    QPainter& painter, const QRectF& rect, double heading_deg, double error_deg, const AxisTilt& tilt, const PlotColours& colours)
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    const double width = rect.width() / 2, line = painter.fontMetrics().height();
    const QString vertical = ReferenceWords::tr("vertical: %1° forward, %2° to starboard")
                                 .arg(plainNumber(toDegrees(tilt.forward_rad), 2), plainNumber(toDegrees(tilt.starboard_rad), 2));
    const double words = 1.2 * line * (painter.fontMetrics().horizontalAdvance(vertical) > rect.width() ? 2 : 1);
    const double high = rect.height() - words + 1.2 * line; // dials leave one line beneath themselves
    paintDial(painter, QRectF(rect.left(), rect.top(), width, high), heading_deg, ReferenceWords::tr("magnetic"), colours);
    paintDial(painter, QRectF(rect.left() + width, rect.top(), width, high), heading_deg + error_deg, ReferenceWords::tr("read"), colours);
    painter.setPen(colours.text);
    painter.drawText(QRectF(rect.left(), rect.bottom() - words, rect.width(), words), Qt::AlignCenter | Qt::TextWordWrap, vertical);
    painter.restore();
}

} // namespace lubberline::ui
