#include "ui/plots/map/MapChart.h"

#include <qwt_plot_layout.h>
#include <qwt_scale_draw.h>
#include <qwt_scale_widget.h>
#include <qwt_text.h>

#include "ui/plots/base/CartesianPlot.h"
#include "ui/plots/base/HeadingScale.h"
#include "ui/plots/map/DivergingMap.h"
#include "ui/plots/map/MapItem.h"
#include "ui/plots/map/MapText.h"

namespace lubberline::ui {

namespace {

class AttitudeScaleDraw : public QwtScaleDraw {
public:
    explicit AttitudeScaleDraw(AttitudeAxis axis) : m_axis(axis) {}
    [[nodiscard]] QwtText label(double value_deg) const override { return attitudeTick(m_axis, value_deg); }

private:
    AttitudeAxis m_axis;
};

bool sameRange(const MapAxis& a, const MapAxis& b)
{
    return a.axis == b.axis && a.range.from_deg == b.range.from_deg && a.range.to_deg == b.range.to_deg;
}

} // namespace

MapChart::MapChart(QWidget* parent) : MapViewChart(parent), m_plot(new CartesianPlot(this)), m_item(new MapItem)
{
    m_plot->setObjectName("mapPlot");
    m_plot->plotLayout()->setCanvasMargin(0);
    m_plot->plotLayout()->setAlignCanvasToScales(true);
    for (const int axis : {QwtAxis::XBottom, QwtAxis::YLeft})
        m_plot->setAxisScaleEngine(axis, new HeadingScaleEngine); // attitudes are read in its steps too
    m_item->attach(m_plot);
    m_contoursEntry = addEntry({tr("contours")}, [this](bool on) { m_item->contoursShown = on; });
    m_limitEntry = addEntry({tr("limit")}, [this](bool on) { m_item->limitShown = on; });
    m_extremesEntry = addEntry({tr("extremes ▲▼")}, [this](bool on) { m_item->extremesShown = on; });
    styleItems();
    takePicture();
}

void MapChart::takePicture()
{
    m_item->setMap(picture(), sharedCells(), scale());
    updateEntries();
    m_plot->setNotice(cells() ? QString() : tr("There is no map yet."));
    for (const int axis : {QwtAxis::XBottom, QwtAxis::YLeft})
        m_plot->setAxisVisible(axis, cells());
    if (!cells())
        return;
    const MapRequest& request = cells()->request();
    const QRectF range = cells()->range_deg();
    m_plot->setAxisScaleDraw(QwtAxis::XBottom, new AttitudeScaleDraw(request.x.axis));
    m_plot->setAxisScaleDraw(QwtAxis::YLeft, new AttitudeScaleDraw(request.y.axis));
    m_plot->setTitles(attitudeTitle(request.x.axis), attitudeTitle(request.y.axis));
    if (m_viewed && !(sameRange(m_viewed->x, request.x) && sameRange(m_viewed->y, request.y)))
        m_plot->resetZoom(); // or the zoom of one pair of axes would be kept for another
    m_viewed = request;
    m_plot->setBase(range.left(), range.right(), range.top(), range.bottom(), 0);
}

void MapChart::updateEntries()
{
    entry(m_contoursEntry).present = !m_item->contours().empty();
    entry(m_limitEntry).present = cells() && picture().limit_deg;
    if (picture().limit_deg)
        entry(m_limitEntry).title = tr("limit ±%1°").arg(*picture().limit_deg);
    entry(m_extremesEntry).present = !picture().extremes.empty();
    updateLegend();
}

std::vector<QWidget*> MapChart::canvases() const { return {m_plot->canvas()}; }

QString MapChart::readOutAt(const CanvasPlace& place) const
{
    if (!cells())
        return {};
    const QPointF at = m_plot->valueAt(place.at);
    if (!cells()->range_deg().contains(at))
        return {};
    return mapReadOut(picture(), at.x(), at.y(), cells()->valueAt_deg(at.x(), at.y()));
}

void MapChart::zoomInto(const QWidget*, const QRectF& rect) { m_plot->zoomInto(rect); }
void MapChart::zoomAt(const CanvasPlace& place, double factor) { m_plot->zoomAt(place.at, factor); }
void MapChart::panBy(const QWidget*, const QPointF& by) { m_plot->panBy(by); }
void MapChart::resetZoom() { m_plot->resetZoom(); }

void MapChart::takeView(const Chart& other)
{
    Chart::takeView(other);
    const auto& map = static_cast<const MapChart&>(other);
    m_plot->takeView(*map.m_plot);
    m_viewed = map.m_viewed;
}

void MapChart::styleItems()
{
    MapViewChart::styleItems();
    m_plot->setLook(colours(), font());
    m_item->setLook(colours().ground, font());
    entry(m_contoursEntry).pen = QPen(colours().text, 0.9);
    entry(m_limitEntry).pen = QPen(colours().text, 2.8);
    entry(m_extremesEntry).pen = Qt::NoPen;
}

void MapChart::layoutBody(const QRect& rect) { m_plot->setGeometry(rect); }
double MapChart::footHeight() const { return m_plot->axisWidget(QwtAxis::XBottom)->sizeHint().height(); }

void MapChart::paintBody(QPainter& painter, const QRectF& device, double)
{
    m_plot->replot();
    m_plot->paintInto(painter, device);
}

void MapChart::replotAll() { m_plot->replot(); }

} // namespace lubberline::ui
