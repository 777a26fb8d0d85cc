#include "ui/kit/fit/FlowLayout.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QWidget>

#include <algorithm>

namespace lubberline::ui {

namespace {

constexpr int kSpacing = 6, kLineSpacing = 4;

/// Those of one line move and grow together.
void placeLine(const QList<QLayoutItem*>& line, const QRect& room, int used)
{
    int growing = 0, height = 0;
    for (const QLayoutItem* item : line) {
        growing += item->expandingDirections().testFlag(Qt::Horizontal);
        height = std::max(height, item->sizeHint().height());
    }
    int left = room.x(), rest = room.width() - used;
    for (QLayoutItem* item : line) {
        int width = std::min(item->sizeHint().width(), room.width());
        if (item->expandingDirections().testFlag(Qt::Horizontal)) {
            const int more = std::min(rest / growing, item->maximumSize().width() - width);
            width += more;
            rest -= more;
            --growing;
        }
        const int own = std::min(height, item->maximumSize().height());
        item->setGeometry({left, room.y() + (height - own) / 2, width, own});
        left += width + kSpacing;
    }
}

} // namespace

FlowLayout::FlowLayout(QWidget* parent) : QLayout(parent) { setContentsMargins(0, 0, 0, 0); }

FlowLayout::~FlowLayout() { qDeleteAll(m_items); }

void FlowLayout::addItem(QLayoutItem* item) { m_items.append(item); }

QLayoutItem* FlowLayout::itemAt(int index) const { return m_items.value(index); }

QLayoutItem* FlowLayout::takeAt(int index) { return index >= 0 && index < count() ? m_items.takeAt(index) : nullptr; }

int FlowLayout::heightForWidth(int width) const { return arrange({0, 0, width, 0}, false); }

QSize FlowLayout::sizeHint() const
{
    QSize size;
    for (const QLayoutItem* item : m_items)
        if (!item->isEmpty())
            size = {size.width() + (size.isEmpty() ? 0 : kSpacing) + item->sizeHint().width(),
                std::max(size.height(), item->sizeHint().height())};
    return size.grownBy(contentsMargins());
}

QSize FlowLayout::minimumSize() const
{
    QSize size;
    for (const QLayoutItem* item : m_items)
        if (!item->isEmpty())
            size = size.expandedTo(item->minimumSize());
    return size.grownBy(contentsMargins());
}

void FlowLayout::setGeometry(const QRect& rect)
{
    QLayout::setGeometry(rect);
    arrange(rect, true);
}

int FlowLayout::arrange(const QRect& rect, bool move) const
{
    QRect room = rect.marginsRemoved(contentsMargins());
    QList<QLayoutItem*> line;
    int used = 0, height = 0;
    const auto end = [&] {
        if (move)
            placeLine(line, room, used);
        room.setTop(room.top() + height + kLineSpacing);
        line.clear();
        used = height = 0;
    };
    for (QLayoutItem* item : m_items) {
        if (item->isEmpty())
            continue;
        const int width = std::min(item->sizeHint().width(), room.width());
        if (!line.isEmpty() && used + kSpacing + width > room.width())
            end();
        used += (line.isEmpty() ? 0 : kSpacing) + width;
        height = std::max(height, item->sizeHint().height());
        line.append(item);
    }
    if (line.isEmpty())
        return contentsMargins().top() + contentsMargins().bottom();
    const int bottom = room.top() + height;
    end();
    return bottom - rect.top() + contentsMargins().bottom();
}

QWidget* labelled(const QString& text, QWidget* control)
{
    auto* pair = new QWidget;
    auto* layout = new QHBoxLayout(pair);
    layout->setContentsMargins(0, 0, 0, 0);
    auto* label = new QLabel(text);
    label->setBuddy(control);
    layout->addWidget(label);
    layout->addWidget(control, 1);
    return pair;
}

} // namespace lubberline::ui
