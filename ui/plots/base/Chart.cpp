#include "ui/plots/base/Chart.h"

#include <QEvent>
#include <QFontInfo>
#include <QFontMetricsF>
#include <QGuiApplication>
#include <QPainter>

#include <cmath>

#include <qwt_painter.h>

#include "core/base/Contract.h"

namespace lubberline::ui {

namespace {

constexpr double kReach_px = 10; ///< how near to a point a click takes it

} // namespace

Chart::Chart(QWidget* parent) : QWidget(parent), m_colours(paperColours()), m_legendStrip(new PlotLegend(this))
{
    // Cut into short pieces, as Qwt does for speed, a dashed line would start its pattern anew in each of them.
    QwtPainter::setPolylineSplitting(false);
    QwtPainter::setRoundingAlignment(false); // curves would follow whole pixels in steps
    connect(m_legendStrip, &PlotLegend::toggled, this, [this](int index) { setShown(index, !m_legend[index].shown); });
}

void Chart::setColours(const PlotColours& colours)
{
    m_colours = colours;
    m_legendStrip->setColours(colours);
    styleItems();
    updateLegend();
    replotAll();
}

void Chart::takeView(const Chart& other)
{
    LUBBERLINE_EXPECT(m_legend.size() == other.m_legend.size(), "a chart takes the view of one of its own kind");
    for (std::size_t i = 0; i < m_legend.size(); ++i)
        setShown(static_cast<int>(i), other.m_legend[i].shown);
}

std::optional<int> Chart::rowNear(const CanvasPlace& place) const
{
    std::optional<int> nearest;
    double least = kReach_px;
    for (const RowPlace& point : rowsOn(place.canvas)) {
        const QPointF away = point.at - place.at;
        const double distance = std::hypot(away.x(), away.y());
        if (distance <= least) {
            least = distance;
            nearest = point.row;
        }
    }
    return nearest;
}

void Chart::setShown(int index, bool shown)
{
    if (m_legend[index].shown == shown)
        return;
    m_legend[index].shown = shown;
    m_switches[index](shown);
    updateLegend();
    replotAll();
}

int Chart::addEntry(const LegendEntry& entry, Switch show)
{
    m_legend.push_back(entry);
    m_switches.push_back(std::move(show));
    return static_cast<int>(m_legend.size()) - 1;
}

void Chart::updateLegend()
{
    m_legendStrip->setEntries(m_legend);
    const int height = static_cast<int>(std::ceil(legendHeight(m_legend, width(), m_legendStrip->font())));
    if (height != m_legendHeight)
        placeParts();
}

void Chart::placeParts()
{
    m_legendHeight = static_cast<int>(std::ceil(legendHeight(m_legend, width(), m_legendStrip->font())));
    m_legendStrip->setGeometry(0, height() - m_legendHeight, width(), m_legendHeight);
    layoutPlots(contentRect());
}

QRect Chart::contentRect() const { return {0, 0, width(), std::max(1, height() - m_legendHeight)}; }

void Chart::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.fillRect(rect(), m_colours.ground);
}

void Chart::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    placeParts();
}

void Chart::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange) {
        styleItems();
        placeParts();
    }
}

void Chart::paint(QPainter& painter, const QRectF& target)
{
    std::vector<LegendEntry> listed = m_legend;
    for (LegendEntry& entry : listed)
        entry.present = entry.present && entry.shown;
    painter.save();
    // Qwt scales by the resolution of the device by itself, so whatever scale the painter has is taken off first.
    const QRectF device = painter.combinedTransform().mapRect(target);
    painter.resetTransform();
    painter.fillRect(device, m_colours.ground);
    const double scale = static_cast<double>(painter.device()->logicalDpiX()) / logicalDpiX();
    const QFont font = pixelFont(this->font());
    const QSizeF units = device.size() / scale;
    const double legend = legendHeight(listed, units.width(), font);
    resize(units.toSize().expandedTo({1, 1}));
    paintPlots(painter, device.adjusted(0, 0, 0, -legend * scale));

    painter.translate(device.topLeft());
    painter.scale(scale, scale);
    painter.setFont(font);
    paintLegend(painter, QRectF(0, units.height() - legend, units.width(), legend), listed, m_colours);
    painter.restore();
}

QFont paperFont()
{
    QFont font = QGuiApplication::font();
    font.setPixelSize(11);
    return font;
}

QFont pixelFont(const QFont& font)
{
    QFont fixed = font;
    fixed.setPixelSize(std::max(1, QFontInfo(font).pixelSize()));
    return fixed;
}

void paintNotice(QPainter& painter, const QRectF& within, const QString& text, const PlotColours& colours, const QFont& font)
{
    if (text.isEmpty())
        return;
    painter.save();
    painter.setFont(font);
    const double width = std::min(within.width() - 16, 46 * QFontMetricsF(font).averageCharWidth());
    const int flags = Qt::AlignHCenter | Qt::AlignVCenter | Qt::TextWordWrap;
    QRectF room(0, 0, std::max(60.0, width), within.height());
    room.moveCenter(within.center());
    const QRectF box = painter.boundingRect(room, flags, text).adjusted(-8, -5, 8, 5);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(colours.grid, 1));
    painter.setBrush(colours.ground);
    painter.drawRoundedRect(box, 4, 4);
    painter.setPen(colours.text);
    painter.drawText(room, flags, text);
    painter.restore();
}

} // namespace lubberline::ui
