#include "ui/swing/PlotTabs.h"

#include <QVBoxLayout>

#include "ui/plots/swing/SwingPlot.h"

namespace lubberline::ui {

namespace {

constexpr int kLeastLines = 24; ///< of text: with its legend in four of them the polar plot can still be read; the page scrolls before

} // namespace

PlotTabs::PlotTabs(QWidget* parent) : QTabWidget(parent)
{
    setObjectName(QStringLiteral("plotTabs"));
    setDocumentMode(true);
    setMinimumHeight(kLeastLines * fontMetrics().lineSpacing());
    for (const QString& title : {tr("&Polar"), tr("C&urve"), tr("Spectru&m"), tr("C&omponents")}) {
        auto* place = new QWidget;
        auto* layout = new QVBoxLayout(place);
        layout->setContentsMargins(0, 0, 0, 0);
        addTab(place, title);
    }
    m_stale.fill(true);
    connect(this, &QTabWidget::currentChanged, this, [this] { catchUp(); });
}

SwingPlot* PlotTabs::make(int tab)
{
    static constexpr std::array makers{makePolarPlot, makeCurvePlot, makeSpectrumPlot, makeComponentsPlot};
    SwingPlot* plot = makers[static_cast<std::size_t>(tab)](widget(tab));
    widget(tab)->layout()->addWidget(plot);
    connect(plot, &SwingPlot::rowSelected, this, &PlotTabs::rowSelected);
    connect(plot, &SwingPlot::readOut, this, &PlotTabs::readOut);
    connect(plot, &SwingPlot::failed, this, &PlotTabs::failed);
    connect(plot, &SwingPlot::leaves, this, &PlotTabs::leaves);
    return plot;
}

SwingPlot* PlotTabs::current()
{
    catchUp();
    return m_plots[static_cast<std::size_t>(currentIndex())];
}

void PlotTabs::catchUp()
{
    const auto tab = static_cast<std::size_t>(currentIndex());
    if (!m_plots[tab])
        m_plots[tab] = make(currentIndex());
    if (m_stale[tab])
        m_plots[tab]->setPicture(m_picture);
    m_plots[tab]->setSelectedRow(m_selectedRow);
    m_stale[tab] = false;
}

void PlotTabs::setPicture(const SwingPicture& picture)
{
    m_picture = picture;
    m_stale.fill(true);
    catchUp();
}

void PlotTabs::setSelectedRow(int row)
{
    if (row == m_selectedRow)
        return;
    m_selectedRow = row;
    catchUp();
}

} // namespace lubberline::ui
