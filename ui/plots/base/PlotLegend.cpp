#include "ui/plots/base/PlotLegend.h"

#include <QFontMetricsF>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>

#include "ui/text/AngleWords.h"

namespace lubberline::ui {

namespace {

constexpr double kKeyWidth = 26, kKeyGap = 5, kEntryGap = 16, kMargin = 4, kHigh = 10'000;
constexpr int kWrapped = Qt::AlignLeft | Qt::AlignVCenter | Qt::TextWordWrap;

struct PlacedEntry {
    int index = 0;
    QRectF rect;
};

double rowHeight(const QFont& font) { return QFontMetricsF(font).height() + 4; }

/// In one line, or, where the room is too narrow, with words that go on beneath.
QSizeF entrySize(const LegendEntry& entry, double room, const QFont& font)
{
    const QFontMetricsF metrics(font);
    const QString title = inAngleStyle(entry.title);
    const double width = kKeyWidth + kKeyGap + metrics.horizontalAdvance(title);
    if (width <= room)
        return {width, rowHeight(font)};
    const QRectF text(0, 0, std::max(1.0, room - kKeyWidth - kKeyGap), kHigh);
    return {room, rowHeight(font) - metrics.height() + metrics.boundingRect(text, kWrapped, title).height()};
}

void centreRow(std::vector<PlacedEntry>& placed, std::size_t first, const QRectF& rect)
{
    if (first == placed.size())
        return;
    const double shift = std::max(0.0, (rect.right() - kMargin - placed.back().rect.right()) / 2);
    for (std::size_t i = first; i < placed.size(); ++i)
        placed[i].rect.translate(shift, 0);
}

std::vector<PlacedEntry> place(const std::vector<LegendEntry>& entries, const QRectF& rect, const QFont& font)
{
    std::vector<PlacedEntry> placed;
    std::size_t rowStart = 0;
    double height = 0; // of the row
    double x = rect.left() + kMargin, y = rect.top() + kMargin / 2;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        if (!entries[i].present)
            continue;
        const auto [width, entryHeight] = entrySize(entries[i], rect.width() - 2 * kMargin, font);
        if (x + width > rect.right() - kMargin + 0.5 && placed.size() > rowStart) {
            centreRow(placed, rowStart, rect);
            rowStart = placed.size();
            x = rect.left() + kMargin;
            y += height;
            height = 0;
        }
        height = std::max(height, entryHeight);
        placed.push_back({static_cast<int>(i), QRectF(x, y, width, entryHeight)});
        x += width + kEntryGap;
    }
    centreRow(placed, rowStart, rect);
    return placed;
}

void paintKey(QPainter& painter, const QRectF& key, const LegendEntry& entry)
{
    const double middle = key.center().y();
    switch (entry.key) {
    case LegendEntry::Key::Line:
        painter.setPen(entry.pen);
        painter.drawLine(QPointF(key.left(), middle), QPointF(key.right(), middle));
        break;
    case LegendEntry::Key::Area:
        painter.setPen(entry.pen);
        painter.setBrush(entry.fill);
        painter.drawRect(key.adjusted(1, 4, -1, -4));
        break;
    case LegendEntry::Key::Bar:
        painter.setPen(entry.pen);
        painter.setBrush(entry.fill);
        painter.drawRect(QRectF(key.center().x() - 5, key.top() + 3, 10, key.height() - 6));
        break;
    case LegendEntry::Key::Dot:
        painter.setPen(QPen(entry.pen.color(), 1));
        painter.drawLine(QPointF(key.center().x(), key.top() + 2), QPointF(key.center().x(), key.bottom() - 2));
        painter.setBrush(entry.fill);
        painter.drawEllipse(key.center(), 3.5, 3.5);
        break;
    }
}

} // namespace

double legendHeight(const std::vector<LegendEntry>& entries, double width, const QFont& font)
{
    const auto placed = place(entries, QRectF(0, 0, width, 0), font);
    return placed.empty() ? 0 : placed.back().rect.bottom() + kMargin / 2;
}

void paintLegend(QPainter& painter, const QRectF& rect, const std::vector<LegendEntry>& entries, const PlotColours& colours)
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    for (const auto& [index, place] : place(entries, rect, painter.font())) {
        const LegendEntry& entry = entries[index];
        painter.setBrush(Qt::NoBrush);
        LegendEntry look = entry;
        if (!entry.shown) {
            look.pen.setColor(colours.grid);
            look.fill = look.key == LegendEntry::Key::Dot ? QBrush(colours.grid) : QBrush(Qt::NoBrush);
        }
        paintKey(painter, QRectF(place.left(), place.top(), kKeyWidth, rowHeight(painter.font())), look);
        painter.setPen(entry.shown ? colours.text : colours.previous);
        painter.drawText(place.adjusted(kKeyWidth + kKeyGap, 0, 1, 0), kWrapped, inAngleStyle(entry.title));
    }
    painter.restore();
}

int legendEntryAt(const std::vector<LegendEntry>& entries, const QRectF& rect, const QFont& font, QPointF at)
{
    for (const auto& [index, placed] : place(entries, rect, font)) {
        if (placed.contains(at))
            return index;
    }
    return -1;
}

PlotLegend::PlotLegend(QWidget* parent) : QWidget(parent), m_colours(coloursFor(palette()))
{
    setObjectName("plotLegend");
    setMouseTracking(true);
}

void PlotLegend::setEntries(const std::vector<LegendEntry>& entries)
{
    m_entries = entries;
    update();
}

void PlotLegend::setColours(const PlotColours& colours)
{
    m_colours = colours;
    update();
}

void PlotLegend::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    paintLegend(painter, rect(), m_entries, m_colours);
}

void PlotLegend::mouseReleaseEvent(QMouseEvent* event)
{
    const int entry = legendEntryAt(m_entries, rect(), font(), event->position());
    if (event->button() == Qt::LeftButton && entry >= 0)
        emit toggled(entry);
}

void PlotLegend::mouseMoveEvent(QMouseEvent* event)
{
    const int entry = legendEntryAt(m_entries, rect(), font(), event->position());
    setCursor(entry >= 0 ? Qt::PointingHandCursor : Qt::ArrowCursor);
    setToolTip(entry < 0 ? QString() : m_entries[entry].shown ? tr("Click to hide") : tr("Click to show"));
}

} // namespace lubberline::ui
