#include "ui/plots/ChartPlot.h"

#include <QAction>
#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMenu>
#include <QPainter>

#include <algorithm>

#include "ui/plots/ChartMouse.h"

namespace lubberline::ui {

namespace {

constexpr int kFrame_px = 1;

bool isOurKey(const QKeyEvent& key)
{
    if (key.matches(QKeySequence::Copy))
        return true;
    switch (key.key()) {
    case Qt::Key_Left:
    case Qt::Key_Right:
    case Qt::Key_Home:
    case Qt::Key_Plus:
    case Qt::Key_Equal:
    case Qt::Key_Minus:
        return !(key.modifiers() & (Qt::ControlModifier | Qt::AltModifier));
    default:
        return false;
    }
}

} // namespace

ChartPlot::ChartPlot(const QString& name, MakeChart makeChart, QWidget* parent)
    : SwingPlot(parent)
    , m_name(name)
    , m_makeChart(std::move(makeChart))
{
    m_chart = m_makeChart().release();
    m_chart->setParent(this);
    m_chart->setFont(font());
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(name);
    followPalette();
    auto* mouse = new ChartMouse(m_chart);
    connect(mouse, &ChartMouse::picked, this, &ChartPlot::select);
    connect(mouse, &ChartMouse::pressed, this, [this] { setFocus(Qt::MouseFocusReason); });
    connect(mouse, &ChartMouse::readOut, this, &ChartPlot::readOut);
}

void ChartPlot::setPicture(const SwingPicture& picture)
{
    m_picture = picture;
    m_stale = true;
    if (isVisible())
        refresh();
}

void ChartPlot::setSelectedRow(int row)
{
    m_selectedRow = row;
    if (isVisible())
        m_chart->setSelectedRow(row);
}

void ChartPlot::refresh()
{
    if (m_stale)
        m_chart->setPicture(m_picture);
    m_stale = false;
    m_chart->setSelectedRow(m_selectedRow);
}

void ChartPlot::resetZoom() { m_chart->resetZoom(); }

void ChartPlot::render(QPainter& painter, const QRectF& target) const
{
    const std::unique_ptr<SwingChart> paper = m_makeChart();
    paper->takeView(*m_chart);
    renderChart(*paper, painter, target, m_picture);
}

bool ChartPlot::event(QEvent* event)
{
    // Our keys come before the window's shortcuts while the plot has the focus.
    if (event->type() == QEvent::ShortcutOverride && isOurKey(static_cast<QKeyEvent&>(*event))) {
        event->accept();
        return true;
    }
    return SwingPlot::event(event);
}

void ChartPlot::showEvent(QShowEvent* event)
{
    SwingPlot::showEvent(event);
    refresh();
}

void ChartPlot::changeEvent(QEvent* event)
{
    SwingPlot::changeEvent(event);
    if (!m_chart)
        return;
    if (event->type() == QEvent::PaletteChange)
        followPalette();
    if (event->type() == QEvent::FontChange)
        m_chart->setFont(font());
}

void ChartPlot::resizeEvent(QResizeEvent* event)
{
    SwingPlot::resizeEvent(event);
    m_chart->setGeometry(rect().marginsRemoved({kFrame_px, kFrame_px, kFrame_px, kFrame_px}));
}

/// The frame of the focus; the chart covers the rest.
void ChartPlot::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.fillRect(rect(), hasFocus() ? palette().color(QPalette::Highlight) : m_chart->colours().ground);
}

void ChartPlot::focusInEvent(QFocusEvent* event)
{
    SwingPlot::focusInEvent(event);
    update();
}

void ChartPlot::focusOutEvent(QFocusEvent* event)
{
    SwingPlot::focusOutEvent(event);
    update();
}

void ChartPlot::followPalette()
{
    const PlotColours colours = coloursFor(palette());
    if (colours != m_chart->colours())
        m_chart->setColours(colours);
}

void ChartPlot::keyPressEvent(QKeyEvent* event)
{
    if (!isOurKey(*event)) {
        SwingPlot::keyPressEvent(event);
        return;
    }
    if (event->matches(QKeySequence::Copy))
        copyToClipboard();
    else if (event->key() == Qt::Key_Left || event->key() == Qt::Key_Right)
        selectNeighbour(event->key() == Qt::Key_Right ? 1 : -1);
    else if (event->key() == Qt::Key_Home)
        resetZoom();
    else
        zoomMiddle(*m_chart, event->key() == Qt::Key_Minus ? 1 / kZoomStep : kZoomStep);
}

void ChartPlot::select(int row)
{
    setSelectedRow(row);
    emit rowSelected(row);
}

void ChartPlot::selectNeighbour(int direction)
{
    std::vector<const PlottedReading*> round;
    for (const PlottedReading& reading : m_picture.readings)
        round.push_back(&reading);
    if (round.empty())
        return;
    std::stable_sort(round.begin(), round.end(),
        [](const auto* a, const auto* b) { return a->magnetic.degrees() < b->magnetic.degrees(); });
    const auto now = std::find_if(round.begin(), round.end(), [this](const auto* r) { return r->row == m_selectedRow; });
    const int count = static_cast<int>(round.size());
    int next = direction > 0 ? 0 : count - 1;
    if (now != round.end())
        next = (static_cast<int>(now - round.begin()) + direction + count) % count;
    select(round[next]->row);
    emit readOut(m_chart->readOutOfRow(m_selectedRow));
}

void ChartPlot::contextMenuEvent(QContextMenuEvent* event)
{
    QMenu menu(this);
    const auto& legend = m_chart->legend();
    for (int i = 0; i < static_cast<int>(legend.size()); ++i) {
        if (!legend[i].present)
            continue;
        QAction* shown = menu.addAction(legend[i].title, this, [this, i](bool on) { m_chart->setShown(i, on); });
        shown->setCheckable(true);
        shown->setChecked(legend[i].shown);
    }
    menu.addSeparator();
    menu.addAction(tr("&Reset zoom"), QKeySequence(Qt::Key_Home), this, &ChartPlot::resetZoom);
    menu.addAction(tr("&Copy"), QKeySequence(QKeySequence::Copy), this, &ChartPlot::copyToClipboard);
    menu.addAction(tr("&Export…"), this, &ChartPlot::exportInteractively);
    menu.exec(event->globalPos());
}

void renderChart(SwingChart& chart, QPainter& painter, const QRectF& target, const SwingPicture& picture)
{
    chart.setFont(paperFont());
    chart.setColours(paperColours());
    chart.setPicture(picture);
    chart.paint(painter, target);
}

} // namespace lubberline::ui
