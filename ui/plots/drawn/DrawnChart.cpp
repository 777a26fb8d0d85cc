#include "ui/plots/drawn/DrawnChart.h"

#include <QPainter>

#include "core/base/Contract.h"
#include "ui/plots/base/PaintedStrip.h"

namespace lubberline::ui {

DrawnChart::DrawnChart(QWidget* parent)
    : Chart(parent)
    , m_canvas(new PaintedStrip([this](QPainter& painter, const QRectF& rect) { draw(painter, rect); }, this))
{
    m_canvas->setMouseTracking(true);
    for (int i = 0; i < kMostDrawnEntries; ++i)
        addEntry({{}, LegendEntry::Key::Line, {}, {}, false, true}, [](bool) {});
}

void DrawnChart::setPicture(const DrawnPicture& picture)
{
    m_picture = picture;
    styleItems();
    updateLegend();
    replotAll();
}

std::vector<QWidget*> DrawnChart::canvases() const { return {m_canvas}; }

QString DrawnChart::readOutAt(const CanvasPlace& place) const
{
    return m_picture.readOut && m_picture.notice.isEmpty() ? m_picture.readOut(m_canvas->rect(), font(), place.at) : QString();
}

void DrawnChart::styleItems()
{
    const auto entries = m_picture.legend && m_picture.notice.isEmpty() ? m_picture.legend(colours()) : std::vector<LegendEntry>();
    LUBBERLINE_EXPECT(entries.size() <= kMostDrawnEntries, "a drawn picture has a few curves");
    for (std::size_t i = 0; i < kMostDrawnEntries; ++i) {
        LegendEntry& mine = entry(static_cast<int>(i));
        const bool shown = mine.shown;
        mine = i < entries.size() ? entries[i] : LegendEntry();
        mine.present = i < entries.size() && mine.present;
        mine.shown = shown;
    }
}

void DrawnChart::layoutPlots(const QRect& rect) { m_canvas->setGeometry(rect); }
void DrawnChart::replotAll() { m_canvas->update(); }

void DrawnChart::draw(QPainter& painter, const QRectF& rect) const
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect, colours().ground);
    DrawnLook look{colours(), {}};
    for (const LegendEntry& one : legend())
        look.shown.push_back(one.shown);
    if (m_picture.paint && m_picture.notice.isEmpty())
        m_picture.paint(painter, rect, look);
    painter.restore();
    paintNotice(painter, rect, m_picture.notice, colours(), painter.font());
}

void DrawnChart::paintPlots(QPainter& painter, const QRectF& device)
{
    painter.save();
    const double scale = static_cast<double>(painter.device()->logicalDpiX()) / logicalDpiX();
    painter.translate(device.topLeft());
    painter.scale(scale, scale);
    painter.setFont(pixelFont(font()));
    draw(painter, QRectF(QPointF(), device.size() / scale));
    painter.restore();
}

} // namespace lubberline::ui
