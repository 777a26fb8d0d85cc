#pragma once
/// The four plots of a swing as tabs. A plot is made when its tab is first shown, and only the one in front is repainted while
/// readings are typed; the others catch up when they are turned to.

#include <QTabWidget>

#include <array>

#include "ui/plots/swing/SwingPicture.h"

namespace lubberline::ui {

class SwingPlot;

class PlotTabs : public QTabWidget {
    Q_OBJECT

public:
    explicit PlotTabs(QWidget* parent = nullptr);

    void setPicture(const SwingPicture& picture);
    void setSelectedRow(int row);
    /// The plot in front; made when there was none.
    [[nodiscard]] SwingPlot* current();

signals:
    void rowSelected(int row);
    void readOut(const QString& text);
    void failed(const QString& message);
    void leaves(); ///< as Plot::leaves()

private:
    static constexpr int kPlots = 4;
    SwingPlot* make(int tab);
    void catchUp();

    std::array<SwingPlot*, kPlots> m_plots{};
    std::array<bool, kPlots> m_stale{};
    SwingPicture m_picture;
    int m_selectedRow = -1;
};

} // namespace lubberline::ui
