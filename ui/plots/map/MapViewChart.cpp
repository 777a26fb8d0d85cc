#include "ui/plots/map/MapViewChart.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>

#include "ui/plots/base/PaintedStrip.h"
#include "ui/plots/map/MapText.h"

namespace lubberline::ui {

namespace {

constexpr double kMargin = 6, kHigh = 10'000;
constexpr int kCaption = Qt::AlignLeft | Qt::AlignVCenter | Qt::TextWordWrap;

QFont boldOf(QFont font)
{
    font.setBold(true);
    return font;
}

double kindWidth(const MapPicture& picture, const QFont& font)
{
    return QFontMetricsF(boldOf(font)).horizontalAdvance(kindWord(picture)) + 2 * kMargin;
}

/// What is wider than the map goes on beneath.
double headerHeight(const MapPicture& picture, double width, const QFont& font)
{
    const QRectF room(0, 0, std::max(1.0, width - 2 * kMargin - kindWidth(picture, font)), kHigh);
    const QFontMetricsF metrics(font);
    return std::max(metrics.height(), metrics.boundingRect(room, kCaption, mapCaption(picture)).height()) + 2 * kMargin;
}

} // namespace

MapViewChart::MapViewChart(QWidget* parent)
    : Chart(parent)
    , m_headerStrip(new PaintedStrip([this](QPainter& painter, const QRectF& rect) { paintHeader(painter, rect, font()); }, this))
    , m_barStrip(new PaintedStrip(
          [this](QPainter& painter, const QRectF& rect) { paintColourBar(painter, rect, m_bar, colours(), font()); }, this))
{
}

void MapViewChart::setPicture(const MapPicture& picture)
{
    const double oldWidth = colourBarWidth(m_bar, font()), oldHeight = headerHeight(m_picture, width(), font());
    m_picture = picture;
    m_cells = picture.map ? std::make_shared<const MapCells>(picture.map) : nullptr;
    m_bar = {mapScale(picture, m_cells ? m_cells->largest_deg() : 0), mapValueTitle(picture), picture.limit_deg};
    m_headerStrip->update();
    m_barStrip->update();
    takePicture();
    if (colourBarWidth(m_bar, font()) != oldWidth || headerHeight(m_picture, width(), font()) != oldHeight)
        layoutPlots(contentRect());
    replotAll();
}

void MapViewChart::styleItems()
{
    m_headerStrip->update();
    m_barStrip->update();
}

MapViewChart::Parts MapViewChart::partsOf(const QRectF& rect, const QFont& font) const
{
    const double header = headerHeight(m_picture, rect.width(), font);
    const double bar = colourBarWidth(m_bar, font) + kMargin;
    const double bodyWidth = std::max(1.0, rect.width() - bar), bodyHeight = std::max(1.0, rect.height() - header);
    const double barHeight = std::max(1.0, bodyHeight - footHeight());
    return {{rect.left(), rect.top(), rect.width(), header}, {rect.left(), rect.top() + header, bodyWidth, bodyHeight},
        {rect.left() + bodyWidth + kMargin, rect.top() + header, bar - kMargin, barHeight}};
}

void MapViewChart::paintHeader(QPainter& painter, const QRectF& rect, const QFont& font) const
{
    const QRectF room = rect.adjusted(kMargin, 0, -kMargin, 0);
    painter.setPen(colours().text);
    painter.setFont(boldOf(font));
    painter.drawText(room, Qt::AlignRight | Qt::AlignVCenter, kindWord(m_picture));
    painter.setFont(font);
    painter.drawText(room.adjusted(0, 0, -kindWidth(m_picture, font), 0), kCaption, mapCaption(m_picture));
}

void MapViewChart::layoutPlots(const QRect& rect)
{
    const Parts parts = partsOf(rect, font());
    m_headerStrip->setGeometry(parts.header.toRect());
    m_barStrip->setGeometry(parts.bar.toRect());
    layoutBody(parts.body.toRect());
}

void MapViewChart::paintPlots(QPainter& painter, const QRectF& device)
{
    const double scale = static_cast<double>(painter.device()->logicalDpiX()) / logicalDpiX();
    const QFont font = pixelFont(this->font());
    const Parts parts = partsOf(QRectF(QPointF(), device.size() / scale), font);
    const QRectF body = parts.body;
    paintBody(painter, QRectF(device.topLeft() + body.topLeft() * scale, body.size() * scale), scale);
    painter.save();
    painter.translate(device.topLeft());
    painter.scale(scale, scale);
    paintHeader(painter, parts.header, font);
    paintColourBar(painter, parts.bar, m_bar, colours(), font);
    painter.restore();
}

} // namespace lubberline::ui
