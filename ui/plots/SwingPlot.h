#pragma once

#include <QWidget>

#include "core/base/Result.h"
#include "ui/plots/SwingPicture.h"

class QPainter;

namespace lubberline::ui {

/// A plot of one swing: read-out under the pointer, zoom by drag (wheel too), pan with the middle button, reset by double
/// click or Home, a click on a point selects its row, the legend toggles curves, copy and export by the context menu.
/// Colours follow the palette (dark and light); what is exported or printed has a white ground.
class SwingPlot : public QWidget {
    Q_OBJECT

public:
    using QWidget::QWidget;

    [[nodiscard]] virtual QString name() const = 0; ///< "Polar", "Curve", …: the tab's text and the file name's end
    virtual void setPicture(const SwingPicture& picture) = 0;
    /// The reading of this row is highlighted; −1: none.
    virtual void setSelectedRow(int row) = 0;
    virtual void resetZoom() = 0;
    /// Draws the plot as it is, light colours on white, in vector form, into `target` of the painter's own units.
    virtual void render(QPainter& painter, const QRectF& target) const = 0;

    /// The ending says which: .png, .svg or .pdf. Errors: InvalidInput (another ending), Io,
    /// Unsupported (no font). No half-written file is left.
    Result<void> exportTo(const QString& path, QSize size_px = {900, 650}) const;
    /// A QFileDialog, then exportTo(); failures are shown by exportFailed().
    void exportInteractively();
    void copyToClipboard() const;

signals:
    void rowSelected(int row);
    void readOut(const QString& text); ///< what is under the pointer, with units; empty when it leaves
    void exportFailed(const QString& message);
};

/// The four plots of a swing.
[[nodiscard]] SwingPlot* makePolarPlot(QWidget* parent = nullptr);
[[nodiscard]] SwingPlot* makeCurvePlot(QWidget* parent = nullptr);
[[nodiscard]] SwingPlot* makeSpectrumPlot(QWidget* parent = nullptr);
[[nodiscard]] SwingPlot* makeComponentsPlot(QWidget* parent = nullptr);

} // namespace lubberline::ui
