#include "ui/plots/base/Plot.h"

#include <QAction>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QGuiApplication>
#include <QImage>
#include <QKeyEvent>
#include <QMenu>
#include <QPainter>

#include "ui/plots/base/AsksToSave.h"
#include "ui/plots/base/Chart.h"
#include "ui/plots/base/ChartMouse.h"
#include "ui/plots/base/PlotFile.h"
#include "ui/text/AngleWords.h"
#include "ui/text/Translated.h"

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
    case Qt::Key_Minus: return !(key.modifiers() & (Qt::ControlModifier | Qt::AltModifier));
    default: return false;
    }
}

} // namespace

Plot::Plot(const QString& name, QWidget* parent) : QWidget(parent), m_name(name)
{
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(name);
}

void Plot::adopt(Chart* chart)
{
    m_chart = chart;
    m_chart->setParent(this);
    m_chart->setFont(font());
    followPalette();
}

ChartMouse* Plot::watchMouse()
{
    auto* mouse = new ChartMouse(m_chart);
    connect(mouse, &ChartMouse::pressed, this, [this] { setFocus(Qt::MouseFocusReason); });
    connect(mouse, &ChartMouse::readOut, this, &Plot::readOut);
    return mouse;
}

void Plot::restyle() { m_chart->setColours(coloursFor(palette())); }
void Plot::resetZoom() { m_chart->resetZoom(); }
bool Plot::step(int) { return false; }

Result<void> Plot::exportTo(const QString& path, QSize size_px) const
{
    return writePlotFile(path, size_px, name(), [this](QPainter& painter, const QRectF& target) { render(painter, target); });
}

AsksToSave* Plot::asksToSave() const
{
    for (QWidget* above = parentWidget(); above; above = above->parentWidget())
        if (auto* asks = dynamic_cast<AsksToSave*>(above))
            return asks;
    return nullptr;
}

void Plot::exportInteractively(const QString& suggestion)
{
    AsksToSave* window = asksToSave();
    const QString path = window ? window->askToSave(tr("Export the plot"), suggestion.isEmpty() ? name().toLower() : suggestion,
                             tr("Image (*.png);;Drawing (*.svg);;PDF (*.pdf)"))
                                : QString();
    if (path.isEmpty())
        return;
    emit leaves();
    const Result<void> written = exportTo(path);
    if (!written)
        emit failed(messageOf(written.error()));
}

void Plot::copyToClipboard()
{
    emit leaves();
    const QSize size = this->size().expandedTo({400, 300});
    QImage image(2 * size, QImage::Format_RGB32); // sharp in a document
    image.setDevicePixelRatio(2);
    image.fill(Qt::white);
    QPainter painter(&image);
    render(painter, QRectF(QPointF(), size));
    painter.end();
    QGuiApplication::clipboard()->setImage(image);
}

bool Plot::event(QEvent* event)
{
    // Our keys come before the window's shortcuts while the plot has the focus.
    if (event->type() == QEvent::ShortcutOverride && isOurKey(static_cast<QKeyEvent&>(*event))) {
        event->accept();
        return true;
    }
    return QWidget::event(event);
}

void Plot::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    refresh();
}

void Plot::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (!m_chart)
        return;
    if (event->type() == QEvent::PaletteChange)
        followPalette();
    if (event->type() == QEvent::FontChange)
        m_chart->setFont(font());
}

void Plot::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    m_chart->setGeometry(rect().marginsRemoved({kFrame_px, kFrame_px, kFrame_px, kFrame_px}));
}

/// The frame of the focus; the chart covers the rest.
void Plot::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.fillRect(rect(), hasFocus() ? palette().color(QPalette::Highlight) : m_chart->colours().ground);
}

void Plot::focusInEvent(QFocusEvent* event)
{
    QWidget::focusInEvent(event);
    update();
}

void Plot::focusOutEvent(QFocusEvent* event)
{
    QWidget::focusOutEvent(event);
    update();
}

void Plot::followPalette()
{
    const PlotColours colours = coloursFor(palette());
    if (colours != m_chart->colours())
        m_chart->setColours(colours);
}

void Plot::keyPressEvent(QKeyEvent* event)
{
    const bool arrow = event->key() == Qt::Key_Left || event->key() == Qt::Key_Right;
    if (!isOurKey(*event) || (arrow && !step(event->key() == Qt::Key_Right ? 1 : -1))) {
        QWidget::keyPressEvent(event);
        return;
    }
    if (arrow)
        return;
    if (event->matches(QKeySequence::Copy))
        copyToClipboard();
    else if (event->key() == Qt::Key_Home)
        resetZoom();
    else
        zoomMiddle(*m_chart, event->key() == Qt::Key_Minus ? 1 / kZoomStep : kZoomStep);
}

void Plot::contextMenuEvent(QContextMenuEvent* event)
{
    QMenu menu(this);
    addLegend(menu);
    menu.addAction(tr("&Reset zoom"), QKeySequence(Qt::Key_Home), this, &Plot::resetZoom);
    menu.addAction(tr("&Copy"), QKeySequence(QKeySequence::Copy), this, &Plot::copyToClipboard);
    if (asksToSave())
        menu.addAction(tr("&Export…"), this, [this] { exportInteractively(); });
    menu.exec(event->globalPos());
}

void Plot::addLegend(QMenu& menu)
{
    const auto& legend = m_chart->legend();
    for (int i = 0; i < static_cast<int>(legend.size()); ++i) {
        if (!legend[i].present)
            continue;
        QAction* shown = menu.addAction(inAngleStyle(legend[i].title), this, [this, i](bool on) { m_chart->setShown(i, on); });
        shown->setCheckable(true);
        shown->setChecked(legend[i].shown);
    }
    menu.addSeparator();
}

} // namespace lubberline::ui
