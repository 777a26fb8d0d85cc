#include "ui/plots/swing/HistoryPlot.h"

#include <QKeyEvent>

#include "ui/plots/base/ChartMouse.h"
#include "ui/plots/swing/HistoryChart.h"

namespace lubberline::ui {

namespace {

/// The manners of the history: as those of the plots of a swing, without selection.
class ChartHistoryPlot : public HistoryPlot {
public:
    explicit ChartHistoryPlot(QWidget* parent) : HistoryPlot(parent), m_chart(new HistoryChart(this))
    {
        setFocusPolicy(Qt::StrongFocus);
        setAccessibleName(tr("Coefficients over time"));
        m_chart->setFont(font());
        m_chart->setColours(coloursFor(palette()));
        auto* mouse = new ChartMouse(m_chart);
        connect(mouse, &ChartMouse::picked, this, &HistoryPlot::swingSelected);
        connect(mouse, &ChartMouse::pressed, this, [this] { setFocus(Qt::MouseFocusReason); });
        connect(mouse, &ChartMouse::readOut, this, &HistoryPlot::readOut);
    }

    void setHistory(const std::vector<HistoryPoint>& points, std::optional<double> limit_deg) override
    {
        m_points = points;
        m_limit_deg = limit_deg;
        m_chart->setHistory(points, limit_deg);
    }

    void render(QPainter& painter, const QRectF& target) const override
    {
        HistoryChart paper;
        paper.setFont(paperFont());
        paper.setColours(paperColours());
        paper.takeView(*m_chart);
        paper.setHistory(m_points, m_limit_deg);
        paper.paint(painter, target);
    }

    [[nodiscard]] QSize sizeHint() const override { return {560, 300}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {220, 160}; }

protected:
    void resizeEvent(QResizeEvent* event) override
    {
        HistoryPlot::resizeEvent(event);
        m_chart->setGeometry(rect());
    }

    void changeEvent(QEvent* event) override
    {
        HistoryPlot::changeEvent(event);
        if (event->type() == QEvent::PaletteChange)
            m_chart->setColours(coloursFor(palette()));
        if (event->type() == QEvent::FontChange)
            m_chart->setFont(font());
    }

    void keyPressEvent(QKeyEvent* event) override
    {
        switch (event->key()) {
        case Qt::Key_Home: return m_chart->resetZoom();
        case Qt::Key_Plus:
        case Qt::Key_Equal: return zoomMiddle(*m_chart, kZoomStep);
        case Qt::Key_Minus: return zoomMiddle(*m_chart, 1 / kZoomStep);
        default: return HistoryPlot::keyPressEvent(event);
        }
    }

private:
    HistoryChart* m_chart;
    std::vector<HistoryPoint> m_points;
    std::optional<double> m_limit_deg;
};

} // namespace

HistoryPlot* makeHistoryPlot(QWidget* parent) { return new ChartHistoryPlot(parent); }

} // namespace lubberline::ui
