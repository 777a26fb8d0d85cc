#include "ui/plots/base/CartesianPlot.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

#include <qwt_plot_canvas.h>
#include <qwt_plot_grid.h>
#include <qwt_plot_layout.h>
#include <qwt_plot_marker.h>
#include <qwt_plot_renderer.h>
#include <qwt_scale_draw.h>
#include <qwt_scale_map.h>
#include <qwt_scale_widget.h>
#include <qwt_text.h>

#include "ui/plots/base/Chart.h"
#include "ui/text/AngleWords.h"

namespace lubberline::ui {

namespace {

constexpr double kClosest = 0.02;                     ///< a fiftieth of the base fills the plot
constexpr int kSideMargin_px = 11, kEndMargin_px = 6; ///< a reading on the frame is still seen whole

/// Signed ticks: east is +, zero has no sign. Where the axis is one of degrees they follow the style of angles.
class SignedScaleDraw : public QwtScaleDraw {
public:
    void setDegrees(bool degrees)
    {
        m_degrees = degrees;
        invalidateCache();
    }
    void forget() { invalidateCache(); }
    [[nodiscard]] QwtText label(double value) const override
    {
        const QList<double> ticks = scaleDiv().ticks(QwtScaleDiv::MajorTick);
        const double step = ticks.size() > 1 ? ticks[1] - ticks[0] : 1.0;
        if (m_degrees)
            return angleTick(value, step);
        return std::abs(value) < 1e-9 * std::abs(step) ? QStringLiteral("0") : signedTick(value, step);
    }

private:
    bool m_degrees = false;
};

double keptWithin(double from, double length, double low, double high) { return std::clamp(from, low, std::max(low, high - length)); }

} // namespace

CartesianPlot::CartesianPlot(QWidget* parent)
    : QwtPlot(parent)
    , m_grid(new QwtPlotGrid)
    , m_zero(new QwtPlotMarker)
    , m_notice(new PlotNotice)
{
    setAutoReplot(false);
    setFrameStyle(QFrame::NoFrame);
    auto* plain = new QwtPlotCanvas(this);
    plain->setFrameStyle(QFrame::NoFrame);
    plain->setCursor(Qt::CrossCursor);
    setCanvas(plain);
    m_grid->setZ(5); // above the tinted bands
    m_grid->attach(this);
    m_zero->setZ(6);
    m_zero->setLineStyle(QwtPlotMarker::HLine);
    m_zero->setValue(0, 0);
    m_zero->attach(this);
    m_notice->attach(this);
    plotLayout()->setCanvasMargin(kSideMargin_px, QwtAxis::YLeft);
    plotLayout()->setCanvasMargin(kSideMargin_px, QwtAxis::YRight);
    plotLayout()->setCanvasMargin(kEndMargin_px, QwtAxis::XBottom);
    plotLayout()->setCanvasMargin(kEndMargin_px, QwtAxis::XTop);
    setAxisScaleDraw(QwtAxis::YLeft, new SignedScaleDraw);
    setAxisMaxMajor(QwtAxis::YLeft, 8);
}

void CartesianPlot::setLook(const PlotColours& colours, const QFont& font)
{
    m_colours = colours;
    m_font = pixelFont(font);
    QPalette looks = palette();
    looks.setColor(QPalette::Window, colours.ground);
    looks.setColor(QPalette::WindowText, colours.axis); // backbone and ticks
    looks.setColor(QPalette::Text, colours.text);       // labels
    setPalette(looks);
    setAutoFillBackground(true);
    setCanvasBackground(colours.ground);
    m_grid->setMajorPen(colours.grid, 1);
    m_zero->setLinePen(colours.axis, 1.6);
    m_notice->setLook(colours, font);
    for (const int axis : {QwtAxis::YLeft, QwtAxis::XBottom}) {
        axisWidget(axis)->setPalette(looks);
        axisWidget(axis)->setMargin(axis == QwtAxis::XBottom ? 1 : 0); // its line would lie half outside the axis
        setAxisFont(axis, m_font);
        QwtText title = axisTitle(axis);
        title.setFont(m_font);
        title.setColor(colours.text);
        setAxisTitle(axis, title);
    }
    if (auto* scale = dynamic_cast<SignedScaleDraw*>(axisScaleDraw(QwtAxis::YLeft)))
        scale->forget(); // the style of angles may be another
}

void CartesianPlot::setTitles(const QString& x, const QString& y)
{
    for (const auto& [axis, text] : {std::pair{QwtAxis::XBottom, x}, {QwtAxis::YLeft, y}}) {
        QwtText title(text);
        title.setRenderFlags(Qt::AlignCenter | Qt::TextWordWrap); // beside a low plot it stands in two lines
        title.setFont(m_font);
        title.setColor(m_colours.text);
        setAxisTitle(axis, title);
        axisScaleDraw(axis)->setPenWidthF(1); // the hairline of 0 vanishes on paper
    }
    if (auto* scale = dynamic_cast<SignedScaleDraw*>(axisScaleDraw(QwtAxis::YLeft)))
        scale->setDegrees(y.contains(u'°'));
}

void CartesianPlot::setNotice(const QString& text) { m_notice->setText(text); }
QString CartesianPlot::notice() const { return m_notice->text(); }

void CartesianPlot::setBase(double xFrom, double xTo, double yFrom, double yTo, double yStep)
{
    const bool wasZoomed = zoomed();
    m_base = QRectF(xFrom, yFrom, xTo - xFrom, yTo - yFrom);
    m_yStep = yStep;
    if (!wasZoomed)
        m_view = m_base;
    applyView();
}

void CartesianPlot::setView(const QRectF& view)
{
    const double width = std::clamp(view.width(), kClosest * m_base.width(), m_base.width());
    const double height = std::clamp(view.height(), kClosest * m_base.height(), m_base.height());
    const double x = keptWithin(view.center().x() - width / 2, width, m_base.left(), m_base.right());
    const double y = keptWithin(view.center().y() - height / 2, height, m_base.top(), m_base.bottom());
    const QRectF kept(x, y, width, height);
    m_view = width == m_base.width() && height == m_base.height() ? m_base : kept;
    applyView();
    emit viewChanged();
    replot();
}

void CartesianPlot::applyView()
{
    setAxisScale(QwtAxis::XBottom, m_view.left(), m_view.right());
    setAxisScale(QwtAxis::YLeft, m_view.top(), m_view.bottom(), m_view.height() == m_base.height() ? m_yStep : 0);
}

void CartesianPlot::resetZoom() { setView(m_base); }

void CartesianPlot::takeView(const CartesianPlot& other)
{
    m_base = other.m_base; // a fresh plot has none of its own yet
    m_yStep = other.m_yStep;
    setView(other.m_view);
}

void CartesianPlot::zoomInto(const QRectF& rect_px)
{
    setView(QRectF(valueAt(rect_px.topLeft()), valueAt(rect_px.bottomRight())).normalized());
}

void CartesianPlot::zoomAt(const QPointF& at_px, double factor)
{
    const QPointF kept = valueAt(at_px);
    const double applied = std::clamp(factor, kClosest * m_base.width() / m_view.width(), m_base.width() / m_view.width());
    setView(QRectF(kept + (m_view.topLeft() - kept) * applied, m_view.size() * applied));
}

void CartesianPlot::panBy(const QPointF& by_px)
{
    const QPointF by = valueAt(by_px) - valueAt(QPointF());
    setView(m_view.translated(-by));
}

QPointF CartesianPlot::valueAt(const QPointF& at_px) const
{
    return {canvasMap(QwtAxis::XBottom).invTransform(at_px.x()), canvasMap(QwtAxis::YLeft).invTransform(at_px.y())};
}

QPointF CartesianPlot::pixelOf(const QPointF& value) const
{
    return {canvasMap(QwtAxis::XBottom).transform(value.x()), canvasMap(QwtAxis::YLeft).transform(value.y())};
}

void CartesianPlot::paintInto(QPainter& painter, const QRectF& device)
{
    QwtPlotRenderer renderer;
    renderer.setDiscardFlags(QwtPlotRenderer::DiscardBackground | QwtPlotRenderer::DiscardCanvasBackground | QwtPlotRenderer::DiscardTitle
        | QwtPlotRenderer::DiscardFooter | QwtPlotRenderer::DiscardLegend);
    renderer.render(this, &painter, device);
}

PlotNotice::PlotNotice() { setZ(40); }

void PlotNotice::setLook(const PlotColours& colours, const QFont& font)
{
    m_colours = colours;
    m_font = pixelFont(font);
}

void PlotNotice::draw(QPainter* painter, const QwtScaleMap&, const QwtScaleMap&, const QRectF& canvasRect) const
{
    paintNotice(*painter, canvasRect, m_text, m_colours, m_font);
}

} // namespace lubberline::ui
