#include "ui/plots/drawn/DrawnPlot.h"

#include <QPainter>

#include "core/base/Contract.h"
#include "ui/plots/base/PaintedStrip.h"
#include "ui/plots/drawn/DrawnChart.h"

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

DrawnPlot::DrawnPlot(const QString& name, QSize least, QWidget* parent) : Plot(name, parent), m_chart(new DrawnChart(this)), m_least(least)
{
    adopt(m_chart);
    watchMouse();
}

void DrawnPlot::setPicture(DrawnPicture picture)
{
    m_picture = std::move(picture);
    m_chart->setPicture(m_picture);
}

void DrawnPlot::redraw() { canvas()->update(); }
QString DrawnPlot::textAt(const QPointF& at) const { return m_chart->readOutAt({canvas(), at}); }
QWidget* DrawnPlot::canvas() const { return m_chart->canvases().front(); }

void DrawnPlot::render(QPainter& painter, const QRectF& target) const
{
    DrawnChart paper;
    paper.setFont(paperFont());
    paper.setColours(paperColours());
    paper.setPicture(m_picture);
    paper.takeView(*m_chart);
    paper.paint(painter, target);
}

void renderDrawn(QPainter& painter, const QRectF& target, const DrawnPicture& picture)
{
    DrawnChart paper;
    paper.setFont(paperFont());
    paper.setColours(paperColours());
    paper.setPicture(picture);
    paper.paint(painter, target);
}

} // namespace lubberline::ui
