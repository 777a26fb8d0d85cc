#include "ui/kit/fit/SideBySide.h"

#include <QEvent>
#include <QLayout>
#include <QScrollBar>
#include <QTabBar>
#include <QTabWidget>

#include <algorithm>

namespace lubberline::ui {

namespace {

constexpr int kLeastHeight = 260; ///< of a plot that stands beneath its fields
constexpr int kTabFrame = 6;      ///< of a page behind a tab, both sides

/// As Qt reckons it: a size that was set rules.
int leastWidth(const QWidget& widget)
{
    return widget.minimumWidth() > 0 ? widget.minimumWidth() : std::min(widget.minimumSizeHint().width(), widget.maximumWidth());
}

/// That words which wrap are read whole at a width; 0: none does. Qt does not ask behind tabs.
int heightOfWords(const QWidget& widget, int width)
{
    if (const auto* tabs = qobject_cast<const QTabWidget*>(&widget)) {
        int height = 0;
        for (int i = 0; i < tabs->count(); ++i)
            height = std::max(height, heightOfWords(*tabs->widget(i), width - kTabFrame));
        return height > 0 ? height + tabs->tabBar()->sizeHint().height() + kTabFrame : 0;
    }
    const QLayout* layout = widget.layout();
    return layout && layout->hasHeightForWidth() ? layout->minimumHeightForWidth(width) : 0;
}

} // namespace

SidePanel::SidePanel(QWidget* content, QWidget* parent) : QScrollArea(parent)
{
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFocusPolicy(Qt::NoFocus);
    setWidget(content);
    content->setAutoFillBackground(false);
    viewport()->setAutoFillBackground(false);
}

QSize SidePanel::sizeHint() const
{
    return {widget()->sizeHint().width() + verticalScrollBar()->sizeHint().width(), widget()->sizeHint().height()};
}

QSize SidePanel::minimumSizeHint() const
{
    return {leastWidth(*widget()) + verticalScrollBar()->sizeHint().width(), QScrollArea::minimumSizeHint().height()};
}

int SidePanel::wholeHeight(int width) const
{
    const QLayout* layout = widget()->layout();
    return (layout && layout->hasHeightForWidth() ? layout->totalHeightForWidth(width) : widget()->sizeHint().height()) + 2 * frameWidth();
}

bool SidePanel::eventFilter(QObject* object, QEvent* event)
{
    if (object == widget() && event->type() == QEvent::LayoutRequest)
        updateGeometry();
    return QScrollArea::eventFilter(object, event);
}

SideBySide::SideBySide(Narrow narrow) : QSplitter(Qt::Horizontal), m_narrow(narrow) { setChildrenCollapsible(false); }

int SideBySide::widthBeside() const
{
    int width = -handleWidth();
    for (int i = 0; i < count(); ++i)
        if (!widget(i)->isHidden())
            width += leastWidth(*widget(i)) + handleWidth();
    return width;
}

QSize SideBySide::minimumSizeHint() const
{
    if (m_narrow == Narrow::Stays)
        return QSplitter::minimumSizeHint();
    int width = 0;
    for (int i = 0; i < count(); ++i)
        if (!widget(i)->isHidden())
            width = std::max(width, leastWidth(*widget(i)));
    return {width, QSplitter::minimumSizeHint().height()};
}

bool SideBySide::event(QEvent* event)
{
    const bool done = QSplitter::event(event);
    if (event->type() == QEvent::LayoutRequest) {
        turn();
        giveHeights();
    }
    return done;
}

void SideBySide::resizeEvent(QResizeEvent* event)
{
    turn();
    QSplitter::resizeEvent(event);
    giveHeights();
}

void SideBySide::turn()
{
    if (m_turning || m_narrow == Narrow::Stays)
        return;
    m_turning = true;
    const bool above = width() < widthBeside(), was = orientation() == Qt::Vertical;
    if (above && !was)
        m_beside = sizes();
    if (above != was) {
        setOrientation(above ? Qt::Vertical : Qt::Horizontal);
        if (!above && m_beside.size() == count())
            setSizes(m_beside);
        updateGeometry();
    }
    m_turning = false;
}

void SideBySide::giveHeights()
{
    const bool above = orientation() == Qt::Vertical;
    for (int i = 0; i < count(); ++i) {
        const auto* panel = dynamic_cast<const SidePanel*>(widget(i));
        const int words = panel ? 0 : heightOfWords(*widget(i), widget(i)->width());
        const int own = m_own.contains(widget(i)) ? m_own.value(widget(i)) : *m_own.insert(widget(i), widget(i)->minimumHeight());
        widget(i)->setMinimumHeight(std::max(own, !above ? words : panel ? panel->wholeHeight(width()) : std::max(words, kLeastHeight)));
    }
}

} // namespace lubberline::ui
