#include "ui/plots/map/MapViewChart.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>

#include "ui/plots/base/PaintedStrip.h"
#include "ui/plots/map/MapText.h"

namespace lubberline::ui {

namespace {

constexpr double kMargin = 6;

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
    const double oldWidth = colourBarWidth(m_bar, font());
    m_picture = picture;
    m_cells = picture.map ? std::make_shared<const MapCells>(picture.map) : nullptr;
    m_bar = {mapScale(picture, m_cells ? m_cells->largest_deg() : 0), mapValueTitle(picture), picture.limit_deg};
    m_headerStrip->update();
    m_barStrip->update();
    takePicture();
    if (colourBarWidth(m_bar, font()) != oldWidth)
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
    const double header = QFontMetricsF(font).height() + 2 * kMargin;
    const double bar = colourBarWidth(m_bar, font) + kMargin;
    const double bodyWidth = std::max(1.0, rect.width() - bar), bodyHeight = std::max(1.0, rect.height() - header);
    const double barHeight = std::max(1.0, bodyHeight - footHeight());
    return {{rect.left(), rect.top(), rect.width(), header}, {rect.left(), rect.top() + header, bodyWidth, bodyHeight},
        {rect.left() + bodyWidth + kMargin, rect.top() + header, bar - kMargin, barHeight}};
}

void MapViewChart::paintHeader(QPainter& painter, const QRectF& rect, const QFont& font) const
{
    QFont bold = font;
    bold.setBold(true);
    const QRectF room = rect.adjusted(kMargin, 0, -kMargin, 0);
    const QString kind = kindWord(m_picture);
    const double kindWidth = QFontMetricsF(bold).horizontalAdvance(kind);
    painter.setPen(colours().text);
    painter.setFont(bold);
    painter.drawText(room, Qt::AlignRight | Qt::AlignVCenter, kind);
    painter.setFont(font);
    const QRectF left = room.adjusted(0, 0, -kindWidth - 2 * kMargin, 0);
    painter.drawText(left, Qt::AlignLeft | Qt::AlignVCenter,
        QFontMetricsF(font).elidedText(mapCaption(m_picture), Qt::ElideMiddle, std::max(0.0, left.width())));
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
