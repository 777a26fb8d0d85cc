#pragma once

#include "ui/plots/base/Plot.h"
#include "ui/plots/swing/SwingPicture.h"

namespace lubberline::ui {

/// A plot of one swing: besides the manners of every plot, a click on a point selects its row and the legend toggles curves.
class SwingPlot : public Plot {
    Q_OBJECT

public:
    using Plot::Plot;

    virtual void setPicture(const SwingPicture& picture) = 0;
    /// The reading of this row is highlighted; −1: none.
    virtual void setSelectedRow(int row) = 0;

signals:
    void rowSelected(int row);
};

/// The four plots of a swing.
[[nodiscard]] SwingPlot* makePolarPlot(QWidget* parent = nullptr);
[[nodiscard]] SwingPlot* makeCurvePlot(QWidget* parent = nullptr);
[[nodiscard]] SwingPlot* makeSpectrumPlot(QWidget* parent = nullptr);
[[nodiscard]] SwingPlot* makeComponentsPlot(QWidget* parent = nullptr);

} // namespace lubberline::ui
