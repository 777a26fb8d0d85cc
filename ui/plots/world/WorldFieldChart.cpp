#include "ui/plots/world/WorldFieldChart.h"

#include <qwt_plot_layout.h>
#include <qwt_scale_draw.h>
#include <qwt_text.h>

#include <algorithm>
#include <cmath>

#include "core/base/Contract.h"
#include "ui/plots/base/CartesianPlot.h"
#include "ui/plots/base/HeadingScale.h"
#include "ui/plots/world/WorldFieldItem.h"
#include "ui/plots/world/WorldFieldText.h"

namespace lubberline::ui {

namespace {

constexpr int kMostSteps = 8; ///< of 45° over the world

/// Where they would collide, only every second or third tick has its label; the equator and Greenwich always have.
class PlaceScaleDraw : public QwtScaleDraw {
public:
    using Text = QString (*)(double value_deg, int decimals);
    explicit PlaceScaleDraw(Text text) : m_text(text) {}
    void setEvery(int every)
    {
        m_every = every;
        invalidateCache();
    }
    [[nodiscard]] QwtText label(double value_deg) const override
    {
        const QList<double> ticks = scaleDiv().ticks(QwtScaleDiv::MajorTick);
        const double step = ticks.size() > 1 ? ticks[1] - ticks[0] : 1;
        return std::lround(value_deg / step) % m_every == 0 ? QwtText(m_text(value_deg, 0)) : QwtText();
    }

private:
    Text m_text;
    int m_every = 1;
};

void thin(QwtPlot& plot, int axis, double length, double labelNeeds)
{
    if (auto* scale = dynamic_cast<PlaceScaleDraw*>(plot.axisScaleDraw(axis)))
        scale->setEvery(std::max(1, static_cast<int>(std::ceil(labelNeeds * kMostSteps / std::max(1.0, length)))));
}

} // namespace

WorldFieldChart::WorldFieldChart(QWidget* parent) : Chart(parent), m_plot(new CartesianPlot(this)), m_item(new WorldFieldItem)
{
    m_plot->setObjectName("worldFieldPlot");
    m_plot->plotLayout()->setCanvasMargin(0);
    m_plot->plotLayout()->setAlignCanvasToScales(true);
    m_plot->setContentsMargins(0, 8, 20, 0); // half a label of 90° N and of 180° E
    for (const int axis : {QwtAxis::XBottom, QwtAxis::YLeft})
        m_plot->setAxisScaleEngine(axis, new HeadingScaleEngine);
    m_plot->setAxisScaleDraw(QwtAxis::XBottom, new PlaceScaleDraw(longitudeText));
    m_plot->setAxisScaleDraw(QwtAxis::YLeft, new PlaceScaleDraw(latitudeText));
    m_plot->setBase(-180, 180, -90, 90, 0);
    m_item->attach(m_plot);
    styleItems();
    setGrid(nullptr);
}

void WorldFieldChart::setGrid(std::shared_ptr<const FieldGrid> grid)
{
    LUBBERLINE_EXPECT(!grid || (grid->columns >= 2 && grid->rows >= 2), "a grid of the world has at least two nodes each way");
    m_grid = std::move(grid);
    m_item->setGrid(m_grid);
    const QString title = m_grid
        ? tr("%1, %2, %3").arg(fieldElementTitle(m_grid->element), QString::fromStdString(m_grid->model)).arg(m_grid->year, 0, 'f', 1)
        : tr("The field is being computed.");
    // Beneath the map, where it has the width of the page: beside a low map it was cut.
    m_plot->setTitles(title + QLatin1Char('\n') + tr("equirectangular, equal scales"), {});
    replotAll();
}

void WorldFieldChart::setPlace(const std::optional<Place>& place, const QString& label)
{
    m_item->setPlace(place, label);
    replotAll();
}

std::vector<QWidget*> WorldFieldChart::canvases() const { return {m_plot->canvas()}; }

std::optional<QPointF> WorldFieldChart::placeAt(const QPointF& at_px) const
{
    const QPointF at = m_plot->valueAt(at_px);
    return QRectF(-180, -90, 360, 180).contains(at) ? std::optional(at) : std::nullopt;
}

QString WorldFieldChart::readOutAt(const CanvasPlace& place) const
{
    const auto at = placeAt(place.at);
    return m_grid && at ? worldReadOut(*m_grid, at->y(), at->x()) : QString();
}

/// What is framed is wholly seen, in the shape that the world keeps.
void WorldFieldChart::zoomInto(const QWidget* canvas, const QRectF& rect)
{
    const double shape = static_cast<double>(canvas->width()) / std::max(1, canvas->height());
    QRectF whole(QPointF(), QSizeF(std::max(rect.width(), rect.height() * shape), std::max(rect.height(), rect.width() / shape)));
    whole.moveCenter(rect.center());
    m_plot->zoomInto(whole);
}

QRectF WorldFieldChart::inShape(const QRectF& rect, double unit) const
{
    const double aside = (m_plot->width() - m_plot->canvas()->width()) * unit,
                 above = (m_plot->height() - m_plot->canvas()->height()) * unit;
    const double width = std::max(1.0, rect.width() - aside), height = std::max(1.0, rect.height() - above);
    QRectF shaped(0, 0, std::min(width, 2 * height) + aside, std::min(height, width / 2) + above);
    shaped.moveCenter(rect.center());
    return shaped;
}
void WorldFieldChart::zoomAt(const CanvasPlace& place, double factor) { m_plot->zoomAt(place.at, factor); }
void WorldFieldChart::panBy(const QWidget*, const QPointF& by) { m_plot->panBy(by); }
void WorldFieldChart::resetZoom() { m_plot->resetZoom(); }

void WorldFieldChart::takeView(const Chart& other)
{
    Chart::takeView(other);
    m_plot->takeView(*static_cast<const WorldFieldChart&>(other).m_plot);
}

void WorldFieldChart::styleItems()
{
    m_plot->setLook(colours(), font());
    m_item->setLook(colours(), font());
}

void WorldFieldChart::layoutPlots(const QRect& rect)
{
    m_plot->setGeometry(rect);
    m_plot->updateLayout(); // its axes say how much they need
    const QRect shaped = inShape(rect, 1).toRect();
    const QFontMetrics metrics(m_plot->axisFont(QwtAxis::XBottom));
    const int aside = m_plot->width() - m_plot->canvas()->width();
    thin(*m_plot, QwtAxis::XBottom, shaped.width() - aside, metrics.horizontalAdvance(longitudeText(-135, 0)) + 8);
    thin(*m_plot, QwtAxis::YLeft, shaped.width() - aside, 2.0 * metrics.height()); // its degrees are as long as those of longitude
    m_plot->setGeometry(shaped);
}

void WorldFieldChart::paintPlots(QPainter& painter, const QRectF& device)
{
    m_plot->replot();
    m_plot->setGeometry(QRect(QPoint(), size()));
    m_plot->updateLayout();
    m_plot->paintInto(painter, inShape(device, device.width() / std::max(1, width())));
}

void WorldFieldChart::replotAll() { m_plot->replot(); }

} // namespace lubberline::ui
