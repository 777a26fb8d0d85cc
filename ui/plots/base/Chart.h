#pragma once
/// What a plot draws, without a plot's manners (ChartPlot has these: mouse, keys, menu, palette). There is one kind for each
/// plot; for paper and exports a fresh one is made in the paper's colours and painted without being shown.

#include <QPointF>
#include <QWidget>

#include <functional>
#include <optional>
#include <vector>

#include "ui/plots/base/PlotColours.h"
#include "ui/plots/base/PlotLegend.h"

class QPainter;

namespace lubberline::ui {

/// A place under the pointer. A chart may have several canvases.
struct CanvasPlace {
    const QWidget* canvas = nullptr;
    QPointF at; ///< pixels of the canvas
};

class Chart : public QWidget {
    Q_OBJECT

public:
    explicit Chart(QWidget* parent = nullptr);

    void setColours(const PlotColours& colours);
    [[nodiscard]] const PlotColours& colours() const { return m_colours; }

    [[nodiscard]] virtual std::vector<QWidget*> canvases() const = 0;
    /// What can be clicked: a row of readings (of a history: a swing), with the pixel where it is drawn.
    struct RowPlace {
        int row = 0;
        QPointF at;
    };
    [[nodiscard]] virtual std::vector<RowPlace> rowsOn(const QWidget* canvas) const = 0;
    /// The nearest of them within reach of the pointer.
    [[nodiscard]] std::optional<int> rowNear(const CanvasPlace& place) const;
    /// A row in words, with units.
    [[nodiscard]] virtual QString readOutOfRow(int row) const = 0;
    /// A place of a canvas in words, with units.
    [[nodiscard]] virtual QString readOutAt(const CanvasPlace& place) const = 0;

    virtual void zoomInto(const QWidget* canvas, const QRectF& rect) = 0;
    /// factor < 1 shows less, larger; the place stays where it is.
    virtual void zoomAt(const CanvasPlace& place, double factor) = 0;
    virtual void panBy(const QWidget* canvas, const QPointF& by) = 0;
    virtual void resetZoom() = 0;
    /// The other chart's zoom and switched-off curves; the other is of the same kind.
    virtual void takeView(const Chart& other);

    [[nodiscard]] const std::vector<LegendEntry>& legend() const { return m_legend; }
    void setShown(int entry, bool shown);

    /// Paints into `target`, in the painter's own units, whatever its device is.
    void paint(QPainter& painter, const QRectF& target);

protected:
    using Switch = std::function<void(bool shown)>;
    /// A line of the legend that shows and hides something. @return its index
    int addEntry(const LegendEntry& entry, Switch show);
    LegendEntry& entry(int index) { return m_legend[index]; }
    /// To be called when entries were changed.
    void updateLegend();

    virtual void styleItems() = 0; ///< colours() and font() into the items and the entries
    virtual void layoutPlots(const QRect& rect) = 0;
    [[nodiscard]] QRect contentRect() const; ///< all but the legend: what layoutPlots() gets
    /// `device` is in pixels of the painter's device; its world transform is the identity.
    virtual void paintPlots(QPainter& painter, const QRectF& device) = 0;
    virtual void replotAll() = 0;

    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void placeParts();

    PlotColours m_colours;
    std::vector<LegendEntry> m_legend;
    std::vector<Switch> m_switches;
    PlotLegend* m_legendStrip;
    int m_legendHeight = 0;
};

/// The font of axis labels and legends on paper: 8 pt at 96 units an inch.
[[nodiscard]] QFont paperFont();
/// The same font with its size in pixels, so that it is scaled with everything else on a device of another resolution.
[[nodiscard]] QFont pixelFont(const QFont& font);

/// A notice in the middle of a plot, wrapped.
void paintNotice(QPainter& painter, const QRectF& within, const QString& text, const PlotColours& colours, const QFont& font);

} // namespace lubberline::ui
