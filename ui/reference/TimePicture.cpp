#include "ui/reference/TimePicture.h"

#include <QCoreApplication>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

#include "core/angle/Angle.h"
#include "core/reference/LevellingLoop.h"
#include "ui/plots/base/NiceScale.h"

namespace lubberline::ui {

namespace {

struct ReferenceWords {
    Q_DECLARE_TR_FUNCTIONS(lubberline::ui::ReferenceWords)
};

QColor colourOfBand(std::size_t i, const PlotColours& colours)
{
    return i < colours.coefficient.size() ? colours.coefficient[i] : colours.faint;
}

/// A frame with scales: what the time plot and the gain share.
class Frame {
public:
    Frame(QPainter& painter, const QRectF& rect, const PlotColours& colours) : m_painter(painter), m_colours(colours)
    {
        const QFontMetricsF metrics(painter.font());
        m_inside = rect.adjusted(metrics.horizontalAdvance(QStringLiteral("+00.0")) + 10, metrics.height() * 1.6, -1.5 * metrics.height(),
            -metrics.height() * 2.4);
        painter.setPen(QPen(colours.axis, 0));
        painter.drawRect(m_inside);
    }
    [[nodiscard]] const QRectF& inside() const { return m_inside; }

    void across(double part, const QString& label)
    {
        const double y = m_inside.bottom() - part * m_inside.height();
        m_painter.setPen(QPen(m_colours.grid, 0));
        m_painter.drawLine(QPointF(m_inside.left(), y), QPointF(m_inside.right(), y));
        m_painter.setPen(m_colours.text);
        const double half = m_painter.fontMetrics().height();
        m_painter.drawText(QRectF(m_inside.left() - 106, y - half, 100, 2 * half), Qt::AlignRight | Qt::AlignVCenter, label);
    }
    void upright(double part, const QString& label)
    {
        const double x = m_inside.left() + part * m_inside.width();
        m_painter.setPen(QPen(m_colours.grid, 0));
        m_painter.drawLine(QPointF(x, m_inside.top()), QPointF(x, m_inside.bottom()));
        m_painter.setPen(m_colours.text);
        m_painter.drawText(
            QRectF(x - 60, m_inside.bottom() + 2, 120, m_painter.fontMetrics().height() + 2), Qt::AlignHCenter | Qt::AlignTop, label);
    }
    void titles(const QString& above, const QString& below)
    {
        m_painter.setPen(m_colours.text);
        const double line = m_painter.fontMetrics().height();
        m_painter.drawText(
            QRectF(m_inside.left(), m_inside.top() - 1.5 * line, m_inside.width(), 1.4 * line), Qt::AlignLeft | Qt::AlignVCenter, above);
        m_painter.drawText(QRectF(m_inside.left(), m_inside.bottom() + line + 2, m_inside.width(), 1.3 * line),
            Qt::AlignHCenter | Qt::AlignVCenter, below);
    }

private:
    QPainter& m_painter;
    const PlotColours& m_colours;
    QRectF m_inside;
};

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
        QStringLiteral("%1°").arg(wrap360(heading_deg), 5, 'f', 1, QChar('0')));
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

void paintTimePicture(QPainter& painter, const QRectF& rect, const TimePicture& picture, const PlotColours& colours)
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    const std::size_t count = picture.time_s.size();
    std::vector<double> above(count, 0.0), below(count, 0.0);
    double most = 0;
    for (std::size_t i = 0; i < count; ++i) {
        for (const auto& band : picture.bands)
            (band.share_deg[i] > 0 ? above[i] : below[i]) += band.share_deg[i];
        most = std::max({most, above[i], -below[i], std::abs(picture.error_deg[i]), picture.vertical_deg[i]});
    }
    const NiceScale scale = niceScale(most, 4, 0.1);
    Frame frame(painter, rect, colours);
    const QRectF inside = frame.inside();
    for (double value = -scale.end; value <= scale.end + scale.step / 2; value += scale.step)
        frame.across((value + scale.end) / (2 * scale.end), signedTick(value, scale.step));
    const double last = count > 1 ? picture.time_s.back() : 1, step = niceStep(last / 8);
    for (double time = 0; time <= last + step / 1000; time += step)
        frame.upright(time / last, plainTick(time, step));
    frame.titles(ReferenceWords::tr("read − magnetic (°), stacked by source; dashed: tilt"), ReferenceWords::tr("time (s)"));
    const auto at = [&](std::size_t i, double value) {
        return QPointF(inside.left() + (last > 0 ? picture.time_s[i] / last : 0) * inside.width(),
            inside.center().y() - value / (2 * scale.end) * inside.height());
    };
    painter.setClipRect(inside);
    std::fill(above.begin(), above.end(), 0.0);
    std::fill(below.begin(), below.end(), 0.0);
    for (std::size_t band = 0; band < picture.bands.size(); ++band)
        for (const bool positive : {true, false}) {
            std::vector<double>& edge = positive ? above : below;
            QPolygonF shape;
            for (std::size_t i = 0; i < count; ++i)
                shape << at(i, edge[i]);
            std::vector<double> next = edge;
            for (std::size_t i = 0; i < count; ++i)
                if ((picture.bands[band].share_deg[i] > 0) == positive)
                    next[i] += picture.bands[band].share_deg[i];
            for (std::size_t i = count; i-- > 0;)
                shape << at(i, next[i]);
            edge = std::move(next);
            painter.setPen(Qt::NoPen);
            painter.setBrush(colourOfBand(band, colours));
            painter.drawPolygon(shape);
        }
    QPolygonF error, vertical;
    for (std::size_t i = 0; i < count; ++i) {
        error << at(i, picture.error_deg[i]);
        vertical << at(i, picture.vertical_deg[i]);
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(colours.text, 0, Qt::DashLine));
    painter.drawPolyline(vertical);
    QPen line(colours.text, std::max(1.5, painter.fontMetrics().height() / 10.0));
    painter.setPen(line);
    painter.drawPolyline(error);
    if (picture.at_s > 0 && last > 0) {
        painter.setPen(QPen(colours.exact, 0));
        const double x = inside.left() + picture.at_s / last * inside.width();
        painter.drawLine(QPointF(x, inside.top()), QPointF(x, inside.bottom()));
    }
    painter.setClipping(false);
    double x = inside.right();
    const double high = painter.fontMetrics().height(), y = inside.top() + 4;
    for (std::size_t band = picture.bands.size(); band-- > 0;) {
        const double width = painter.fontMetrics().horizontalAdvance(picture.bands[band].name);
        x -= width + 2.2 * high;
        painter.fillRect(QRectF(x, y, high, high * 0.8), colourOfBand(band, colours));
        painter.setPen(colours.text);
        painter.drawText(
            QRectF(x + 1.3 * high, y - 0.1 * high, width + high, high), Qt::AlignLeft | Qt::AlignVCenter, picture.bands[band].name);
    }
    painter.restore();
}

void paintGain(QPainter& painter, const QRectF& rect, const VerticalGyro& loop, const PlotColours& colours)
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    constexpr double kFrom = 0, kTo = 4, kLow = -4, kHigh = 0.5; // decades of period [s] and of gain
    Frame frame(painter, rect, colours);
    const QRectF inside = frame.inside();
    for (int decade = -4; decade <= 0; ++decade)
        frame.across((decade - kLow) / (kHigh - kLow), QString::number(std::pow(10.0, decade)));
    for (int decade = 0; decade <= 4; ++decade)
        frame.upright((decade - kFrom) / (kTo - kFrom), QString::number(std::pow(10.0, decade)));
    frame.titles(ReferenceWords::tr("gain, tilt of gyro ÷ apparent"), ReferenceWords::tr("period (s)"));
    QPolygonF curve;
    for (int i = 0; i <= 200; ++i) {
        const double decade = kFrom + (kTo - kFrom) * i / 200;
        const double gain = std::clamp(std::log10(gainAt(loop, 2 * kPi / std::pow(10.0, decade))), kLow, kHigh);
        curve << QPointF(inside.left() + (decade - kFrom) / (kTo - kFrom) * inside.width(),
            inside.bottom() - (gain - kLow) / (kHigh - kLow) * inside.height());
    }
    painter.setClipRect(inside);
    painter.setPen(QPen(colours.exact, 2));
    painter.drawPolyline(curve);
    painter.restore();
}

void paintDials(
    QPainter& painter, const QRectF& rect, double heading_deg, double error_deg, const AxisTilt& tilt, const PlotColours& colours)
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    const double width = rect.width() / 2;
    paintDial(painter, QRectF(rect.left(), rect.top(), width, rect.height()), heading_deg, ReferenceWords::tr("magnetic"), colours);
    paintDial(painter, QRectF(rect.left() + width, rect.top(), width, rect.height()), heading_deg + error_deg, ReferenceWords::tr("read"),
        colours);
    const double line = painter.fontMetrics().height();
    painter.setPen(colours.text);
    painter.drawText(QRectF(rect.left(), rect.bottom() - 1.2 * line, rect.width(), 1.2 * line), Qt::AlignCenter,
        ReferenceWords::tr("vertical: %1° forward, %2° to starboard")
            .arg(toDegrees(tilt.forward_rad), 0, 'f', 2)
            .arg(toDegrees(tilt.starboard_rad), 0, 'f', 2));
    painter.restore();
}

} // namespace lubberline::ui
