#include "ui/plots/swing/PredictionPlot.h"

#include "ui/plots/swing/PredictionChart.h"

namespace lubberline::ui {

PredictionPlot::PredictionPlot(QWidget* parent) : Plot(tr("Prediction"), parent), m_chart(new PredictionChart(this))
{
    adopt(m_chart);
    watchMouse();
}

void PredictionPlot::setPicture(const PredictionPicture& picture)
{
    m_picture = picture;
    m_chart->setPicture(picture);
}

void PredictionPlot::render(QPainter& painter, const QRectF& target) const
{
    PredictionChart paper;
    paper.setFont(paperFont());
    paper.setColours(paperColours());
    paper.takeView(*m_chart);
    paper.setPicture(m_picture);
    paper.paint(painter, target);
}

} // namespace lubberline::ui
